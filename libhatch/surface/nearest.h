/* Finds points of a surface by position and by vertex. */
#ifndef HATCH_SURFACE_NEAREST_H
#define HATCH_SURFACE_NEAREST_H

#include "surface/surface.h"

/* Returns the point nearest to a position in mesh units; of equally near points, the one with the lowest number. Tests
 * every point. */
uint32_t hatch_surface_nearest(const struct hatch_surface *surface, const double position[3]);

/* Finds, for each vertex of the mesh, the lowest-numbered point made from it.
 *   vertex_count  of the mesh
 *   points        out: per vertex, its point, or HATCH_NO_SIDE when no face uses the vertex */
void hatch_surface_vertex_points(const struct hatch_surface *surface, uint32_t vertex_count, uint32_t *points);

#endif
