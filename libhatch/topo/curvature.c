#include <assert.h>

#include "math/vector.h"
#include "topo/curvature.h"
#include "topo/curvature_bend.h"
#include "topo/curvature_support.h"
#include "topo/curvature_work.h"

/* Points for each coefficient, at least: with fewer the residual says little. */
#define POINTS_PER_TERM 1.4
#define GROWTH 1.25
#define GROWTHS_MAX 12

#define DEGREE_DEFAULT 4u
#define RADIUS_DEFAULT 2.6

#define BLOCK 256u

struct run {
    const struct hatch_surface *surface;
    const struct hatch_frames *frames;
    double radius;
    uint32_t degree;
    uint32_t workers;
    struct hatch_support *supports; /* one a worker */
    struct hatch_curvature *curvature;
};

/* Half the last place of a float at a point's largest coordinate, in units of the surface: files hold floats,
 * and no fit is better known than its points. */
static double grain(const struct hatch_surface *surface, uint32_t point)
{
    const struct hatch_component *component = &surface->components[surface->point_component[point]];
    double largest = 0;
    for (uint32_t k = 0; k < 3; k++)
        largest = fmax(largest, fabs(surface->points[(size_t)point * 3 + k] +
                                     component->center[k] / component->scale));
    return largest * 0x1p-25;
}

/* Takes a support of the radius wanted, larger where it holds too few points. */
static void fit(struct hatch_support *support, uint32_t point, const double normal[3], double radius,
                uint32_t degree, struct hatch_jet_frame *frame, struct hatch_jet_system *system)
{
    double wanted = POINTS_PER_TERM * hatch_jet_terms(degree);
    uint32_t before = 0;
    system->degree = 0;
    for (int tries = 0; tries < GROWTHS_MAX; tries++, radius *= GROWTH) {
        bool full = hatch_support_gather(support, point, normal, radius);
        if (support->count < wanted && support->count > before) {
            before = support->count;
            continue;
        }
        struct hatch_jet_sums sums;
        hatch_support_sums(support, normal, radius, frame, &sums);
        hatch_jet_factorise(&sums, degree, system);
        if (system->degree == degree || full || support->count == before)
            return;
        before = support->count;
    }
}

static void estimate_point(const struct run *run, struct hatch_support *support, uint32_t p)
{
    struct hatch_curvature *out = run->curvature;
    const double *normal = &run->frames->normal[(size_t)p * 3];
    struct hatch_jet_frame frame;
    struct hatch_jet_system system;
    fit(support, p, normal, run->radius, run->degree, &frame, &system);
    uint32_t terms = hatch_jet_terms(system.degree);
    if (system.degree == 0 || system.count <= terms) {
        hatch_vec_copy(&run->frames->axis[(size_t)p * 3], &out->direction[(size_t)p * 3]);
        out->deviation_rad[p] = atan(1);
        out->radius[p] = run->radius;
        return;
    }
    double coefficients[HATCH_JET_TERMS];
    struct hatch_bend bend;
    struct hatch_principal principal;
    struct hatch_bend_variance variance;
    hatch_jet_solve(&system, system.degree, coefficients);
    hatch_bend_of_jet(&frame, coefficients, system.degree, 0, 0, &bend);
    hatch_bend_principal(&bend, &principal);
    hatch_bend_variance_of_jet(&frame, &system, system.degree, 0, 0, principal.direction, &variance);
    double noise = sqrt(hatch_jet_residual(&system, system.degree) / (system.count - terms));
    noise = fmax(noise * frame.radius, grain(run->surface, p));
    hatch_vec_copy(principal.direction, &out->direction[(size_t)p * 3]);
    for (uint32_t k = 0; k < 2; k++)
        out->value[(size_t)p * 2 + k] = principal.value[k];
    out->deviation_rad[p] = hatch_bend_deviation(&principal, &variance, noise);
    out->confidence[p] = hatch_bend_confidence(&principal, out->deviation_rad[p]);
    out->radius[p] = frame.radius;
}

static void estimate_some(void *context, uint32_t worker)
{
    const struct run *run = context;
    for (uint32_t first = worker * BLOCK; first < run->surface->point_count;
         first += run->workers * BLOCK)
        for (uint32_t p = first; p < first + BLOCK && p < run->surface->point_count; p++)
            estimate_point(run, &run->supports[worker], p);
}

enum hatch_status hatch_curvature_allocate(uint32_t points, struct hatch_arena *arena,
                                           struct hatch_curvature *curvature, struct hatch_err *err)
{
    struct hatch_curvature made = {.direction = HATCH_NEW(arena, double, (size_t)points * 3, err)};
    made.value = made.direction ? HATCH_NEW(arena, double, (size_t)points * 2, err) : NULL;
    made.confidence = made.value ? HATCH_NEW(arena, double, points, err) : NULL;
    made.deviation_rad = made.confidence ? HATCH_NEW(arena, double, points, err) : NULL;
    made.radius = made.deviation_rad ? HATCH_NEW(arena, double, points, err) : NULL;
    if (!made.radius)
        return HATCH_LIMIT;
    *curvature = made;
    return HATCH_OK;
}

enum hatch_status hatch_curvature_estimate(const struct hatch_surface *surface,
                                           const struct hatch_frames *frames,
                                           const struct hatch_curvature_options *options,
                                           struct hatch_pool *pool, struct hatch_arena *arena,
                                           struct hatch_arena *scratch,
                                           struct hatch_curvature *curvature, struct hatch_err *err)
{
    assert(!(options->radius < 0) && options->radius <= 100);
    assert(options->degree == 0 || (options->degree >= 2 && options->degree <= HATCH_JET_DEGREE_MAX));
    struct hatch_curvature made;
    HATCH_TRY(hatch_curvature_allocate(surface->point_count, arena, &made, err));
    struct run run = {.surface = surface,
                      .frames = frames,
                      .radius = options->radius > 0 ? options->radius : RADIUS_DEFAULT,
                      .degree = options->degree > 0 ? options->degree : DEGREE_DEFAULT,
                      .workers = hatch_pool_threads(pool),
                      .curvature = &made};
    struct hatch_arena_mark mark = hatch_arena_mark(scratch);
    run.supports = HATCH_NEW(scratch, struct hatch_support, run.workers, err);
    enum hatch_status status = run.supports ? HATCH_OK : HATCH_LIMIT;
    for (uint32_t w = 0; w < run.workers && status == HATCH_OK; w++)
        status = hatch_support_make(surface, frames->normal, scratch, &run.supports[w], err);
    if (status == HATCH_OK) {
        hatch_parallel_for(pool, run.workers, estimate_some, &run);
        *curvature = made;
    }
    hatch_arena_rewind(scratch, mark);
    return status;
}
