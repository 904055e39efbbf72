/* Curvature from the smallest supports.
 *
 * Fits are centred at some of the points, spaced by a share of their radius, and each covers the points around it.
 * Where several cover a point, their tensors are averaged, weighted by expected error (a partition of unity: Ohtake et
 * al., "Multi-level partition of unity implicits", SIGGRAPH 2003). The residuals of quartics measure the noise.
 * Points with little noise get a fit of their own. */
#include <math.h>
#include <string.h>

#include "math/vector.h"
#include "curvature/work.h"

#define RADIUS HATCH_CURVATURE_RADIUS_MIN
#define COVER_RADIUS (0.5 * RADIUS) /* of the points that a fit covers; also the least distance between centres */
#define NOISE_ROUNDS 3       /* of averaging with neighbours: the residual of one fit has few degrees of freedom */
#define ERROR_REFIT_RAD 0.01 /* a point gets a fit of its own below this error */

struct fit {
    struct hatch_jet_frame frame;
    double coefficients[HATCH_JET_TERMS];
    uint32_t degree;                          /* 0: the fit failed */
    struct hatch_curvature_variance variance; /* at first for noise of variance 1 */
    double residual, freedom;                 /* sum of squares in surface units, and its degrees of freedom */
};

struct covered_point {
    uint32_t point;
    int32_t side; /* -1: its outside is not that of the center, else 1 */
};

struct work {
    const struct hatch_curvature_run *run;
    struct hatch_curvature_sample *samples; /* per point: weighted sums, at last means */
    double *weight;                         /* per point: sum of the weights */
    double *noise;           /* per point: sum of squared residuals of the fits around, then variance of the noise */
    double *freedom;         /* per point: degrees of freedom of that sum */
    uint32_t *centers;       /* points at which a fit is centred */
    uint32_t *first_covered; /* per center, and one more: points covered by it start here in `covered` */
    struct covered_point *covered;
    uint32_t covered_capacity;
    struct fit *fits; /* per center */
};

/* Records the points that a center covers: the support gathered last. */
static enum hatch_status record_covered(struct work *w, const struct hatch_support *support, uint32_t center,
                                        struct hatch_arena *scratch, struct hatch_err *err)
{
    uint32_t first = w->first_covered[center];
    if (support->count > UINT32_MAX / 2 - first)
        return hatch_fail(err, HATCH_LIMIT, "the curvature fits cover more than 2^31 points: simplify the mesh");
    if (first + support->count > w->covered_capacity) {
        w->covered_capacity = 2 * (first + support->count);
        struct covered_point *grown;
        HATCH_TRY(HATCH_ALLOC_UNSET(scratch, &grown, w->covered_capacity, err));
        if (first > 0)
            memcpy(grown, w->covered, first * sizeof *grown);
        w->covered = grown;
    }
    for (uint32_t i = 0; i < support->count; i++)
        w->covered[first + i] = (struct covered_point){support->points[i], support->sides[i]};
    w->first_covered[center + 1] = first + support->count;
    return HATCH_OK;
}

/* Goes through the points in order and chooses each that no chosen one covers. */
static enum hatch_status choose_centers(struct work *w, uint32_t *count, struct hatch_arena *scratch,
                                        struct hatch_err *err)
{
    const struct hatch_curvature_graph *graph = &w->run->graph;
    struct hatch_support *support = &w->run->supports[0];
    bool *near;
    HATCH_TRY(HATCH_ALLOC(scratch, &near, graph->surface.point_count, err));
    *count = 0;
    for (uint32_t p = 0; p < graph->surface.point_count; p++) {
        if (near[p])
            continue;
        hatch_support_gather(support, p, &graph->normals[(size_t)p * 3], COVER_RADIUS);
        for (uint32_t i = 0; i < support->count; i++)
            near[support->points[i]] = true;
        HATCH_TRY(record_covered(w, support, *count, scratch, err));
        w->centers[(*count)++] = p;
    }
    return HATCH_OK;
}

/* Always fits a quartic, since the residual of a lower degree would be bias rather than noise; its system holds the fit
 * of the wanted degree, too. */
static void fit_center(void *context, uint32_t i, struct hatch_support *support)
{
    struct work *w = context;
    struct fit *fit = &w->fits[i];
    uint32_t point = w->centers[i];
    struct hatch_jet_system system;
    hatch_curvature_fit(support, point, &w->run->graph.normals[(size_t)point * 3], RADIUS, HATCH_CURVATURE_DEGREE,
                        &fit->frame, &system);
    fit->freedom = (double)system.count - hatch_jet_terms(system.degree);
    if (system.degree == 0 || !(fit->freedom > 0)) {
        fit->degree = 0;
        return;
    }
    fit->residual = hatch_jet_residual(&system, system.degree) * fit->frame.radius * fit->frame.radius;
    fit->degree = hatch_curvature_degree(w->run);
    if (fit->degree > system.degree)
        fit->degree = system.degree;
    struct hatch_jet_variance variances[HATCH_JET_DEGREE_MAX + 1];
    hatch_jet_solve(&system, fit->degree, fit->coefficients);
    hatch_jet_variances(&system, variances);
    fit->variance = hatch_curvature_variance_of_jet(&fit->frame, &variances[fit->degree]);
}

/* Estimates the noise around each point from the residuals. */
static enum hatch_status measure_noise(struct work *w, uint32_t count, struct hatch_arena *scratch,
                                       struct hatch_err *err)
{
    const struct hatch_surface *surface = &w->run->graph.surface;
    double *sums[2] = {w->noise, w->freedom}, *before;
    HATCH_TRY(HATCH_ALLOC_UNSET(scratch, &before, surface->point_count, err));
    for (uint32_t c = 0; c < count; c++) {
        const struct fit *fit = &w->fits[c];
        for (uint32_t i = w->first_covered[c]; fit->degree > 0 && i < w->first_covered[c + 1]; i++) {
            w->noise[w->covered[i].point] += fit->residual;
            w->freedom[w->covered[i].point] += fit->freedom;
        }
    }
    for (int round = 0; round < NOISE_ROUNDS; round++)
        for (int k = 0; k < 2; k++) {
            memcpy(before, sums[k], surface->point_count * sizeof *before);
            for (uint32_t p = 0; p < surface->point_count; p++) {
                uint32_t first = surface->ring_first[p], end = surface->ring_first[p + 1];
                for (uint32_t i = first; i < end; i++)
                    sums[k][p] += before[surface->ring_point[i]];
                sums[k][p] /= end - first + 1;
            }
        }
    for (uint32_t p = 0; p < surface->point_count; p++) {
        double rounding = hatch_curvature_rounding_error(surface, p);
        double variance = w->freedom[p] > 0 ? w->noise[p] / w->freedom[p] : 0;
        w->noise[p] = fmax(variance, rounding * rounding);
    }
    return HATCH_OK;
}

/* Points covered by a fit that wait to be evaluated in pairs. */
struct pending {
    uint32_t point[2];
    double weight[2], side[2], x[2], y[2];
    uint32_t count;
};

static void evaluate_pending(struct work *w, const struct fit *fit, struct pending *pending)
{
    struct hatch_curvature_tensor tensors[2];
    hatch_curvature_tensors_of_jet(&fit->frame, fit->coefficients, fit->degree, pending->x, pending->y, tensors);
    for (uint32_t i = 0; i < pending->count; i++) {
        struct hatch_curvature_sample *sample = &w->samples[pending->point[i]];
        double weight = pending->weight[i], side = pending->side[i];
        for (int k = 0; k < 6; k++)
            sample->tensor.matrix[k] += side * weight * tensors[i].matrix[k];
        hatch_vec_add_scaled(sample->tensor.normal, side * weight, tensors[i].normal, sample->tensor.normal);
        sample->variance.off_diagonal += weight * fit->variance.off_diagonal;
        sample->variance.mean += weight * fit->variance.mean;
        sample->radius += weight * fit->frame.radius;
        w->weight[pending->point[i]] += weight;
    }
    pending->count = 0;
}

/* Adds a fit to the points it covers; its weight falls to 0 at COVER_RADIUS. Fits that share points have correlated
 * errors, so the best should dominate: weights are steeper than inverse variance. */
static void cover_points(struct work *w, const struct fit *fit, uint32_t center)
{
    double error = hatch_curvature_variance_sum(&fit->variance), unit = 1 / fit->frame.radius;
    struct pending pending = {.count = 0};
    for (uint32_t n = w->first_covered[center]; n < w->first_covered[center + 1]; n++) {
        uint32_t p = w->covered[n].point, index = pending.count;
        double offset[3];
        hatch_vec_sub(&w->run->graph.surface.points[3 * (size_t)p], fit->frame.origin, offset);
        double square = hatch_vec_dot(offset, offset) * unit * unit * (RADIUS * RADIUS / (COVER_RADIUS * COVER_RADIUS));
        if (!(square < 1))
            continue;
        pending.point[index] = p;
        pending.weight[index] = (1 - square) * (1 - square) / (error * sqrt(error));
        pending.side[index] = w->covered[n].side;
        pending.x[index] = hatch_vec_dot(offset, fit->frame.axes[0]) * unit;
        pending.y[index] = hatch_vec_dot(offset, fit->frame.axes[1]) * unit;
        if (++pending.count == 2)
            evaluate_pending(w, fit, &pending);
    }
    if (pending.count > 0)
        evaluate_pending(w, fit, &pending);
}

/* Divides the sums by their weight. */
static void take_mean(struct hatch_curvature_sample *sample, double weight)
{
    if (weight > 0) {
        for (int i = 0; i < 6; i++)
            sample->tensor.matrix[i] /= weight;
        sample->variance.off_diagonal /= weight;
        sample->variance.mean /= weight;
        sample->radius /= weight;
    }
    if (!(weight > 0 && hatch_vec_normalize(sample->tensor.normal) > 0))
        *sample = (struct hatch_curvature_sample){.variance = {INFINITY, INFINITY}, .radius = RADIUS};
}

/* Replaces the mean at a point whose direction is nearly certain by a fit of its own. */
static void refit_point(void *context, uint32_t p, struct hatch_support *support)
{
    struct work *w = context;
    struct hatch_curvature_sample *sample = &w->samples[p];
    struct hatch_jet_system system;
    struct hatch_jet_frame frame;
    if (!hatch_curvature_is_certain(sample, ERROR_REFIT_RAD))
        return;
    hatch_curvature_fit(support, p, &w->run->graph.normals[(size_t)p * 3], RADIUS, hatch_curvature_degree(w->run),
                        &frame, &system);
    if (system.degree == 0)
        return;
    hatch_curvature_tensor_of_system(&frame, &system, system.degree, &sample->tensor, &sample->variance);
    sample->variance.off_diagonal *= w->noise[p];
    sample->variance.mean *= w->noise[p];
    sample->radius = frame.radius;
}

static enum hatch_status allocate(struct work *w, struct hatch_arena *scratch, struct hatch_err *err)
{
    uint32_t points = w->run->graph.surface.point_count;
    HATCH_TRY(HATCH_ALLOC(scratch, &w->weight, points, err));
    HATCH_TRY(HATCH_ALLOC(scratch, &w->freedom, points, err));
    HATCH_TRY(HATCH_ALLOC_UNSET(scratch, &w->centers, points, err));
    return HATCH_ALLOC(scratch, &w->first_covered, (size_t)points + 1, err);
}

enum hatch_status hatch_curvature_fit_small(const struct hatch_curvature_run *run, struct hatch_arena *scratch,
                                            struct hatch_curvature_sample *samples, double *noise,
                                            struct hatch_err *err)
{
    struct work w = {.run = run, .samples = samples, .noise = noise};
    uint32_t points = run->graph.surface.point_count, count;
    struct hatch_arena_mark mark = hatch_arena_mark(scratch);
    memset(samples, 0, points * sizeof *samples);
    memset(noise, 0, points * sizeof *noise);
    HATCH_TRY(allocate(&w, scratch, err));
    HATCH_TRY(choose_centers(&w, &count, scratch, err));
    HATCH_TRY(HATCH_ALLOC_UNSET(scratch, &w.fits, count, err));
    hatch_curvature_for_each(run, count, fit_center, &w);
    HATCH_TRY(measure_noise(&w, count, scratch, err));
    for (uint32_t c = 0; c < count; c++) {
        struct fit *fit = &w.fits[c];
        fit->variance.off_diagonal *= noise[w.centers[c]];
        fit->variance.mean *= noise[w.centers[c]];
        if (fit->degree > 0)
            cover_points(&w, fit, c);
    }
    for (uint32_t p = 0; p < points; p++)
        take_mean(&samples[p], w.weight[p]);
    hatch_curvature_for_each(run, points, refit_point, &w);
    hatch_arena_rewind(scratch, mark);
    return HATCH_OK;
}
