/* Points at even distances along strokes: where gaps are measured and new strokes begin. */
#include <math.h>

#include "trace/work.h"

static enum hatch_status add_stop(struct hatch_tracer *tracer, const struct hatch_trace_stop *stop,
                                  struct hatch_err *err)
{
    HATCH_TRY(hatch_trace_room_reserve(tracer->stop_room, &tracer->stops, sizeof *tracer->stops, tracer->stop_count,
                                       &tracer->stop_capacity, err));
    tracer->stops[tracer->stop_count++] = *stop;
    return HATCH_OK;
}

/* Adds the stops of half a stroke, without its seed, in the order from the seed. */
static enum hatch_status add_half(struct hatch_tracer *tracer, uint32_t number, uint32_t way, struct hatch_err *err)
{
    double step = HATCH_TRACE_STEP * tracer->gap;
    int32_t count = 1 + (int32_t)(tracer->strokes[number].first_arc / step);
    for (uint32_t n = tracer->strokes[number].first[way]; n != HATCH_TRACE_NONE; n = tracer->pieces[n].next) {
        const struct hatch_trace_piece *piece = &tracer->pieces[n];
        float x = piece->to[0] - piece->from[0], y = piece->to[1] - piece->from[1], length = sqrtf(x * x + y * y);
        for (; count * step <= (double)piece->arc && length > 0; count++) {
            float back = (float)((double)piece->arc - count * step) / length;
            const struct hatch_trace_stop stop = {.face = piece->face,
                                                  .stroke = number,
                                                  .x = piece->to[0] - back * x,
                                                  .y = piece->to[1] - back * y,
                                                  .heading = {x / length, y / length},
                                                  .arc = (float)(way ? -count * step : count * step),
                                                  .number = way ? -count : count};
            HATCH_TRY(add_stop(tracer, &stop, err));
        }
    }
    return HATCH_OK;
}

static void reverse(struct hatch_trace_stop *stops, uint32_t count)
{
    for (uint32_t i = 0; i < count / 2; i++) {
        struct hatch_trace_stop swapped = stops[i];
        stops[i] = stops[count - 1 - i];
        stops[count - 1 - i] = swapped;
    }
}

enum hatch_status hatch_trace_add_stops(struct hatch_tracer *tracer, uint32_t first, struct hatch_err *err)
{
    for (uint32_t s = first; s < tracer->stroke_count; s++) {
        const struct hatch_trace_place *seed = &tracer->strokes[s].seed;
        const double *origin = hatch_trace_origin_of(tracer, seed->face);
        const struct hatch_trace_stop middle = {.face = seed->face,
                                                .stroke = s,
                                                .x = hatch_trace_local(tracer, seed->x, origin[0]),
                                                .y = hatch_trace_local(tracer, seed->y, origin[1]),
                                                .heading = {(float)seed->heading[0], (float)seed->heading[1]}};
        uint32_t begin = tracer->stop_count;
        HATCH_TRY(add_half(tracer, s, 1, err));
        reverse(&tracer->stops[begin], tracer->stop_count - begin);
        if (!tracer->strokes[s].given)
            HATCH_TRY(add_stop(tracer, &middle, err));
        HATCH_TRY(add_half(tracer, s, 0, err));
    }
    return HATCH_OK;
}

struct hatch_trace_place hatch_trace_stop_place(const struct hatch_tracer *tracer, const struct hatch_trace_stop *stop)
{
    double sign = stop->number < 0 ? -1 : 1;
    const double *origin = hatch_trace_origin_of(tracer, stop->face);
    return (struct hatch_trace_place){.face = stop->face,
                                      .x = (double)stop->x + origin[0],
                                      .y = (double)stop->y + origin[1],
                                      .heading = {sign * (double)stop->heading[0], sign * (double)stop->heading[1]}};
}
