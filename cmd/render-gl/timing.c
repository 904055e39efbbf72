/* How long frames and their passes take, as TSV or JSON. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "render-gl/job.h"

#define WARM_UP 3u

/* The times of one span over all frames. */
struct series {
    uint32_t technique;
    const char *name;
    double *gpu_ms, *wall_ms;
};

#define SERIES_MAX (CLOCK_PASSES_MAX + 2u)

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

static void draw(struct job *job, uint32_t technique, bool every_pass, const struct view *view,
                 const struct target *target)
{
    const struct options *options = &job->options;
    struct tile tile = {0, 0, target->width, target->height, options->width, options->height};
    struct hatch_err err;
    job->renderer.clock->every_pass = every_pass;
    cmd_check(renderer_draw(&job->renderer, technique, view, &tile, target, &err), NULL, &err);
}

/* Draws frames and notes their times: the whole frame, its passes, and the frame of the reference,
 * gouraud, in turns, so that all see the same weather on the machine. The GPU has to finish after each
 * pass to tell passes apart, which is slower, so whole frames are drawn by themselves. */
static uint32_t measure(struct job *job, const struct target *target, struct series *series)
{
    const struct options *options = &job->options;
    const struct clock *clock = job->renderer.clock;
    const uint32_t techniques_drawn[3] = {(uint32_t)options->technique,
                                          (uint32_t)options->technique, TECHNIQUE_GOURAUD};
    struct view view;
    job_set_frame(job, 0, &view);
    uint32_t last = 0;
    for (uint32_t run = 0; run < WARM_UP + options->timed_frames; run++)
        for (uint32_t turn = 0; turn < 3; turn++) {
            draw(job, techniques_drawn[turn], turn == 1, &view, target);
            uint32_t first = turn == 0 ? 0 : turn == 1 ? 1 : last;
            for (uint32_t i = 0; i < clock->count; i++) {
                struct series *span = &series[first + i];
                span->technique = techniques_drawn[turn];
                span->name = clock->names[i];
                if (run < WARM_UP)
                    continue;
                span->gpu_ms[run - WARM_UP] = clock->gpu_ms[i];
                span->wall_ms[run - WARM_UP] = clock->wall_ms[i];
            }
            if (turn == 1)
                last = 1 + clock->count;
        }
    return last + 1;
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
    const char *technique = techniques[span->technique]->name;
    uint32_t frames = job->options.timed_frames;
    bool json = job->args.json;
    if (json)
        HATCH_TRY(hatch_buffer_print(text, err, "    {\"technique\": \"%s\", \"span\": \"%s\"",
                                     technique, span->name));
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
                                     "{\n  \"device\": \"%s\",\n  \"frames\": %u,\n"
                                     "  \"spans\": [\n",
                                     job->context.device, job->options.timed_frames));
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
    struct series series[SERIES_MAX];
    struct clock clock;
    struct target target;
    for (uint32_t i = 0; i < SERIES_MAX; i++) {
        double *ms = HATCH_NEW(keep, double, 2 * (size_t)job->options.timed_frames, &err);
        cmd_check(ms ? HATCH_OK : HATCH_LIMIT, NULL, &err);
        series[i] = (struct series){0, "", ms, ms + job->options.timed_frames};
    }
    job_make_target(job, &target);
    if (target.width < job->options.width || target.height < job->options.height)
        cmd_warn(NULL, "only the first tile of %u by %u pixels is timed", target.width,
                 target.height);
    cmd_check(renderer_prepare(&job->renderer, TECHNIQUE_GOURAUD, &job->args.scratch, &err), NULL,
              &err);
    /* The reference differs from the technique in its strokes alone. */
    if (job->renderer.lines && techniques[job->options.technique]->columns != COLUMNS_NONE)
        job->renderer.lines->style.asked = true;
    clock_make(&clock);
    job->renderer.clock = &clock;
    uint32_t count = measure(job, &target, series);
    struct hatch_buffer text = {.arena = keep};
    cmd_check(print(job, series, count, &text, &err), NULL, &err);
    clock_free(&clock);
    target_free(&target);
    cmd_write(job->outputs[0], text.data, text.size);
}
