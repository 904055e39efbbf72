/* Curvature from supports that follow the noise: the smallest ones where they leave little doubt; elsewhere large ones
 * besides, smoothed, each weighted by the inverse of its variance. */
#include <math.h>

#include "math/vector.h"
#include "curvature/work.h"

#define ERROR_WANTED_RAD 0.01 /* a point wants a smoothed sample above this error of its direction */
#define WANTED_MIN 0.05       /* nothing is smoothed in components where fewer of the points want it */
#define NORMAL_COSINE_MIN 0.5 /* of large supports: polynomials cannot follow steeper slopes */

/* Rejects clear cases early by the squared difference of the curvatures: twice the sum of the squares of the matrix,
 * less the square of its trace. */
bool hatch_curvature_is_certain(const struct hatch_curvature_sample *sample, double limit_rad)
{
    const double *m = sample->tensor.matrix;
    double trace = m[0] + m[3] + m[5], off_diagonal = m[1] * m[1] + m[2] * m[2] + m[4] * m[4];
    double difference = 2 * (m[0] * m[0] + m[3] * m[3] + m[5] * m[5] + 2 * off_diagonal) - trace * trace;
    if (!(sample->variance.off_diagonal <= 2 * limit_rad * limit_rad * difference))
        return false;
    struct hatch_principal_curvatures principal;
    hatch_curvature_tensor_principal(&sample->tensor, &principal);
    return hatch_curvature_direction_error(&principal, &sample->variance) <= limit_rad;
}

/* Replaces a sample by the mean of itself and another, which decides the side: among noisy slivers, a small fit may lie
 * on its back. */
static void merge(struct hatch_curvature_sample *sample, const struct hatch_curvature_sample *other)
{
    double a = sample->variance.off_diagonal, b = other->variance.off_diagonal;
    if (!(b < INFINITY))
        return;
    double share = a < INFINITY ? a / (a + b) : 1, keep = 1 - share;
    double side = hatch_vec_dot(sample->tensor.normal, other->tensor.normal) < 0 ? -1 : 1;
    for (int k = 0; k < 6; k++)
        sample->tensor.matrix[k] = side * keep * sample->tensor.matrix[k] + share * other->tensor.matrix[k];
    for (int k = 0; k < 3; k++)
        sample->tensor.normal[k] = side * keep * sample->tensor.normal[k] + share * other->tensor.normal[k];
    hatch_vec_normalize(sample->tensor.normal);
    sample->radius = keep * sample->radius + share * other->radius;
    /* Both fits share points: no more is known than by the better one. */
    sample->variance.off_diagonal = fmin(a, b);
    sample->variance.mean = fmin(sample->variance.mean, other->variance.mean);
}

/* Finds the points that want a smoothed sample, in the components in which enough of them do. Returns whether there are
 * any.
 *   wanted  out: per point */
static enum hatch_status find_wanted(const struct hatch_surface *surface, const struct hatch_curvature_sample *samples,
                                     struct hatch_arena *scratch, bool *wanted, bool *any, struct hatch_err *err)
{
    uint32_t *count;
    struct hatch_arena_mark mark = hatch_arena_mark(scratch);
    HATCH_TRY(HATCH_ALLOC(scratch, &count, surface->component_count, err));
    for (uint32_t p = 0; p < surface->point_count; p++) {
        wanted[p] = !hatch_curvature_is_certain(&samples[p], ERROR_WANTED_RAD);
        count[surface->point_component[p]] += wanted[p];
    }
    *any = false;
    for (uint32_t p = 0; p < surface->point_count; p++) {
        uint32_t c = surface->point_component[p];
        wanted[p] = wanted[p] && count[c] > WANTED_MIN * surface->components[c].point_count;
        *any = *any || wanted[p];
    }
    hatch_arena_rewind(scratch, mark);
    return HATCH_OK;
}

static enum hatch_status smooth(const struct hatch_curvature_run *run, const double *noise,
                                struct hatch_curvature_sample *samples, struct hatch_arena *scratch,
                                struct hatch_err *err)
{
    uint32_t points = run->graph.surface.point_count;
    struct hatch_curvature_sample *smoothed;
    bool *wanted, any;
    HATCH_TRY(HATCH_ALLOC_UNSET(scratch, &wanted, points, err));
    HATCH_TRY(find_wanted(&run->graph.surface, samples, scratch, wanted, &any, err));
    for (uint32_t p = 0; p < points; p++)
        if (samples[p].variance.off_diagonal < INFINITY)
            hatch_vec_copy(samples[p].tensor.normal, &run->graph.normals[3 * (size_t)p]);
    if (!any)
        return HATCH_OK;
    HATCH_TRY(HATCH_ALLOC_UNSET(scratch, &smoothed, points, err));
    for (uint32_t i = 0; i < run->workers; i++)
        run->supports[i].normal_cosine_min = NORMAL_COSINE_MIN;
    HATCH_TRY(hatch_curvature_smooth(run, noise, wanted, scratch, smoothed, err));
    for (uint32_t p = 0; p < points; p++)
        if (wanted[p])
            merge(&samples[p], &smoothed[p]);
    return HATCH_OK;
}

enum hatch_status hatch_curvature_estimate_adaptive(const struct hatch_curvature_run *run, struct hatch_arena *scratch,
                                                    struct hatch_err *err)
{
    uint32_t points = run->graph.surface.point_count;
    struct hatch_curvature_sample *samples;
    double *noise;
    HATCH_TRY(HATCH_ALLOC_UNSET(scratch, &samples, points, err));
    HATCH_TRY(HATCH_ALLOC_UNSET(scratch, &noise, points, err));
    HATCH_TRY(hatch_curvature_fit_small(run, scratch, samples, noise, err));
    HATCH_TRY(smooth(run, noise, samples, scratch, err));
    for (uint32_t p = 0; p < points; p++) {
        bool found = samples[p].variance.off_diagonal < INFINITY;
        hatch_curvature_store(run, p, found ? &samples[p].tensor : NULL, &samples[p].variance, samples[p].radius);
    }
    return HATCH_OK;
}
