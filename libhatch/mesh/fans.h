/* Fans: the groups of joined faces around a point. */
#ifndef HATCH_MESH_FANS_H
#define HATCH_MESH_FANS_H

#include "mesh/edges.h"

/* Counts the pinched points: those where faces meet that share no edge there, as two tetrahedra joined at a tip. Faces
 * that share an edge of more than two faces are joined. */
enum hatch_status hatch_mesh_count_pinched(const struct hatch_connectivity *faces, const struct hatch_edges *edges,
                                           struct hatch_arena *scratch, uint32_t *count,
                                           struct hatch_err *err) HATCH_MUST_USE;

/* Numbers the fans of corners in the order of their lowest corners: corners at one end of two joined sides belong to
 * one fan. The corners of a fan follow one another around their point; those of faces left out are fans of their own.
 * Returns the number of fans.
 *   partner  per side, from hatch_edges_partners
 *   fan      out: per corner */
uint32_t hatch_mesh_corner_fans(const uint32_t *point, const uint32_t *partner, uint32_t face_count, uint32_t *fan);

/* Disjoint sets (union-find) over 0 .. count-1, each identified by its lowest member.
 *   parent  count entries, filled by hatch_sets_init */
void hatch_sets_init(uint32_t *parent, uint32_t count);
uint32_t hatch_sets_find(uint32_t *parent, uint32_t member);
void hatch_sets_join(uint32_t *parent, uint32_t a, uint32_t b);

#endif
