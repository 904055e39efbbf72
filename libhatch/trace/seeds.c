/* Seeds of new strokes: beside strokes that have room there, and on faces that have none nearby. Every random number is
 * a hash of the stroke or face that a seed comes from, so that the seeds do not depend on an order. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/random.h"
#include "trace/work.h"

#define CHUNK 64u     /* candidates per task */
#define BATCH 8192u   /* candidates that are in memory at a time */
#define GAP_MIN 1.45  /* of the gap: wider ones get a stroke */
#define CELL_GAPS 8.0 /* side of the cells of a large face, each of which has random numbers of its own */
#define CLEAR_MIN 0.7 /* of the gap: least distance of a seed from the strokes beside it */

/* Seeds per gap of stroke and side, and per square of a gap of surface, phase by phase. */
static const double beside[HATCH_TRACE_PHASES] = {1 / 12.0, 1 / 12.0, 1 / 6.0, 1 / 3.0, 1 / 2.0};
static const double on_faces[HATCH_TRACE_PHASES] = {0, 0, 0, 0.1, 0.25};
#define FIRST_ON_FACES 0.02 /* in the first phase of all */
#define CHOICE_BITS 24u     /* low bits of a seed's id by which places beside strokes are chosen */

/* Streams of random numbers. */
enum { STREAM_COUNT = 2, STREAM_PLACE, STREAM_ITEM, STREAM_PHASES };

/* The place that a seed comes from. */
struct source {
    struct hatch_trace_place place; /* its heading is along the stroke beside which the seed will be */
    double arc;
    uint32_t stroke; /* HATCH_TRACE_NONE: on a face */
    double side;     /* 1: to the left of the stroke; -1: to the right */
};

/* A search for seeds, in batches of candidates. */
struct search {
    const struct hatch_tracer *tracer;
    uint64_t stream;
    uint64_t cells, counts;         /* keys of random numbers: ids of faces' first cells, and numbers of places */
    struct source *sources;         /* of a batch */
    struct hatch_trace_seed *batch; /* one per source */
    uint32_t batch_count;
    struct hatch_trace_seed *seeds; /* those found */
    uint32_t count, capacity;
};

/* Walks straight aside, to the left of the heading where `way` is positive, and heads along the strokes again. Returns
 * false where the walk meets a stroke or ends early. */
static bool step_aside(const struct hatch_tracer *tracer, struct hatch_trace_place *place, double way,
                       const struct hatch_trace_origin *origin)
{
    double sign = way < 0 ? -1 : 1, heading[2];
    double border;
    hatch_trace_turn(place, sign);
    if (hatch_trace_cast(tracer, place, fabs(way), origin, &border) < 0.999 * fabs(way) || border > 0)
        return false;
    hatch_trace_turn(place, -sign);
    if (!hatch_trace_direction(&tracer->ground, place, heading))
        return false;
    memcpy(place->heading, heading, sizeof heading);
    return true;
}

/* Moves a seed away from the nearer of the strokes beside it, to the middle of a gap or to the wanted distance. */
static bool center(const struct hatch_tracer *tracer, struct hatch_trace_place *place)
{
    const struct hatch_trace_origin nowhere = {.stroke = HATCH_TRACE_NONE};
    struct hatch_trace_gaps gaps = hatch_trace_gaps_at(tracer, place, &nowhere);
    double reach = HATCH_TRACE_REACH * tracer->gap, way = 0;
    if (gaps.left + gaps.right < GAP_MIN * tracer->gap)
        return false;
    if (gaps.left < reach && gaps.right < reach)
        way = (gaps.left - gaps.right) / 2;
    else if (gaps.left < reach)
        way = gaps.left - tracer->gap;
    else if (gaps.right < reach)
        way = tracer->gap - gaps.right;
    if (fabs(way) > 0.05 * tracer->gap) {
        if (!step_aside(tracer, place, way, &nowhere))
            return false;
        gaps = hatch_trace_gaps_at(tracer, place, &nowhere);
    }
    return fmin(gaps.left, gaps.right) >= CLEAR_MIN * tracer->gap;
}

static bool find_place(const struct hatch_tracer *tracer, const struct source *source, struct hatch_trace_seed *seed)
{
    const struct hatch_trace_pose *pose;
    double heading[2];
    seed->place = source->place;
    if (source->stroke == HATCH_TRACE_NONE) {
        if (!hatch_trace_direction(&tracer->ground, &seed->place, heading))
            return false;
        memcpy(seed->place.heading, heading, sizeof heading);
    } else {
        const struct hatch_trace_origin origin = {.stroke = source->stroke, .arc = source->arc};
        struct hatch_trace_place beyond;
        if (!step_aside(tracer, &seed->place, source->side * tracer->gap, &origin))
            return false;
        beyond = seed->place;
        if (!step_aside(tracer, &beyond, source->side * (GAP_MIN - 1) * tracer->gap, &origin))
            return false;
    }
    if (!center(tracer, &seed->place))
        return false;
    if (tracer->region && !hatch_trace_region_has(tracer->region, &seed->place))
        return false;
    pose = &tracer->ground.poses[seed->place.face];
    hatch_trace_position(pose, seed->place.x, seed->place.y, seed->at);
    hatch_trace_vector(pose, seed->place.heading, seed->heading);
    hatch_trace_normal(pose, seed->normal);
    return true;
}

static void find_places(void *context, uint32_t chunk)
{
    struct search *search = context;
    for (uint32_t i = chunk * CHUNK; i < (chunk + 1) * CHUNK && i < search->batch_count; i++)
        search->batch[i].valid = find_place(search->tracer, &search->sources[i], &search->batch[i]);
}

/* Looks for the places of a batch's seeds, and keeps the seeds that have one. */
static enum hatch_status finish_batch(struct search *search, struct hatch_err *err)
{
    hatch_parallel_for(search->tracer->pool, (search->batch_count + CHUNK - 1) / CHUNK, find_places, search);
    for (uint32_t i = 0; i < search->batch_count; i++) {
        if (!search->batch[i].valid)
            continue;
        HATCH_TRY(hatch_curve_reserve(search->tracer->scratch, &search->seeds, sizeof *search->seeds, search->count,
                                      &search->capacity, err));
        search->seeds[search->count++] = search->batch[i];
    }
    search->batch_count = 0;
    return HATCH_OK;
}

static enum hatch_status add_source(struct search *search, const struct source *source, uint64_t id,
                                    struct hatch_err *err)
{
    search->sources[search->batch_count] = *source;
    search->batch[search->batch_count++] = (struct hatch_trace_seed){.id = id};
    return search->batch_count < BATCH ? HATCH_OK : finish_batch(search, err);
}

/* Chooses places beside strokes. */
static enum hatch_status choose_stops(struct search *search, double share, struct hatch_err *err)
{
    const struct hatch_tracer *tracer = search->tracer;
    const uint32_t chosen = (uint32_t)(share * (1u << CHOICE_BITS));
    uint32_t stroke = HATCH_TRACE_NONE;
    uint64_t key = 0;
    for (uint32_t i = 0; i < tracer->stop_count; i++)
        for (uint32_t side = 0; side < 2; side++) {
            const struct hatch_trace_stop *stop = &tracer->stops[i];
            if (stop->stroke != stroke)
                key = hatch_random_key(tracer->strokes[stroke = stop->stroke].id, search->stream);
            int64_t number = tracer->strokes[stroke].first_number + stop->number;
            uint64_t id = hatch_random_at(key, (uint64_t)(uint32_t)number << 1 | side);
            if ((id & ((1u << CHOICE_BITS) - 1)) >= chosen)
                continue;
            const struct source source = {hatch_trace_stop_place(tracer, stop), (double)stop->arc, stop->stroke,
                                          side ? 1 : -1};
            HATCH_TRY(add_source(search, &source, id, err));
        }
    return HATCH_OK;
}

/* Chooses places in a cell of a face.
 *   id    of the cell
 *   cell  part of the rectangle around the face; places outside of the face are dropped */
static enum hatch_status choose_in_cell(struct search *search, const struct hatch_trace_window *cell, uint64_t id,
                                        double density, struct hatch_err *err)
{
    const struct hatch_tracer *tracer = search->tracer;
    double width = cell->high[0] - cell->low[0], height = cell->high[1] - cell->low[1];
    double count = floor(density * width * height + (double)hatch_random_unit_at(search->counts, id));
    for (uint64_t i = 0; (double)i < count; i++) {
        uint64_t item = hatch_random_u64(id, STREAM_ITEM, i);
        double x = cell->low[0] + width * (double)hatch_random_unit(item, STREAM_PLACE, 0), share[3];
        double y = cell->low[1] + height * (double)hatch_random_unit(item, STREAM_PLACE, 1);
        const struct source source = {{cell->face, x, y, {1, 0}}, 0, HATCH_TRACE_NONE, 0};
        hatch_trace_shares(&tracer->ground.faces[cell->face], x, y, share);
        if (share[0] >= 0 && share[1] >= 0 && share[2] >= 0)
            HATCH_TRY(add_source(search, &source, item, err));
    }
    return HATCH_OK;
}

/* Chooses places on a face, cell by cell, so that a part of a large face has the places that the whole has.
 *   whole   window of the face
 *   window  the part of it */
static enum hatch_status choose_on_face(struct search *search, const struct hatch_trace_window *whole,
                                        const struct hatch_trace_window *window, double density, struct hatch_err *err)
{
    const struct hatch_tracer *tracer = search->tracer;
    double side = CELL_GAPS * tracer->gap;
    uint64_t id =
        hatch_random_at(search->cells, tracer->ground.surface->face_source[tracer->ground.source[window->face]]);
    int64_t first[2], last[2];
    for (int k = 0; k < 2; k++) {
        first[k] = (int64_t)floor((window->low[k] - whole->low[k]) / side);
        last[k] = (int64_t)floor((window->high[k] - whole->low[k]) / side);
    }
    for (int64_t y = first[1]; y <= last[1]; y++)
        for (int64_t x = first[0]; x <= last[0]; x++) {
            double low[2] = {whole->low[0] + (double)x * side, whole->low[1] + (double)y * side};
            const struct hatch_trace_window cell = {
                window->face,
                {low[0], low[1]},
                {fmin(low[0] + side, whole->high[0]), fmin(low[1] + side, whole->high[1])}};
            uint64_t number = x == 0 && y == 0 ? id : hatch_random_u64(id, (uint64_t)x, (uint64_t)y);
            HATCH_TRY(choose_in_cell(search, &cell, number, density, err));
        }
    return HATCH_OK;
}

static enum hatch_status choose_faces(struct search *search, double density, struct hatch_err *err)
{
    const struct hatch_tracer *tracer = search->tracer;
    const struct hatch_component *component = tracer->component;
    uint32_t count = tracer->region ? tracer->region->count : component->face_count;
    for (uint32_t i = 0; i < count && density > 0; i++) {
        uint32_t face = tracer->region ? tracer->region->windows[i].face : component->first_face + i;
        const struct hatch_trace_window whole = hatch_trace_window_of(&tracer->ground, face);
        HATCH_TRY(choose_on_face(search, &whole, tracer->region ? &tracer->region->windows[i] : &whole, density, err));
    }
    return HATCH_OK;
}

static void drop_invalid(struct search *search)
{
    uint32_t kept = 0;
    for (uint32_t i = 0; i < search->count; i++)
        if (search->seeds[i].valid)
            search->seeds[kept++] = search->seeds[i];
    search->count = kept;
}

/* Orders seeds that are near to one another on the surface near in memory. */
static int by_face(const void *a, const void *b)
{
    const struct hatch_trace_seed *x = a, *y = b;
    if (x->place.face != y->place.face)
        return x->place.face < y->place.face ? -1 : 1;
    return x->id < y->id ? -1 : x->id > y->id;
}

enum hatch_status hatch_trace_add_seeds(struct hatch_tracer *tracer, uint32_t phase, struct hatch_err *err)
{
    struct search search = {
        .tracer = tracer,
        .stream = STREAM_PHASES + (uint64_t)tracer->level * HATCH_TRACE_PHASES + phase,
        .counts = hatch_random_key(tracer->seed, STREAM_COUNT),
    };
    search.cells = hatch_random_key(tracer->seed, search.stream);
    double density = tracer->level == 0 && phase == 0 ? FIRST_ON_FACES : on_faces[phase];
    HATCH_TRY(HATCH_ALLOC_UNSET(tracer->scratch, &search.sources, BATCH, err));
    HATCH_TRY(HATCH_ALLOC_UNSET(tracer->scratch, &search.batch, BATCH, err));
    HATCH_TRY(choose_stops(&search, beside[phase] * HATCH_TRACE_STEP, err));
    HATCH_TRY(choose_faces(&search, density / (tracer->gap * tracer->gap), err));
    HATCH_TRY(finish_batch(&search, err));
    HATCH_TRY(hatch_trace_thin(tracer, search.seeds, search.count, err));
    drop_invalid(&search);
    if (search.count > 0)
        qsort(search.seeds, search.count, sizeof *search.seeds, by_face);
    for (uint32_t i = 0; i < search.count; i++)
        HATCH_TRY(hatch_trace_add_stroke(tracer, &search.seeds[i], err));
    return HATCH_OK;
}
