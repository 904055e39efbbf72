/* The parts of strokes that lie in a region, as curves of the mesh. */
#include <math.h>
#include <string.h>

#include "trace/finer/store.h"

#define TOLERANCE 0.15 /* of the finest gap: how far a line may pass from the stroke */

/* A line of a batch on its way into the curves. */
struct passing {
    const struct hatch_store *store;
    const struct hatch_store_line *line;
    const struct hatch_component *component;
    struct hatch_store_sink *sink;
    double log_raised;                /* added to thresholds */
    struct hatch_trace_joint *joints; /* of the part that is in the region: room for two per piece */
    uint32_t count;
};

static void add_joint(struct passing *passing, uint32_t face, const double at[2], double arc, double log_threshold)
{
    struct hatch_trace_joint *joint = &passing->joints[passing->count++];
    *joint =
        (struct hatch_trace_joint){.face = face, .x = at[0], .y = at[1], .arc = arc, .log_threshold = log_threshold};
    hatch_trace_position(&passing->store->ground.poses[face], at[0], at[1], joint->at);
    hatch_trace_normal(&passing->store->ground.poses[face], joint->normal);
}

/* Makes a curve of the joints. */
static enum hatch_status end_part(struct passing *passing, struct hatch_err *err)
{
    const struct hatch_store *store = passing->store;
    struct hatch_store_sink *sink = passing->sink;
    struct hatch_curves *curves = &sink->found->curves;
    double scale = passing->component->scale, start, end;
    uint32_t count = passing->count;
    passing->count = 0;
    if (count < 2)
        return HATCH_OK;
    start = passing->joints[0].arc;
    end = passing->joints[count - 1].arc;
    if (!(end > start))
        return HATCH_OK;
    count = hatch_trace_simplify(passing->joints, count, TOLERANCE * sink->finest / scale);
    HATCH_TRY(hatch_curve_reserve(sink->arena, &curves->curves, sizeof *curves->curves, curves->count,
                                  &sink->curve_capacity, err));
    HATCH_TRY(hatch_curve_reserve(sink->arena, &sink->found->parts, sizeof *sink->found->parts, curves->count,
                                  &sink->part_capacity, err));
    struct hatch_finer_part *part = &sink->found->parts[curves->count];
    *part = (struct hatch_finer_part){.before = (float)(start * scale),
                                      .after = (float)(fmax(passing->line->length - end, 0) * scale)};
    memcpy(part->middle, passing->line->middle, sizeof part->middle);
    curves->curves[curves->count++] =
        (struct hatch_curve){.first = curves->point_count,
                             .count = count,
                             .id = (uint32_t)(passing->line->id >> 32) & HATCH_CURVE_ID_MAX,
                             .free_ends = passing->line->free_ends};
    for (uint32_t i = 0; i < count; i++) {
        HATCH_TRY(hatch_curve_reserve(sink->arena, &curves->points, sizeof *curves->points, curves->point_count,
                                      &sink->point_capacity, err));
        struct hatch_curve_point *point = &curves->points[curves->point_count++];
        hatch_trace_fill_point(&store->ground, sink->mesh, &passing->joints[i],
                               exp(passing->joints[i].log_threshold + passing->log_raised), point);
        hatch_trace_find_narrow(&store->ground, &store->options, store->family, &passing->joints[i],
                                hatch_store_gap(store, passing->line->level, passing->component), scale, point);
    }
    return HATCH_OK;
}

/* Adds the part of a piece that is in the region.
 *   before  logarithm of the threshold at its start */
static enum hatch_status add_piece(struct passing *passing, const struct hatch_trace_region *region,
                                   const struct hatch_store_piece *piece, double before, struct hatch_err *err)
{
    uint32_t window = region->of_face[piece->face];
    double share[2], length = hypot(piece->to[0] - piece->from[0], piece->to[1] - piece->from[1]);
    bool any =
        window != HATCH_NO_SIDE && hatch_trace_window_clip(&region->windows[window], piece->from, piece->to, share);
    if (!any || share[0] > 0)
        HATCH_TRY(end_part(passing, err));
    if (!any)
        return HATCH_OK;
    for (int e = passing->count > 0 ? 1 : 0; e < 2; e++) {
        double at[2];
        for (int k = 0; k < 2; k++)
            at[k] = piece->from[k] + share[e] * (piece->to[k] - piece->from[k]);
        add_joint(passing, piece->face, at, piece->arc - (1 - share[e]) * length,
                  before + share[e] * ((double)piece->log_threshold - before));
    }
    return share[1] < 1 ? end_part(passing, err) : HATCH_OK;
}

static const struct hatch_component *component_of(const struct hatch_store *store, uint32_t face)
{
    const struct hatch_surface *surface = store->ground.surface;
    uint32_t low = 0, high = surface->component_count;
    while (high - low > 1) {
        uint32_t middle = (low + high) / 2;
        if (surface->components[middle].first_face <= face)
            low = middle;
        else
            high = middle;
    }
    return &surface->components[low];
}

static enum hatch_status add_batch(const struct hatch_store *store, const struct hatch_store_batch *batch,
                                   uint32_t level, const struct hatch_trace_region *region,
                                   struct hatch_store_sink *sink, struct hatch_err *err)
{
    for (uint32_t l = 0; l < batch->line_count; l++) {
        const struct hatch_store_line *line = &batch->lines[l];
        const struct hatch_store_piece *pieces = &batch->pieces[line->first];
        if (line->level != level || line->count == 0)
            continue;
        struct passing passing = {
            .store = store, .line = line, .sink = sink, .component = component_of(store, pieces[0].face)};
        passing.log_raised = level < store->level_count ? 0 : log(store->raised);
        struct hatch_arena_mark mark = hatch_arena_mark(sink->scratch);
        HATCH_TRY(HATCH_ALLOC_UNSET(sink->scratch, &passing.joints, 2 * (size_t)line->count, err));
        for (uint32_t i = 0; i < line->count; i++)
            HATCH_TRY(add_piece(&passing, region, &pieces[i],
                                (double)(i > 0 ? pieces[i - 1].log_threshold : line->log_threshold), err));
        HATCH_TRY(end_part(&passing, err));
        hatch_arena_rewind(sink->scratch, mark);
    }
    return HATCH_OK;
}

enum hatch_status hatch_store_add_parts(const struct hatch_store *store, uint32_t level,
                                        const struct hatch_trace_region *region, struct hatch_store_sink *sink,
                                        struct hatch_err *err)
{
    struct hatch_curves *curves = &sink->found->curves;
    HATCH_TRY(hatch_curve_reserve(sink->arena, &curves->sets, sizeof *curves->sets, curves->set_count,
                                  &sink->set_capacity, err));
    struct hatch_curve_set *set = &curves->sets[curves->set_count++];
    *set = (struct hatch_curve_set){.family = store->family,
                                    .level = level,
                                    .angle_rad = store->angle_rad,
                                    .gap = (float)ldexp(store->options.gap, -(int)level),
                                    .first = curves->count};
    if (level < store->level_count)
        HATCH_TRY(add_batch(store, &store->given, level, region, sink, err));
    for (const struct hatch_store_batch *batch = store->batches; batch && level >= store->level_count;
         batch = batch->next)
        if (batch->level == level)
            HATCH_TRY(add_batch(store, batch, level, region, sink, err));
    set->count = curves->count - set->first;
    return HATCH_OK;
}
