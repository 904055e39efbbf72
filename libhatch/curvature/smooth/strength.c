#include <math.h>
#include <string.h>

#include "curvature/smooth/smooth.h"

/* Lengths are tried on a coarse net, each LENGTH_GROWTH times the last. Where fits and solution differ by noise alone,
 * the part of the difference that turns the axes has twice the fits' variance, and exceeds 1.6 times it on a fifth of
 * the area. A coarse net averages fits that share points; the smaller TURN_MAX allows for that, and was chosen on the
 * shapes of tests/bench/bench_dirfield.sh. The part that scales Q does not count: its bias is harmless. */
#define LEVEL 2u
#define LENGTH_MIN 1.0
#define LENGTH_GROWTH 1.6
#define LENGTHS_MAX 8
#define TURN_MAX 0.6 /* squared, in the fits' variances */
#define TURNED_MAX 0.2
#define STEPS_LENGTH 10u /* of conjugate gradients, for each length */
#define TOLERANCE_LENGTH 1e-2

#define STEPS 30u
#define TOLERANCE 3e-3

#define LENGTH_OF_STRENGTH 0.24 /* ℓ⁴ = this · strength · variance: a point answers by a half within ℓ */

static void set_bending(const struct hatch_smoothing *s, struct hatch_curvature_net *net)
{
    for (uint32_t n = 0; n < net->graph->surface.point_count; n++) {
        uint32_t c = net->graph->surface.point_component[n];
        double ratio = net->spacing[n] > 0 ? s->length[c] / net->spacing[n] : 0;
        net->bending[n] = net->area[n] * ratio * ratio * ratio * ratio / (LENGTH_OF_STRENGTH * s->typical[c]);
    }
}

/* Finds, per component, the share of the area where a fit turns against the solution by more than its noise. */
static void find_turned(const struct hatch_smoothing *s, const struct hatch_curvature_net *net, double *turned,
                        double *area)
{
    uint32_t components = s->run->graph.surface.component_count;
    memset(turned, 0, components * sizeof *turned);
    memset(area, 0, components * sizeof *area);
    for (size_t n = 0; n < net->graph->surface.point_count; n++) {
        const double *z = &net->z[HATCH_NET_CHANNELS * n], *fit = &net->fit[HATCH_NET_CHANNELS * n];
        uint32_t c = net->graph->surface.point_component[n];
        if (!(net->certainty[n] > 0))
            continue;
        double across = z[0] * fit[1] - z[1] * fit[0], variance = 4 * net->area[n] / net->certainty[n];
        area[c] += net->area[n];
        if (across * across > TURN_MAX * variance * (z[0] * z[0] + z[1] * z[1]))
            turned[c] += net->area[n];
    }
    for (uint32_t c = 0; c < components; c++)
        turned[c] = area[c] > 0 ? turned[c] / area[c] : 1;
}

/* Chooses the length at which a share of TURNED_MAX is turned, between the last two tried. */
static enum hatch_status choose_lengths(struct hatch_smoothing *s, struct hatch_curvature_net *net,
                                        struct hatch_arena *scratch, struct hatch_err *err)
{
    uint32_t components = s->run->graph.surface.component_count;
    double *turned, *last, *area;
    bool *done, more = true;
    struct hatch_arena_mark mark = hatch_arena_mark(scratch);
    HATCH_TRY(HATCH_ALLOC(scratch, &turned, components, err));
    HATCH_TRY(HATCH_ALLOC(scratch, &last, components, err));
    HATCH_TRY(HATCH_ALLOC(scratch, &area, components, err));
    HATCH_TRY(HATCH_ALLOC(scratch, &done, components, err));
    for (uint32_t c = 0; c < components; c++)
        s->length[c] = LENGTH_MIN;
    memcpy(net->z, net->fit, HATCH_NET_CHANNELS * net->graph->surface.point_count * sizeof *net->z);
    for (int i = 0; more && i < LENGTHS_MAX; i++) {
        set_bending(s, net);
        HATCH_TRY(hatch_curvature_net_solve(net, TOLERANCE_LENGTH, STEPS_LENGTH, scratch, err));
        find_turned(s, net, turned, area);
        more = false;
        for (uint32_t c = 0; c < components; c++) {
            if (done[c])
                continue;
            done[c] = turned[c] > TURNED_MAX;
            double step = done[c] ? (i ? (TURNED_MAX - last[c]) / (turned[c] - last[c]) : 1) - 1 : 1;
            s->length[c] *= pow(LENGTH_GROWTH, step);
            last[c] = turned[c];
            more = more || !done[c];
        }
    }
    hatch_arena_rewind(scratch, mark);
    return HATCH_OK;
}

enum hatch_status hatch_smooth_solve(struct hatch_smoothing *s, struct hatch_arena *scratch, struct hatch_err *err)
{
    uint32_t level = s->net_count > LEVEL ? LEVEL : s->net_count - 1;
    HATCH_TRY(choose_lengths(s, &s->nets[level], scratch, err));
    for (uint32_t k = level + 1; k-- > 0;) {
        set_bending(s, &s->nets[k]);
        if (k < level)
            HATCH_TRY(hatch_curvature_net_prolong(&s->nets[k + 1], scratch, err));
        HATCH_TRY(hatch_curvature_net_solve(&s->nets[k], TOLERANCE, STEPS, scratch, err));
    }
    return HATCH_OK;
}
