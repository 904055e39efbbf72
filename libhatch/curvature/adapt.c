/* Supports that grow with the noise.
 *
 * Fits stand on some of the points only, a share of their radius apart, each serves the points around it, and where
 * several serve a point their shape operators are averaged, weighed by what error each is expected to have (a
 * partition of unity: Ohtake et al., "Multi-level partition of unity implicits", SIGGRAPH 2003). Small supports,
 * first, measure the noise: the residual of a quartic. Where that leaves the direction uncertain, larger and larger
 * supports follow, until the error that the noise leaves no longer falls below the error that the polynomial's own
 * stiffness makes: that is measured by what a higher degree would change, and where the residual grows beyond the
 * noise (compare Lepski, "On a problem of adaptive estimation in Gaussian white noise", 1990). Clean points get a
 * fit each. */
#include <string.h>

#include "math/vector.h"
#include "curvature/place.h"
#include "curvature/work.h"

#define RADIUS_STEP 1.7
#define RADIUS_MAX 24.0
#define SPACING 0.36 /* between fits, in radii */
#define SPACING_FIRST 0.5
#define SERVED 0.5       /* how far a fit reaches, in radii */
#define LEVEL_THINNED 3u /* the first whose supports hold means of points */
#define LEAN_COSINE 0.5  /* from the second level on: a polynomial over a plane cannot follow steeper slopes */
#define POINTS_LEAST 16u
#define NOISE_ROUNDS 3     /* of averaging with neighbours: one fit's residual has few degrees of freedom */
#define CERTAIN_RAD 0.0017 /* no larger support is tried */
#define NEARLY_RAD 0.01    /* a fit of its own is worth it */
#define WORSE 2.0          /* than the least expected error so far: no larger support is tried */
#define DEGREE_LEAST 3u
#define SIGNIFICANT 16.0 /* differences of degrees, in variances */
#define STIFFNESS 0.1    /* squared bias of a quartic, as a share of the largest that its residual allows */

struct fit {
    struct hatch_jet_frame frame;
    double coefficients[HATCH_JET_TERMS];
    uint32_t degree; /* 0: the points do not say */
    struct hatch_bend_variance variance;
    double residual, freedom; /* of the first level: squares summed, in units of the surface; and of how many */
};

struct served {
    uint32_t node; /* of the terrain */
    int32_t side;  /* -1: its outside is not the center's */
};

struct work {
    const struct hatch_curvature_run *run;
    const struct hatch_curvature_terrain *terrain; /* the level's: the run's, or a thinned one */
    struct hatch_place *places;
    double *squares, *freedom; /* per point: residuals around; squares is then the noise's variance */
    uint32_t *centers;         /* the terrain's points that a fit stands on */
    uint32_t *first_served;    /* per center, and one more: where in served what it serves begins */
    struct served *served;
    uint32_t served_room;
    struct fit *fits;
    double radius;
    bool first;
};

static uint32_t point_of(const struct work *w, uint32_t entry)
{
    return w->terrain->points ? w->terrain->points[entry] : entry;
}

static bool is_open(const struct work *w, uint32_t node)
{
    struct hatch_curvature_span span = hatch_curvature_points(w->terrain, node);
    for (uint32_t i = span.first; i < span.end; i++)
        if (w->places[point_of(w, i)].open)
            return true;
    return false;
}

/* Remembers what a center serves, from the support just gathered. */
static enum hatch_status list_served(struct work *w, const struct hatch_support *support, uint32_t center,
                                     struct hatch_arena *scratch, struct hatch_err *err)
{
    uint32_t first = w->first_served[center];
    if (support->count > UINT32_MAX / 2 - first)
        return hatch_fail(err, HATCH_LIMIT, "too many points for curvature");
    if (first + support->count > w->served_room) {
        w->served_room = 2 * (first + support->count);
        struct served *grown = HATCH_NEW_UNSET(scratch, struct served, w->served_room, err);
        if (!grown)
            return HATCH_LIMIT;
        if (first > 0)
            memcpy(grown, w->served, first * sizeof *grown);
        w->served = grown;
    }
    for (uint32_t i = 0; i < support->count; i++)
        w->served[first + i] = (struct served){support->points[i], support->sides[i]};
    w->first_served[center + 1] = first + support->count;
    return HATCH_OK;
}

/* Points that are open and further from all others chosen than the spacing, in the points' order. */
static enum hatch_status choose_centers(struct work *w, uint32_t *covered, uint32_t level, uint32_t *count,
                                        struct hatch_arena *scratch, struct hatch_err *err)
{
    struct hatch_support *support = &w->run->supports[0];
    double spacing = w->radius * (w->first ? SPACING_FIRST : SPACING);
    const double *x = support->offsets[0], *y = support->offsets[1], *z = support->offsets[2];
    w->served_room = 0;
    *count = 0;
    for (uint32_t p = 0; p < w->terrain->surface.point_count; p++) {
        if (covered[p] == level || !is_open(w, p))
            continue;
        hatch_support_gather(support, p, &w->terrain->normals[(size_t)p * 3], w->radius * SERVED);
        for (uint32_t i = 0; i < support->count; i++)
            if (x[i] * x[i] + y[i] * y[i] + z[i] * z[i] <= spacing * spacing)
                covered[support->points[i]] = level;
        HATCH_TRY(list_served(w, support, *count, scratch, err));
        w->centers[(*count)++] = p;
    }
    return HATCH_OK;
}

/* How much a lower degree's bending differs from a higher one's, squared, in the frame's unit. */
static struct hatch_bend_variance difference(const double a[HATCH_JET_TERMS], const double b[HATCH_JET_TERMS])
{
    double skew = (a[3] - b[3]) - (a[5] - b[5]), across = a[4] - b[4], mean = (a[3] - b[3]) + (a[5] - b[5]);
    return (struct hatch_bend_variance){(skew * skew + across * across) / 2, mean * mean};
}

/* The squared bias in a squared difference that noise alone would make this large on average. One difference is
 * a rough measure: what noise makes now and then is not taken for bias, or the choice would follow the noise. */
static double bias(double squared, double by_noise)
{
    return squared > SIGNIFICANT * by_noise ? squared - by_noise : 0;
}

/* The expected error of each degree is its variance and its bias. Least squares of nested degrees differ by the
 * bias and by a variance that is the difference of their variances. The highest degree's bias shows in a residual
 * that is beyond the noise and its own scatter. */
static void choose_degree(const struct work *w, const struct hatch_jet_system *system, double noise, struct fit *fit)
{
    uint32_t asked = w->run->options->degree, top = system->degree;
    double unit = 1 / (fit->frame.radius * fit->frame.radius), highest[HATCH_JET_TERMS];
    struct hatch_jet_variance variances[HATCH_JET_DEGREE_MAX + 1];
    double freedom = system->count - hatch_jet_terms(top);
    double excess = hatch_jet_residual(system, top) * fit->frame.radius * fit->frame.radius / freedom -
                    noise * (1 + 2 * sqrt(2 / freedom));
    hatch_jet_solve(system, top, highest);
    hatch_jet_variances(system, variances);
    struct hatch_bend_variance widest = hatch_bend_variance_of_jet(&fit->frame, &variances[top]);
    fit->degree = 0;
    uint32_t lowest = asked ? asked : DEGREE_LEAST;
    for (uint32_t d = lowest < top ? lowest : top; d <= (asked && asked < top ? asked : top); d++) {
        double coefficients[HATCH_JET_TERMS];
        if (d < top)
            hatch_jet_solve(system, d, coefficients);
        else
            memcpy(coefficients, highest, sizeof highest);
        struct hatch_bend_variance own = hatch_bend_variance_of_jet(&fit->frame, &variances[d]);
        struct hatch_bend_variance error = {noise * own.across, noise * own.mean};
        struct hatch_bend_variance apart = difference(coefficients, highest);
        if (d < top) {
            error.across += bias(apart.across * unit, noise * (widest.across - own.across));
            error.mean += bias(apart.mean * unit, noise * (widest.mean - own.mean));
        } else {
            error.across += STIFFNESS * fmax(0, excess) * system->count * own.across;
            error.mean += STIFFNESS * fmax(0, excess) * system->count * own.mean;
        }
        if (fit->degree == 0 || hatch_bend_variance_sum(&error) < hatch_bend_variance_sum(&fit->variance)) {
            fit->degree = d;
            fit->variance = error;
            memcpy(fit->coefficients, coefficients, sizeof coefficients);
        }
    }
}

static void fit_first(struct work *w, uint32_t point, struct hatch_support *support, struct fit *fit)
{
    struct hatch_jet_system system;
    hatch_curvature_fit(support, point, &w->terrain->normals[(size_t)point * 3], w->radius, HATCH_CURVATURE_DEGREE,
                        &fit->frame, &system);
    fit->freedom = (double)system.count - hatch_jet_terms(system.degree);
    fit->degree = fit->freedom > 0 ? system.degree : 0;
    if (fit->degree == 0)
        return;
    struct hatch_jet_variance variances[HATCH_JET_DEGREE_MAX + 1];
    hatch_jet_solve(&system, fit->degree, fit->coefficients);
    hatch_jet_variances(&system, variances);
    fit->variance = hatch_bend_variance_of_jet(&fit->frame, &variances[fit->degree]);
    fit->residual = hatch_jet_residual(&system, fit->degree) * fit->frame.radius * fit->frame.radius;
}

/* The noise's variance around a node. */
static double noise_of(const struct work *w, uint32_t node)
{
    struct hatch_curvature_span span = hatch_curvature_points(w->terrain, node);
    double sum = 0;
    for (uint32_t i = span.first; i < span.end; i++)
        sum += w->squares[point_of(w, i)];
    return sum / (span.end - span.first);
}

static void fit_center(void *context, uint32_t i, struct hatch_support *support)
{
    struct work *w = context;
    struct fit *fit = &w->fits[i];
    uint32_t point = w->centers[i];
    if (w->first) {
        fit_first(w, point, support, fit);
        return;
    }
    struct hatch_jet_sums sums;
    struct hatch_jet_system system;
    const double *normal = &w->terrain->normals[(size_t)point * 3];
    fit->degree = 0;
    hatch_support_gather(support, point, normal, w->radius);
    if (support->count < POINTS_LEAST)
        return;
    hatch_support_sums(support, normal, w->radius, &fit->frame, &sums);
    hatch_jet_factorise(&sums, HATCH_JET_DEGREE_MAX, &system);
    if (system.degree >= 2 && system.count > hatch_jet_terms(system.degree))
        choose_degree(w, &system, noise_of(w, point), fit);
}

/* The noise around each point from the residuals of the first level's fits. */
static void measure_noise(struct work *w, uint32_t count, double *scratch)
{
    const struct hatch_surface *surface = &w->terrain->surface;
    for (uint32_t c = 0; c < count; c++) {
        const struct fit *fit = &w->fits[c];
        if (fit->degree == 0)
            continue;
        for (uint32_t i = w->first_served[c]; i < w->first_served[c + 1]; i++) {
            w->squares[w->served[i].node] += fit->residual;
            w->freedom[w->served[i].node] += fit->freedom;
        }
    }
    double *sums[2] = {w->squares, w->freedom};
    for (int round = 0; round < NOISE_ROUNDS; round++)
        for (int k = 0; k < 2; k++) {
            memcpy(scratch, sums[k], surface->point_count * sizeof *scratch);
            for (uint32_t p = 0; p < surface->point_count; p++) {
                uint32_t first = surface->ring_first[p], end = surface->ring_first[p + 1];
                for (uint32_t i = first; i < end; i++)
                    sums[k][p] += scratch[surface->ring_point[i]];
                sums[k][p] /= end - first + 1;
            }
        }
    for (uint32_t p = 0; p < surface->point_count; p++) {
        double grain = hatch_curvature_grain(surface, p);
        double square = w->freedom[p] > 0 ? w->squares[p] / w->freedom[p] : 0;
        w->squares[p] = fmax(square, grain * grain);
    }
}

/* Points that a fit serves, to be told two at a time. */
struct served_points {
    struct hatch_place *places[2];
    double weight[2], side[2], x[2], y[2];
    uint32_t count;
};

static void tell_points(const struct fit *fit, struct served_points *told)
{
    struct hatch_bend bends[2];
    hatch_bends_of_jet(&fit->frame, fit->coefficients, fit->degree, told->x, told->y, bends);
    for (uint32_t i = 0; i < told->count; i++)
        hatch_place_add(told->places[i], told->weight[i], told->side[i], &bends[i], &fit->variance, fit->frame.radius);
    told->count = 0;
}

/* Gives what a fit says to a point that it serves, which lies at an offset from its middle. The middle of its support
 * weighs most. */
static void serve_point(struct hatch_place *place, const struct fit *fit, double most, double side,
                        const double offset[3], struct served_points *told)
{
    double unit = 1 / fit->frame.radius, away = hatch_vec_dot(offset, offset) * unit * unit / (SERVED * SERVED);
    uint32_t at = told->count;
    if (!(away < 1))
        return;
    if (away <= 4 * SPACING * SPACING)
        place->now = fmin(place->now, hatch_bend_variance_sum(&fit->variance));
    told->places[at] = place;
    told->weight[at] = (1 - away) * (1 - away) * most;
    told->side[at] = side;
    told->x[at] = hatch_vec_dot(offset, fit->frame.axes[0]) * unit;
    told->y[at] = hatch_vec_dot(offset, fit->frame.axes[1]) * unit;
    if (++told->count == 2)
        tell_points(fit, told);
}

static void serve(struct work *w, const struct fit *fit, uint32_t center)
{
    const struct hatch_curvature_terrain *terrain = w->terrain;
    double most = hatch_place_weight(hatch_bend_variance_sum(&fit->variance));
    struct served_points told = {.count = 0};
    for (uint32_t n = w->first_served[center]; n < w->first_served[center + 1]; n++) {
        struct hatch_curvature_span span = hatch_curvature_points(terrain, w->served[n].node);
        for (uint32_t i = span.first; i < span.end; i++) {
            uint32_t p = point_of(w, i);
            double side = w->served[n].side * (terrain->sides ? terrain->sides[i] : 1), offset[3];
            hatch_vec_sub(&w->run->terrain.surface.points[3 * (size_t)p], fit->frame.origin, offset);
            serve_point(&w->places[p], fit, most, side, offset, &told);
        }
    }
    if (told.count > 0)
        tell_points(fit, &told);
}

/* A point whose direction is nearly certain gets a fit of its own in place of what the first level's fits
 * around it say. */
static void fit_itself(void *context, uint32_t p, struct hatch_support *support)
{
    struct work *w = context;
    struct hatch_place *place = &w->places[p];
    struct hatch_jet_system system;
    struct hatch_jet_frame frame;
    if (!hatch_place_known(place, NEARLY_RAD))
        return;
    hatch_curvature_fit(support, p, &w->run->terrain.normals[(size_t)p * 3], w->radius,
                        w->run->options->degree ? w->run->options->degree : HATCH_CURVATURE_DEGREE, &frame, &system);
    if (system.degree == 0)
        return;
    struct hatch_bend bend;
    struct hatch_bend_variance variance;
    hatch_bend_of_system(&frame, &system, system.degree, &bend, &variance);
    variance.across *= w->squares[p];
    variance.mean *= w->squares[p];
    double error = hatch_bend_variance_sum(&variance);
    *place = (struct hatch_place){.least = error, .now = error, .open = true};
    hatch_place_add(place, hatch_place_weight(error), 1, &bend, &variance, frame.radius);
}

/* Closes the points that need no larger support, or that a larger one has not helped. */
static void settle(struct work *w)
{
    for (uint32_t p = 0; p < w->run->terrain.surface.point_count; p++) {
        struct hatch_place *place = &w->places[p];
        if (!place->open)
            continue;
        bool worse = place->now < INFINITY && place->now > WORSE * place->least;
        place->least = fmin(place->least, place->now);
        place->now = INFINITY;
        place->open = !worse && !hatch_place_known(place, CERTAIN_RAD);
        if (place->weight > 0) {
            double *normal = &w->run->terrain.normals[(size_t)p * 3];
            hatch_vec_copy(place->bend.normal, normal);
            hatch_vec_normalize(normal);
        }
    }
}

/* One level: false when no point is open. */
static enum hatch_status run_level(struct work *w, uint32_t level, uint32_t *covered, double *pool,
                                   struct hatch_arena *scratch, bool *more, struct hatch_err *err)
{
    uint32_t count;
    struct hatch_arena_mark mark = hatch_arena_mark(scratch);
    HATCH_TRY(choose_centers(w, covered, level, &count, scratch, err));
    *more = count > 0;
    w->fits = HATCH_NEW_UNSET(scratch, struct fit, count, err);
    if (!w->fits)
        return HATCH_LIMIT;
    hatch_curvature_each(w->run, count, fit_center, w);
    if (w->first)
        measure_noise(w, count, pool);
    for (uint32_t c = 0; c < count; c++) {
        struct fit *fit = &w->fits[c];
        if (fit->degree == 0)
            continue;
        if (w->first) {
            fit->variance.across *= w->squares[w->centers[c]];
            fit->variance.mean *= w->squares[w->centers[c]];
        }
        serve(w, fit, c);
    }
    if (w->first)
        hatch_curvature_each(w->run, w->run->terrain.surface.point_count, fit_itself, w);
    settle(w);
    hatch_arena_rewind(scratch, mark);
    return HATCH_OK;
}

static enum hatch_status allocate(struct work *w, struct hatch_arena *scratch, uint32_t **covered, double **pool,
                                  struct hatch_err *err)
{
    uint32_t points = w->run->terrain.surface.point_count;
    w->places = HATCH_NEW_UNSET(scratch, struct hatch_place, points, err);
    w->squares = w->places ? HATCH_NEW(scratch, double, points, err) : NULL;
    w->freedom = w->squares ? HATCH_NEW(scratch, double, points, err) : NULL;
    w->centers = w->freedom ? HATCH_NEW_UNSET(scratch, uint32_t, points, err) : NULL;
    w->first_served = w->centers ? HATCH_NEW(scratch, uint32_t, (size_t)points + 1, err) : NULL;
    *covered = w->first_served ? HATCH_NEW(scratch, uint32_t, points, err) : NULL;
    *pool = *covered ? HATCH_NEW_UNSET(scratch, double, points, err) : NULL;
    return *pool ? HATCH_OK : HATCH_LIMIT;
}

/* A terrain of fewer points for the next level. */
static enum hatch_status thin(struct work *w, struct hatch_arena *scratch, struct hatch_err *err)
{
    struct hatch_curvature_terrain *coarse = HATCH_NEW(scratch, struct hatch_curvature_terrain, 1, err);
    if (!coarse)
        return HATCH_LIMIT;
    HATCH_TRY(hatch_curvature_thin(&w->run->terrain, w->terrain, scratch, coarse, err));
    w->terrain = coarse;
    for (uint32_t i = 0; i < w->run->workers; i++)
        hatch_support_move(&w->run->supports[i], &coarse->surface, coarse->normals, coarse->weights);
    return HATCH_OK;
}

enum hatch_status hatch_curvature_adapt(const struct hatch_curvature_run *run, struct hatch_arena *scratch,
                                        struct hatch_err *err)
{
    struct work w = {.run = run, .terrain = &run->terrain, .radius = HATCH_CURVATURE_RADIUS, .first = true};
    uint32_t points = run->terrain.surface.point_count, *covered;
    double *pool;
    HATCH_TRY(allocate(&w, scratch, &covered, &pool, err));
    for (uint32_t p = 0; p < points; p++)
        w.places[p] = (struct hatch_place){.least = INFINITY, .now = INFINITY, .open = true};
    bool more = true;
    for (uint32_t level = 1; more && w.radius <= RADIUS_MAX; level++, w.radius *= RADIUS_STEP) {
        if (level >= LEVEL_THINNED)
            HATCH_TRY(thin(&w, scratch, err));
        HATCH_TRY(run_level(&w, level, covered, pool, scratch, &more, err));
        w.first = false;
        for (uint32_t i = 0; i < run->workers; i++)
            run->supports[i].lean_cosine = LEAN_COSINE;
    }
    for (uint32_t p = 0; p < points; p++) {
        const struct hatch_place *place = &w.places[p];
        struct hatch_bend bend;
        struct hatch_bend_variance variance;
        bool known = hatch_place_mean(place, &bend, &variance);
        hatch_curvature_store(run, p, known ? &bend : NULL, &variance,
                              known ? place->radius / place->weight : w.radius);
    }
    return HATCH_OK;
}
