/* The density from which on a point of a stroke is drawn, from the gaps beside it. */
#include <math.h>

#include "base/random.h"
#include "trace/work.h"

#define CHUNK 16u          /* strokes per task */
#define SMOOTH_STOPS 4     /* to each side */
#define RANK_OCTAVES 0.333 /* thresholds of strokes with equal gaps spread over this */
#define STREAM_RANK 7

struct measure {
    const struct hatch_tracer *tracer;
    const uint32_t *strokes; /* of the level */
    uint32_t count;
    float *raw; /* logarithms, per threshold of the level */
};

/* Measures the gaps at the stops of half a stroke.
 *   raw  out: at the stops; the next is `direction` entries further */
static void measure_half(const struct hatch_tracer *tracer, uint32_t number, uint32_t way, float *raw)
{
    const struct hatch_trace_stroke *stroke = &tracer->strokes[number];
    struct hatch_trace_stops stops = hatch_trace_stops_begin(stroke, way, HATCH_TRACE_STEP * tracer->gap);
    while (hatch_trace_stops_next(tracer, stroke, way, &stops)) {
        double arc = (stops.count - 1) * stops.step;
        const struct hatch_trace_origin origin = {number, way ? -arc : arc, false};
        if (way == 1 && stops.count == 1)
            continue;
        struct hatch_trace_gaps gaps = hatch_trace_gaps_at(tracer, &stops.place, &origin);
        float value = (float)log(1.5 / (gaps.left + gaps.right));
        raw[way ? -(int64_t)(stops.count - 1) : (int64_t)(stops.count - 1)] = value;
    }
}

static void measure_chunk(void *context, uint32_t chunk)
{
    const struct measure *measure = context;
    const struct hatch_tracer *tracer = measure->tracer;
    uint32_t begin = tracer->threshold_count;
    for (uint32_t i = chunk * CHUNK; i < (chunk + 1) * CHUNK && i < measure->count; i++) {
        const struct hatch_trace_stroke *stroke = &tracer->strokes[measure->strokes[i]];
        float *seed = &measure->raw[stroke->first_threshold - begin + stroke->threshold_count[1]];
        measure_half(tracer, measure->strokes[i], 0, seed);
        measure_half(tracer, measure->strokes[i], 1, seed);
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

static uint32_t count_stops(const struct hatch_tracer *tracer, const struct hatch_trace_stroke *stroke, uint32_t way)
{
    struct hatch_trace_stops stops = hatch_trace_stops_begin(stroke, way, HATCH_TRACE_STEP * tracer->gap);
    while (hatch_trace_stops_next(tracer, stroke, way, &stops))
        ;
    return stops.count;
}

enum hatch_status hatch_trace_find_thresholds(struct hatch_tracer *tracer, struct hatch_err *err)
{
    struct measure measure = {.tracer = tracer};
    uint32_t begin = tracer->threshold_count, *strokes;
    size_t wanted = begin;
    HATCH_TRY(HATCH_ALLOC_UNSET(tracer->scratch, &strokes, tracer->stroke_count, err));
    for (uint32_t s = 0; s < tracer->stroke_count; s++) {
        struct hatch_trace_stroke *stroke = &tracer->strokes[s];
        if (stroke->level != tracer->level)
            continue;
        strokes[measure.count++] = s;
        stroke->first_threshold = (uint32_t)wanted;
        stroke->threshold_count[0] = count_stops(tracer, stroke, 0);
        stroke->threshold_count[1] = count_stops(tracer, stroke, 1) - 1;
        wanted += (size_t)stroke->threshold_count[0] + stroke->threshold_count[1];
    }
    measure.strokes = strokes;
    while (tracer->threshold_capacity < wanted)
        HATCH_TRY(hatch_trace_reserve(tracer->scratch, &tracer->thresholds, sizeof *tracer->thresholds,
                                      tracer->threshold_capacity, &tracer->threshold_capacity, err));
    HATCH_TRY(HATCH_ALLOC_UNSET(tracer->scratch, &measure.raw, wanted - begin, err));
    hatch_parallel_for(tracer->pool, (measure.count + CHUNK - 1) / CHUNK, measure_chunk, &measure);
    for (uint32_t i = 0; i < measure.count; i++) {
        const struct hatch_trace_stroke *stroke = &tracer->strokes[strokes[i]];
        smooth(stroke, tracer->seed, &measure.raw[stroke->first_threshold - begin],
               &tracer->thresholds[stroke->first_threshold]);
    }
    tracer->threshold_count = (uint32_t)wanted;
    return HATCH_OK;
}
