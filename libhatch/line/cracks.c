/* Boundaries that only look like some. */
#include "math/vector.h"
#include "line/prune.h"

#define COS_STRAIGHT 0.9998  /* a path this straight lies on the edge that it goes along */
#define PATH_MAX 256u        /* edges of a path */
#define BOUNDARIES_MAX 1000u /* at a node: no crack has as many, and each would look at all of them */

/* Boundary segments by node: those at node n are numbers[first[n]] .. numbers[first[n + 1] - 1]. */
struct meeting {
    const struct hatch_line_graph *graph;
    uint32_t *first, *numbers;
};

static enum hatch_status list_meeting(const struct hatch_line_graph *graph, const uint8_t *bounds,
                                      struct hatch_arena *scratch, struct meeting *meeting, struct hatch_err *err)
{
    size_t ends = 2 * (size_t)graph->segment_count;
    meeting->graph = graph;
    meeting->first = HATCH_NEW(scratch, uint32_t, (size_t)graph->node_count + 2, err);
    meeting->numbers = meeting->first ? HATCH_NEW(scratch, uint32_t, ends, err) : NULL;
    if (!meeting->numbers)
        return HATCH_LIMIT;
    for (size_t i = 0; i < ends; i++)
        meeting->first[graph->ends[i] + 2] += bounds[i / 2] != 0;
    for (uint32_t node = 0; node < graph->node_count; node++)
        meeting->first[node + 2] += meeting->first[node + 1];
    for (size_t i = 0; i < ends; i++)
        if (bounds[i / 2])
            meeting->numbers[meeting->first[graph->ends[i] + 1]++] = (uint32_t)(i / 2);
    return HATCH_OK;
}

/* The boundary, other than one, that leaves a node in a direction; *node moves to its end. */
static uint32_t step(const struct meeting *meeting, uint32_t other_than, const double direction[3], uint32_t *node)
{
    const struct hatch_line_graph *graph = meeting->graph;
    if (meeting->first[*node + 1] - meeting->first[*node] > BOUNDARIES_MAX)
        return UINT32_MAX;
    for (uint32_t i = meeting->first[*node]; i < meeting->first[*node + 1]; i++) {
        uint32_t segment = meeting->numbers[i];
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

/* Follows the straight path beside a segment. false when it does not arrive at the segment's end. */
static bool find_path(const struct meeting *meeting, uint32_t segment, uint32_t *path, uint32_t *count)
{
    const uint32_t *ends = &meeting->graph->ends[2 * (size_t)segment];
    const double *nodes = meeting->graph->nodes;
    double direction[3];
    uint32_t node = ends[0];
    hatch_vec_sub(&nodes[3 * (size_t)ends[1]], &nodes[3 * (size_t)ends[0]], direction);
    double length = hatch_vec_normalize(direction);
    *count = 0;
    while (node != ends[1] && *count < PATH_MAX) {
        path[*count] = step(meeting, segment, direction, &node);
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
    struct meeting meeting;
    enum hatch_status status = list_meeting(graph, bounds, scratch, &meeting, err);
    for (uint32_t s = 0; s < graph->segment_count && status == HATCH_OK; s++) {
        uint32_t path[PATH_MAX], count;
        if (!bounds[s] || !find_path(&meeting, s, path, &count))
            continue;
        pruned[s] = 1;
        for (uint32_t i = 0; i < count; i++)
            pruned[path[i]] = 1;
    }
    hatch_arena_rewind(scratch, mark);
    return status;
}
