/* Strokes grow at both ends, in lock step: all ends are tested against what earlier rounds have drawn before any of
 * them moves on, so that the order of strokes does not matter. */
#include <math.h>
#include <string.h>

#include "trace/work.h"

#define CHUNK 64u        /* ends per task */
#define ACROSS_MIN 0.45  /* of the gap: nearer strokes block one another */
#define LEGS_KEPT 6u     /* legs of a round that are kept; longer rounds are walked again */
#define LEG_MIN 1e-6     /* of the gap: shorter legs lead nowhere, and are no pieces */
#define IDLE_MAX 8u      /* legs that lead nowhere after which a stroke ends */
#define TURNED_MAX -0.5f /* cosine of the turn in space after which a round ends: longer ones might wind unseen */
#define INWARD 1e-5      /* share of the way to the middle of a face */

/* A round of an end. */
struct stride {
    uint32_t half; /* 2 * stroke, plus 1 for the half behind the seed */
    uint32_t leg_count;
    bool goes_on, bound; /* bound: the ground or its direction ends there */
    struct hatch_trace_place to;
    struct hatch_trace_leg legs[LEGS_KEPT]; /* the first of leg_count */
};

struct advance {
    const struct hatch_tracer *tracer;
    struct stride *strides;
    uint32_t count;
};

static struct hatch_trace_origin origin_of(const struct hatch_tracer *tracer, uint32_t half, double walked, double turn)
{
    double arc = tracer->strokes[half / 2].length[half % 2] + walked;
    return (struct hatch_trace_origin){.stroke = half / 2,
                                       .arc = half % 2 ? -arc : arc,
                                       .growing = true,
                                       .passes = turn != 0,
                                       .turn = turn,
                                       .backward = half % 2};
}

/* Returns whether strokes pass too near to both sides of an end. */
static bool is_blocked(const struct hatch_tracer *tracer, const struct stride *stride, double walked)
{
    double reach = ACROSS_MIN * tracer->gap;
    for (int side = -1; side <= 1; side += 2) {
        struct hatch_trace_place aside = stride->to;
        const struct hatch_trace_origin origin = origin_of(tracer, stride->half, walked, side);
        double border;
        hatch_trace_turn(&aside, side);
        if (hatch_trace_cast(tracer, &aside, reach, &origin, &border) < reach && border == 0)
            return true;
    }
    return false;
}

/* Ends a stroke before a stride, where another one is in the way. */
static void give_up(struct stride *stride)
{
    stride->leg_count = 0;
    stride->goes_on = stride->bound = false;
}

/* Walks a leg along the field. A place that gets nowhere between two faces, as on an edge that the field follows, is
 * moved a little into its face.
 *   idle  in, out: legs that led nowhere, up to here */
static bool walk_leg(const struct hatch_tracer *tracer, struct hatch_trace_place *place, double length, uint32_t *idle,
                     struct hatch_trace_leg *leg)
{
    const struct hatch_trace_face *face = &tracer->ground.faces[place->face];
    if (*idle == IDLE_MAX / 2) {
        place->x += INWARD * (((double)face->x1 + (double)face->x2) / 3 - place->x);
        place->y += INWARD * ((double)face->y2 / 3 - place->y);
    }
    bool goes_on = hatch_trace_walk(&tracer->ground, place, length, HATCH_TRACE_ALONG, leg);
    *idle = leg->length > LEG_MIN * tracer->gap ? 0 : *idle + 1;
    return goes_on;
}

/* Returns whether the heading of a walk has turned around in space. */
static bool is_turned(const struct hatch_tracer *tracer, const struct hatch_trace_place *place, const float before[3])
{
    float now[3];
    hatch_trace_vector(&tracer->ground.poses[place->face], place->heading, now);
    return now[0] * before[0] + now[1] * before[1] + now[2] * before[2] < TURNED_MAX;
}

/* Walks one round from the stroke's end; leg_count is 0 where a stroke blocks the way. The round ends where it has
 * turned around, so that the next one sees its pieces. */
static void walk_stride(const struct hatch_tracer *tracer, struct stride *stride)
{
    double length = HATCH_TRACE_STEP * tracer->gap, walked = 0, least = LEG_MIN * tracer->gap;
    uint32_t idle = 0;
    float before[3];
    stride->to = tracer->strokes[stride->half / 2].end[stride->half % 2];
    hatch_trace_vector(&tracer->ground.poses[stride->to.face], stride->to.heading, before);
    stride->leg_count = 0;
    stride->goes_on = true;
    stride->bound = false;
    for (uint32_t n = 0; stride->goes_on && length - walked > least; n++) {
        struct hatch_trace_leg leg;
        if (n == HATCH_TRACE_LEGS_MAX || idle == IDLE_MAX) { /* as where directions lead to an edge from both sides */
            stride->goes_on = false;
            stride->bound = true;
            return;
        }
        const struct hatch_trace_origin origin = origin_of(tracer, stride->half, walked, 0);
        stride->goes_on = walk_leg(tracer, &stride->to, fmin(length - walked, tracer->leg_max), &idle, &leg);
        stride->bound = !stride->goes_on;
        bool left = tracer->region && !hatch_trace_region_has(tracer->region, &stride->to);
        if (left || (leg.length > least && hatch_trace_look(tracer, &leg, &origin) < HUGE_VAL)) {
            give_up(stride);
            return;
        }
        walked += leg.length;
        if (leg.length > least && stride->leg_count < LEGS_KEPT)
            stride->legs[stride->leg_count] = leg;
        stride->leg_count += leg.length > least;
        if (walked > HATCH_TRACE_WINDING * tracer->gap && is_turned(tracer, &stride->to, before))
            break;
    }
    if (stride->leg_count > 0 && is_blocked(tracer, stride, walked))
        give_up(stride);
}

static void advance_chunk(void *context, uint32_t chunk)
{
    const struct advance *advance = context;
    uint32_t stop = (chunk + 1) * CHUNK < advance->count ? (chunk + 1) * CHUNK : advance->count;
    for (uint32_t i = chunk * CHUNK; i < stop; i++)
        walk_stride(advance->tracer, &advance->strides[i]);
}

/* Draws the legs of a round, and ends the growth where it is due. */
static enum hatch_status commit(struct hatch_tracer *tracer, const struct stride *stride, struct hatch_err *err)
{
    struct hatch_trace_stroke *stroke = &tracer->strokes[stride->half / 2];
    uint32_t way = stride->half % 2;
    struct hatch_trace_place place = stroke->end[way];
    uint32_t idle = 0;
    double length = HATCH_TRACE_STEP * tracer->gap, walked = 0; /* as in walk_stride, to the last bit */
    double least = LEG_MIN * tracer->gap;
    for (uint32_t i = 0; i < stride->leg_count;) {
        struct hatch_trace_leg leg;
        if (stride->leg_count <= LEGS_KEPT)
            leg = stride->legs[i];
        else
            walk_leg(tracer, &place, fmin(length - walked, tracer->leg_max), &idle, &leg);
        i += leg.length > least;
        walked += leg.length;
        if (leg.length > least)
            HATCH_TRY(hatch_trace_add_piece(tracer, stride->half, &leg, err));
    }
    stroke->end[way] = stride->to;
    stroke->bound[way] = stride->bound;
    stroke->growing[way] = stride->goes_on && stroke->length[way] < stroke->length_max[way];
    return HATCH_OK;
}

enum hatch_status hatch_trace_grow(struct hatch_tracer *tracer, struct hatch_err *err)
{
    struct advance advance = {.tracer = tracer};
    uint32_t count = 0;
    for (uint32_t s = 0; s < tracer->stroke_count; s++)
        count += (uint32_t)tracer->strokes[s].growing[0] + (uint32_t)tracer->strokes[s].growing[1];
    HATCH_TRY(HATCH_ALLOC_UNSET(tracer->scratch, &advance.strides, count, err));
    for (uint32_t half = 0; half < 2 * tracer->stroke_count; half++)
        if (tracer->strokes[half / 2].growing[half % 2])
            advance.strides[advance.count++].half = half;
    while (advance.count > 0) {
        uint32_t kept = 0;
        tracer->round++;
        hatch_parallel_for(tracer->pool, (advance.count + CHUNK - 1) / CHUNK, advance_chunk, &advance);
        for (uint32_t i = 0; i < advance.count; i++)
            HATCH_TRY(commit(tracer, &advance.strides[i], err));
        for (uint32_t i = 0; i < advance.count; i++) {
            uint32_t half = advance.strides[i].half;
            if (tracer->strokes[half / 2].growing[half % 2])
                advance.strides[kept++].half = half;
        }
        advance.count = kept;
    }
    return HATCH_OK;
}
