/* The usual beginning of a test that reads meshes from files: the mesh that was read last, and what must be refused. */
#ifndef HATCH_TEST_FILES_READ_MESH_H
#define HATCH_TEST_FILES_READ_MESH_H

#include <string.h>

#include "arenas.h"
#include "fail_alloc.h"
#include "io/mesh/file.h"

static struct hatch_mesh mesh;
static struct hatch_mesh_notes notes;
static double origin[3];

static inline void begin_reading(void)
{
    begin();
    notes = (struct hatch_mesh_notes){0};
}

static inline struct hatch_bytes text(const char *words)
{
    return (struct hatch_bytes){(const uint8_t *)words, strlen(words)};
}

static inline enum hatch_status read_bytes(struct hatch_bytes file)
{
    enum hatch_mesh_format format = hatch_mesh_format_of(file, NULL);
    return hatch_mesh_read((struct hatch_mesh_file){file, format}, &keep, &scratch, &mesh, origin, &notes, &err);
}

static inline void reads(struct hatch_bytes file, uint32_t vertices, uint32_t faces)
{
    HATCH_TEST_OK(read_bytes(file), &err);
    ck_assert_uint_eq(mesh.vertex_count, vertices);
    ck_assert_uint_eq(mesh.face_count, faces);
}

static inline void refused(const char *file, const char *place)
{
    struct hatch_mesh before = mesh;
    ck_assert_int_eq(read_bytes(text(file)), HATCH_BAD_INPUT);
    ck_assert_msg(strstr(err.text, place) != NULL, "'%s' does not say '%s'", err.text, place);
    ck_assert_mem_eq(&before, &mesh, sizeof mesh);
}

/* Reads a file, for hatch_test_fail_alloc.
 *   context  its struct hatch_bytes */
static inline enum hatch_status read_mesh_file(void *context, struct hatch_arena *kept, struct hatch_arena *temporary,
                                               struct hatch_err *error)
{
    struct hatch_mesh_notes noted = {0};
    struct hatch_bytes file = *(const struct hatch_bytes *)context;
    const char *name = file.data[0] == 's' ? "x.stl" : NULL;
    return hatch_mesh_read((struct hatch_mesh_file){file, hatch_mesh_format_of(file, name)}, kept, temporary, &mesh,
                           origin, &noted, error);
}

#endif
