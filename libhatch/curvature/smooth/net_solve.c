#include <string.h>

#include "curvature/smooth/net.h"

/* out = A z, A = c + Dᵀ b D with D the difference to the linear fit. */
static void apply(const struct hatch_curvature_net *net, const double *z, double *out)
{
    const struct hatch_surface *s = &net->graph->surface;
    for (size_t n = 0; n < s->point_count; n++)
        for (uint32_t k = 0; k < HATCH_NET_CHANNELS; k++)
            out[HATCH_NET_CHANNELS * n + k] = net->certainty[n] * z[HATCH_NET_CHANNELS * n + k];
    for (size_t n = 0; n < s->point_count; n++) {
        double own = net->own[n], re = own * z[3 * n], im = own * z[3 * n + 1], mean = own * z[3 * n + 2];
        uint32_t first = s->ring_first[n], end = s->ring_first[n + 1];
        for (uint32_t i = first; i < end; i++) {
            const double *q = &z[3 * (size_t)s->ring_point[i]], *turn = &net->turn[2 * (size_t)i];
            double weight = net->weight[i], side = s->ring_turned[i] ? -1 : 1, real = side * q[0];
            re -= weight * (turn[0] * real - turn[1] * q[1]);
            im -= weight * (turn[1] * real + turn[0] * q[1]);
            mean -= weight * side * q[2];
        }
        double b = net->bending[n];
        re *= b;
        im *= b;
        mean *= b;
        out[3 * n] += own * re;
        out[3 * n + 1] += own * im;
        out[3 * n + 2] += own * mean;
        for (uint32_t i = first; i < end; i++) {
            double *q = &out[3 * (size_t)s->ring_point[i]], weight = net->weight[i], side = s->ring_turned[i] ? -1 : 1;
            const double *turn = &net->turn[2 * (size_t)i];
            q[0] -= weight * side * (turn[0] * re + turn[1] * im);
            q[1] -= weight * (turn[0] * im - turn[1] * re);
            q[2] -= weight * side * mean;
        }
    }
}

static void find_diagonal(const struct hatch_curvature_net *net, double *inverse)
{
    const struct hatch_surface *s = &net->graph->surface;
    for (uint32_t n = 0; n < s->point_count; n++)
        inverse[n] = net->certainty[n] + net->bending[n] * net->own[n] * net->own[n];
    for (uint32_t n = 0; n < s->point_count; n++)
        for (uint32_t i = s->ring_first[n]; i < s->ring_first[n + 1]; i++)
            inverse[s->ring_point[i]] += net->bending[n] * net->weight[i] * net->weight[i];
    for (uint32_t n = 0; n < s->point_count; n++)
        inverse[n] = inverse[n] > 0 ? 1 / inverse[n] : 0;
}

/* Conjugate gradients, in which each component has steps of its own. */
struct gradients {
    struct hatch_curvature_net *net;
    double *r, *s, *d, *ad; /* 3 per node: residual, the same over the diagonal, search direction, A d */
    double *inverse;        /* per node: of the diagonal */
    /* Per component. */
    double *limit;        /* of r · s, where it ends */
    double *now, *before; /* r · s in this step and in the last */
    double *curve;        /* d · A d */
    double *length;       /* of the step; 0: ended */
};

static enum hatch_status allocate(struct gradients *g, struct hatch_arena *scratch, struct hatch_err *err)
{
    size_t nodes = g->net->graph->surface.point_count, components = g->net->graph->surface.component_count;
    double **vectors[] = {&g->r, &g->s, &g->d, &g->ad};
    double **sums[] = {&g->limit, &g->now, &g->before, &g->curve, &g->length};
    for (size_t i = 0; i < sizeof vectors / sizeof *vectors; i++)
        HATCH_TRY(HATCH_ALLOC(scratch, vectors[i], HATCH_NET_CHANNELS * nodes, err));
    for (size_t i = 0; i < sizeof sums / sizeof *sums; i++)
        HATCH_TRY(HATCH_ALLOC(scratch, sums[i], components, err));
    return HATCH_ALLOC(scratch, &g->inverse, nodes, err);
}

/* Computes a · b per component. */
static void dot(const struct hatch_surface *surface, const double *a, const double *b, double *sums)
{
    memset(sums, 0, surface->component_count * sizeof *sums);
    for (size_t n = 0; n < surface->point_count; n++)
        for (size_t i = HATCH_NET_CHANNELS * n; i < HATCH_NET_CHANNELS * (n + 1); i++)
            sums[surface->point_component[n]] += a[i] * b[i];
}

static void begin(const struct gradients *g, double tolerance)
{
    const struct hatch_curvature_net *net = g->net;
    const struct hatch_surface *surface = &net->graph->surface;
    find_diagonal(net, g->inverse);
    apply(net, net->z, g->ad);
    for (size_t n = 0; n < surface->point_count; n++)
        for (size_t i = HATCH_NET_CHANNELS * n; i < HATCH_NET_CHANNELS * (n + 1); i++) {
            double right = net->certainty[n] * net->fit[i];
            g->r[i] = right - g->ad[i];
            g->limit[surface->point_component[n]] += right * right * g->inverse[n];
        }
    for (uint32_t c = 0; c < surface->component_count; c++)
        g->limit[c] *= tolerance * tolerance;
}

/* Makes a step in the components that have not ended. Returns whether there are any. */
static bool step(const struct gradients *g)
{
    const struct hatch_surface *surface = &g->net->graph->surface;
    bool more = false;
    for (size_t i = 0; i < HATCH_NET_CHANNELS * (size_t)surface->point_count; i++)
        g->s[i] = g->inverse[i / HATCH_NET_CHANNELS] * g->r[i];
    dot(surface, g->r, g->s, g->now);
    for (uint32_t c = 0; c < surface->component_count; c++)
        more = more || g->now[c] > g->limit[c];
    if (!more)
        return false;
    for (size_t n = 0; n < surface->point_count; n++) {
        uint32_t c = surface->point_component[n];
        double keep = g->before[c] > 0 ? g->now[c] / g->before[c] : 0;
        for (size_t i = HATCH_NET_CHANNELS * n; i < HATCH_NET_CHANNELS * (n + 1); i++)
            g->d[i] = g->s[i] + keep * g->d[i];
    }
    apply(g->net, g->d, g->ad);
    dot(surface, g->d, g->ad, g->curve);
    for (uint32_t c = 0; c < surface->component_count; c++)
        g->length[c] = g->now[c] > g->limit[c] ? g->now[c] / g->curve[c] : 0;
    for (size_t n = 0; n < surface->point_count; n++) {
        double length = g->length[surface->point_component[n]];
        for (size_t i = HATCH_NET_CHANNELS * n; length > 0 && i < HATCH_NET_CHANNELS * (n + 1); i++) {
            g->net->z[i] += length * g->d[i];
            g->r[i] -= length * g->ad[i];
        }
    }
    memcpy(g->before, g->now, surface->component_count * sizeof *g->before);
    return true;
}

enum hatch_status hatch_curvature_net_solve(struct hatch_curvature_net *net, double tolerance, uint32_t steps_max,
                                            struct hatch_arena *scratch, struct hatch_err *err)
{
    struct gradients g = {.net = net};
    struct hatch_arena_mark mark = hatch_arena_mark(scratch);
    enum hatch_status status = allocate(&g, scratch, err);
    if (status == HATCH_OK) {
        begin(&g, tolerance);
        for (uint32_t done = 0; done < steps_max && step(&g); done++)
            ;
    }
    hatch_arena_rewind(scratch, mark);
    return status;
}
