/* Fans: groups of faces around a point that are joined across edges. */
#ifndef HATCH_MESH_FANS_H
#define HATCH_MESH_FANS_H

#include "mesh/edges.h"

/* Counts the pinched points, at which more than one fan meets, as where two tetrahedra touch at a tip. All faces at an
 * edge count as joined, even if there are more than two. */
enum hatch_status hatch_mesh_count_pinched(const struct hatch_connectivity *faces, const struct hatch_edges *edges,
                                           struct hatch_arena *scratch, uint32_t *count,
                                           struct hatch_err *err) HATCH_MUST_USE;

/* Groups the face corners into fans and numbers the fans in the order of their lowest corners; returns the number of
 * fans. Corners belong to one fan if they are at the same end of two paired sides, so the corners of a fan follow one
 * another around their point. A corner whose sides have no partners is a fan of its own.
 *   partner  per side, from hatch_edges_partners
 *   cut      per side that is the lower one of a pair: bits 1 and 2: the pair joins no corners at the begin and at the
 *            end of that side; NULL: all pairs join both
 *   fan      out: per corner */
uint32_t hatch_mesh_corner_fans(const uint32_t *point, const uint32_t *partner, const uint8_t *cut, uint32_t face_count,
                                uint32_t *fan);

/* Disjoint sets (union-find) over 0 .. count-1, each identified by its lowest member.
 *   parent  count entries, filled by hatch_sets_init */
void hatch_sets_init(uint32_t *parent, uint32_t count);
uint32_t hatch_sets_find(uint32_t *parent, uint32_t member);
void hatch_sets_join(uint32_t *parent, uint32_t a, uint32_t b);

#endif
