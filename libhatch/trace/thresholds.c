/* The density from which on a point of a stroke is drawn, from the gaps beside it. */
#include <math.h>

#include "base/random.h"
#include "trace/work.h"

#define CHUNK 256u         /* stops per task */
#define SMOOTH_STOPS 4     /* to each side */
#define RANK_OCTAVES 0.333 /* thresholds of strokes with equal gaps spread over this */
#define STREAM_RANK 7

struct measure {
    const struct hatch_tracer *tracer;
    float *raw; /* logarithms, per stop; unset for strokes of earlier levels */
};

static void measure_chunk(void *context, uint32_t chunk)
{
    const struct measure *measure = context;
    const struct hatch_tracer *tracer = measure->tracer;
    for (uint32_t i = chunk * CHUNK; i < (chunk + 1) * CHUNK && i < tracer->stop_count; i++) {
        const struct hatch_trace_stop *stop = &tracer->stops[i];
        if (tracer->strokes[stop->stroke].level != tracer->level)
            continue;
        const struct hatch_trace_place place = hatch_trace_stop_place(tracer, stop);
        const struct hatch_trace_origin origin = {.stroke = stop->stroke, .arc = (double)stop->arc, .passes = true};
        struct hatch_trace_gaps gaps = hatch_trace_gaps_at(tracer, &place, &origin);
        measure->raw[i] = (float)log(1.5 / (gaps.left + gaps.right));
    }
}

/* Sets thresholds to smoothed means of the measured ones, times the stroke's rank. */
static void smooth(const struct hatch_trace_stroke *stroke, uint64_t seed, const float *raw, float *thresholds)
{
    int64_t count = (int64_t)stroke->threshold_count[0] + stroke->threshold_count[1];
    double rank = ((double)hatch_random_unit(seed, STREAM_RANK, stroke->id) - 0.5) * RANK_OCTAVES * log(2);
    for (int64_t i = 0; i < count; i++) {
        double sum = 0;
        int64_t low = i < SMOOTH_STOPS ? 0 : i - SMOOTH_STOPS;
        int64_t high = i + SMOOTH_STOPS < count ? i + SMOOTH_STOPS : count - 1;
        for (int64_t j = low; j <= high; j++)
            sum += (double)raw[j];
        thresholds[i] = (float)exp(sum / (double)(high - low + 1) + rank);
    }
}

enum hatch_status hatch_trace_find_thresholds(struct hatch_tracer *tracer, struct hatch_err *err)
{
    struct measure measure = {.tracer = tracer};
    HATCH_TRY(HATCH_ALLOC_UNSET(tracer->scratch, &measure.raw, tracer->stop_count, err));
    hatch_parallel_for(tracer->pool, (tracer->stop_count + CHUNK - 1) / CHUNK, measure_chunk, &measure);
    while (tracer->threshold_capacity - tracer->threshold_count < tracer->stop_count)
        HATCH_TRY(hatch_curve_reserve(tracer->keep, &tracer->thresholds, sizeof *tracer->thresholds,
                                      tracer->threshold_capacity, &tracer->threshold_capacity, err));
    for (uint32_t i = 0; i < tracer->stop_count;) {
        struct hatch_trace_stroke *stroke = &tracer->strokes[tracer->stops[i].stroke];
        uint32_t first = i;
        while (i < tracer->stop_count && tracer->stops[i].stroke == tracer->stops[first].stroke)
            i++;
        if (stroke->level != tracer->level)
            continue;
        stroke->threshold_count[1] = (uint32_t)-tracer->stops[first].number;
        stroke->threshold_count[0] = i - first - stroke->threshold_count[1];
        stroke->first_threshold = tracer->threshold_count;
        smooth(stroke, tracer->seed, &measure.raw[first], &tracer->thresholds[stroke->first_threshold]);
        tracer->threshold_count += i - first;
    }
    return HATCH_OK;
}
