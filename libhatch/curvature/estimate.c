#include <assert.h>

#include "math/vector.h"
#include "curvature/work.h"

/* Smallest number of points per coefficient: with fewer the residual is no measure of the noise. */
#define POINTS_PER_TERM 1.4
#define RADIUS_GROWTH 1.25
#define ATTEMPTS_MAX 12

#define BLOCK 64u /* consecutive items of one worker */

double hatch_curvature_rounding_error(const struct hatch_surface *surface, uint32_t point)
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
    double count_min = POINTS_PER_TERM * hatch_jet_terms(degree);
    uint32_t count_before = 0;
    system->degree = 0;
    for (int attempt = 0; attempt < ATTEMPTS_MAX; attempt++, radius *= RADIUS_GROWTH) {
        bool full = hatch_support_gather(support, point, normal, radius);
        if (support->count < count_min && support->count > count_before) {
            count_before = support->count;
            continue;
        }
        struct hatch_jet_sums sums;
        hatch_support_sums(support, normal, radius, frame, &sums);
        hatch_jet_factorise(&sums, degree, system);
        if (system->degree == degree || full || support->count == count_before)
            return;
        count_before = support->count;
    }
}

void hatch_curvature_store(const struct hatch_curvature_run *run, uint32_t point,
                           const struct hatch_curvature_tensor *tensor, const struct hatch_curvature_variance *variance,
                           double radius)
{
    struct hatch_curvature *out = run->curvature;
    size_t index = run->graph.order[point];
    double *direction = &out->direction[index * 3], *normal = &out->normal[index * 3];
    struct hatch_principal_curvatures principal;
    out->radius[index] = radius;
    if (!tensor) {
        hatch_vec_copy(&run->frames->axis[index * 3], direction);
        hatch_vec_copy(&run->frames->normal[index * 3], normal);
        out->standard_error_rad[index] = atan(1);
        return;
    }
    hatch_curvature_tensor_principal(tensor, &principal);
    hatch_vec_copy(principal.direction, direction);
    hatch_vec_copy(tensor->normal, normal);
    for (uint32_t k = 0; k < 2; k++)
        out->value[index * 2 + k] = principal.value[k];
    out->standard_error_rad[index] = hatch_curvature_direction_error(&principal, variance);
    out->confidence[index] = hatch_curvature_confidence(&principal, variance);
}

struct batch {
    const struct hatch_curvature_run *run;
    uint32_t count;
    hatch_curvature_task task;
    void *context;
};

static void run_batch(void *context, uint32_t worker)
{
    const struct batch *batch = context;
    uint32_t stride = batch->run->workers * BLOCK;
    for (uint32_t first = worker * BLOCK; first < batch->count; first += stride)
        for (uint32_t i = first; i < first + BLOCK && i < batch->count; i++)
            batch->task(batch->context, i, &batch->run->supports[worker]);
}

void hatch_curvature_for_each(const struct hatch_curvature_run *run, uint32_t count, hatch_curvature_task task,
                              void *context)
{
    struct batch batch = {run, count, task, context};
    hatch_parallel_for(run->options->pool, run->workers, run_batch, &batch);
}

/* Estimates a point over a support of a fixed radius, or of the least larger one that holds enough points. */
static void estimate_point(void *context, uint32_t p, struct hatch_support *support)
{
    const struct hatch_curvature_run *run = context;
    uint32_t degree = hatch_curvature_degree(run), terms;
    struct hatch_jet_frame frame = {.radius = run->options->radius};
    struct hatch_jet_system system;
    double radius = run->options->radius;
    bool fits = false;
    for (int attempt = 0; attempt < ATTEMPTS_MAX && !fits; attempt++, radius *= RADIUS_GROWTH) {
        hatch_curvature_fit(support, p, &run->graph.normals[(size_t)p * 3], radius, degree, &frame, &system);
        terms = hatch_jet_terms(system.degree);
        fits = (system.degree > 0 && system.count > terms) || !support->cut;
    }
    if (system.degree == 0 || system.count <= terms) {
        hatch_curvature_store(run, p, NULL, NULL, frame.radius);
        return;
    }
    struct hatch_curvature_tensor tensor;
    struct hatch_curvature_variance variance;
    hatch_curvature_tensor_of_system(&frame, &system, system.degree, &tensor, &variance);
    double noise = hatch_jet_residual(&system, system.degree) / (system.count - terms);
    double rounding = hatch_curvature_rounding_error(&run->graph.surface, p);
    noise = fmax(noise * frame.radius * frame.radius, rounding * rounding);
    variance.off_diagonal *= noise;
    variance.mean *= noise;
    hatch_curvature_store(run, p, &tensor, &variance, frame.radius);
}

enum hatch_status hatch_curvature_allocate(uint32_t points, struct hatch_arena *arena,
                                           struct hatch_curvature *curvature, struct hatch_err *err)
{
    struct hatch_curvature made = {0};
    HATCH_TRY(HATCH_ALLOC(arena, &made.direction, (size_t)points * 3, err));
    HATCH_TRY(HATCH_ALLOC(arena, &made.value, (size_t)points * 2, err));
    HATCH_TRY(HATCH_ALLOC(arena, &made.confidence, points, err));
    HATCH_TRY(HATCH_ALLOC(arena, &made.standard_error_rad, points, err));
    HATCH_TRY(HATCH_ALLOC(arena, &made.radius, points, err));
    HATCH_TRY(HATCH_ALLOC(arena, &made.normal, (size_t)points * 3, err));
    *curvature = made;
    return HATCH_OK;
}

static enum hatch_status estimate(const struct hatch_surface *surface, struct hatch_curvature_run *run,
                                  struct hatch_arena *scratch, struct hatch_err *err)
{
    struct hatch_curvature_graph *graph = &run->graph;
    HATCH_TRY(hatch_curvature_graph_make(surface, run->frames, scratch, graph, err));
    HATCH_TRY(HATCH_ALLOC(scratch, &run->supports, run->workers, err));
    for (uint32_t w = 0; w < run->workers; w++)
        HATCH_TRY(hatch_support_make(&graph->surface, graph->normals, scratch, &run->supports[w], err));
    if (!(run->options->radius > 0))
        return hatch_curvature_estimate_adaptive(run, scratch, err);
    hatch_curvature_for_each(run, surface->point_count, estimate_point, run);
    return HATCH_OK;
}

enum hatch_status hatch_curvature_estimate(const struct hatch_surface *surface, const struct hatch_frames *frames,
                                           const struct hatch_curvature_options *options, struct hatch_arena *arena,
                                           struct hatch_arena *scratch, struct hatch_curvature *curvature,
                                           struct hatch_err *err)
{
    assert(!(options->radius < 0) && options->radius <= 100);
    assert(options->degree == 0 || (options->degree >= 2 && options->degree <= HATCH_JET_DEGREE_MAX));
    struct hatch_curvature made;
    HATCH_TRY(hatch_curvature_allocate(surface->point_count, arena, &made, err));
    struct hatch_curvature_run run = {
        .frames = frames,
        .options = options,
        .workers = hatch_pool_workers(options->pool, hatch_support_bytes(surface->point_count), scratch),
        .curvature = &made};
    struct hatch_arena_mark mark = hatch_arena_mark(scratch);
    enum hatch_status status = estimate(surface, &run, scratch, err);
    hatch_arena_rewind(scratch, mark);
    if (status == HATCH_LIMIT && run.workers > 1) { /* the number of threads must not decide */
        run.workers = 1;
        status = estimate(surface, &run, scratch, err);
        hatch_arena_rewind(scratch, mark);
    }
    if (status == HATCH_OK)
        *curvature = made;
    return status;
}
