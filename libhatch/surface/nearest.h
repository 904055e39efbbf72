/* Finds points of a surface by position and by vertex. */
#ifndef HATCH_SURFACE_NEAREST_H
#define HATCH_SURFACE_NEAREST_H

#include "math/point_tree.h"
#include "surface/surface.h"

/* The points of a surface, for searches. */
struct hatch_surface_points {
    const struct hatch_surface *surface;
    struct hatch_point_tree tree; /* of their positions in mesh units */
};

/* Makes it in arena; the surface is kept by reference. */
enum hatch_status hatch_surface_points_make(const struct hatch_surface *surface, struct hatch_arena *arena,
                                            struct hatch_surface_points *points, struct hatch_err *err) HATCH_MUST_USE;

/* Returns the point nearest to a position in mesh units; of equally near points, the one with the lowest number. */
uint32_t hatch_surface_nearest(const struct hatch_surface_points *points, const double position[3]);

/* Finds, for each vertex of the mesh, the lowest-numbered point made from it.
 *   vertex_count  of the mesh
 *   points        out: per vertex, its point, or HATCH_NO_SIDE when no face uses the vertex */
void hatch_surface_vertex_points(const struct hatch_surface *surface, uint32_t vertex_count, uint32_t *points);

#endif
