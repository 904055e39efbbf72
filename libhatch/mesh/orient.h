/* Consistent orientation of faces. */
#ifndef HATCH_MESH_ORIENT_H
#define HATCH_MESH_ORIENT_H

#include "mesh/edges.h"

struct hatch_orientation {
    uint8_t *flipped;    /* set by the caller, out: per face, 1 when it must be turned round, else 0 */
    uint32_t *component; /* set by the caller, out: per face, its component in order of their lowest faces; faces left
                            out keep their value; NULL: not wanted */
    uint32_t components; /* sets of faces joined side by side */
    uint32_t faces_flipped;
    uint32_t contrary_edges; /* joined sides whose faces cannot agree, as on a Möbius strip */
};

/* Finds the faces to be turned so that neighbours agree. A component keeps the orientation of most of its faces; where
 * it is closed and its faces disagree, it gets positive volume. A non-orientable component keeps its faces unless
 * turning some leaves fewer contrary edges.
 *   partner      per side, from hatch_edges_partners
 *   orientation  in, out */
enum hatch_status hatch_mesh_orient(const struct hatch_mesh *mesh, const struct hatch_connectivity *faces,
                                    const uint32_t *partner, struct hatch_arena *scratch,
                                    struct hatch_orientation *orientation, struct hatch_err *err) HATCH_MUST_USE;

#endif
