/* Traces a level in a region: the strokes of the levels before are laid there, and those of the level between them. */
#include <math.h>
#include <string.h>

#include "trace/finer/store.h"

#define TOLERANCE 0.02      /* of the gap: how far a line may pass from the pieces that it replaces */
#define THRESHOLD_RATIO 0.1 /* logarithm of the ratio by which its threshold may differ */
#define LEG_MAX 0.75        /* of the gap: greatest length of a piece */
#define PERIOD 4096.0       /* stops from which lengths are measured anew, so that they are precise */
#define QUANTUM 14          /* binary places of the gap in coordinates */
#define RUN_MAX 32u         /* pieces that a line may replace */
#define LENGTH_MIN 1.0      /* of the gap: shorter strokes are left out */

/* A stroke that is being laid in the region. */
struct laying {
    struct hatch_tracer *tracer;
    const struct hatch_store_line *line;
    double origin; /* length along the line from which the tracer's stroke is measured */
    bool open;     /* the last stroke of the tracer goes on */
};

/* Begins a stroke of the tracer.
 *   arc  length along the line */
static enum hatch_status begin_stroke(struct laying *laying, uint32_t face, const double at[2], double arc,
                                      struct hatch_err *err)
{
    struct hatch_tracer *tracer = laying->tracer;
    double step = HATCH_TRACE_STEP * tracer->gap, number = floor(arc / (step * PERIOD)) * PERIOD;
    const struct hatch_trace_seed seed = {.place = {face, at[0], at[1], {1, 0}}, .id = laying->line->id};
    HATCH_TRY(hatch_trace_add_stroke(tracer, &seed, err));
    struct hatch_trace_stroke *stroke = &tracer->strokes[tracer->stroke_count - 1];
    stroke->level = laying->line->level;
    stroke->given = true;
    stroke->growing[0] = stroke->growing[1] = false;
    stroke->first_number = (int64_t)number;
    stroke->first_arc = arc - number * step;
    laying->origin = number * step;
    laying->open = true;
    return HATCH_OK;
}

/* Lays the part of a piece that is in the region. It is cut into parts no longer than the tracer's, at places that do
 * not depend on the region. */
static enum hatch_status lay_piece(struct laying *laying, const struct hatch_store_piece *piece, struct hatch_err *err)
{
    struct hatch_tracer *tracer = laying->tracer;
    uint32_t window = tracer->region->of_face[piece->face];
    double share[2], way[2] = {piece->to[0] - piece->from[0], piece->to[1] - piece->from[1]};
    double length = hypot(way[0], way[1]), parts = fmax(ceil(length / tracer->leg_max), 1);
    if (window == HATCH_NO_SIDE ||
        !hatch_trace_window_clip(&tracer->region->windows[window], piece->from, piece->to, share)) {
        laying->open = false;
        return HATCH_OK;
    }
    double first = floor(share[0] * parts), last = fmin(ceil(share[1] * parts), parts);
    for (double i = first; i < last; i++) {
        struct hatch_trace_leg leg = {.face = piece->face, .length = length / parts};
        double arc = piece->arc - (parts - i) / parts * length;
        for (int k = 0; k < 2; k++) {
            leg.from[k] = piece->from[k] + i / parts * way[k];
            leg.to[k] = piece->from[k] + (i + 1) / parts * way[k];
        }
        if (!laying->open || (first > 0 && i <= first))
            HATCH_TRY(begin_stroke(laying, piece->face, leg.from, arc, err));
        tracer->strokes[tracer->stroke_count - 1].length[0] = arc - laying->origin;
        HATCH_TRY(hatch_trace_add_piece(tracer, 2 * (tracer->stroke_count - 1), &leg, err));
    }
    laying->open = last >= parts;
    return HATCH_OK;
}

/* Lays the strokes of the tracer's component. */
static enum hatch_status lay_batch(const struct hatch_store_batch *batch, struct hatch_tracer *tracer,
                                   struct hatch_err *err)
{
    const struct hatch_component *component = tracer->component;
    for (uint32_t l = 0; l < batch->line_count; l++) {
        struct laying laying = {tracer, &batch->lines[l], 0, false};
        const uint32_t face = laying.line->count > 0 ? batch->pieces[laying.line->first].face : 0;
        if (face < component->first_face || face - component->first_face >= component->face_count)
            continue;
        for (uint32_t i = 0; i < laying.line->count; i++)
            HATCH_TRY(lay_piece(&laying, &batch->pieces[laying.line->first + i], err));
    }
    return HATCH_OK;
}

/* Returns the logarithm of the threshold with which a stroke is drawn. */
static double drawn(const struct hatch_store *store, double log_threshold)
{
    double octaves = hatch_store_octaves(store, log_threshold);
    double part = (octaves - floor(octaves)) * HATCH_STORE_DRIFTS - 0.5;
    double before = floor(part), drifts[2];
    for (int i = 0; i < 2; i++)
        drifts[i] = store->drift[((int)before + i + (int)HATCH_STORE_DRIFTS) % (int)HATCH_STORE_DRIFTS];
    return log_threshold + drifts[0] + (part - before) * (drifts[1] - drifts[0]);
}

/* A stroke of the tracer while it is kept. */
struct keeping {
    const struct hatch_store *store;
    const struct hatch_tracer *tracer;
    const struct hatch_trace_stroke *stroke;
    struct hatch_store_batch *batch;
    struct hatch_store_piece run[RUN_MAX]; /* pieces on a face that one may replace */
    uint32_t run_count;
    double run_threshold, last_threshold; /* logarithms: before the run, and at the end of the last piece */
};

/* Returns whether the run and one more piece can be replaced by a line. */
static bool is_straight(const struct keeping *keeping, const struct hatch_store_piece *next)
{
    const struct hatch_store_piece *first = &keeping->run[0];
    double way[2] = {next->to[0] - first->from[0], next->to[1] - first->from[1]}, length = hypot(way[0], way[1]);
    double start = first->arc - hypot(first->to[0] - first->from[0], first->to[1] - first->from[1]);
    for (uint32_t i = 0; i < keeping->run_count; i++) {
        const struct hatch_store_piece *piece = &keeping->run[i];
        double off[2] = {piece->to[0] - first->from[0], piece->to[1] - first->from[1]};
        double share = (piece->arc - start) / fmax(next->arc - start, 1e-300);
        double wanted = keeping->run_threshold + share * ((double)next->log_threshold - keeping->run_threshold);
        if (fabs(way[0] * off[1] - way[1] * off[0]) > TOLERANCE * keeping->tracer->gap * length ||
            fabs((double)piece->log_threshold - wanted) > THRESHOLD_RATIO)
            return false;
    }
    return length >= (1 - 1e-4) * (next->arc - start);
}

static enum hatch_status end_run(struct keeping *keeping, struct hatch_err *err)
{
    if (keeping->run_count == 0)
        return HATCH_OK;
    struct hatch_store_piece piece = keeping->run[keeping->run_count - 1];
    memcpy(piece.from, keeping->run[0].from, sizeof piece.from);
    keeping->run_count = 0;
    return hatch_store_add_piece(keeping->batch, &keeping->batch->arena, &piece, err);
}

static enum hatch_status keep_piece(struct keeping *keeping, const struct hatch_store_piece *piece,
                                    struct hatch_err *err)
{
    if (keeping->run_count > 0 &&
        (keeping->run_count == RUN_MAX || keeping->run[0].face != piece->face || !is_straight(keeping, piece)))
        HATCH_TRY(end_run(keeping, err));
    if (keeping->run_count == 0)
        keeping->run_threshold = keeping->last_threshold;
    keeping->run[keeping->run_count++] = *piece;
    keeping->last_threshold = (double)piece->log_threshold;
    return HATCH_OK;
}

/* Keeps the pieces of one half of a stroke, from its back to its front. */
static enum hatch_status keep_half(struct keeping *keeping, uint32_t way, struct hatch_err *err)
{
    const struct hatch_tracer *tracer = keeping->tracer;
    const struct hatch_trace_stroke *stroke = keeping->stroke;
    struct hatch_arena_mark mark = hatch_arena_mark(tracer->scratch);
    uint32_t *order, count = 0;
    for (uint32_t n = stroke->first[way]; n != HATCH_TRACE_NONE; n = tracer->pieces[n].next)
        count++;
    HATCH_TRY(HATCH_ALLOC_UNSET(tracer->scratch, &order, count, err));
    count = 0;
    for (uint32_t n = stroke->first[way]; n != HATCH_TRACE_NONE; n = tracer->pieces[n].next)
        order[count++] = n;
    for (uint32_t i = 0; i < count; i++) {
        const struct hatch_trace_piece *piece = &tracer->pieces[order[way ? count - 1 - i : i]];
        const double *corner = hatch_trace_origin_of(tracer, piece->face);
        const float *from = way ? piece->to : piece->from, *to = way ? piece->from : piece->to;
        double length = hypot((double)(to[0] - from[0]), (double)(to[1] - from[1]));
        double arc = way ? length - (double)piece->arc : (double)piece->arc; /* from the seed to `to` */
        double threshold = hatch_trace_threshold_at(tracer, stroke, arc) - log(tracer->component->scale);
        const struct hatch_store_piece kept = {.face = piece->face,
                                               .log_threshold = (float)drawn(keeping->store, threshold),
                                               .from = {(double)from[0] + corner[0], (double)from[1] + corner[1]},
                                               .to = {(double)to[0] + corner[0], (double)to[1] + corner[1]},
                                               .arc = arc + stroke->length[1]};
        HATCH_TRY(keep_piece(keeping, &kept, err));
    }
    hatch_arena_rewind(tracer->scratch, mark);
    return HATCH_OK;
}

/* Keeps a stroke if its seed is in one of the batch's tiles. */
static enum hatch_status keep_stroke(struct keeping *keeping, struct hatch_err *err)
{
    const struct hatch_trace_stroke *stroke = keeping->stroke;
    const struct hatch_tracer *tracer = keeping->tracer;
    const struct hatch_trace_place *seed = &stroke->seed;
    const double at[2] = {seed->x, seed->y};
    double middle[3], log_scale = log(tracer->component->scale);
    const struct hatch_store_tile tile =
        hatch_store_tile_at(&tracer->ground, seed->face, at, hatch_store_tile_side(tracer->gap));
    if (stroke->given || stroke->length[0] + stroke->length[1] < LENGTH_MIN * tracer->gap ||
        !hatch_store_has_tile(keeping->batch, &tile))
        return HATCH_OK;
    struct hatch_store_line line = {
        .level = stroke->level,
        .free_ends = (stroke->bound[1] ? 0u : 1u) | (stroke->bound[0] ? 0u : 2u),
        .id = stroke->id,
        .length = stroke->length[0] + stroke->length[1],
        .log_threshold =
            (float)drawn(keeping->store, hatch_trace_threshold_at(tracer, stroke, -stroke->length[1]) - log_scale)};
    hatch_trace_position(&tracer->ground.poses[seed->face], seed->x, seed->y, middle);
    for (int k = 0; k < 3; k++)
        line.middle[k] = (float)(middle[k] * tracer->component->scale + tracer->component->center[k]);
    keeping->last_threshold = (double)line.log_threshold;
    HATCH_TRY(hatch_store_add_line(keeping->batch, &keeping->batch->arena, &line, err));
    HATCH_TRY(keep_half(keeping, 1, err));
    HATCH_TRY(keep_half(keeping, 0, err));
    return end_run(keeping, err);
}

static enum hatch_status trace(struct hatch_store *store, struct hatch_store_batch *batch, struct hatch_tracer *tracer,
                               struct hatch_err *err)
{
    tracer->level = batch->level;
    tracer->gap = hatch_store_gap(store, batch->level, tracer->component);
    tracer->leg_max = LEG_MAX * tracer->gap;
    tracer->quantum = ldexp(1, (int)floor(log2(tracer->gap)) - QUANTUM);
    for (uint32_t i = 0; i < tracer->region->count; i++)
        for (int k = 0; k < 2; k++)
            tracer->region->windows[i].low[k] =
                floor(tracer->region->windows[i].low[k] / tracer->quantum) * tracer->quantum;
    HATCH_TRY(hatch_trace_sort(tracer, err));
    HATCH_TRY(lay_batch(&store->given, tracer, err));
    for (const struct hatch_store_batch *from = store->batches; from; from = from->next)
        if (from->level < batch->level && from->component == tracer->component)
            HATCH_TRY(lay_batch(from, tracer, err));
    HATCH_TRY(hatch_trace_add_level(tracer, batch->level, err));
    for (uint32_t s = 0; s < tracer->stroke_count; s++) {
        struct keeping keeping = {
            .store = store, .tracer = tracer, .stroke = &tracer->strokes[s], .batch = batch, .run_count = 0};
        HATCH_TRY(keep_stroke(&keeping, err));
    }
    return HATCH_OK;
}

enum hatch_status hatch_store_trace_region(struct hatch_store *store, const struct hatch_component *component,
                                           const struct hatch_trace_region *region, struct hatch_store_batch *batch,
                                           struct hatch_err *err)
{
    struct hatch_arena keep;
    struct hatch_trace_room pieces, stops;
    struct hatch_tracer tracer = {.options = &store->options,
                                  .family = store->family,
                                  .seed = store->options.seed,
                                  .ground = store->ground,
                                  .component = component,
                                  .region = region,
                                  .keep = &keep,
                                  .scratch = &store->scratch,
                                  .piece_room = &pieces,
                                  .stop_room = &stops,
                                  .pool = store->pool};
    hatch_arena_init_shared(&keep, &store->budget);
    hatch_trace_room_init(&pieces, &store->budget);
    hatch_trace_room_init(&stops, &store->budget);
    enum hatch_status status = trace(store, batch, &tracer, err);
    hatch_trace_room_free(&pieces);
    hatch_trace_room_free(&stops);
    hatch_arena_free(&keep);
    return status;
}
