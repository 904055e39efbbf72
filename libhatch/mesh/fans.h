/* How the faces around a point hang together. */
#ifndef HATCH_MESH_FANS_H
#define HATCH_MESH_FANS_H

#include "mesh/edges.h"

/* Counts the points where faces meet that share no edge there: two tetrahedra joined at a tip. A point
 * of a book's back is none: its pages share an edge. point, edges, dropped: as for hatch_edges_find. */
enum hatch_status hatch_mesh_count_pinched(const uint32_t *point, uint32_t face_count, uint32_t point_count,
                                           const struct hatch_edges *edges, const uint8_t *dropped,
                                           struct hatch_arena *scratch, uint32_t *count,
                                           struct hatch_err *err) HATCH_MUST_USE;

/* Numbers the fans of corners: corners on both sides of a pair of joined sides are in one. A fan is a
 * disk or a part of one: its corners follow one another around their point. Fans are numbered in the order
 * of their lowest corners; corners of faces left out are fans of their own. Returns how many there are.
 * partner: per side, as hatch_edges_partners makes it; fan: per corner. */
uint32_t hatch_mesh_corner_fans(const uint32_t *point, const uint32_t *partner, uint32_t face_count, uint32_t *fan);

/* Disjoint sets over 0 .. count-1, each known by its lowest member. */
void hatch_sets_init(uint32_t *parent, uint32_t count);
uint32_t hatch_sets_find(uint32_t *parent, uint32_t member);
void hatch_sets_join(uint32_t *parent, uint32_t a, uint32_t b);

#endif
