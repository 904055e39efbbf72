/* Finds degenerate and duplicate faces. */
#ifndef HATCH_MESH_DROPPED_H
#define HATCH_MESH_DROPPED_H

#include "mesh/mesh.h"

/* Marks faces that have a repeated point or no area; returns their number.
 *   point    3 * face_count: the point of each corner
 *   dropped  in, out: per face; set to 1 for the faces found */
uint32_t hatch_mesh_find_degenerate(const struct hatch_mesh *mesh, const uint32_t *point, uint8_t *dropped);

struct hatch_mesh_duplicates {
    uint32_t count;    /* faces with the same three points as an earlier face */
    uint32_t reversed; /* those of them that face the other way than the first */
};

/* Marks faces that have the same three points, in any order, as an earlier face.
 *   point    3 * face_count: the point of each corner
 *   dropped  in, out: per face; faces that are already marked are ignored
 *   found    out */
enum hatch_status hatch_mesh_find_duplicates(const uint32_t *point, uint32_t face_count, uint8_t *dropped,
                                             struct hatch_arena *scratch, struct hatch_mesh_duplicates *found,
                                             struct hatch_err *err) HATCH_MUST_USE;

#endif
