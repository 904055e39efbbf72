/* The edges of a triangle mesh, each with the faces along it. */
#ifndef HATCH_MESH_EDGES_H
#define HATCH_MESH_EDGES_H

#include "mesh/mesh.h"

/* Faces as triples of points: vertices at one position are one point (hatch_mesh_weld). */
struct hatch_connectivity {
    const uint32_t *point; /* 3 * face_count: the point of each corner */
    uint32_t face_count, point_count;
    const uint8_t *dropped; /* per face: not 0 leaves it out; NULL: none is left out */
};

/* Edges between points. Side 3 * f + c of face f runs from its corner c to corner (c + 1) % 3. */
struct hatch_edges {
    uint32_t count;
    uint32_t *first; /* count + 1 entries: edge e has sides[first[e]] .. sides[first[e + 1] - 1] */
    uint32_t *sides; /* grouped by edge; ascending within an edge */
};

#define HATCH_NO_EDGE UINT32_MAX

/* Returns the corner at which a side ends: 3 * f + (c + 1) % 3. */
static inline uint32_t hatch_side_end(uint32_t side)
{
    return side % 3 == 2 ? side - 2 : side + 1;
}

/* Computes the unit vector in the plane of a face that is perpendicular to one of its sides and points into the face.
 * Returns false if the face is so thin that the vector would depend on rounding. */
bool hatch_side_direction(const struct hatch_mesh *mesh, uint32_t side, double direction[3]);

/* Fills point[i] = vertex_to_point[mesh->indices[i]] for all 3 * face_count corners. */
void hatch_mesh_corner_points(const struct hatch_mesh *mesh, const uint32_t *vertex_to_point, uint32_t *point);

/* Finds all edges, ordered by their lower point, then by their higher point. The time is linear in the numbers of faces
 * and points, whatever the valences.
 *   edges  out: its arrays are in arena */
enum hatch_status hatch_edges_find(const struct hatch_connectivity *faces, struct hatch_arena *arena,
                                   struct hatch_arena *scratch, struct hatch_edges *edges,
                                   struct hatch_err *err) HATCH_MUST_USE;

/* Pairs the two sides of each edge that has exactly two faces and is not sharp.
 *   sharp    per edge, not 0: sharp; NULL: no edge is sharp
 *   partner  out: per side of all face_count faces: the other side of its pair; HATCH_NO_EDGE: none */
void hatch_edges_partners(const struct hatch_edges *edges, const uint8_t *sharp, uint32_t face_count,
                          uint32_t *partner);

#endif
