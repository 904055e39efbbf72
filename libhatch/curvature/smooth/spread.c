#include <math.h>
#include <string.h>

#include "math/vector.h"
#include "curvature/smooth/smooth.h"

#define REACH 1.1 /* of a node's model, in spacings */

/* The variance of the solution, as the noise of the shapes of tests/bench/bench_dirfield.sh has it: */
#define VARIANCE_MAX 4.0   /* of a fit, in typical ones: its neighbours make up for it */
#define SUPPORT 7.0        /* smoothing over ℓ divides the variance of fits over supports of this radius */
#define LENGTH_HALF 1.15   /* by 1 + (ℓ / LENGTH_HALF)³, */
#define LEVERAGE 7.0       /* times the square of this many nodes over those around: fewer at borders */
#define BIAS_VARIANCES 9.0 /* a squared turn of the fit beyond so many variances is bias */

struct spreading {
    const struct hatch_smoothing *s;
    double (*slopes)[HATCH_NET_CHANNELS][2]; /* per node: of the solution */
    double *variance;                        /* per node: of the solution */
};

/* Returns the expected squared error of the solution at a node, with the bias by which the fit shows it to be turned.
 */
static double variance_at(const struct hatch_smoothing *s, size_t n)
{
    const struct hatch_curvature_net *net = &s->nets[0];
    const double *z = &net->z[HATCH_NET_CHANNELS * n], *fit = &net->fit[HATCH_NET_CHANNELS * n];
    uint32_t c = net->graph->surface.point_component[n];
    double square = z[0] * z[0] + z[1] * z[1], across = z[0] * fit[1] - z[1] * fit[0], turn = 0;
    if (!(s->variance[n] < INFINITY))
        return VARIANCE_MAX * s->typical[c];
    if (square > 0)
        turn = fmax(0, across * across / square / 4 - BIAS_VARIANCES * s->variance[n]);
    double length = s->length[c] * SUPPORT / s->radius[n] / LENGTH_HALF;
    double noise = fmin(s->variance[n] - s->bias[n], VARIANCE_MAX * s->typical[c]);
    double one_sided = fmax(1, LEVERAGE * (1 - net->own[n]));
    return noise * one_sided * one_sided / (1 + length * length * length) + s->bias[n] + turn;
}

/* Returns the weight of a node's model at a point, 0 beyond its reach.
 *   offset  out: of the point from the node */
static double model_weight(const struct hatch_curvature_net *net, const double point[3], uint32_t node,
                           double offset[3])
{
    double reach = REACH * net->spacing[node];
    hatch_vec_sub(point, &net->graph->surface.points[3 * (size_t)node], offset);
    double square = hatch_vec_dot(offset, offset) / (reach * reach);
    return square < 1 ? (1 - square) * (1 - square) : 0;
}

/* Adds a node's model: its plane tilted to the point, with z there.
 *   middle  offset at which z is taken: half-way between the point and the mean of the nodes, where means of linear
 *           models have no error of second order */
static void add_model(const struct spreading *spread, uint32_t node, double weight, double side, const double offset[3],
                      const double middle[3], struct hatch_curvature_sample *sample)
{
    const struct hatch_curvature_net *net = &spread->s->nets[0];
    const double *normal = &net->graph->normals[3 * (size_t)node], *z = &net->z[HATCH_NET_CHANNELS * (size_t)node];
    double at[2], here[2], value[HATCH_NET_CHANNELS], axis[3], across[3], up[3], matrix[6];
    hatch_curvature_net_local(net, node, offset, at);
    hatch_curvature_net_local(net, node, middle, here);
    for (uint32_t k = 0; k < HATCH_NET_CHANNELS; k++)
        value[k] = z[k] + spread->slopes[node][k][0] * here[0] + spread->slopes[node][k][1] * here[1];
    hatch_vec_copy(&net->axis[3 * (size_t)node], axis);
    hatch_vec_cross(normal, axis, across);
    hatch_vec_add_scaled(normal, (z[2] + z[0] / 2) * at[0] + z[1] / 2 * at[1], axis, up);
    hatch_vec_add_scaled(up, z[1] / 2 * at[0] + (z[2] - z[0] / 2) * at[1], across, up);
    hatch_vec_normalize(up);
    hatch_curvature_net_carry_tangent(normal, up, axis);
    hatch_curvature_net_tensor(up, axis, value, side * weight, matrix);
    for (int k = 0; k < 6; k++)
        sample->tensor.matrix[k] += matrix[k];
    hatch_vec_add_scaled(sample->tensor.normal, side * weight, up, sample->tensor.normal);
    sample->variance.off_diagonal += weight * spread->variance[node];
    sample->variance.mean += 2 * weight * spread->variance[node];
    sample->radius += weight * spread->s->radius[node];
}

/* Computes the sample at a point from the models of its node and the node's ring. */
static void spread_to_point(const struct spreading *spread, uint32_t node, double side, uint32_t point,
                            struct hatch_curvature_sample *sample)
{
    const struct hatch_curvature_net *net = &spread->s->nets[0];
    const struct hatch_surface *graph = &net->graph->surface;
    const double *position = &spread->s->run->graph.surface.points[3 * (size_t)point];
    uint32_t first = graph->ring_first[node], count = graph->ring_first[node + 1] - first;
    double mean[3] = {0}, sum = 0;
    *sample = (struct hatch_curvature_sample){.variance = {INFINITY, INFINITY}};
    for (uint32_t i = 0; i <= count; i++) {
        double offset[3], weight = model_weight(net, position, i ? graph->ring_point[first + i - 1] : node, offset);
        hatch_vec_add_scaled(mean, weight, offset, mean);
        sum += weight;
    }
    if (!(sum > 0))
        return;
    sample->variance = (struct hatch_curvature_variance){0, 0};
    for (uint32_t i = 0; i <= count; i++) {
        uint32_t q = i ? graph->ring_point[first + i - 1] : node;
        double offset[3], middle[3], weight = model_weight(net, position, q, offset) / sum;
        for (int k = 0; k < 3; k++)
            middle[k] = (offset[k] + mean[k] / sum) / 2;
        if (weight > 0)
            add_model(spread, q, weight, i && graph->ring_turned[first + i - 1] ? -side : side, offset, middle, sample);
    }
    if (!(hatch_vec_normalize(sample->tensor.normal) > 0))
        sample->variance.off_diagonal = INFINITY;
}

enum hatch_status hatch_smooth_spread(const struct hatch_smoothing *s, const bool *wanted, struct hatch_arena *scratch,
                                      struct hatch_curvature_sample *samples, struct hatch_err *err)
{
    const struct hatch_curvature_graph *graph = s->nets[0].graph;
    uint32_t nodes = graph->surface.point_count;
    struct spreading spread = {.s = s};
    struct hatch_arena_mark mark = hatch_arena_mark(scratch);
    HATCH_TRY(HATCH_ALLOC_UNSET(scratch, &spread.slopes, nodes, err));
    HATCH_TRY(HATCH_ALLOC_UNSET(scratch, &spread.variance, nodes, err));
    for (uint32_t n = 0; n < nodes; n++) {
        hatch_curvature_net_slope(&s->nets[0], n, spread.slopes[n]);
        spread.variance[n] = variance_at(s, n);
    }
    for (uint32_t n = 0; n < nodes; n++)
        for (uint32_t i = graph->first[n]; i < graph->first[n + 1]; i++)
            if (wanted[graph->points[i]])
                spread_to_point(&spread, n, graph->sides[i], graph->points[i], &samples[graph->points[i]]);
    hatch_arena_rewind(scratch, mark);
    return HATCH_OK;
}
