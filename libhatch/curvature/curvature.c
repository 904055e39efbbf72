#include <assert.h>

#include "math/vector.h"
#include "curvature/work.h"

/* Points for each coefficient, at least: with fewer the residual says little. */
#define POINTS_PER_TERM 1.4
#define GROWTH 1.25
#define GROWTHS_MAX 12

#define BLOCK 64u

double hatch_curvature_grain(const struct hatch_surface *surface, uint32_t point)
{
    const struct hatch_component *component = &surface->components[surface->point_component[point]];
    double largest = 0;
    for (uint32_t k = 0; k < 3; k++)
        largest = fmax(largest, fabs(surface->points[(size_t)point * 3 + k] + component->center[k] / component->scale));
    return largest * 0x1p-25;
}

void hatch_curvature_fit(struct hatch_support *support, uint32_t point, const double normal[3], double radius,
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

void hatch_curvature_store(const struct hatch_curvature_run *run, uint32_t point, const struct hatch_bend *bend,
                           const struct hatch_bend_variance *variance, double radius)
{
    struct hatch_curvature *out = run->curvature;
    size_t at = run->terrain.order[point];
    double *direction = &out->direction[at * 3], *normal = &out->normal[at * 3];
    struct hatch_principal principal;
    out->radius[at] = radius;
    if (!bend) {
        hatch_vec_copy(&run->frames->axis[at * 3], direction);
        hatch_vec_copy(&run->frames->normal[at * 3], normal);
        out->deviation_rad[at] = atan(1);
        return;
    }
    hatch_bend_principal(bend, &principal);
    hatch_vec_copy(principal.direction, direction);
    hatch_vec_copy(bend->normal, normal);
    for (uint32_t k = 0; k < 2; k++)
        out->value[at * 2 + k] = principal.value[k];
    out->deviation_rad[at] = hatch_bend_deviation(&principal, variance);
    out->confidence[at] = hatch_bend_confidence(&principal, variance);
}

struct share {
    const struct hatch_curvature_run *run;
    uint32_t count;
    hatch_curvature_task task;
    void *context;
};

static void run_share(void *context, uint32_t worker)
{
    const struct share *share = context;
    uint32_t stride = share->run->workers * BLOCK;
    for (uint32_t first = worker * BLOCK; first < share->count; first += stride)
        for (uint32_t i = first; i < first + BLOCK && i < share->count; i++)
            share->task(share->context, i, &share->run->supports[worker]);
}

void hatch_curvature_each(const struct hatch_curvature_run *run, uint32_t count, hatch_curvature_task task,
                          void *context)
{
    struct share share = {run, count, task, context};
    hatch_parallel_for(run->pool, run->workers, run_share, &share);
}

/* One point over the support that the options name. */
static void estimate_point(void *context, uint32_t p, struct hatch_support *support)
{
    const struct hatch_curvature_run *run = context;
    uint32_t degree = run->options->degree ? run->options->degree : HATCH_CURVATURE_DEGREE;
    struct hatch_jet_frame frame = {.radius = run->options->radius};
    struct hatch_jet_system system;
    hatch_curvature_fit(support, p, &run->terrain.normals[(size_t)p * 3], run->options->radius, degree, &frame,
                        &system);
    uint32_t terms = hatch_jet_terms(system.degree);
    if (system.degree == 0 || system.count <= terms) {
        hatch_curvature_store(run, p, NULL, NULL, frame.radius);
        return;
    }
    struct hatch_bend bend;
    struct hatch_bend_variance variance;
    hatch_bend_of_system(&frame, &system, system.degree, &bend, &variance);
    double square = hatch_jet_residual(&system, system.degree) / (system.count - terms);
    double grain = hatch_curvature_grain(&run->terrain.surface, p);
    square = fmax(square * frame.radius * frame.radius, grain * grain);
    variance.across *= square;
    variance.mean *= square;
    hatch_curvature_store(run, p, &bend, &variance, frame.radius);
}

enum hatch_status hatch_curvature_allocate(uint32_t points, struct hatch_arena *arena,
                                           struct hatch_curvature *curvature, struct hatch_err *err)
{
    struct hatch_curvature made = {.direction = HATCH_NEW(arena, double, (size_t)points * 3, err)};
    made.value = made.direction ? HATCH_NEW(arena, double, (size_t)points * 2, err) : NULL;
    made.confidence = made.value ? HATCH_NEW(arena, double, points, err) : NULL;
    made.deviation_rad = made.confidence ? HATCH_NEW(arena, double, points, err) : NULL;
    made.radius = made.deviation_rad ? HATCH_NEW(arena, double, points, err) : NULL;
    made.normal = made.radius ? HATCH_NEW(arena, double, (size_t)points * 3, err) : NULL;
    if (!made.normal)
        return HATCH_LIMIT;
    *curvature = made;
    return HATCH_OK;
}

static enum hatch_status estimate(const struct hatch_surface *surface, struct hatch_curvature_run *run,
                                  struct hatch_arena *scratch, struct hatch_err *err)
{
    struct hatch_curvature_terrain *terrain = &run->terrain;
    HATCH_TRY(hatch_curvature_order(surface, run->frames, scratch, terrain, err));
    run->supports = HATCH_NEW(scratch, struct hatch_support, run->workers, err);
    if (!run->supports)
        return HATCH_LIMIT;
    for (uint32_t w = 0; w < run->workers; w++)
        HATCH_TRY(hatch_support_make(&terrain->surface, terrain->normals, scratch, &run->supports[w], err));
    if (!(run->options->radius > 0))
        return hatch_curvature_adapt(run, scratch, err);
    hatch_curvature_each(run, surface->point_count, estimate_point, run);
    return HATCH_OK;
}

enum hatch_status hatch_curvature_estimate(const struct hatch_surface *surface, const struct hatch_frames *frames,
                                           const struct hatch_curvature_options *options, struct hatch_pool *pool,
                                           struct hatch_arena *arena, struct hatch_arena *scratch,
                                           struct hatch_curvature *curvature, struct hatch_err *err)
{
    assert(!(options->radius < 0) && options->radius <= 100);
    assert(options->degree == 0 || (options->degree >= 2 && options->degree <= HATCH_JET_DEGREE_MAX));
    struct hatch_curvature made;
    HATCH_TRY(hatch_curvature_allocate(surface->point_count, arena, &made, err));
    struct hatch_curvature_run run = {
        .frames = frames, .options = options, .pool = pool, .workers = hatch_pool_threads(pool), .curvature = &made};
    struct hatch_arena_mark mark = hatch_arena_mark(scratch);
    enum hatch_status status = estimate(surface, &run, scratch, err);
    hatch_arena_rewind(scratch, mark);
    if (status == HATCH_OK)
        *curvature = made;
    return status;
}
