/* Traces the levels of all families and components. */
#include "trace/trace.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/budget.h"
#include "base/random.h"
#include "trace/work.h"

#define STREAM_FAMILY 11
#define CALM 0.5 /* of the gap: strokes end that near to a singularity */

enum hatch_status hatch_trace_add_level(struct hatch_tracer *tracer, uint32_t level, struct hatch_err *err)
{
    struct hatch_arena_mark mark = hatch_arena_mark(tracer->scratch);
    tracer->level = level;
    tracer->gap = ldexp(tracer->options->gap, -(int)level) / tracer->component->scale;
    tracer->ground.calm = CALM * tracer->gap;
    tracer->stop_count = 0;
    HATCH_TRY(hatch_trace_sort(tracer, err));
    HATCH_TRY(hatch_trace_gather(tracer, err));
    HATCH_TRY(hatch_trace_add_stops(tracer, 0, err));
    for (uint32_t phase = 0; phase < HATCH_TRACE_PHASES; phase++) {
        uint32_t before = tracer->stroke_count;
        HATCH_TRY(hatch_trace_add_seeds(tracer, phase, err));
        hatch_arena_rewind(tracer->scratch, mark);
        HATCH_TRY(hatch_trace_grow(tracer, err));
        hatch_arena_rewind(tracer->scratch, mark);
        HATCH_TRY(hatch_trace_add_stops(tracer, before, err));
        if (phase == 0)
            HATCH_TRY(hatch_trace_gather(tracer, err));
    }
    HATCH_TRY(hatch_trace_find_thresholds(tracer, err));
    hatch_arena_rewind(tracer->scratch, mark);
    return HATCH_OK;
}

/* A curve's place in the order of a set. */
struct ranked {
    float threshold; /* least of its points */
    uint8_t level;
    uint32_t id, curve;
};

static int by_rank(const void *a, const void *b)
{
    const struct ranked *x = a, *y = b;
    if (x->level != y->level)
        return x->level < y->level ? -1 : 1;
    if (x->threshold != y->threshold)
        return x->threshold < y->threshold ? -1 : 1;
    if (x->id != y->id)
        return x->id < y->id ? -1 : 1;
    return x->curve < y->curve ? -1 : x->curve > y->curve;
}

/* Appends the collected curves of a family to the result, sorted, a set for each level. */
static enum hatch_status add_sets(const struct hatch_trace_options *options, uint32_t family,
                                  const struct hatch_trace_sink *sink, struct hatch_arena *scratch,
                                  struct hatch_curves *curves, struct hatch_err *err)
{
    const struct hatch_curves *from = &sink->curves;
    struct hatch_arena_mark mark = hatch_arena_mark(scratch);
    struct ranked *order;
    HATCH_TRY(HATCH_ALLOC_UNSET(scratch, &order, from->count, err));
    for (uint32_t c = 0; c < from->count; c++) {
        const struct hatch_curve *curve = &from->curves[c];
        order[c] = (struct ranked){HUGE_VALF, sink->levels[c], curve->id, c};
        for (uint32_t i = curve->first; i < curve->first + curve->count; i++)
            order[c].threshold = fminf(order[c].threshold, from->points[i].threshold);
    }
    if (from->count > 0)
        qsort(order, from->count, sizeof *order, by_rank);
    uint32_t next = 0;
    for (uint32_t level = 0; level < options->levels; level++) {
        struct hatch_curve_set *set = &curves->sets[curves->set_count++];
        *set = (struct hatch_curve_set){.family = family,
                                        .level = level,
                                        .angle_rad = options->angle_rad[family],
                                        .gap = (float)ldexp(options->gap, -(int)level),
                                        .first = curves->count,
                                        .length = (float)options->length,
                                        .hard_rad = (float)options->hard_rad};
        for (; next < from->count && order[next].level == level; next++) {
            struct hatch_curve *curve = &curves->curves[curves->count++];
            *curve = from->curves[order[next].curve];
            memcpy(&curves->points[curves->point_count], &from->points[curve->first],
                   curve->count * sizeof *curves->points);
            curve->first = curves->point_count;
            curves->point_count += curve->count;
        }
        set->count = curves->count - set->first;
    }
    hatch_arena_rewind(scratch, mark);
    return HATCH_OK;
}

/* The families while they are traced. Each has arenas of its own, so that they can be traced side by side. */
struct tracing {
    const struct hatch_surface *surface;
    const struct hatch_mesh *mesh;
    const struct hatch_frames *frames;
    const double *direction;
    const struct hatch_trace_options *options;
    struct hatch_pool *pool; /* for the inside of a family */
    bool together;           /* families are traced side by side, each on one thread */
    struct hatch_arena traced[HATCH_CURVE_FAMILIES_MAX];
    struct hatch_trace_sink sinks[HATCH_CURVE_FAMILIES_MAX];
    enum hatch_status statuses[HATCH_CURVE_FAMILIES_MAX];
    struct hatch_err errs[HATCH_CURVE_FAMILIES_MAX];
    struct hatch_budget budget; /* of all arenas */
};

/* Traces a family on all components.
 *   tracer  without component */
static enum hatch_status trace_family(const struct tracing *tracing, const struct hatch_tracer *tracer, uint32_t family,
                                      struct hatch_trace_sink *sink, struct hatch_err *err)
{
    const struct hatch_surface *surface = tracing->surface;
    const struct hatch_trace_options *options = tracing->options;
    uint32_t before = tracing->together ? 0 : family, all = tracing->together ? 1 : options->family_count;
    double steps = (double)all * surface->component_count * options->levels;
    for (uint32_t c = 0; c < surface->component_count; c++) {
        struct hatch_arena_mark mark = hatch_arena_mark(tracer->keep);
        struct hatch_tracer fresh = *tracer;
        fresh.component = &surface->components[c];
        fresh.leg_max = ldexp(options->gap, 1 - (int)options->levels) / fresh.component->scale;
        for (uint32_t level = 0; level < options->levels; level++) {
            HATCH_TRY(hatch_trace_add_level(&fresh, level, err));
            double done = ((double)before * surface->component_count + c) * options->levels + level + 1;
            if (!tracing->together || family == 0) /* progress is reported on one thread */
                hatch_progress_report(options->progress, done / steps);
        }
        HATCH_TRY(hatch_trace_collect(&fresh, sink, err));
        hatch_arena_rewind(tracer->keep, mark);
        hatch_trace_room_free(tracer->piece_room);
        hatch_trace_room_free(tracer->stop_room);
    }
    return HATCH_OK;
}

static void run_family(void *context, uint32_t family)
{
    struct tracing *tracing = context;
    struct hatch_arena keep, scratch;
    struct hatch_trace_room pieces, stops;
    struct hatch_err *err = &tracing->errs[family];
    struct hatch_tracer tracer = {.options = tracing->options,
                                  .family = family,
                                  .seed = hatch_random_u64(tracing->options->seed, STREAM_FAMILY, family),
                                  .keep = &keep,
                                  .scratch = &scratch,
                                  .piece_room = &pieces,
                                  .stop_room = &stops,
                                  .pool = tracing->together ? NULL : tracing->pool};
    hatch_arena_init_shared(&keep, &tracing->budget);
    hatch_arena_init_shared(&scratch, &tracing->budget);
    hatch_trace_room_init(&pieces, &tracing->budget);
    hatch_trace_room_init(&stops, &tracing->budget);
    hatch_arena_init_shared(&tracing->traced[family], &tracing->budget);
    tracing->sinks[family] = (struct hatch_trace_sink){.mesh = tracing->mesh, .arena = &tracing->traced[family]};
    enum hatch_status status = hatch_trace_lay_out(tracing->surface, tracing->frames, tracing->direction,
                                                   (double)tracing->options->angle_rad[family],
                                                   tracing->options->hard_rad, &keep, &tracer.ground, err);
    if (status == HATCH_OK)
        status = trace_family(tracing, &tracer, family, &tracing->sinks[family], err);
    tracing->statuses[family] = status;
    hatch_trace_room_free(&pieces);
    hatch_trace_room_free(&stops);
    hatch_arena_free(&keep);
    hatch_arena_free(&scratch);
}

static void free_traced(struct tracing *tracing)
{
    for (uint32_t family = 0; family < tracing->options->family_count; family++)
        hatch_arena_free(&tracing->traced[family]);
}

static enum hatch_status first_failure(const struct tracing *tracing, struct hatch_err *err)
{
    for (uint32_t family = 0; family < tracing->options->family_count; family++)
        if (tracing->statuses[family] != HATCH_OK) {
            *err = tracing->errs[family];
            return err->status;
        }
    return HATCH_OK;
}

/* Traces all families: one after the other where the memory does not suffice for all at once. */
static void trace_families(struct tracing *tracing)
{
    uint32_t count = tracing->options->family_count;
    struct hatch_err err;
    if (tracing->together) {
        hatch_parallel_for(tracing->pool, count, run_family, tracing);
        if (first_failure(tracing, &err) != HATCH_LIMIT)
            return;
        free_traced(tracing);
        tracing->together = false;
    }
    for (uint32_t family = 0; family < count; family++)
        run_family(tracing, family);
}

/* Joins the families in one result. */
static enum hatch_status join(const struct tracing *tracing, struct hatch_arena *arena, struct hatch_arena *scratch,
                              struct hatch_curves *curves, struct hatch_err *err)
{
    const struct hatch_trace_options *options = tracing->options;
    struct hatch_curves made = {0};
    size_t count = 0, point_count = 0;
    HATCH_TRY(first_failure(tracing, err));
    for (uint32_t family = 0; family < options->family_count; family++) {
        count += tracing->sinks[family].curves.count;
        point_count += tracing->sinks[family].curves.point_count;
    }
    if (point_count > UINT32_MAX)
        return hatch_fail(err, HATCH_LIMIT, "too many strokes: use a wider gap or fewer levels");
    HATCH_TRY(HATCH_ALLOC(arena, &made.sets, (size_t)options->family_count * options->levels, err));
    HATCH_TRY(HATCH_ALLOC_UNSET(arena, &made.curves, count, err));
    HATCH_TRY(HATCH_ALLOC_UNSET(arena, &made.points, point_count, err));
    for (uint32_t family = 0; family < options->family_count; family++)
        HATCH_TRY(add_sets(options, family, &tracing->sinks[family], scratch, &made, err));
    *curves = made;
    return HATCH_OK;
}

enum hatch_status hatch_trace_make(const struct hatch_surface *surface, const struct hatch_mesh *mesh,
                                   const struct hatch_frames *frames, const double *direction,
                                   const struct hatch_trace_options *options, struct hatch_pool *pool,
                                   struct hatch_arena *arena, struct hatch_arena *scratch, struct hatch_curves *curves,
                                   struct hatch_err *err)
{
    uint32_t threads = pool ? hatch_pool_threads(pool) : 1;
    size_t available = scratch->limit_bytes - scratch->used_bytes;
    struct tracing tracing = {.surface = surface,
                              .mesh = mesh,
                              .frames = frames,
                              .direction = direction,
                              .options = options,
                              .pool = pool,
                              .together = threads > 1 && threads <= options->family_count};
    hatch_budget_init(&tracing.budget, available ? available : 1);
    trace_families(&tracing);
    enum hatch_status status = join(&tracing, arena, scratch, curves, err);
    free_traced(&tracing);
    return status;
}
