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

static double dot(size_t count, const double *a, const double *b)
{
    double sum = 0;
    for (size_t i = 0; i < count; i++)
        sum += a[i] * b[i];
    return sum;
}

enum hatch_status hatch_curvature_net_solve(struct hatch_curvature_net *net, double tolerance, uint32_t steps_max,
                                            struct hatch_arena *scratch, struct hatch_err *err)
{
    size_t nodes = net->graph->surface.point_count, size = HATCH_NET_CHANNELS * nodes;
    double *r, *d, *ad, *s, *inverse, old = 1, limit = 0;
    struct hatch_arena_mark mark = hatch_arena_mark(scratch);
    HATCH_TRY(HATCH_ALLOC(scratch, &r, size, err));
    HATCH_TRY(HATCH_ALLOC(scratch, &d, size, err));
    HATCH_TRY(HATCH_ALLOC(scratch, &ad, size, err));
    HATCH_TRY(HATCH_ALLOC(scratch, &s, size, err));
    HATCH_TRY(HATCH_ALLOC(scratch, &inverse, nodes, err));
    find_diagonal(net, inverse);
    apply(net, net->z, ad);
    for (size_t i = 0; i < size; i++) {
        double right = net->certainty[i / HATCH_NET_CHANNELS] * net->fit[i];
        r[i] = right - ad[i];
        limit += right * right * inverse[i / HATCH_NET_CHANNELS];
    }
    limit *= tolerance * tolerance;
    for (uint32_t step = 0; step < steps_max; step++) {
        for (size_t i = 0; i < size; i++)
            s[i] = inverse[i / HATCH_NET_CHANNELS] * r[i];
        double now = dot(size, r, s);
        if (!(now > limit))
            break;
        for (size_t i = 0; i < size; i++)
            d[i] = s[i] + (step ? now / old : 0) * d[i];
        apply(net, d, ad);
        double length = now / dot(size, d, ad);
        for (size_t i = 0; i < size; i++) {
            net->z[i] += length * d[i];
            r[i] -= length * ad[i];
        }
        old = now;
    }
    hatch_arena_rewind(scratch, mark);
    return HATCH_OK;
}
