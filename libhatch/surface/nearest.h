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

/* The points of a surface by groups of vertices. */
struct hatch_surface_groups {
    uint32_t *first;  /* per group and 1 more: its points are points[first[g]] .. points[first[g + 1] - 1] */
    uint32_t *points; /* a point may be in a group several times */
    uint32_t *group;  /* per point: one of its groups */
};

/* Lists the points made from each group of vertices: several where the surface is cut.
 *   group_of     per vertex of the mesh: its group; NULL: each vertex is its own
 *   group_count  number of groups
 *   groups       out: arrays in arena */
enum hatch_status hatch_surface_group_points(const struct hatch_surface *surface, const uint32_t *group_of,
                                             uint32_t group_count, struct hatch_arena *arena,
                                             struct hatch_surface_groups *groups, struct hatch_err *err) HATCH_MUST_USE;

#endif
