/* Shared by the fuzz targets of mesh formats: a mesh that was read must withstand every use that the commands
 * make of it. */
#ifndef HATCH_TEST_FUZZ_MESH_H
#define HATCH_TEST_FUZZ_MESH_H

#include "fuzz.h"
#include "io/mesh/file.h"
#include "measure/mesh_figures.h"

#define FUZZ_MUST_HOLD(condition)                                                                                      \
    do {                                                                                                               \
        if (!(condition))                                                                                              \
            abort();                                                                                                   \
    } while (0)

/* Measures, cleans and completes a mesh. Steps may fail; the invariants must hold. */
static inline void fuzz_use_mesh(struct hatch_mesh *mesh, struct fuzz_arenas *arenas)
{
    struct hatch_err err;
    struct hatch_mesh_figures figures;
    struct hatch_mesh_notes notes = {0};
    if (hatch_measure_mesh(mesh, &arenas->scratch, &figures, &err) == HATCH_OK)
        FUZZ_MUST_HOLD(figures.points <= figures.vertices && figures.area >= 0);
    if (hatch_mesh_clean(&arenas->keep, &arenas->scratch, mesh, &notes, &err) != HATCH_OK)
        return;
    FUZZ_MUST_HOLD(hatch_mesh_check(mesh, &err) == HATCH_OK);
    if (hatch_mesh_add_normals(&arenas->keep, &arenas->scratch, mesh, 0.7f, &err) != HATCH_OK)
        return;
    if (hatch_mesh_find(mesh, "TEXCOORD_0", 2) &&
        hatch_mesh_add_tangents(&arenas->keep, &arenas->scratch, mesh, &err) != HATCH_OK)
        return;
    FUZZ_MUST_HOLD(hatch_mesh_check(mesh, &err) == HATCH_OK);
    for (uint32_t a = 0; a < mesh->attribute_count; a++)
        for (size_t i = 0; i < (size_t)mesh->vertex_count * mesh->attributes[a].components; i++)
            FUZZ_MUST_HOLD(mesh->attributes[a].data[i] - mesh->attributes[a].data[i] == 0);
}

/* Fuzz target for a mesh format. */
static inline int fuzz_mesh_file(enum hatch_mesh_format format, const uint8_t *data, size_t size)
{
    struct fuzz_arenas arenas = fuzz_arenas_make();
    struct hatch_mesh mesh;
    double origin[3];
    struct hatch_mesh_notes notes = {0};
    struct hatch_err err = {HATCH_OK, ""};
    enum hatch_status status = hatch_mesh_read((struct hatch_mesh_file){{data, size}, format}, &arenas.keep,
                                               &arenas.scratch, &mesh, origin, &notes, &err);
    fuzz_check(status, &err, &arenas);
    if (status == HATCH_OK)
        fuzz_use_mesh(&mesh, &arenas);
    fuzz_arenas_free(&arenas);
    return 0;
}

#endif
