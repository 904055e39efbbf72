/* A guess which axis of a mesh points up. */
#ifndef HATCH_SCENE_UP_H
#define HATCH_SCENE_UP_H

#include "mesh/mesh.h"

/* Returns whether a mesh seems to stand along z, and not along y: along z, the lowest hundredth of its height, a base
 * or feet, spreads over at least 15 % of its bounding rectangle seen from above, and over twice as much as the highest
 * hundredth; along y over at most a quarter of that. False for a mesh that is flat along an axis, and for a height
 * field along y, such as a terrain, whose base along z is its border. */
bool hatch_mesh_stands_along_z(const struct hatch_mesh *mesh);

#endif
