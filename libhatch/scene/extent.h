/* Sizes of a scene in its rest pose. */
#ifndef HATCH_SCENE_EXTENT_H
#define HATCH_SCENE_EXTENT_H

#include "scene/scene.h"

struct hatch_scene_extent {
    double diagonal; /* diagonal of the box around everything that nodes draw, in scene units; where they draw nothing,
                        around all meshes */
    double *scale; /* per mesh: scene units per unit of the mesh, as its first node places it; 1 for meshes that no node
                      draws, or only with scale 0 */
    double *unevenness; /* per mesh: ratio, 1 .., of its largest to its smallest scale in a direction, as the node that
                           scales it most unevenly places it; nodes that flatten it do not count */
};

/* Measures a scene.
 *   extent  out: its array is in arena */
enum hatch_status hatch_scene_find_extent(const struct hatch_scene *scene, struct hatch_arena *arena,
                                          struct hatch_arena *scratch, struct hatch_scene_extent *extent,
                                          struct hatch_err *err) HATCH_MUST_USE;

#endif
