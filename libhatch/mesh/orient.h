/* Turning faces so that neighbours agree. */
#ifndef HATCH_MESH_ORIENT_H
#define HATCH_MESH_ORIENT_H

#include "mesh/edges.h"

struct hatch_orientation {
    uint32_t components;     /* of faces joined by edges of exactly two faces */
    uint32_t faces_flipped;
    uint32_t contrary_edges; /* edges of two faces that no turning makes agree */
};

/* flipped[f] becomes 1 for the faces to be turned. Faces are joined over edges of exactly two faces. A
 * component keeps the side that most of its faces had; where it is closed and its faces disagreed, it
 * takes the side of positive volume. point, edges, dropped: as for hatch_edges_find. flipped:
 * face_count zeros. component: NULL, or per face: the number of its component, in order of their lowest
 * faces; faces left out keep theirs. */
enum hatch_status hatch_mesh_orient(const struct hatch_mesh *mesh, const uint32_t *point,
                                    const struct hatch_edges *edges, const uint8_t *dropped,
                                    struct hatch_arena *scratch, uint8_t *flipped,
                                    uint32_t *component, struct hatch_orientation *result,
                                    struct hatch_err *err) HATCH_MUST_USE;

#endif
