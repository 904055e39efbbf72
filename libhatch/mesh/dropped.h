/* Faces that no surface has a use for. */
#ifndef HATCH_MESH_DROPPED_H
#define HATCH_MESH_DROPPED_H

#include "mesh/mesh.h"

/* Sets dropped[f] to 1 for every face with a repeated point or without area. Returns how many it set.
 * point: the 3 * face_count corners' points. */
uint32_t hatch_mesh_find_degenerate(const struct hatch_mesh *mesh, const uint32_t *point, uint8_t *dropped);

/* Sets dropped[f] to 1 for every face on the same three points as an earlier one, whichever way round
 * they go, and counts them. Faces already dropped take no part. point: the 3 * face_count corners'
 * points. */
enum hatch_status hatch_mesh_find_duplicates(const uint32_t *point, uint32_t face_count, uint8_t *dropped,
                                             struct hatch_arena *scratch, uint32_t *count,
                                             struct hatch_err *err) HATCH_MUST_USE;

#endif
