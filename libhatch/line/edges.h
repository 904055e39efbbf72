/* The edges of a mesh as lines see them: welded by position, without what noise makes. */
#ifndef HATCH_LINE_EDGES_H
#define HATCH_LINE_EDGES_H

#include "mesh/creases.h"
#include "line/chain.h"

struct hatch_line_edges {
    uint32_t *point; /* per corner */
    uint32_t point_count;
    struct hatch_edges edges;
    uint8_t *kinds; /* per edge, enum hatch_edge_kind */
};

/* Welds and classifies. Creases and cracks that nobody meant (line/prune.h) count as
 * smooth. crease_rad: 0 .. π. normals_meant: the mesh's normals are its maker's; an edge that they
 * smooth over is then a crease only beyond 60 degrees, as no tessellated curve turns. arena and scratch
 * must not be the same. */
enum hatch_status hatch_line_edges_find(const struct hatch_mesh *mesh, double crease_rad, bool normals_meant,
                                        struct hatch_arena *arena, struct hatch_arena *scratch,
                                        struct hatch_line_edges *edges, struct hatch_err *err) HATCH_MUST_USE;

/* Does one normal serve both faces of an edge, at either end? */
bool hatch_line_edge_is_smoothed(const struct hatch_mesh *mesh, const struct hatch_line_edges *edges, uint32_t edge);

/* The corners at both ends of an edge on one of its sides, the lower point first. */
void hatch_line_side_corners(const uint32_t *point, uint32_t side, uint32_t corners[2]);

#endif
