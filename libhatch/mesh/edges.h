/* The edges of a triangle mesh, each with the faces along it. */
#ifndef HATCH_MESH_EDGES_H
#define HATCH_MESH_EDGES_H

#include "mesh/mesh.h"

/* Side 3 * f + c of face f runs from its corner c to corner (c + 1) % 3. */
struct hatch_edges {
    uint32_t count;
    uint32_t *first;   /* count + 1 entries: edge e owns sides[first[e]] .. sides[first[e + 1] - 1] */
    uint32_t *sides;   /* grouped by edge, rising within one */
    uint32_t *edge_of; /* per side; HATCH_NO_EDGE for a side of no length or of a face left out */
};

#define HATCH_NO_EDGE UINT32_MAX

/* The corner after a side's first: 3 * f + (c + 1) % 3. */
static inline uint32_t hatch_side_end(uint32_t side)
{
    return side % 3 == 2 ? side - 2 : side + 1;
}

/* The unit vector at a right angle to a side that points into its face. false when the face is so flat
 * that rounding decides. */
bool hatch_side_direction(const struct hatch_mesh *mesh, uint32_t side, double direction[3]);

/* The point of every corner: point[i] = vertex_to_point[mesh->indices[i]]. point: 3 * face_count. */
void hatch_mesh_corner_points(const struct hatch_mesh *mesh, const uint32_t *vertex_to_point, uint32_t *point);

/* Finds all edges in time linear in faces and points, whatever the valences. Edges are ordered by their
 * lower, then by their higher point. point: the 3 * face_count corners' points, below point_count;
 * dropped: NULL, or per face: not 0 leaves it out. */
enum hatch_status hatch_edges_find(const uint32_t *point, uint32_t face_count, uint32_t point_count,
                                   const uint8_t *dropped, struct hatch_arena *arena, struct hatch_arena *scratch,
                                   struct hatch_edges *edges, struct hatch_err *err) HATCH_MUST_USE;

/* partner: per side of all face_count faces the other side of its edge, where that has exactly two faces
 * and is not sharp; else HATCH_NO_EDGE. sharp: NULL, or per edge. */
void hatch_edges_partners(const struct hatch_edges *edges, const uint8_t *sharp, uint32_t face_count,
                          uint32_t *partner);

#endif
