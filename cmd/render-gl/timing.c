/* How long frames and their passes take, as TSV or JSON. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "shared/report.h"
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

static void draw(struct job *job, uint32_t technique, bool every_pass, const struct hatch_view *view,
                 const struct target *target)
{
    const struct options *options = &job->options;
    struct hatch_tile tile = {0, 0, target->width, target->height, options->width, options->height};
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
    const uint32_t techniques_drawn[3] = {(uint32_t)options->technique, (uint32_t)options->technique,
                                          TECHNIQUE_GOURAUD};
    struct hatch_view view;
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

static void report_times(struct cmd_report *report, double *ms, uint32_t frames)
{
    qsort(ms, frames, sizeof *ms, compare);
    cmd_report_number(report, quantile(ms, frames, 0.5));
    cmd_report_number(report, quantile(ms, frames, 0.25));
    cmd_report_number(report, quantile(ms, frames, 0.75));
}

static void report_span(struct cmd_report *report, const struct job *job, const struct series *span)
{
    uint32_t frames = job->options.timed_frames;
    cmd_report_text(report, techniques[span->technique]->name);
    cmd_report_text(report, span->name);
    cmd_report_integer(report, frames);
    report_times(report, span->gpu_ms, frames);
    report_times(report, span->wall_ms, frames);
    cmd_report_text(report, job->context.device);
}

void timing_report(struct job *job)
{
    static const char *const columns[] = {"technique",    "span",        "frames",  "gpu_ms",
                                          "gpu_low_ms",   "gpu_high_ms", "wall_ms", "wall_low_ms",
                                          "wall_high_ms", "device",      NULL};
    struct hatch_arena *keep = &job->args.keep;
    struct cmd_report report;
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
        cmd_warn(NULL, "only the first tile of %u by %u pixels is timed", target.width, target.height);
    cmd_check(renderer_prepare(&job->renderer, TECHNIQUE_GOURAUD, &job->args.scratch, &err), NULL, &err);
    /* The reference differs from the technique in its strokes alone. */
    if (job->renderer.lines && technique_draws_strokes(techniques[job->options.technique]))
        job->renderer.lines->style.asked = true;
    clock_make(&clock);
    job->renderer.clock = &clock;
    uint32_t count = measure(job, &target, series);
    cmd_report_begin(&report, &job->args, columns);
    for (uint32_t i = 0; i < count; i++)
        report_span(&report, job, &series[i]);
    clock_free(&clock);
    target_free(&target);
    cmd_report_write(&report, job->outputs[0]);
}
