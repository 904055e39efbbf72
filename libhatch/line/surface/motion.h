/* How skins and morph targets move vertices. */
#ifndef HATCH_LINE_MOTION_H
#define HATCH_LINE_MOTION_H

#include "mesh/mesh.h"

/* Computes by how much each vertex moves in a pose that is made up: vertices at one position stay together in all poses
 * if they move by the same amount in this one, and come apart in some pose if not. Different orders of the same joints
 * are the same but for rounding.
 *   size    by which joints move, in units of the positions
 *   motion  out: 3 per vertex */
void hatch_line_motion(const struct hatch_mesh *mesh, double size, float *motion);

#endif
