/* How much larger faces are in the pose of a view than at rest: needs are told in lengths at rest, in which generators
 * make meshes and strokes. */
#ifndef RENDER_MODE_NEEDS_GROWTH_H
#define RENDER_MODE_NEEDS_GROWTH_H

#include "render-gl/mode/job.h"

struct needs_growth {
    struct hatch_pose pose;
    float **rest; /* per item and face: length at rest, in scene units */
};

/* Measures the faces of all items at rest, if the scene is animated. A face is as long as its longest edge; one that
 * has no length at rest is as long as it would be at the scale of its mesh that hatch_scene_find_extent finds, which
 * generators work with, or has length 0 if it has none there. Exits with a message when memory does not suffice. */
void needs_growth_begin(struct job *job, struct needs_growth *growth);

/* Computes how much longer the faces of an item are in the pose of the scene.
 *   factors  out: one per face; 1 for a face whose length at rest is 0 */
void needs_growth_find(struct job *job, struct needs_growth *growth, uint32_t item, float *factors);

#endif
