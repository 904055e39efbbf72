/* Influences: the joints that move a vertex, and their weights. */
#ifndef HATCH_MESH_SKIN_INFLUENCES_H
#define HATCH_MESH_SKIN_INFLUENCES_H

#include "mesh/mesh.h"

#define HATCH_INFLUENCES 4u     /* of a vertex of a mesh: the components of JOINTS_0 and WEIGHTS_0 */
#define HATCH_INFLUENCE_SETS 8u /* most sets of these that a file may give a vertex */
#define HATCH_INFLUENCES_MAX (HATCH_INFLUENCES * HATCH_INFLUENCE_SETS)

/* Influences from several sets or vertices; no joint occurs twice. */
struct hatch_influences {
    uint32_t count;
    float joint[HATCH_INFLUENCES_MAX], weight[HATCH_INFLUENCES_MAX];
};

/* Adds a weight to that of its joint. There must be room for one joint more. */
void hatch_influences_add(struct hatch_influences *influences, float joint, float weight);

/* Keeps the joints that weigh most, the heaviest first and of equal ones those added first. Returns whether others with
 * a weight over 0 are left out.
 *   joints   out: of influences without a weight over 0: 0
 *   weights  out: as they were added; 0 where there are no more joints */
bool hatch_influences_keep(const struct hatch_influences *influences, float joints[HATCH_INFLUENCES],
                           float weights[HATCH_INFLUENCES]);

/* Reduces the sets JOINTS_0 and WEIGHTS_0, JOINTS_1 and WEIGHTS_1 and so on to the first, in place. A vertex keeps its
 * heaviest influences. If it has others, those kept are scaled to the sum of all. A vertex without a weight over 0
 * keeps its first set. Returns the number of vertices with more than HATCH_INFLUENCES influences. */
uint32_t hatch_mesh_keep_influences(struct hatch_mesh *mesh);

#endif
