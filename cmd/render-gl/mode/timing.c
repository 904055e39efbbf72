/* --time: reports how long frames and their passes take, as TSV or JSON. */
#include <stdlib.h>
#include <string.h>

#include "render-gl/mode/modes.h"
#include "shared/report.h"

#define WARM_UP 3u /* frames drawn before any is timed */

/* The times of one span, a whole frame or one of its passes, in all frames. */
struct series {
    const struct technique *technique;
    const char *name;
    double *gpu_ms, *wall_ms;              /* one entry per frame */
    const struct technique_counts *counts; /* NULL: none */
};

#define SERIES_MAX (GPU_TIMER_PASSES_MAX + 2u)

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

/* Draws frames and records their times. Three kinds of frame alternate, so that the load of the machine affects all of
 * them alike: one is timed as a whole, one pass by pass, and one is drawn by the reference technique, without a look.
 * Passes are not timed in the first kind, because waiting for the GPU after each pass makes a frame slower. Returns the
 * number of series. turns   one picture for each kind of frame counts  out: the strokes of the very first frame, if the
 * technique counts them */
static uint32_t measure(struct job *job, const struct picture turns[3], const struct canvas *canvas,
                        struct series *series, struct technique_counts *counts)
{
    const struct options *options = job->options;
    const struct hatch_tile tile = {0, 0, canvas->width, canvas->height, options->width, options->height};
    struct gpu_timer *timer = job->frame.timer;
    struct look *look = job->context.look;
    struct hatch_view view;
    struct hatch_err err;
    job_set_frame(job, 0, &view);
    uint32_t last = 0;
    for (uint32_t run = 0; run < WARM_UP + options->timed_frames; run++)
        for (uint32_t turn = 0; turn < 3; turn++) {
            timer->every_pass = turn == 1;
            job->context.look = turn < 2 ? look : NULL;
            cmd_check(picture_draw_tile(&turns[turn], &view, &tile, canvas, &err), NULL, &err);
            if (run == 0 && turn == 0 && turns->instance->technique->count) {
                *counts = turns->instance->technique->count(turns->instance);
                series[0].counts = counts;
            }
            uint32_t first = turn == 0 ? 0 : turn == 1 ? 1 : last;
            for (uint32_t i = 0; i < timer->count; i++) {
                struct series *span = &series[first + i];
                span->technique = turns[turn].instance->technique;
                span->name = timer->names[i];
                if (run < WARM_UP)
                    continue;
                span->gpu_ms[run - WARM_UP] = timer->gpu_ms[i];
                span->wall_ms[run - WARM_UP] = timer->wall_ms[i];
            }
            if (turn == 1)
                last = 1 + timer->count;
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
    uint32_t frames = job->options->timed_frames;
    cmd_report_text(report, span->technique->name);
    cmd_report_text(report, span->name);
    cmd_report_integer(report, frames);
    report_times(report, span->gpu_ms, frames);
    report_times(report, span->wall_ms, frames);
    cmd_report_text(report, job->gpu.device);
    const struct technique_counts counts = span->counts ? *span->counts : (struct technique_counts){.strokes = 0};
    const double numbers[] = {counts.strokes, counts.fragments, counts.waited};
    cmd_report_numbers(report, span->counts ? numbers : NULL, 3);
}

static void make_series(struct job *job, struct series series[SERIES_MAX])
{
    struct hatch_err err;
    for (uint32_t i = 0; i < SERIES_MAX; i++) {
        double *ms = HATCH_NEW(&job->args.keep, double, 2 * (size_t)job->options->timed_frames, &err);
        cmd_check(ms ? HATCH_OK : HATCH_LIMIT, NULL, &err);
        series[i] = (struct series){.name = "", .gpu_ms = ms, .wall_ms = ms + job->options->timed_frames};
    }
}

void timing_report(struct job *job)
{
    static const char *const columns[] = {
        "technique",   "span",         "frames", "gpu_ms",       "gpu_low_ms",     "gpu_high_ms", "wall_ms",
        "wall_low_ms", "wall_high_ms", "device", "stroke_count", "fragment_count", "waited",      NULL};
    struct series series[SERIES_MAX];
    struct cmd_report report;
    struct gpu_timer timer;
    struct canvas canvas;
    struct technique_counts counts;
    const struct picture picture = job_picture(job, job_use(job, job->options->technique));
    const struct picture reference = job_picture(job, job_use(job, technique_find(TECHNIQUE_REFERENCE)));
    struct picture turns[3] = {picture, picture, reference};
    /* The reference is drawn with the same feature lines, so that it differs from the technique in the strokes only. */
    turns[2].draws_lines = picture.draws_lines;
    make_series(job, series);
    job_make_canvas(job, &canvas);
    if (canvas.width < job->options->width || canvas.height < job->options->height)
        cmd_warn(NULL, "only the first tile of %u by %u pixels is timed", canvas.width, canvas.height);
    gpu_timer_make(&timer);
    job->frame.timer = &timer;
    uint32_t count = measure(job, turns, &canvas, series, &counts);
    cmd_report_begin(&report, &job->args, columns);
    for (uint32_t i = 0; i < count; i++)
        report_span(&report, job, &series[i]);
    gpu_timer_free(&timer);
    canvas_free(&canvas);
    cmd_report_write(&report, job->outputs[0]);
}
