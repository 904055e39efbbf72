/* Scenes of a few meshes for tests of hidden lines. */
#ifndef HATCH_TEST_OCCLUDERS_H
#define HATCH_TEST_OCCLUDERS_H

#include "meshes.h"
#include "vector/curves.h"
#include "vector/project.h"

#define SIDE_PX 400.0 /* side of the picture */

static struct hatch_scene hiding_scene;
static struct hatch_unit_scene hiding_unit;
static struct hatch_occluders hiding;

/* Joins two meshes; the second one is scaled and moved. */
static inline struct hatch_mesh joined(const struct hatch_mesh *a, const struct hatch_mesh *b, double scale,
                                       const double by[3])
{
    struct hatch_mesh mesh;
    HATCH_TEST_OK(hatch_mesh_make(&keep, a->vertex_count + b->vertex_count, a->face_count + b->face_count, &mesh, &err),
                  &err);
    float *to = mesh.attributes[0].data;
    memcpy(to, a->attributes[0].data, 12 * (size_t)a->vertex_count);
    for (size_t i = 0; i < 3 * (size_t)b->vertex_count; i++)
        to[3 * (size_t)a->vertex_count + i] = (float)(scale * (double)b->attributes[0].data[i] + by[i % 3]);
    memcpy(mesh.indices, a->indices, 12 * (size_t)a->face_count);
    for (size_t i = 0; i < 3 * (size_t)b->face_count; i++)
        mesh.indices[3 * (size_t)a->face_count + i] = a->vertex_count + b->indices[i];
    return mesh;
}

/* Makes occluders of a mesh, whose coordinates are those of the unit scene. */
static inline void hide_behind(const struct hatch_mesh *mesh, const struct hatch_view *view)
{
    const struct hatch_bounds bounds = {.radius = 1};
    HATCH_TEST_OK(hatch_scene_of_mesh(mesh, &keep, &hiding_scene, &err), &err);
    HATCH_TEST_OK(hatch_unit_scene_make(&hiding_scene, NULL, &bounds, &keep, &hiding_unit, &err), &err);
    hatch_unit_scene_pose(&hiding_unit, HATCH_NONE, 0);
    HATCH_TEST_OK(hatch_occluders_make(&hiding_unit, view, SIDE_PX, SIDE_PX, &keep, &scratch, &hiding, &err), &err);
}

/* Finds the visible and the hidden parts of curves, without those that are due to rounding. */
static inline void see(const struct hatch_vector_curves *curves, struct hatch_vector_paths *visible,
                       struct hatch_vector_paths *hidden)
{
    static const struct hatch_vector_care exact = {1e-3, 1e-3};
    HATCH_TEST_OK(hatch_vector_see(&hiding, curves, NULL, &exact, &keep, &scratch, visible, hidden, &err), &err);
}

#endif
