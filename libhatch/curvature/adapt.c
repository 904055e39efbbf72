/* Curvature from supports that grow with the noise.
 *
 * Fits are centred at some of the points only, spaced by a share of their radius, and each covers the points around
 * it. Where several cover a point, their tensors are averaged, weighted by expected error (a partition of unity:
 * Ohtake et al., "Multi-level partition of unity implicits", SIGGRAPH 2003). The smallest supports measure the noise:
 * the residual of a quartic. Where they leave the direction uncertain, larger supports follow, level by level, until
 * the error from the noise no longer falls below the error from the bias of the polynomial. The bias shows in the
 * difference to a higher degree, and in a residual beyond the noise (compare Lepski, "On a problem of adaptive
 * estimation in Gaussian white noise", 1990). Points with little noise get a fit of their own. */
#include <string.h>

#include "math/vector.h"
#include "curvature/work.h"

#define RADIUS_GROWTH 1.7 /* from level to level */
#define RADIUS_MAX 24.0
#define SPACING 0.36 /* between centres, in radii */
#define SPACING_FIRST 0.5
#define COVER_RADIUS 0.5      /* of the points that a fit covers, in radii */
#define LEVEL_COARSE 3u       /* the first level on a coarser graph */
#define NORMAL_COSINE_MIN 0.5 /* from the second level on: polynomials cannot follow steeper slopes */
#define COUNT_MIN 16u         /* points of a support */
#define NOISE_ROUNDS 3        /* of averaging with neighbours: the residual of one fit has few degrees of freedom */
#define ERROR_STOP_RAD 0.0017 /* no larger support is tried below this error of the direction */
#define ERROR_REFIT_RAD 0.01  /* a point gets a fit of its own below this error */
#define ERROR_GROWTH_MAX 2.0  /* no larger support is tried above this multiple of the smallest squared error */
#define DEGREE_MIN 3u
#define SIGNIFICANCE 16.0 /* of differences between degrees, in variances */
#define BIAS_SHARE 0.1    /* squared bias of a quartic, as a share of the largest that its residual allows */

struct blend {
    /* Weighted sums over the fits, and the sum of the weights. */
    struct hatch_curvature_tensor tensor;
    struct hatch_curvature_variance variance;
    double radius, weight;
    /* Smallest expected squared error of a fit: over all levels, and on the current one; INFINITY: no fit. */
    double best_error, level_error;
    bool open; /* whether larger supports may help */
};

/* Steeper than inverse variance: fits that share points have correlated errors, so the best should dominate. */
/* Returns the weight of a fit of an expected squared error. */
static double blend_weight(double error)
{
    return 1 / (error * sqrt(error));
}

/* Adds a fit.
 *   side  1, or -1 where the fit's outside is not that of the point */
static void add_to_blend(struct blend *blend, double weight, double side, const struct hatch_curvature_tensor *tensor,
                         const struct hatch_curvature_variance *variance, double radius)
{
    for (int i = 0; i < 6; i++)
        blend->tensor.matrix[i] += side * weight * tensor->matrix[i];
    for (int i = 0; i < 3; i++)
        blend->tensor.normal[i] += side * weight * tensor->normal[i];
    blend->weight += weight;
    blend->variance.off_diagonal += weight * variance->off_diagonal;
    blend->variance.mean += weight * variance->mean;
    blend->radius += weight * radius;
}

/* Computes the weighted means. Returns false when the blend has no fit. */
static bool mean_of_blend(const struct blend *blend, struct hatch_curvature_tensor *tensor,
                          struct hatch_curvature_variance *variance)
{
    if (!(blend->weight > 0))
        return false;
    for (int i = 0; i < 6; i++)
        tensor->matrix[i] = blend->tensor.matrix[i] / blend->weight;
    hatch_vec_copy(blend->tensor.normal, tensor->normal);
    variance->off_diagonal = blend->variance.off_diagonal / blend->weight;
    variance->mean = blend->variance.mean / blend->weight;
    return hatch_vec_normalize(tensor->normal) > 0;
}

/* Rejects clear cases early by the squared difference of the curvatures: twice the sum of the squares of the matrix,
 * less the square of its trace. */
/* Returns whether the standard error of the direction is at most limit_rad. */
static bool is_blend_certain(const struct blend *blend, double limit_rad)
{
    const double *m = blend->tensor.matrix;
    double trace = m[0] + m[3] + m[5], off_diagonal = m[1] * m[1] + m[2] * m[2] + m[4] * m[4];
    double difference = 2 * (m[0] * m[0] + m[3] * m[3] + m[5] * m[5] + 2 * off_diagonal) - trace * trace;
    if (blend->variance.off_diagonal * blend->weight > 2 * limit_rad * limit_rad * difference)
        return false;
    struct hatch_curvature_tensor tensor;
    struct hatch_curvature_variance variance;
    struct hatch_principal_curvatures principal;
    if (!mean_of_blend(blend, &tensor, &variance))
        return false;
    hatch_curvature_tensor_principal(&tensor, &principal);
    return hatch_curvature_direction_error(&principal, &variance) <= limit_rad;
}

struct fit {
    struct hatch_jet_frame frame;
    double coefficients[HATCH_JET_TERMS];
    uint32_t degree;                          /* 0: the fit failed */
    struct hatch_curvature_variance variance; /* with squared bias; on the first level for noise of variance 1 */
    double residual, freedom; /* first level: sum of squares in surface units, and its degrees of freedom */
};

struct covered_node {
    uint32_t node; /* of the graph */
    int32_t side;  /* -1: its outside is not that of the center, else 1 */
};

struct work {
    const struct hatch_curvature_run *run;
    const struct hatch_curvature_graph *graph; /* of the level: the run's, or a coarser one */
    struct blend *blends;                      /* per point */
    double *noise;           /* per point: sum of squared residuals of the fits around, then variance of the noise */
    double *freedom;         /* per point: degrees of freedom of that sum */
    double *buffer;          /* per point */
    uint32_t *last_near;     /* per node: last level with a center within the spacing */
    uint32_t *centers;       /* nodes at which a fit is centred */
    uint32_t *first_covered; /* per center, and one more: nodes covered by it start here in `covered` */
    struct covered_node *covered;
    uint32_t covered_capacity;
    struct fit *fits; /* per center */
    uint32_t level;   /* from 1 */
    double radius;
};

static uint32_t point_of(const struct work *w, uint32_t entry)
{
    return w->graph->points ? w->graph->points[entry] : entry;
}

static bool is_node_open(const struct work *w, uint32_t node)
{
    struct hatch_curvature_members members = hatch_curvature_node_members(w->graph, node);
    for (uint32_t i = members.first; i < members.end; i++)
        if (w->blends[point_of(w, i)].open)
            return true;
    return false;
}

/* Records the nodes that a center covers: the support gathered last. */
static enum hatch_status record_covered(struct work *w, const struct hatch_support *support, uint32_t center,
                                        struct hatch_arena *scratch, struct hatch_err *err)
{
    uint32_t first = w->first_covered[center];
    if (support->count > UINT32_MAX / 2 - first)
        return hatch_fail(err, HATCH_LIMIT, "the curvature fits cover more than 2^31 points: simplify the mesh");
    if (first + support->count > w->covered_capacity) {
        w->covered_capacity = 2 * (first + support->count);
        struct covered_node *grown;
        HATCH_TRY(HATCH_ALLOC_UNSET(scratch, &grown, w->covered_capacity, err));
        if (first > 0)
            memcpy(grown, w->covered, first * sizeof *grown);
        w->covered = grown;
    }
    for (uint32_t i = 0; i < support->count; i++)
        w->covered[first + i] = (struct covered_node){support->points[i], support->sides[i]};
    w->first_covered[center + 1] = first + support->count;
    return HATCH_OK;
}

/* Goes through the open nodes in order and chooses each whose distance to all chosen ones exceeds the spacing. */
static enum hatch_status choose_centers(struct work *w, uint32_t *count, struct hatch_arena *scratch,
                                        struct hatch_err *err)
{
    struct hatch_support *support = &w->run->supports[0];
    double spacing = w->radius * (w->level == 1 ? SPACING_FIRST : SPACING);
    const double *x = support->offsets[0], *y = support->offsets[1], *z = support->offsets[2];
    w->covered_capacity = 0;
    *count = 0;
    for (uint32_t p = 0; p < w->graph->surface.point_count; p++) {
        if (w->last_near[p] == w->level || !is_node_open(w, p))
            continue;
        hatch_support_gather(support, p, &w->graph->normals[(size_t)p * 3], w->radius * COVER_RADIUS);
        for (uint32_t i = 0; i < support->count; i++)
            if (x[i] * x[i] + y[i] * y[i] + z[i] * z[i] <= spacing * spacing)
                w->last_near[support->points[i]] = w->level;
        HATCH_TRY(record_covered(w, support, *count, scratch, err));
        w->centers[(*count)++] = p;
    }
    return HATCH_OK;
}

/* Returns the squared difference between the curvature tensors of two fits, in units of the frame. */
static struct hatch_curvature_variance difference(const double a[HATCH_JET_TERMS], const double b[HATCH_JET_TERMS])
{
    double skew = (a[3] - b[3]) - (a[5] - b[5]), mixed = a[4] - b[4], mean = (a[3] - b[3]) + (a[5] - b[5]);
    return (struct hatch_curvature_variance){(skew * skew + mixed * mixed) / 2, mean * mean};
}

/* Returns the squared bias contained in the squared difference of two fits; 0 unless it is significant, since the
 * choice of the degree would otherwise follow the noise.
 *   noise  expected squared difference without bias */
static double bias(double squared, double noise)
{
    return squared > SIGNIFICANCE * noise ? squared - noise : 0;
}

/* Chooses the degree of the smallest expected error: variance plus squared bias. Least-squares fits of nested degrees
 * differ by the bias and by noise, the variance of which is the difference of their variances. The bias of the highest
 * degree shows in a residual beyond the noise and twice its standard deviation. */
static void choose_degree(const struct work *w, const struct hatch_jet_system *system, double noise, struct fit *fit)
{
    uint32_t fixed = w->run->options->degree, top = system->degree;
    double unit = 1 / (fit->frame.radius * fit->frame.radius), highest[HATCH_JET_TERMS];
    struct hatch_jet_variance variances[HATCH_JET_DEGREE_MAX + 1];
    double freedom = system->count - hatch_jet_terms(top);
    double misfit = hatch_jet_residual(system, top) * fit->frame.radius * fit->frame.radius / freedom -
                    noise * (1 + 2 * sqrt(2 / freedom));
    hatch_jet_solve(system, top, highest);
    hatch_jet_variances(system, variances);
    struct hatch_curvature_variance variance_top = hatch_curvature_variance_of_jet(&fit->frame, &variances[top]);
    fit->degree = 0;
    uint32_t lowest = fixed ? fixed : DEGREE_MIN;
    for (uint32_t d = lowest < top ? lowest : top; d <= (fixed && fixed < top ? fixed : top); d++) {
        double coefficients[HATCH_JET_TERMS];
        if (d < top)
            hatch_jet_solve(system, d, coefficients);
        else
            memcpy(coefficients, highest, sizeof highest);
        struct hatch_curvature_variance own = hatch_curvature_variance_of_jet(&fit->frame, &variances[d]);
        struct hatch_curvature_variance error = {noise * own.off_diagonal, noise * own.mean};
        struct hatch_curvature_variance gap = difference(coefficients, highest);
        if (d < top) {
            error.off_diagonal += bias(gap.off_diagonal * unit, noise * (variance_top.off_diagonal - own.off_diagonal));
            error.mean += bias(gap.mean * unit, noise * (variance_top.mean - own.mean));
        } else {
            error.off_diagonal += BIAS_SHARE * fmax(0, misfit) * system->count * own.off_diagonal;
            error.mean += BIAS_SHARE * fmax(0, misfit) * system->count * own.mean;
        }
        if (fit->degree == 0 || hatch_curvature_variance_sum(&error) < hatch_curvature_variance_sum(&fit->variance)) {
            fit->degree = d;
            fit->variance = error;
            memcpy(fit->coefficients, coefficients, sizeof coefficients);
        }
    }
}

static void fit_first(struct work *w, uint32_t point, struct hatch_support *support, struct fit *fit)
{
    struct hatch_jet_system system;
    hatch_curvature_fit(support, point, &w->graph->normals[(size_t)point * 3], w->radius, HATCH_CURVATURE_DEGREE,
                        &fit->frame, &system);
    fit->freedom = (double)system.count - hatch_jet_terms(system.degree);
    fit->degree = fit->freedom > 0 ? system.degree : 0;
    if (fit->degree == 0)
        return;
    struct hatch_jet_variance variances[HATCH_JET_DEGREE_MAX + 1];
    hatch_jet_solve(&system, fit->degree, fit->coefficients);
    hatch_jet_variances(&system, variances);
    fit->variance = hatch_curvature_variance_of_jet(&fit->frame, &variances[fit->degree]);
    fit->residual = hatch_jet_residual(&system, fit->degree) * fit->frame.radius * fit->frame.radius;
}

/* Returns the variance of the noise around a node. */
static double noise_of(const struct work *w, uint32_t node)
{
    struct hatch_curvature_members members = hatch_curvature_node_members(w->graph, node);
    double sum = 0;
    for (uint32_t i = members.first; i < members.end; i++)
        sum += w->noise[point_of(w, i)];
    return sum / (members.end - members.first);
}

static void fit_center(void *context, uint32_t i, struct hatch_support *support)
{
    struct work *w = context;
    struct fit *fit = &w->fits[i];
    uint32_t point = w->centers[i];
    if (w->level == 1) {
        fit_first(w, point, support, fit);
        return;
    }
    struct hatch_jet_sums sums;
    struct hatch_jet_system system;
    const double *normal = &w->graph->normals[(size_t)point * 3];
    fit->degree = 0;
    hatch_support_gather(support, point, normal, w->radius);
    if (support->count < COUNT_MIN)
        return;
    hatch_support_sums(support, normal, w->radius, &fit->frame, &sums);
    hatch_jet_factorise(&sums, HATCH_JET_DEGREE_MAX, &system);
    if (system.degree >= 2 && system.count > hatch_jet_terms(system.degree))
        choose_degree(w, &system, noise_of(w, point), fit);
}

/* Estimates the noise around each point from the residuals of the fits of the first level. */
static void measure_noise(struct work *w, uint32_t count)
{
    const struct hatch_surface *surface = &w->graph->surface;
    for (uint32_t c = 0; c < count; c++) {
        const struct fit *fit = &w->fits[c];
        if (fit->degree == 0)
            continue;
        for (uint32_t i = w->first_covered[c]; i < w->first_covered[c + 1]; i++) {
            w->noise[w->covered[i].node] += fit->residual;
            w->freedom[w->covered[i].node] += fit->freedom;
        }
    }
    double *sums[2] = {w->noise, w->freedom};
    for (int round = 0; round < NOISE_ROUNDS; round++)
        for (int k = 0; k < 2; k++) {
            memcpy(w->buffer, sums[k], surface->point_count * sizeof *w->buffer);
            for (uint32_t p = 0; p < surface->point_count; p++) {
                uint32_t first = surface->ring_first[p], end = surface->ring_first[p + 1];
                for (uint32_t i = first; i < end; i++)
                    sums[k][p] += w->buffer[surface->ring_point[i]];
                sums[k][p] /= end - first + 1;
            }
        }
    for (uint32_t p = 0; p < surface->point_count; p++) {
        double rounding = hatch_curvature_rounding_error(surface, p);
        double variance = w->freedom[p] > 0 ? w->noise[p] / w->freedom[p] : 0;
        w->noise[p] = fmax(variance, rounding * rounding);
    }
}

/* Points covered by a fit that wait to be evaluated in pairs. */
struct pending {
    struct blend *blends[2];
    double weight[2], side[2], x[2], y[2];
    uint32_t count;
};

static void evaluate_pending(const struct fit *fit, struct pending *pending)
{
    struct hatch_curvature_tensor tensors[2];
    hatch_curvature_tensors_of_jet(&fit->frame, fit->coefficients, fit->degree, pending->x, pending->y, tensors);
    for (uint32_t i = 0; i < pending->count; i++)
        add_to_blend(pending->blends[i], pending->weight[i], pending->side[i], &tensors[i], &fit->variance,
                     fit->frame.radius);
    pending->count = 0;
}

/* Adds a fit to the blend of a point it covers; the weight falls from weight_max at the centre of the fit to 0.
 *   offset  of the point from the centre */
static void cover_point(struct blend *blend, const struct fit *fit, double weight_max, double side,
                        const double offset[3], struct pending *pending)
{
    double unit = 1 / fit->frame.radius;
    double square = hatch_vec_dot(offset, offset) * unit * unit / (COVER_RADIUS * COVER_RADIUS);
    uint32_t index = pending->count;
    if (!(square < 1))
        return;
    if (square <= 4 * SPACING * SPACING)
        blend->level_error = fmin(blend->level_error, hatch_curvature_variance_sum(&fit->variance));
    pending->blends[index] = blend;
    pending->weight[index] = (1 - square) * (1 - square) * weight_max;
    pending->side[index] = side;
    pending->x[index] = hatch_vec_dot(offset, fit->frame.axes[0]) * unit;
    pending->y[index] = hatch_vec_dot(offset, fit->frame.axes[1]) * unit;
    if (++pending->count == 2)
        evaluate_pending(fit, pending);
}

static void cover_points(struct work *w, const struct fit *fit, uint32_t center)
{
    const struct hatch_curvature_graph *graph = w->graph;
    double weight_max = blend_weight(hatch_curvature_variance_sum(&fit->variance));
    struct pending pending = {.count = 0};
    for (uint32_t n = w->first_covered[center]; n < w->first_covered[center + 1]; n++) {
        struct hatch_curvature_members members = hatch_curvature_node_members(graph, w->covered[n].node);
        for (uint32_t i = members.first; i < members.end; i++) {
            uint32_t p = point_of(w, i);
            double side = w->covered[n].side * (graph->sides ? graph->sides[i] : 1), offset[3];
            hatch_vec_sub(&w->run->graph.surface.points[3 * (size_t)p], fit->frame.origin, offset);
            cover_point(&w->blends[p], fit, weight_max, side, offset, &pending);
        }
    }
    if (pending.count > 0)
        evaluate_pending(fit, &pending);
}

/* Replaces the blend of a point whose direction is nearly certain after the first level by a fit of its own. */
static void refit_point(void *context, uint32_t p, struct hatch_support *support)
{
    struct work *w = context;
    struct blend *blend = &w->blends[p];
    struct hatch_jet_system system;
    struct hatch_jet_frame frame;
    if (!is_blend_certain(blend, ERROR_REFIT_RAD))
        return;
    hatch_curvature_fit(support, p, &w->run->graph.normals[(size_t)p * 3], w->radius,
                        w->run->options->degree ? w->run->options->degree : HATCH_CURVATURE_DEGREE, &frame, &system);
    if (system.degree == 0)
        return;
    struct hatch_curvature_tensor tensor;
    struct hatch_curvature_variance variance;
    hatch_curvature_tensor_of_system(&frame, &system, system.degree, &tensor, &variance);
    variance.off_diagonal *= w->noise[p];
    variance.mean *= w->noise[p];
    double error = hatch_curvature_variance_sum(&variance);
    *blend = (struct blend){.best_error = error, .level_error = error, .open = true};
    add_to_blend(blend, blend_weight(error), 1, &tensor, &variance, frame.radius);
}

/* Closes the points that need no larger support, or that the last one made worse. Updates the normals. */
static void close_points(struct work *w)
{
    for (uint32_t p = 0; p < w->run->graph.surface.point_count; p++) {
        struct blend *blend = &w->blends[p];
        if (!blend->open)
            continue;
        bool worse = blend->level_error < INFINITY && blend->level_error > ERROR_GROWTH_MAX * blend->best_error;
        blend->best_error = fmin(blend->best_error, blend->level_error);
        blend->level_error = INFINITY;
        blend->open = !worse && !is_blend_certain(blend, ERROR_STOP_RAD);
        if (blend->weight > 0) {
            double *normal = &w->run->graph.normals[(size_t)p * 3];
            hatch_vec_copy(blend->tensor.normal, normal);
            hatch_vec_normalize(normal);
        }
    }
}

/* Runs one level.
 *   more  out: whether a point was open */
static enum hatch_status run_level(struct work *w, struct hatch_arena *scratch, bool *more, struct hatch_err *err)
{
    uint32_t count;
    struct hatch_arena_mark mark = hatch_arena_mark(scratch);
    HATCH_TRY(choose_centers(w, &count, scratch, err));
    *more = count > 0;
    HATCH_TRY(HATCH_ALLOC_UNSET(scratch, &w->fits, count, err));
    hatch_curvature_for_each(w->run, count, fit_center, w);
    if (w->level == 1)
        measure_noise(w, count);
    for (uint32_t c = 0; c < count; c++) {
        struct fit *fit = &w->fits[c];
        if (fit->degree == 0)
            continue;
        if (w->level == 1) {
            fit->variance.off_diagonal *= w->noise[w->centers[c]];
            fit->variance.mean *= w->noise[w->centers[c]];
        }
        cover_points(w, fit, c);
    }
    if (w->level == 1)
        hatch_curvature_for_each(w->run, w->run->graph.surface.point_count, refit_point, w);
    close_points(w);
    hatch_arena_rewind(scratch, mark);
    return HATCH_OK;
}

static enum hatch_status allocate(struct work *w, struct hatch_arena *scratch, struct hatch_err *err)
{
    uint32_t points = w->run->graph.surface.point_count;
    HATCH_TRY(HATCH_ALLOC_UNSET(scratch, &w->blends, points, err));
    HATCH_TRY(HATCH_ALLOC(scratch, &w->noise, points, err));
    HATCH_TRY(HATCH_ALLOC(scratch, &w->freedom, points, err));
    HATCH_TRY(HATCH_ALLOC_UNSET(scratch, &w->centers, points, err));
    HATCH_TRY(HATCH_ALLOC(scratch, &w->first_covered, (size_t)points + 1, err));
    HATCH_TRY(HATCH_ALLOC(scratch, &w->last_near, points, err));
    return HATCH_ALLOC_UNSET(scratch, &w->buffer, points, err);
}

/* Moves to a graph of fewer nodes. */
static enum hatch_status coarsen(struct work *w, struct hatch_arena *scratch, struct hatch_err *err)
{
    struct hatch_curvature_graph *coarse;
    HATCH_TRY(HATCH_ALLOC(scratch, &coarse, 1, err));
    HATCH_TRY(hatch_curvature_graph_coarsen(&w->run->graph, w->graph, scratch, coarse, err));
    w->graph = coarse;
    for (uint32_t i = 0; i < w->run->workers; i++)
        hatch_support_set_surface(&w->run->supports[i], &coarse->surface, coarse->normals, coarse->weights);
    return HATCH_OK;
}

enum hatch_status hatch_curvature_estimate_adaptive(const struct hatch_curvature_run *run, struct hatch_arena *scratch,
                                                    struct hatch_err *err)
{
    struct work w = {.run = run, .graph = &run->graph, .radius = HATCH_CURVATURE_RADIUS_MIN, .level = 1};
    uint32_t points = run->graph.surface.point_count;
    HATCH_TRY(allocate(&w, scratch, err));
    for (uint32_t p = 0; p < points; p++)
        w.blends[p] = (struct blend){.best_error = INFINITY, .level_error = INFINITY, .open = true};
    bool more = true;
    for (; more && w.radius <= RADIUS_MAX; w.level++, w.radius *= RADIUS_GROWTH) {
        if (w.level >= LEVEL_COARSE)
            HATCH_TRY(coarsen(&w, scratch, err));
        HATCH_TRY(run_level(&w, scratch, &more, err));
        for (uint32_t i = 0; i < run->workers; i++)
            run->supports[i].normal_cosine_min = NORMAL_COSINE_MIN;
    }
    for (uint32_t p = 0; p < points; p++) {
        const struct blend *blend = &w.blends[p];
        struct hatch_curvature_tensor tensor;
        struct hatch_curvature_variance variance;
        bool found = mean_of_blend(blend, &tensor, &variance);
        hatch_curvature_store(run, p, found ? &tensor : NULL, &variance,
                              found ? blend->radius / blend->weight : w.radius);
    }
    return HATCH_OK;
}
