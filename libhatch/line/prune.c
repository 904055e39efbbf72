#include "line/prune.h"

#include <math.h>
#include <string.h>

#include "math/vector.h"

#define ROUNDS 3         /* each round removes chains whose ends became free in the round before */
#define SEGMENTS_MIN 4u  /* least number of segments of a chain with a free end */
#define LENGTH_MIN 0.03  /* least length of a chain with a free end, in diagonals of the mesh */
#define TURN_MAX_RAD 0.7 /* largest mean angle between successive segments of a chain with a free end */

/* State of pruning; graph holds the segments that remain. */
struct pruning {
    const struct hatch_line_graph *whole;
    const uint8_t *bounds;         /* per segment of the whole: not 0: a boundary */
    const uint8_t *flat;           /* per segment of the whole: not 0: between planes */
    double size;                   /* of the mesh */
    uint8_t *pruned;               /* per segment of the whole: 1: removed */
    struct hatch_line_graph graph; /* of the remaining segments */
    uint32_t *ends, *number;       /* ends: those of graph; number: per segment of graph, its number in the whole */
    uint8_t *degree;               /* per node: number of remaining segments there, at most 3 */
};

static void collect_remaining(struct pruning *p)
{
    const struct hatch_line_graph *graph = p->whole;
    uint32_t count = 0;
    memset(p->degree, 0, graph->node_count);
    for (uint32_t s = 0; s < graph->segment_count; s++) {
        if (p->pruned[s])
            continue;
        for (uint32_t end = 2 * s; end < 2 * s + 2; end++)
            if (p->degree[graph->ends[end]] < 3)
                p->degree[graph->ends[end]]++;
        p->number[count] = s;
        p->ends[2 * count] = graph->ends[2 * s];
        p->ends[2 * count + 1] = graph->ends[2 * s + 1];
        count++;
    }
    p->graph = *graph;
    p->graph.segment_count = count;
    p->graph.ends = p->ends;
}

struct shape {
    double length, turning_rad; /* of a chain */
    bool isolated;              /* no other segment meets it */
};

static void measure(const struct pruning *p, const struct hatch_line_chain *chain, const uint32_t *nodes,
                    struct shape *shape)
{
    double along[3], before[3] = {0, 0, 0};
    *shape = (struct shape){.isolated = true};
    for (uint32_t i = 0; i < chain->segment_count; i++) {
        const double *a = &p->graph.nodes[3 * (size_t)nodes[i]];
        const double *b = &p->graph.nodes[3 * (size_t)nodes[i + 1]];
        hatch_vec_sub(b, a, along);
        shape->length += hatch_vec_normalize(along);
        if (i > 0)
            shape->turning_rad += acos(fmax(-1, fmin(1, hatch_vec_dot(along, before))));
        hatch_vec_copy(along, before);
        shape->isolated = shape->isolated && p->degree[nodes[i]] == 2;
    }
}

/* Returns whether all segments of a chain lie between planes.
 *   segments  of the remaining graph, in order */
static bool is_flat(const struct pruning *p, const struct hatch_line_chain *chain, const uint32_t *segments)
{
    uint32_t flat = 0;
    for (uint32_t k = 0; k < chain->segment_count; k++)
        flat += p->flat[p->number[segments[k]]] != 0;
    return flat == chain->segment_count;
}

/* Returns whether a chain is due to noise. */
static bool is_stray(const struct pruning *p, const struct hatch_line_chain *chain, const uint32_t *nodes,
                     const uint32_t *segments)
{
    struct shape shape;
    measure(p, chain, nodes, &shape);
    bool few = chain->segment_count < SEGMENTS_MIN, small = shape.length < LENGTH_MIN * p->size;
    if (chain->closed)
        return shape.isolated && few && small;
    if (chain->joined[0] && chain->joined[1])
        return false;
    few = few && !is_flat(p, chain, segments);
    return few || small || shape.turning_rad > TURN_MAX_RAD * (chain->segment_count - 1);
}

/* Removes the stray chains of the remaining segments.
 *   found  out: number of segments removed */
static enum hatch_status prune_once(struct pruning *p, struct hatch_arena *arena, struct hatch_arena *scratch,
                                    uint32_t *found, struct hatch_err *err)
{
    struct hatch_line_chains chains;
    HATCH_TRY(hatch_line_chains_make(&p->graph, arena, scratch, &chains, err));
    *found = 0;
    for (uint32_t i = 0; i < chains.count; i++) {
        const struct hatch_line_chain *chain = &chains.chains[i];
        bool stray = is_stray(p, chain, &chains.nodes[chain->first + i], &chains.segments[chain->first]);
        for (uint32_t k = 0; k < chain->segment_count; k++) {
            uint32_t segment = p->number[chains.segments[chain->first + k]];
            p->pruned[segment] = stray && !p->bounds[segment];
            *found += p->pruned[segment];
        }
    }
    return HATCH_OK;
}

enum hatch_status hatch_line_prune(const struct hatch_line_graph *graph, const uint8_t *bounds, const uint8_t *flat,
                                   double size, struct hatch_arena *arena, struct hatch_arena *scratch, uint8_t *pruned,
                                   struct hatch_err *err)
{
    struct hatch_arena_mark mark = hatch_arena_mark(arena);
    struct pruning p = {.whole = graph, .bounds = bounds, .flat = flat, .size = size, .pruned = pruned};
    enum hatch_status status = HATCH_LIMIT;
    uint32_t found = 1;
    p.ends = HATCH_NEW(arena, uint32_t, 2 * (size_t)graph->segment_count, err);
    p.number = p.ends ? HATCH_NEW(arena, uint32_t, graph->segment_count, err) : NULL;
    p.degree = p.number ? HATCH_NEW(arena, uint8_t, graph->node_count, err) : NULL;
    if (p.degree)
        status = HATCH_OK;
    for (int round = 0; round < ROUNDS && found && status == HATCH_OK; round++) {
        collect_remaining(&p);
        status = prune_once(&p, arena, scratch, &found, err);
    }
    hatch_arena_rewind(arena, mark);
    return status;
}
