/* --time: reports how long frames and their passes take, as TSV or JSON; --times: how long each picture takes. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "render-gl/mode/modes.h"
#include "shared/report.h"

#define WARM_UP 3u /* frames drawn before any is timed */

/* The times of one span, a whole frame or one of its passes, in all frames. */
struct series {
    const struct technique *technique;
    const char *name;
    uint32_t frames;
    double *gpu_ms, *wall_ms; /* one entry per frame */
    double counts[3];         /* strokes, fragments, and strokes that waited, if the technique counts them; else NAN */
};

#define SERIES_MAX (GPU_TIMER_PASSES_MAX + 3u) /* the last is that of the film */

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

/* Adds the strokes of the frames that have been drawn since the last call. */
static void add_counts(const struct picture *picture, struct series *series)
{
    struct technique_instance *instance = picture->instance;
    if (!instance->technique->count)
        return;
    const struct technique_counts counts = instance->technique->count(instance);
    const double numbers[3] = {(double)counts.strokes, (double)counts.fragments, (double)counts.waited};
    for (int k = 0; k < 3; k++)
        series->counts[k] = numbers[k] + (isnan(series->counts[k]) ? 0 : series->counts[k]);
}

/* Draws a frame, and records the time of the whole. */
static void draw_frame(const struct job *job, const struct picture *picture, const struct hatch_view *view,
                       const struct canvas *canvas)
{
    const struct options *options = job->options;
    const struct hatch_tile tile = {0, 0, canvas->width, canvas->height, options->width, options->height};
    struct hatch_err err;
    cmd_check(picture_draw_tile(picture, view, &tile, canvas, &err), NULL, &err);
}

/* Draws the frames of the film once each, in their order, and records their times and all of their strokes.
 *   first  out: has the strokes of the first of them */
static void measure_film(struct job *job, const struct picture *picture, const struct canvas *canvas,
                         struct series *film, struct series *first)
{
    struct gpu_timer *timer = job->frame.timer;
    struct hatch_view view;
    timer->every_pass = false;
    for (uint32_t frame = 0; frame < film->frames; frame++) {
        job_set_frame(job, frame, &view);
        draw_frame(job, picture, &view, canvas);
        film->gpu_ms[frame] = timer->gpu_ms[0];
        film->wall_ms[frame] = timer->wall_ms[0];
        add_counts(picture, film);
        if (frame == 0)
            memcpy(first->counts, film->counts, sizeof film->counts);
    }
}

/* Draws frames and records their times. Three kinds of frame alternate, so that the load of the machine affects all of
 * them alike: one is timed as a whole, one pass by pass, and one is drawn by the reference technique, without a look.
 * Passes are not timed in the first kind, because waiting for the GPU after each pass makes a frame slower. Returns the
 * number of series.
 *   turns  one picture for each kind of frame */
static uint32_t measure(struct job *job, const struct picture turns[3], const struct canvas *canvas,
                        struct series *series)
{
    const struct options *options = job->options;
    struct gpu_timer *timer = job->frame.timer;
    struct look *look = job->context.look;
    struct hatch_view view;
    job_set_frame(job, 0, &view);
    uint32_t last = 0;
    for (uint32_t run = 0; run < WARM_UP + options->timed_frames; run++)
        for (uint32_t turn = 0; turn < 3; turn++) {
            timer->every_pass = turn == 1;
            job->context.look = turn < 2 ? look : NULL;
            draw_frame(job, &turns[turn], &view, canvas);
            if (run == 0 && turn == 0 && isnan(series[0].counts[0]))
                add_counts(&turns[0], &series[0]);
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
    cmd_report_text(report, span->technique->name);
    cmd_report_text(report, span->name);
    cmd_report_integer(report, span->frames);
    report_times(report, span->gpu_ms, span->frames);
    report_times(report, span->wall_ms, span->frames);
    cmd_report_text(report, job->gpu.device);
    cmd_report_numbers(report, span->counts, 3);
}

static void make_series(struct job *job, struct series series[SERIES_MAX])
{
    struct hatch_err err;
    for (uint32_t i = 0; i < SERIES_MAX; i++) {
        uint32_t frames = i + 1 < SERIES_MAX ? job->options->timed_frames : job->options->frames;
        double *ms = HATCH_NEW(&job->args.keep, double, 2 * (size_t)frames, &err);
        cmd_check(ms ? HATCH_OK : HATCH_LIMIT, NULL, &err);
        series[i] = (struct series){.name = "film",
                                    .technique = job->options->technique,
                                    .frames = frames,
                                    .gpu_ms = ms,
                                    .wall_ms = ms + frames,
                                    .counts = {NAN, NAN, NAN}};
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
    struct series *film = &series[SERIES_MAX - 1];
    if (film->frames > 1)
        measure_film(job, &picture, &canvas, film, &series[0]);
    uint32_t count = measure(job, turns, &canvas, series);
    cmd_report_begin(&report, &job->args, columns);
    for (uint32_t i = 0; i < count; i++)
        report_span(&report, job, &series[i]);
    if (film->frames > 1)
        report_span(&report, job, film);
    gpu_timer_free(&timer);
    canvas_free(&canvas);
    cmd_report_write(&report, job->outputs[0]);
}

void times_begin(struct job *job, struct picture_times *times)
{
    struct hatch_err err;
    double *ms = HATCH_NEW(&job->args.keep, double, TIMES_KINDS *(size_t)job->options->frames, &err);
    cmd_check(ms ? HATCH_OK : HATCH_LIMIT, NULL, &err);
    *times = (struct picture_times){.ms = ms};
    gpu_timer_make(&times->timer);
}

void times_add(struct job *job, const struct picture *picture, const struct hatch_view *view,
               const struct canvas *canvas, uint32_t frame, struct hatch_image *image, struct picture_times *times)
{
    struct gpu_timer *timer = &times->timer;
    double *ms = times->ms + TIMES_KINDS * (size_t)frame;
    struct hatch_err err;
    ms[0] = ms[1] = ms[2] = INFINITY;
    job->frame.timer = timer;
    for (uint32_t draw = 0; draw < job->options->draws; draw++) {
        timer->sum_gpu_ms = timer->sum_wall_ms = timer->sum_cpu_ms = 0;
        cmd_check(picture_draw(picture, view, canvas, image, &err), NULL, &err);
        ms[0] = fmin(ms[0], timer->sum_gpu_ms);
        ms[1] = fmin(ms[1], timer->sum_wall_ms);
        ms[2] = fmin(ms[2], timer->sum_cpu_ms);
    }
    job->frame.timer = NULL;
    if (picture->instance->technique->count)
        picture->instance->technique->count(picture->instance); /* of repeated draws, which are not reported */
}

struct cmd_file times_end(struct job *job, struct picture_times *times)
{
    static const char *const columns[] = {"frame", "draws", "gpu_ms", "wall_ms", "cpu_ms", "device", NULL};
    struct cmd_report report;
    cmd_report_begin(&report, &job->args, columns);
    for (uint32_t frame = 0; frame < job->options->frames; frame++) {
        cmd_report_integer(&report, frame);
        cmd_report_integer(&report, job->options->draws);
        cmd_report_numbers(&report, times->ms + TIMES_KINDS * (size_t)frame, TIMES_KINDS);
        cmd_report_text(&report, job->gpu.device);
    }
    gpu_timer_free(&times->timer);
    const struct hatch_bytes table = cmd_report_end(&report);
    return (struct cmd_file){.output = job->times_output, .data = table.data, .size = table.size};
}
