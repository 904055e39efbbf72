/* The surfaces of a scene that have feature lines. A file divides a surface into meshes, one per material; those that a
 * node shows together are one surface again, so that their common borders are edges like any others. */
#ifndef HATCH_LINE_SURFACE_H
#define HATCH_LINE_SURFACE_H

#include "line/trace.h"
#include "scene/unit_scene.h"

/* The data of a surface for all views and poses; nodes that show the same meshes share it. */
struct hatch_line_body {
    struct hatch_line_choice choice;
    struct hatch_line_mesh lines;   /* rigid: relative to the origin of the first mesh */
    struct hatch_mesh mesh;         /* deformed: all meshes joined, as in the file */
    struct hatch_line_edges *edges; /* deformed: of mesh; their kinds follow from each pose */
    uint8_t *double_sided;          /* per face: not 0: visible from behind, too */
};

struct hatch_line_surface {
    const struct hatch_item *item; /* the first of its items, which places all of it */
    const struct hatch_line_body *body;
};

/* Finds the surfaces of a scene: successive items of a node, except that skins or morph targets of one kind move all of
 * a surface. Items with cut_out set belong to none.
 *   choice    normals_authored is ignored: it follows from the meshes
 *   arena     for the surfaces; not the scratch arena
 *   surfaces  out: *count of them, in the order of the items, which they keep by reference */
enum hatch_status hatch_line_surfaces_make(const struct hatch_unit_scene *scene, const struct hatch_line_choice *choice,
                                           struct hatch_arena *arena, struct hatch_arena *scratch,
                                           struct hatch_line_surface **surfaces, uint32_t *count,
                                           struct hatch_err *err) HATCH_MUST_USE;

/* Poses a surface. A deformed one gets new vertices, and its creases and boundaries are found anew.
 *   arena  for the shape; not the scratch arena */
enum hatch_status hatch_line_surface_pose(struct hatch_unit_scene *scene, const struct hatch_line_surface *surface,
                                          struct hatch_arena *arena, struct hatch_arena *scratch,
                                          struct hatch_line_shape *shape, struct hatch_err *err) HATCH_MUST_USE;

#endif
