/* Replaces polylines of silhouettes by curves. */
#include <string.h>

#include "math/vector.h"
#include "line/trace.h"

#define PARTS 4u            /* segments that a curve is divided into */
#define COS_TURN_MIN 0.9994 /* turns below 2 degrees look straight */
#define COS_TURN_MAX 0.57   /* turns above 55 degrees may be corners of the surface */
#define REACH 0.5           /* how far beyond a segment its tangent is looked for, in lengths of the segment */
#define STEPS_MAX 16u

struct work {
    const struct hatch_line_trace *from;
    const struct hatch_line_chains *chains;
    struct hatch_line_trace trace;
    struct hatch_line_chains refined;
};

static const double *node_at(const struct work *w, uint32_t node)
{
    return &w->from->nodes[3 * (size_t)node];
}

/* Returns the position of the first node along a chain that is at least `distance` from node i; NULL if the chain ends
 * or has a corner before that. */
static const double *reach(const struct work *w, const struct hatch_line_chain *chain, const uint32_t *nodes,
                           uint32_t i, bool forward, double distance)
{
    const double *from = node_at(w, nodes[i]);
    uint32_t count = chain->segment_count;
    for (uint32_t step = 0; step < STEPS_MAX; step++) {
        if (!w->from->smooth[nodes[i]] || (!chain->closed && i == (forward ? count : 0)))
            return NULL;
        if (forward)
            i = i < count ? i + 1 : 1;
        else
            i = i > 0 ? i - 1 : count - 1;
        if (hatch_vec_distance(from, node_at(w, nodes[i])) >= distance)
            return node_at(w, nodes[i]);
    }
    return NULL;
}

/* Computes the tangent of a segment at its first or last node, i: that of the circle through both ends of the segment
 * and a point of the line beyond the node. This point is not simply the next node, because a short neighbour would not
 * show how a long segment bends. Returns false if the chain ends, has a corner, or is straight there. */
static bool tangent(const struct work *w, const struct hatch_line_chain *chain, const uint32_t *nodes, uint32_t i,
                    bool first, double out[3])
{
    const double *at = node_at(w, nodes[i]), *end = node_at(w, nodes[first ? i + 1 : i - 1]);
    const double *other = reach(w, chain, nodes, i, !first, REACH * hatch_vec_distance(at, end));
    if (!other)
        return false;
    double a[3], b[3];
    hatch_vec_sub(at, first ? other : end, a);
    hatch_vec_sub(first ? end : other, at, b);
    double length_a = hatch_vec_normalize(a), length_b = hatch_vec_normalize(b);
    double cosine = hatch_vec_dot(a, b);
    for (int k = 0; k < 3; k++)
        out[k] = a[k] * length_b + b[k] * length_a;
    return cosine < COS_TURN_MIN && cosine > COS_TURN_MAX && hatch_vec_normalize(out) > 0;
}

/* Appends a segment to a chain. */
static void add(struct work *w, struct hatch_line_chain *chain, uint32_t *nodes, uint32_t end, float slack)
{
    uint32_t segment = w->trace.segment_count++;
    w->trace.slack[segment] = slack;
    w->refined.segments[segment] = segment;
    nodes[++chain->segment_count] = end;
}

/* Appends all segments but the last of the cubic from p to q with the given tangents. */
static void add_curve(struct work *w, struct hatch_line_chain *chain, uint32_t *nodes, const double *p, const double *q,
                      const double tangents[2][3], float slack)
{
    double length = hatch_vec_distance(p, q);
    for (uint32_t part = 1; part < PARTS; part++) {
        double t = (double)part / PARTS, s = 1 - t;
        double *at = &w->trace.nodes[3 * (size_t)w->trace.node_count];
        for (int k = 0; k < 3; k++)
            at[k] = s * s * (1 + 2 * t) * p[k] + t * t * (3 - 2 * t) * q[k] +
                    length * s * t * (s * tangents[0][k] - t * tangents[1][k]);
        add(w, chain, nodes, w->trace.node_count++, slack);
    }
}

static void refine_chain(struct work *w, uint32_t number)
{
    const struct hatch_line_chain *chain = &w->chains->chains[number];
    const uint32_t *from = &w->chains->nodes[chain->first + number];
    struct hatch_line_chain *made = &w->refined.chains[number];
    *made = *chain;
    made->first = w->trace.segment_count;
    made->segment_count = 0;
    uint32_t *nodes = &w->refined.nodes[made->first + number];
    nodes[0] = from[0];
    for (uint32_t i = 0; i < chain->segment_count; i++) {
        const double *p = &w->from->nodes[3 * (size_t)from[i]];
        const double *q = &w->from->nodes[3 * (size_t)from[i + 1]];
        float slack = w->from->slack[w->chains->segments[chain->first + i]];
        double tangents[2][3];
        bool curved = false;
        for (uint32_t k = 0; k < 2; k++) {
            if (tangent(w, chain, from, i + k, k == 0, tangents[k])) {
                curved = true;
                continue;
            }
            hatch_vec_sub(q, p, tangents[k]);
            hatch_vec_normalize(tangents[k]);
        }
        if (curved)
            add_curve(w, made, nodes, p, q, (const double(*)[3])tangents, slack);
        add(w, made, nodes, from[i + 1], slack);
    }
}

enum hatch_status hatch_line_refine(struct hatch_line_trace *trace, struct hatch_line_chains *chains,
                                    struct hatch_arena *arena, struct hatch_err *err)
{
    size_t most = (size_t)PARTS * trace->segment_count;
    struct work w = {.from = trace, .chains = chains};
    w.trace.node_count = trace->node_count;
    w.refined.count = chains->count;
    HATCH_TRY(HATCH_ALLOC(arena, &w.trace.nodes, 3 * (trace->node_count + most), err));
    HATCH_TRY(HATCH_ALLOC(arena, &w.trace.slack, most, err));
    HATCH_TRY(HATCH_ALLOC(arena, &w.refined.chains, chains->count, err));
    HATCH_TRY(HATCH_ALLOC(arena, &w.refined.nodes, most + chains->count, err));
    HATCH_TRY(HATCH_ALLOC(arena, &w.refined.segments, most, err));
    if (trace->node_count)
        memcpy(w.trace.nodes, trace->nodes, 3 * sizeof(double) * trace->node_count);
    for (uint32_t i = 0; i < chains->count; i++)
        refine_chain(&w, i);
    *trace = w.trace;
    *chains = w.refined;
    return HATCH_OK;
}
