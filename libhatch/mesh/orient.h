/* Turning faces so that neighbours agree. */
#ifndef HATCH_MESH_ORIENT_H
#define HATCH_MESH_ORIENT_H

#include "mesh/edges.h"

struct hatch_orientation {
    uint32_t components; /* of faces joined side by side */
    uint32_t faces_flipped;
    uint32_t contrary_edges; /* joined sides that no turning makes agree */
};

/* flipped[f] becomes 1 for the faces to be turned, 0 for the others. A component keeps the side that most
 * of its faces had; where it is closed and its faces disagreed, it takes the side of positive volume. One
 * that has but one side keeps its faces as they came, unless fewer edges are contrary when some are
 * turned. point, dropped: as for hatch_edges_find; partner: per side, as hatch_edges_partners makes it.
 * component: NULL, or per face: the number of its component, in order of their lowest faces; faces left
 * out keep theirs. */
enum hatch_status hatch_mesh_orient(const struct hatch_mesh *mesh, const uint32_t *point, const uint32_t *partner,
                                    const uint8_t *dropped, struct hatch_arena *scratch, uint8_t *flipped,
                                    uint32_t *component, struct hatch_orientation *result,
                                    struct hatch_err *err) HATCH_MUST_USE;

#endif
