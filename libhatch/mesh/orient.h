/* Consistent orientation of faces. */
#ifndef HATCH_MESH_ORIENT_H
#define HATCH_MESH_ORIENT_H

#include "mesh/edges.h"

struct hatch_orientation {
    uint8_t *flipped;    /* array of the caller; out: per face, 1 if it must be flipped, else 0 */
    uint32_t *component; /* array of the caller, or NULL; out: per face, the number of its component (numbered in the
                            order of their lowest faces); unchanged for faces that are left out */
    uint32_t components; /* number of components: sets of faces that are joined across edges */
    uint32_t faces_flipped;
    uint32_t contrary_edges; /* edges whose two faces cannot agree, as on a Möbius strip */
};

/* Finds the faces that must be flipped so that neighbours agree. A component keeps the orientation of the majority of
 * its faces; if it is closed and its faces disagree, it is oriented to a positive volume. A non-orientable component
 * stays as it is, unless flipping leaves fewer contrary edges.
 *   partner      per side, from hatch_edges_partners
 *   orientation  in, out */
enum hatch_status hatch_mesh_orient(const struct hatch_mesh *mesh, const struct hatch_connectivity *faces,
                                    const uint32_t *partner, struct hatch_arena *scratch,
                                    struct hatch_orientation *orientation, struct hatch_err *err) HATCH_MUST_USE;

#endif
