/* Traces the levels of all families and components. */
#include "trace/trace.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/random.h"
#include "trace/work.h"

#define STREAM_FAMILY 11

static enum hatch_status add_level(struct hatch_tracer *tracer, uint32_t level, struct hatch_err *err)
{
    tracer->level = level;
    tracer->gap = ldexp(tracer->options->gap, -(int)level) / tracer->component->scale;
    HATCH_TRY(hatch_trace_sort(tracer, err));
    HATCH_TRY(hatch_trace_gather(tracer, err));
    tracer->stop_count = 0;
    HATCH_TRY(hatch_trace_add_stops(tracer, 0, err));
    for (uint32_t phase = 0; phase < HATCH_TRACE_PHASES; phase++) {
        uint32_t before = tracer->stroke_count;
        HATCH_TRY(hatch_trace_add_seeds(tracer, phase, err));
        HATCH_TRY(hatch_trace_grow(tracer, err));
        HATCH_TRY(hatch_trace_add_stops(tracer, before, err));
        if (phase == 0)
            HATCH_TRY(hatch_trace_gather(tracer, err));
    }
    return hatch_trace_find_thresholds(tracer, err);
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
                                        .first = curves->count};
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

/* Traces a family on all components. */
static enum hatch_status trace_family(struct hatch_tracer *tracer, uint32_t family, struct hatch_trace_sink *sink,
                                      struct hatch_err *err)
{
    const struct hatch_surface *surface = tracer->ground.surface;
    const struct hatch_trace_options *options = tracer->options;
    double steps = (double)options->family_count * surface->component_count * options->levels;
    tracer->seed = hatch_random_u64(options->seed, STREAM_FAMILY, family);
    for (uint32_t c = 0; c < surface->component_count; c++) {
        struct hatch_arena_mark mark = hatch_arena_mark(tracer->scratch);
        struct hatch_tracer fresh = *tracer;
        fresh.component = &surface->components[c];
        fresh.leg_max = ldexp(options->gap, 1 - (int)options->levels) / fresh.component->scale;
        for (uint32_t level = 0; level < options->levels; level++) {
            HATCH_TRY(add_level(&fresh, level, err));
            double done = ((double)family * surface->component_count + c) * options->levels + level + 1;
            hatch_progress_report(options->progress, done / steps);
        }
        HATCH_TRY(hatch_trace_collect(&fresh, sink, err));
        hatch_arena_rewind(tracer->scratch, mark);
    }
    return HATCH_OK;
}

enum hatch_status hatch_trace_make(const struct hatch_surface *surface, const struct hatch_mesh *mesh,
                                   const struct hatch_frames *frames, const double *direction,
                                   const struct hatch_trace_options *options, struct hatch_pool *pool,
                                   struct hatch_arena *arena, struct hatch_arena *scratch, struct hatch_curves *curves,
                                   struct hatch_err *err)
{
    struct hatch_trace_sink sinks[HATCH_CURVE_FAMILIES_MAX];
    struct hatch_arena traced; /* what is collected outlives the scratch memory of the tracer */
    struct hatch_curves made = {0};
    size_t count = 0, point_count = 0;
    enum hatch_status status = HATCH_OK;
    hatch_arena_init(&traced, scratch->limit_bytes);
    for (uint32_t family = 0; family < options->family_count && status == HATCH_OK; family++) {
        struct hatch_arena_mark mark = hatch_arena_mark(scratch);
        struct hatch_tracer tracer = {.options = options, .scratch = scratch, .pool = pool};
        sinks[family] = (struct hatch_trace_sink){.mesh = mesh, .arena = &traced};
        status = hatch_trace_lay_out(surface, frames, direction, (double)options->angle_rad[family], options->hard_rad,
                                     scratch, &tracer.ground, err);
        if (status == HATCH_OK)
            status = trace_family(&tracer, family, &sinks[family], err);
        hatch_arena_rewind(scratch, mark);
        count += sinks[family].curves.count;
        point_count += sinks[family].curves.point_count;
    }
    if (status == HATCH_OK && point_count > UINT32_MAX)
        status = hatch_fail(err, HATCH_LIMIT, "too many strokes: use a wider gap or fewer levels");
    if (status == HATCH_OK)
        status = HATCH_ALLOC(arena, &made.sets, (size_t)options->family_count * options->levels, err);
    if (status == HATCH_OK)
        status = HATCH_ALLOC_UNSET(arena, &made.curves, count, err);
    if (status == HATCH_OK)
        status = HATCH_ALLOC_UNSET(arena, &made.points, point_count, err);
    for (uint32_t family = 0; family < options->family_count && status == HATCH_OK; family++)
        status = add_sets(options, family, &sinks[family], scratch, &made, err);
    hatch_arena_free(&traced);
    if (status == HATCH_OK)
        *curves = made;
    return status;
}
