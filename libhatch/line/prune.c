#include "line/prune.h"

#include <math.h>
#include <string.h>

#include "math/vector.h"

#define ROUNDS 3 /* of dropping what hung on what was dropped */
#define SEGMENTS_MIN 4u
#define LENGTH_MIN 0.03  /* of the whole's size */
#define TURN_MAX_RAD 0.7 /* from segment to segment, in the mean */

/* The part of a graph that is left, with its segments' numbers in the whole. */
struct rest {
    struct hatch_line_graph graph;
    uint32_t *ends, *number;
    uint8_t *meeting; /* per node: how many segments end there, up to 3 */
};

static void take_rest(const struct hatch_line_graph *graph, const uint8_t *pruned, struct rest *rest)
{
    uint32_t count = 0;
    memset(rest->meeting, 0, graph->node_count);
    for (uint32_t s = 0; s < graph->segment_count; s++) {
        if (pruned[s])
            continue;
        for (uint32_t end = 2 * s; end < 2 * s + 2; end++)
            if (rest->meeting[graph->ends[end]] < 3)
                rest->meeting[graph->ends[end]]++;
        rest->number[count] = s;
        rest->ends[2 * count] = graph->ends[2 * s];
        rest->ends[2 * count + 1] = graph->ends[2 * s + 1];
        count++;
    }
    rest->graph = *graph;
    rest->graph.segment_count = count;
    rest->graph.ends = rest->ends;
}

/* Length and turning of a chain. */
struct shape {
    double length, turned;
    bool alone; /* nothing else meets it */
};

static void measure(const struct rest *rest, const struct hatch_line_chain *chain, const uint32_t *nodes,
                    struct shape *shape)
{
    double along[3], before[3] = {0, 0, 0};
    *shape = (struct shape){.alone = true};
    for (uint32_t i = 0; i < chain->segment_count; i++) {
        const double *a = &rest->graph.nodes[3 * (size_t)nodes[i]];
        const double *b = &rest->graph.nodes[3 * (size_t)nodes[i + 1]];
        hatch_vec_sub(b, a, along);
        shape->length += hatch_vec_normalize(along);
        if (i > 0)
            shape->turned += acos(fmax(-1, fmin(1, hatch_vec_dot(along, before))));
        hatch_vec_copy(along, before);
        shape->alone = shape->alone && rest->meeting[nodes[i]] == 2;
    }
}

static bool is_stray(const struct rest *rest, const struct hatch_line_chain *chain, const uint32_t *nodes, double size)
{
    struct shape shape;
    measure(rest, chain, nodes, &shape);
    bool few = chain->segment_count < SEGMENTS_MIN, small = shape.length < LENGTH_MIN * size;
    if (chain->closed)
        return shape.alone && few && small;
    if (chain->joined[0] && chain->joined[1])
        return false;
    return few || small || shape.turned > TURN_MAX_RAD * (chain->segment_count - 1);
}

/* One round. *found: how many segments go. */
static enum hatch_status prune_once(struct rest *rest, const uint8_t *bounds, double size, struct hatch_arena *arena,
                                    struct hatch_arena *scratch, uint8_t *pruned, uint32_t *found,
                                    struct hatch_err *err)
{
    struct hatch_line_chains chains;
    HATCH_TRY(hatch_line_chains_make(&rest->graph, arena, scratch, &chains, err));
    *found = 0;
    for (uint32_t i = 0; i < chains.count; i++) {
        const struct hatch_line_chain *chain = &chains.chains[i];
        bool stray = is_stray(rest, chain, &chains.nodes[chain->first + i], size);
        for (uint32_t k = 0; k < chain->segment_count; k++) {
            uint32_t segment = rest->number[chains.segments[chain->first + k]];
            pruned[segment] = stray && !bounds[segment];
            *found += pruned[segment];
        }
    }
    return HATCH_OK;
}

enum hatch_status hatch_line_prune(const struct hatch_line_graph *graph, const uint8_t *bounds, double size,
                                   struct hatch_arena *arena, struct hatch_arena *scratch, uint8_t *pruned,
                                   struct hatch_err *err)
{
    struct hatch_arena_mark mark = hatch_arena_mark(arena);
    struct rest rest;
    enum hatch_status status = HATCH_LIMIT;
    uint32_t found = 1;
    rest.ends = HATCH_NEW(arena, uint32_t, 2 * (size_t)graph->segment_count, err);
    rest.number = rest.ends ? HATCH_NEW(arena, uint32_t, graph->segment_count, err) : NULL;
    rest.meeting = rest.number ? HATCH_NEW(arena, uint8_t, graph->node_count, err) : NULL;
    if (rest.meeting)
        status = HATCH_OK;
    for (int round = 0; round < ROUNDS && found && status == HATCH_OK; round++) {
        take_rest(graph, pruned, &rest);
        status = prune_once(&rest, bounds, size, arena, scratch, pruned, &found, err);
    }
    hatch_arena_rewind(arena, mark);
    return status;
}
