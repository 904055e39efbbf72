/* Points of a surface by place and by vertex. */
#ifndef HATCH_TOPO_NEAREST_H
#define HATCH_TOPO_NEAREST_H

#include "surface/surface.h"

/* The point nearest to a position in the mesh's units; the lowest number among equals. Looks at
 * all points. */
uint32_t hatch_surface_nearest(const struct hatch_surface *surface, const double position[3]);

/* points[v]: the first point that vertex v of the mesh became, or HATCH_NO_SIDE when no face uses it.
 * points: vertex_count, the mesh's. */
void hatch_surface_vertex_points(const struct hatch_surface *surface, uint32_t vertex_count, uint32_t *points);

#endif
