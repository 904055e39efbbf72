#include <math.h>
#include <string.h>

#include "math/vector.h"
#include "curvature/smooth/smooth.h"

#define ROUNDS 2

/* Adds to a normal half its change over an offset, by the shape operator: positive curvature bends it forwards. */
static void bend(const double m[6], double side, const double d[3], double normal[3])
{
    normal[0] += side / 2 * (m[0] * d[0] + m[1] * d[1] + m[2] * d[2]);
    normal[1] += side / 2 * (m[1] * d[0] + m[3] * d[1] + m[4] * d[2]);
    normal[2] += side / 2 * (m[2] * d[0] + m[4] * d[1] + m[5] * d[2]);
}

/* Replaces each normal by the mean over its node and ring, weighted by inverse variance.
 *   shape  NULL, or per node the shape operator, by which normals change between a neighbour and the node */
static void average(struct hatch_smoothing *s, double (*shape)[6], const double *before)
{
    struct hatch_curvature_graph *graph = s->nets[0].graph;
    const struct hatch_surface *net = &graph->surface;
    for (uint32_t n = 0; n < net->point_count; n++) {
        double sum[3] = {0};
        hatch_vec_add_scaled(sum, 1 / s->variance[n], &before[3 * (size_t)n], sum);
        for (uint32_t i = net->ring_first[n]; i < net->ring_first[n + 1]; i++) {
            size_t q = net->ring_point[i];
            double side = net->ring_turned[i] ? -1 : 1, normal[3], offset[3];
            hatch_vec_copy(&before[3 * q], normal);
            hatch_vec_sub(&net->points[3 * (size_t)n], &net->points[3 * q], offset);
            if (shape) {
                bend(shape[q], 1, offset, normal);
                bend(shape[n], side, offset, normal);
            }
            hatch_vec_add_scaled(sum, side / s->variance[q], normal, sum);
        }
        if (hatch_vec_normalize(sum) > 0)
            hatch_vec_copy(sum, &graph->normals[3 * (size_t)n]);
    }
}

static enum hatch_status mean_normals(struct hatch_smoothing *s, double (*shape)[6], struct hatch_arena *scratch,
                                      struct hatch_err *err)
{
    struct hatch_curvature_graph *graph = s->nets[0].graph;
    size_t nodes = graph->surface.point_count;
    double *before;
    struct hatch_arena_mark mark = hatch_arena_mark(scratch);
    HATCH_TRY(HATCH_ALLOC_UNSET(scratch, &before, 3 * nodes, err));
    for (size_t n = 0; n < nodes; n++)
        if (s->variance[n] < INFINITY)
            hatch_vec_copy(s->tensor[n].normal, &graph->normals[3 * n]);
    for (int round = 0; round < ROUNDS; round++) {
        memcpy(before, graph->normals, 3 * nodes * sizeof *before);
        average(s, shape, before);
    }
    hatch_arena_rewind(scratch, mark);
    return HATCH_OK;
}

enum hatch_status hatch_smooth_find_normals(struct hatch_smoothing *s, struct hatch_arena *scratch,
                                            struct hatch_err *err)
{
    struct hatch_curvature_graph *graph = s->nets[0].graph;
    for (size_t n = 0; n < graph->surface.point_count; n++) {
        struct hatch_curvature_tensor *tensor = &s->tensor[n];
        if (!(s->variance[n] < INFINITY) || hatch_vec_dot(tensor->normal, &graph->normals[3 * n]) >= 0)
            continue;
        for (int k = 0; k < 6; k++)
            tensor->matrix[k] = -tensor->matrix[k];
        for (int k = 0; k < 3; k++)
            tensor->normal[k] = -tensor->normal[k];
    }
    return mean_normals(s, NULL, scratch, err);
}

enum hatch_status hatch_smooth_correct_normals(struct hatch_smoothing *s, struct hatch_arena *scratch,
                                               struct hatch_err *err)
{
    struct hatch_curvature_net *net = &s->nets[0];
    double *normals = net->graph->normals, *before, (*shape)[6];
    size_t nodes = net->graph->surface.point_count;
    struct hatch_arena_mark mark = hatch_arena_mark(scratch);
    HATCH_TRY(HATCH_ALLOC_UNSET(scratch, &before, 3 * nodes, err));
    HATCH_TRY(HATCH_ALLOC(scratch, &shape, nodes, err));
    memcpy(before, normals, 3 * nodes * sizeof *before);
    for (size_t n = 0; n < nodes; n++)
        hatch_curvature_net_tensor(&normals[3 * n], &net->axis[3 * n], &net->z[HATCH_NET_CHANNELS * n], 1, shape[n]);
    HATCH_TRY(mean_normals(s, shape, scratch, err));
    for (size_t n = 0; n < nodes; n++)
        hatch_curvature_net_carry_tangent(&before[3 * n], &normals[3 * n], &net->axis[3 * n]);
    hatch_arena_rewind(scratch, mark);
    return HATCH_OK;
}
