/* Sizes of a scene in its rest pose. */
#ifndef HATCH_SCENE_EXTENT_H
#define HATCH_SCENE_EXTENT_H

#include "scene/scene.h"

struct hatch_scene_extent {
    double diagonal; /* diagonal of the box around everything that nodes draw, in scene units: if that has no size, at
                        the times at which animations set scales; where nodes draw nothing, around all meshes */
    double *scale;   /* per mesh: scene units per unit of the mesh: the root of the factor by which its node makes the
                        areas of its faces larger, in the root mean square; the largest of its nodes. If that is 0, the
                        largest that animations set; if there is none, the scale at which the mesh is as large as the
                        scene. 1 if the scene has no size, and where nodes draw nothing. Always over 0 */
    double *stretch; /* per mesh: the largest factor by which its nodes make a length longer; at least its scale */
    double *unevenness; /* per mesh: ratio, 1 .., of its largest to its smallest scale in a direction, as the node that
                           scales it most unevenly places it; nodes that flatten it do not count */
};

/* Sums areas of a mesh by their directions: A n n' over its faces, with area A, in the mesh's units squared, and unit
 * normal n. The trace is the area of the mesh.
 *   areas  out: symmetric */
void hatch_mesh_sum_areas(const struct hatch_mesh *mesh, double areas[3][3]);

/* Measures a scene.
 *   extent  out: its arrays are in arena */
enum hatch_status hatch_scene_find_extent(const struct hatch_scene *scene, struct hatch_arena *arena,
                                          struct hatch_arena *scratch, struct hatch_scene_extent *extent,
                                          struct hatch_err *err) HATCH_MUST_USE;

#endif
