/* Finds cracks: boundaries that coincide. */
#include "math/vector.h"
#include "line/prune.h"

#define COS_STRAIGHT 0.9998  /* cosine of the largest angle between an edge and the segments of a path along it */
#define PATH_MAX 256u        /* largest number of segments of a path */
#define BOUNDARIES_MAX 1000u /* nodes with more are not followed: cracks have fewer, and each path would test all */

/* Boundary segments by node: those at node n are segments[first[n]] .. segments[first[n + 1] - 1]. */
struct boundaries {
    const struct hatch_line_graph *graph;
    uint32_t *first, *segments;
};

static enum hatch_status list_boundaries(const struct hatch_line_graph *graph, const uint8_t *bounds,
                                         struct hatch_arena *scratch, struct boundaries *boundaries,
                                         struct hatch_err *err)
{
    size_t ends = 2 * (size_t)graph->segment_count;
    boundaries->graph = graph;
    HATCH_TRY(HATCH_ALLOC(scratch, &boundaries->first, (size_t)graph->node_count + 2, err));
    HATCH_TRY(HATCH_ALLOC(scratch, &boundaries->segments, ends, err));
    for (size_t i = 0; i < ends; i++)
        boundaries->first[graph->ends[i] + 2] += bounds[i / 2] != 0;
    for (uint32_t node = 0; node < graph->node_count; node++)
        boundaries->first[node + 2] += boundaries->first[node + 1];
    for (size_t i = 0; i < ends; i++)
        if (bounds[i / 2])
            boundaries->segments[boundaries->first[graph->ends[i] + 1]++] = (uint32_t)(i / 2);
    return HATCH_OK;
}

/* Returns a boundary other than `other_than` that leaves a node in the given direction, or UINT32_MAX.
 *   node  in and out: moves to the boundary's other end */
static uint32_t follow(const struct boundaries *boundaries, uint32_t other_than, const double direction[3],
                       uint32_t *node)
{
    const struct hatch_line_graph *graph = boundaries->graph;
    if (boundaries->first[*node + 1] - boundaries->first[*node] > BOUNDARIES_MAX)
        return UINT32_MAX;
    for (uint32_t i = boundaries->first[*node]; i < boundaries->first[*node + 1]; i++) {
        uint32_t segment = boundaries->segments[i];
        const uint32_t *ends = &graph->ends[2 * (size_t)segment];
        uint32_t far = ends[ends[0] == *node];
        double along[3];
        hatch_vec_sub(&graph->nodes[3 * (size_t)far], &graph->nodes[3 * (size_t)*node], along);
        hatch_vec_normalize(along);
        if (segment != other_than && hatch_vec_dot(along, direction) >= COS_STRAIGHT) {
            *node = far;
            return segment;
        }
    }
    return UINT32_MAX;
}

/* Follows the straight path of other boundaries along a segment; returns false if it does not reach the segment's end.
 *   path  out: room for PATH_MAX segments */
static bool find_path(const struct boundaries *boundaries, uint32_t segment, uint32_t *path, uint32_t *count)
{
    const uint32_t *ends = &boundaries->graph->ends[2 * (size_t)segment];
    const double *nodes = boundaries->graph->nodes;
    double direction[3];
    uint32_t node = ends[0];
    hatch_vec_sub(&nodes[3 * (size_t)ends[1]], &nodes[3 * (size_t)ends[0]], direction);
    double length = hatch_vec_normalize(direction);
    *count = 0;
    while (node != ends[1] && *count < PATH_MAX) {
        path[*count] = follow(boundaries, segment, direction, &node);
        if (path[*count] == UINT32_MAX ||
            hatch_vec_distance(&nodes[3 * (size_t)ends[0]], &nodes[3 * (size_t)node]) > 1.001 * length)
            return false;
        (*count)++;
    }
    return node == ends[1];
}

enum hatch_status hatch_line_find_cracks(const struct hatch_line_graph *graph, const uint8_t *bounds,
                                         struct hatch_arena *scratch, uint8_t *pruned, struct hatch_err *err)
{
    struct hatch_arena_mark mark = hatch_arena_mark(scratch);
    struct boundaries boundaries;
    enum hatch_status status = list_boundaries(graph, bounds, scratch, &boundaries, err);
    for (uint32_t s = 0; s < graph->segment_count && status == HATCH_OK; s++) {
        uint32_t path[PATH_MAX], count;
        if (!bounds[s] || !find_path(&boundaries, s, path, &count))
            continue;
        pruned[s] = 1;
        for (uint32_t i = 0; i < count; i++)
            pruned[path[i]] = 1;
    }
    hatch_arena_rewind(scratch, mark);
    return status;
}
