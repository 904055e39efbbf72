/* Makes silhouettes smooth within about a pixel of the faces' edges. */
#include <string.h>

#include "math/vector.h"
#include "line/trace.h"

#define WINDOW_PX 8.0 /* nodes move towards the mean of the chain up to this far along it */
#define TAPS 8        /* positions to either side that the mean is taken of */
#define WALK_MAX 256u /* segments that are followed for it; shorter ones need no smoothing */
#define MOVE_PX 0.5   /* largest movement of a node */

#define PARTS 4u            /* segments that a curve is divided into */
#define COS_TURN_MIN 0.9994 /* turns below 2 degrees look straight */
#define COS_TURN_MAX 0.57   /* turns above 55 degrees may be corners of the surface */
#define REACH 0.5           /* how far beyond a segment its tangent is looked for, in lengths of the segment */
#define STEPS_MAX 16u
#define BULGE_PX 0.5 /* largest distance of a curve from its segment */

struct work {
    const struct hatch_line_eye *eye;
    const struct hatch_line_trace *from;
    const struct hatch_line_chains *chains;
    double *places; /* 2 per node: pixels from the middle of the picture; NAN behind the near plane */
    double *smooth; /* the same after the nodes have moved */
    struct hatch_line_trace trace;
    struct hatch_line_chains refined;
};

/* A chain, whose nodes are addressed by their number along it. */
struct run {
    const struct hatch_line_chain *chain;
    const uint32_t *nodes;
    const double *places;
    const uint8_t *fixed;
};

static const double *place_at(const struct run *run, uint32_t i)
{
    return &run->places[2 * (size_t)run->nodes[i]];
}

static double distance(const double a[2], const double b[2])
{
    return sqrt((a[0] - b[0]) * (a[0] - b[0]) + (a[1] - b[1]) * (a[1] - b[1]));
}

/* Moves to the next node along a chain, or to the one before; returns false at an end of the chain. */
static bool advance(const struct run *run, bool forward, uint32_t *i)
{
    uint32_t count = run->chain->segment_count;
    if (*i == (forward ? count : 0)) {
        if (!run->chain->closed)
            return false;
        *i = forward ? 0 : count;
    }
    *i += forward ? 1u : UINT32_MAX;
    return true;
}

static void find_places(struct work *w)
{
    const struct hatch_view *view = w->eye->view;
    for (uint32_t i = 0; i < w->from->node_count; i++) {
        const double *node = &w->from->nodes[3 * (size_t)i];
        double from[3], pixel = hatch_line_pixel(w->eye, node);
        bool ahead = view->orthographic || hatch_line_depth(view, node) > view->near;
        hatch_vec_sub(node, view->eye, from);
        w->places[2 * (size_t)i] = ahead ? hatch_vec_dot(from, view->right) / pixel : NAN;
        w->places[2 * (size_t)i + 1] = ahead ? hatch_vec_dot(from, view->up) / pixel : NAN;
    }
}

/* Adds the weighted positions at equal distances along a chain from node i, up to WINDOW_PX away. Returns false where
 * the chain ends, leaves the picture's side of the near plane, or has too many segments before that. */
static bool add_taps(const struct run *run, uint32_t i, bool forward, double sum[2])
{
    const double step = WINDOW_PX / (TAPS + 1);
    double before = 0;
    int tap = 1;
    for (uint32_t walked = 0; tap <= TAPS; walked++) {
        const double *a = place_at(run, i);
        if (walked == WALK_MAX || !advance(run, forward, &i))
            return false;
        const double *b = place_at(run, i);
        double length = distance(a, b);
        if (!isfinite(length))
            return false;
        for (; tap <= TAPS && tap * step <= before + length; tap++) {
            double t = (tap * step - before) / length, weight = 1.0 - (double)tap / (TAPS + 1);
            for (int k = 0; k < 2; k++)
                sum[k] += weight * (a[k] + t * (b[k] - a[k]));
        }
        before += length;
    }
    return true;
}

/* Returns the share of a movement that keeps it within a limit. */
static double within(double x, double y, double most)
{
    double size = sqrt(x * x + y * y);
    return size > most ? most / size : 1;
}

/* Moves the nodes of a chain in the picture towards the mean of the chain around them. */
static void move_nodes(struct work *w, uint32_t number)
{
    const struct hatch_line_chain *chain = &w->chains->chains[number];
    const struct run run = {chain, &w->chains->nodes[chain->first + number], w->places, w->from->fixed};
    const struct hatch_view *view = w->eye->view;
    for (uint32_t i = 0; i <= chain->segment_count; i++) {
        const double *at = place_at(&run, i);
        double sum[2] = {at[0], at[1]}, move[2];
        if (w->from->fixed[run.nodes[i]] || !isfinite(at[0]) || !add_taps(&run, i, true, sum) ||
            !add_taps(&run, i, false, sum))
            continue;
        for (int k = 0; k < 2; k++)
            move[k] = sum[k] / (TAPS + 1) - at[k];
        double share = within(move[0], move[1], MOVE_PX), *node = &w->trace.nodes[3 * (size_t)run.nodes[i]];
        double pixel = hatch_line_pixel(w->eye, &w->from->nodes[3 * (size_t)run.nodes[i]]);
        for (int k = 0; k < 2; k++)
            w->smooth[2 * (size_t)run.nodes[i] + (size_t)k] = at[k] + share * move[k];
        hatch_vec_copy(&w->from->nodes[3 * (size_t)run.nodes[i]], node);
        hatch_vec_add_scaled(node, share * move[0] * pixel, view->right, node);
        hatch_vec_add_scaled(node, share * move[1] * pixel, view->up, node);
    }
}

/* Returns the place of the first node along a chain that is at least `least` pixels from node i; NULL if the chain ends
 * or has a crease before that. */
static const double *reach(const struct run *run, uint32_t i, bool forward, double least)
{
    const double *from = place_at(run, i);
    for (uint32_t step = 0; step < STEPS_MAX && !run->fixed[run->nodes[i]] && advance(run, forward, &i); step++)
        if (distance(from, place_at(run, i)) >= least)
            return place_at(run, i);
    return NULL;
}

/* Computes the tangent of a segment at its first or last node, i: that of the circle through both ends of the segment
 * and a point of the chain beyond the node. This point is not simply the next node, because a short neighbour would not
 * show how a long segment bends. The tangent is the segment's own direction if the chain ends, has a corner or a
 * crease, or is straight there. */
static bool tangent(const struct run *run, uint32_t i, bool first, double out[2])
{
    const double *at = place_at(run, i), *end = place_at(run, first ? i + 1 : i - 1);
    double length = distance(at, end);
    for (int k = 0; k < 2; k++)
        out[k] = (first ? end[k] - at[k] : at[k] - end[k]) / length;
    const double *other = length > 0 && !run->fixed[run->nodes[i]] ? reach(run, i, !first, REACH * length) : NULL;
    if (!other)
        return false;
    double beyond = distance(at, other), toward[2], sum[2];
    for (int k = 0; k < 2; k++) {
        toward[k] = (first ? at[k] - other[k] : other[k] - at[k]) / beyond;
        sum[k] = toward[k] * length + out[k] * beyond;
    }
    double cosine = toward[0] * out[0] + toward[1] * out[1], size = sqrt(sum[0] * sum[0] + sum[1] * sum[1]);
    if (!(cosine < COS_TURN_MIN && cosine > COS_TURN_MAX))
        return false;
    for (int k = 0; k < 2; k++)
        out[k] = sum[k] / size;
    return true;
}

/* Appends a segment to a chain. */
static void add(struct work *w, struct hatch_line_chain *chain, uint32_t *nodes, uint32_t end, uint32_t like)
{
    uint32_t segment = w->trace.segment_count++;
    w->trace.slack_px[segment] = w->from->slack_px[like];
    w->trace.surface[segment] = w->from->surface[like];
    w->refined.segments[segment] = segment;
    nodes[++chain->segment_count] = end;
}

/* Appends all segments but the last of the cubic with the given tangents over the segment after node i, at a distance
 * of at most BULGE_PX from it. */
static void add_curve(struct work *w, const struct run *run, uint32_t i, const double tangents[2][2], uint32_t like,
                      struct hatch_line_chain *chain, uint32_t *nodes)
{
    const double *p = place_at(run, i), *q = place_at(run, i + 1);
    const struct hatch_view *view = w->eye->view;
    double length = distance(p, q), ease[2][2], share = 1, bulge[PARTS][2];
    for (int k = 0; k < 2; k++)
        for (int end = 0; end < 2; end++)
            ease[end][k] = length * tangents[end][k] - (q[k] - p[k]);
    for (uint32_t part = 1; part < PARTS; part++) {
        double t = (double)part / PARTS, s = 1 - t;
        for (int k = 0; k < 2; k++)
            bulge[part][k] = s * t * (s * ease[0][k] - t * ease[1][k]);
        share = fmin(share, within(bulge[part][0], bulge[part][1], BULGE_PX));
    }
    for (uint32_t part = 1; part < PARTS; part++) {
        double *at = &w->trace.nodes[3 * (size_t)w->trace.node_count], along[3];
        const double *a = &w->trace.nodes[3 * (size_t)run->nodes[i]];
        hatch_vec_sub(&w->trace.nodes[3 * (size_t)run->nodes[i + 1]], a, along);
        hatch_vec_add_scaled(a, (double)part / PARTS, along, at);
        double pixel = share * hatch_line_pixel(w->eye, at);
        hatch_vec_add_scaled(at, bulge[part][0] * pixel, view->right, at);
        hatch_vec_add_scaled(at, bulge[part][1] * pixel, view->up, at);
        add(w, chain, nodes, w->trace.node_count++, like);
    }
}

static void refine_chain(struct work *w, uint32_t number)
{
    const struct hatch_line_chain *chain = &w->chains->chains[number];
    const struct run run = {chain, &w->chains->nodes[chain->first + number], w->smooth, w->from->fixed};
    struct hatch_line_chain *made = &w->refined.chains[number];
    *made = *chain;
    made->first = w->trace.segment_count;
    made->segment_count = 0;
    uint32_t *nodes = &w->refined.nodes[made->first + number];
    nodes[0] = run.nodes[0];
    for (uint32_t i = 0; i < chain->segment_count; i++) {
        uint32_t segment = w->chains->segments[chain->first + i], first = w->trace.segment_count;
        double tangents[2][2];
        bool curved = tangent(&run, i, true, tangents[0]);
        curved = tangent(&run, i + 1, false, tangents[1]) || curved;
        if (curved)
            add_curve(w, &run, i, (const double(*)[2])tangents, segment, made, nodes);
        add(w, made, nodes, run.nodes[i + 1], segment);
        if (w->from->ends[2 * (size_t)segment] != run.nodes[i])
            for (uint32_t k = first; k < w->trace.segment_count; k++)
                w->trace.surface[k] = (int8_t)-w->trace.surface[k];
    }
}

enum hatch_status hatch_line_refine(const struct hatch_line_eye *eye, struct hatch_line_trace *trace,
                                    struct hatch_line_chains *chains, struct hatch_arena *arena, struct hatch_err *err)
{
    size_t most = (size_t)PARTS * trace->segment_count, places = 2 * (size_t)trace->node_count;
    struct work w = {.eye = eye, .from = trace, .chains = chains};
    w.trace.node_count = trace->node_count;
    w.refined.count = chains->count;
    HATCH_TRY(HATCH_ALLOC(arena, &w.places, places, err));
    HATCH_TRY(HATCH_ALLOC(arena, &w.smooth, places, err));
    HATCH_TRY(HATCH_ALLOC(arena, &w.trace.nodes, 3 * (trace->node_count + most), err));
    HATCH_TRY(HATCH_ALLOC(arena, &w.trace.slack_px, most, err));
    HATCH_TRY(HATCH_ALLOC(arena, &w.trace.surface, most, err));
    HATCH_TRY(HATCH_ALLOC(arena, &w.refined.chains, chains->count, err));
    HATCH_TRY(HATCH_ALLOC(arena, &w.refined.nodes, most + chains->count, err));
    HATCH_TRY(HATCH_ALLOC(arena, &w.refined.segments, most, err));
    find_places(&w);
    if (trace->node_count) {
        memcpy(w.trace.nodes, trace->nodes, 3 * sizeof(double) * trace->node_count);
        memcpy(w.smooth, w.places, sizeof(double) * places);
    }
    for (uint32_t i = 0; i < chains->count; i++)
        move_nodes(&w, i);
    for (uint32_t i = 0; i < chains->count; i++)
        refine_chain(&w, i);
    *trace = w.trace;
    *chains = w.refined;
    return HATCH_OK;
}
