/* How long frames and their passes take, as TSV or JSON. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "render-gl/job.h"

#define WARM_UP 3u

/* The times of one span over all frames. */
struct series {
    const char *name;
    double *gpu_ms, *wall_ms;
};

static int compare(const void *a, const void *b)
{
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

static double quantile(const double *sorted, uint32_t count, double share)
{
    double at = share * (double)(count - 1);
    uint32_t below = (uint32_t)at, above = below + 1 < count ? below + 1 : below;
    return sorted[below] + (at - below) * (sorted[above] - sorted[below]);
}

/* Draws frames and notes their times: series 0 is the whole frame, the others its passes. The GPU has
 * to finish after each pass to tell them apart, which is slower, so whole frames are drawn by
 * themselves. */
static uint32_t measure(struct job *job, const struct target *target, struct series *series)
{
    const struct options *options = &job->options;
    struct clock *clock = job->renderer.clock;
    struct tile tile = {0, 0, target->width, target->height, options->width, options->height};
    struct view view;
    job_set_frame(job, 0, &view);
    uint32_t passes = 0;
    for (uint32_t run = 0; run < WARM_UP + options->timed_frames; run++)
        for (int every_pass = 0; every_pass < 2; every_pass++) {
            clock->every_pass = every_pass;
            struct hatch_err err;
            cmd_check(renderer_draw(&job->renderer, (uint32_t)options->technique, &view, &tile,
                                    target, &err),
                      NULL, &err);
            for (uint32_t i = 0; i < clock->count && run >= WARM_UP; i++) {
                struct series *span = &series[every_pass ? i + 1 : 0];
                span->name = clock->names[i];
                span->gpu_ms[run - WARM_UP] = clock->gpu_ms[i];
                span->wall_ms[run - WARM_UP] = clock->wall_ms[i];
            }
            if (every_pass)
                passes = clock->count;
        }
    return passes + 1;
}

/* Median and quartiles of one clock's times. */
static enum hatch_status print_times(struct hatch_buffer *text, bool json, const char *clock,
                                     double *ms, uint32_t frames, struct hatch_err *err)
{
    qsort(ms, frames, sizeof *ms, compare);
    double median = quantile(ms, frames, 0.5);
    double low = quantile(ms, frames, 0.25), high = quantile(ms, frames, 0.75);
    if (json)
        return hatch_buffer_print(text, err,
                                  ", \"%s_ms\": %.4f, \"%s_low_ms\": %.4f, \"%s_high_ms\": %.4f",
                                  clock, median, clock, low, clock, high);
    return hatch_buffer_print(text, err, "\t%.4f\t%.4f\t%.4f", median, low, high);
}

static enum hatch_status print_span(const struct job *job, const struct series *span,
                                    struct hatch_buffer *text, struct hatch_err *err)
{
    const char *technique = techniques[job->options.technique]->name;
    uint32_t frames = job->options.timed_frames;
    bool json = job->args.json;
    if (json)
        HATCH_TRY(hatch_buffer_print(text, err, "    {\"span\": \"%s\"", span->name));
    else
        HATCH_TRY(hatch_buffer_print(text, err, "%s\t%s\t%u", technique, span->name, frames));
    HATCH_TRY(print_times(text, json, "gpu", span->gpu_ms, frames, err));
    HATCH_TRY(print_times(text, json, "wall", span->wall_ms, frames, err));
    return hatch_buffer_print(text, err, json ? "}" : "\n");
}

static enum hatch_status print(const struct job *job, const struct series *series, uint32_t count,
                               struct hatch_buffer *text, struct hatch_err *err)
{
    bool json = job->args.json;
    if (json)
        HATCH_TRY(hatch_buffer_print(text, err,
                                     "{\n  \"device\": \"%s\",\n  \"technique\": \"%s\",\n"
                                     "  \"frames\": %u,\n  \"spans\": [\n",
                                     job->context.device,
                                     techniques[job->options.technique]->name,
                                     job->options.timed_frames));
    else
        HATCH_TRY(hatch_buffer_print(text, err,
                                     "technique\tspan\tframes\tgpu_ms\tgpu_low_ms\tgpu_high_ms\t"
                                     "wall_ms\twall_low_ms\twall_high_ms\n"));
    for (uint32_t i = 0; i < count; i++) {
        HATCH_TRY(print_span(job, &series[i], text, err));
        if (json)
            HATCH_TRY(hatch_buffer_print(text, err, i + 1 < count ? ",\n" : "\n  ]\n}\n"));
    }
    return HATCH_OK;
}

void timing_report(struct job *job)
{
    struct hatch_arena *keep = &job->args.keep;
    struct hatch_err err;
    struct series series[CLOCK_PASSES_MAX + 1];
    struct clock clock;
    struct target target;
    for (uint32_t i = 0; i <= CLOCK_PASSES_MAX; i++) {
        double *ms = HATCH_NEW(keep, double, 2 * (size_t)job->options.timed_frames, &err);
        cmd_check(ms ? HATCH_OK : HATCH_LIMIT, NULL, &err);
        series[i] = (struct series){"", ms, ms + job->options.timed_frames};
    }
    job_make_target(job, &target);
    if (target.width < job->options.width || target.height < job->options.height)
        cmd_warn(NULL, "only the first tile of %u by %u pixels is timed", target.width,
                 target.height);
    clock_make(&clock);
    job->renderer.clock = &clock;
    uint32_t count = measure(job, &target, series);
    struct hatch_buffer text = {.arena = keep};
    cmd_check(print(job, series, count, &text, &err), NULL, &err);
    clock_free(&clock);
    target_free(&target);
    cmd_write(job->outputs[0], text.data, text.size);
}
