/* Pictures of candidates: their times, and their errors of tone. */
#include "hatchplan/hatchplan.h"

#include <assert.h>
#include <math.h>
#include <string.h>

#include "base/text.h"
#include "measure/ink_figures.h"
#include "shared/picture.h"

#define SMALL_LEAST_PX 160 /* least side of a small picture */
#define PLAIN_DRAWS 20     /* of the plain scene, whose shortest time counts */

/* Pictures of one size. */
struct pictures {
    const char *plain, *drawn; /* names of the files */
    double scale;
};
static const struct pictures sizes[] = {{"plain", "picture", 1}, {"small-plain", "small-picture", PLAN_SMALL}};

/* Returns the path of a picture, or of all pictures.
 *   view  number of the picture; -1: all, as for -o of render-gl */
static const char *picture_path(const struct plan *plan, const char *name, int view)
{
    if (view < 0 && plan->options->frames_given)
        return cmd_child_path(plan->args, "%s%%d.exr", name);
    return cmd_child_path(plan->args, "%s%d.exr", name, view < 0 ? 0 : view);
}

/* Times of the pictures of a run of render-gl: means, in milliseconds. */
struct times {
    double wall_ms;
    double work_ms; /* with a software renderer the processor time, else wall_ms */
};

/* Columns of a table of --times. */
enum { WALL_MS = 3, CPU_MS, DEVICE, COLUMNS };

/* Whether the processor draws: Mesa's software renderers are called so. */
static bool is_software(struct hatch_text device)
{
    static const char *const names[] = {"llvmpipe", "softpipe", "swrast"};
    for (size_t i = 0; i < sizeof names / sizeof *names; i++)
        if (device.length >= strlen(names[i]) && memcmp(device.at, names[i], strlen(names[i])) == 0)
            return true;
    return false;
}

static void read_times(const struct plan *plan, const char *path, struct times *times)
{
    struct hatch_arena arena;
    struct hatch_bytes file = {0};
    struct hatch_err err;
    struct hatch_text line, field = {NULL, 0};
    double sums[COLUMNS] = {0};
    hatch_arena_init(&arena, plan->args->max_memory);
    cmd_check(cmd_try_read(&arena, path, &file, &err), path, &err);
    struct hatch_text rest = hatch_text_of(file);
    hatch_text_line(&rest, &line); /* names of the columns */
    while (hatch_text_line(&rest, &line))
        for (int column = 0; column < COLUMNS && hatch_text_field(&line, &field); column++) {
            double value;
            sums[column] += hatch_text_number(field, &value) ? value : 0;
        }
    times->wall_ms = sums[WALL_MS] / plan->views;
    times->work_ms = sums[is_software(field) ? CPU_MS : WALL_MS] / plan->views;
    hatch_arena_free(&arena);
}

void plan_add_drawing(struct plan *plan, const struct plan_candidate *candidate, bool small, uint32_t draws,
                      struct cmd_child_words *words)
{
    struct plan_asset *own = candidate ? plan_own_asset(plan, candidate) : NULL;
    const struct pictures *pictures = &sizes[small];
    plan_add_common(plan, words);
    if (candidate)
        plan_add_technique(plan, candidate, words);
    else
        cmd_child_add_all(words, "technique", "--technique gouraud");
    plan_add_view(plan, plan->views, pictures->scale, words);
    if (own) {
        cmd_child_add(words, own->kind == PLAN_SOLID ? "--solid" : "--tam");
        cmd_child_add(words, "%s", own->path);
    }
    cmd_child_add(words, "--draws");
    cmd_child_add(words, "%u", draws);
    cmd_child_add(words, "--times");
    cmd_child_add(words, "%s", cmd_child_path(plan->args, "times.tsv"));
    cmd_child_add(words, "-o");
    cmd_child_add(words, "%s", picture_path(plan, candidate ? pictures->drawn : pictures->plain, -1));
}

/* Runs render-gl and reads the times.
 *   candidate  NULL: the plain scene */
static void draw(struct plan *plan, const struct plan_candidate *candidate, bool small, uint32_t draws,
                 struct times *times, struct cmd_child_end *end)
{
    struct cmd_child_words words;
    cmd_child_begin(&words, plan->args, "render-gl");
    plan_add_drawing(plan, candidate, small, draws, &words);
    cmd_child_add(&words, "--");
    for (uint32_t i = 0; i < plan->file_count; i++) {
        const struct plan_asset *asset = candidate ? plan_scene_asset(plan, candidate, i) : NULL;
        cmd_child_add(&words, "%s", asset ? asset->path : plan->files[i].path);
    }
    cmd_child_run(&words, INFINITY, end);
    if (end->status == 0)
        read_times(plan, cmd_child_path(plan->args, "times.tsv"), times);
}

/* Compares the pictures of a candidate with the plain ones. Views without tone count as exact. */
static void measure_error(struct plan *plan, struct plan_candidate *candidate, const struct pictures *pictures)
{
    double squares = 0, grey = 0;
    for (uint32_t view = 0; view < plan->views; view++) {
        struct hatch_image plain, drawn;
        struct hatch_ink_figures figures;
        struct hatch_arena arena;
        struct hatch_err err;
        const char *path = picture_path(plan, pictures->drawn, (int)view);
        hatch_arena_init(&arena, plan->args->max_memory);
        cmd_read_picture(plan->args, picture_path(plan, pictures->plain, (int)view), 1, &arena, &plain);
        cmd_read_picture(plan->args, path, 1, &arena, &drawn);
        cmd_check(hatch_measure_ink(&drawn, &plain, &plan->args->scratch, &figures, &err), path, &err);
        squares += isnan(figures.tone_rms) ? 0 : figures.tone_rms * figures.tone_rms;
        grey += isnan(figures.grey_strokes) ? 0 : figures.grey_strokes;
        hatch_arena_free(&arena);
    }
    candidate->figures.error = sqrt(squares / plan->views);
    candidate->grey = grey / plan->views;
}

void plan_measure_plain(struct plan *plan)
{
    const double *size_px = plan->options->size_px;
    struct cmd_child_end end;
    struct times times[2];
    plan->has_small = PLAN_SMALL * fmin(size_px[0], size_px[1]) >= SMALL_LEAST_PX && !plan->options->exhaustive;
    for (int small = plan->has_small; small >= 0; small--) {
        draw(plan, NULL, small > 0, PLAIN_DRAWS, &times[small], &end);
        if (end.status != 0)
            cmd_child_die("render-gl", &end);
    }
    plan->plain_ms = times[0].wall_ms;
    for (int small = plan->has_small; small >= 0; small--)
        plan->scale[small] = times[0].wall_ms / times[small].work_ms;
}

/* Sorts values and returns their median. */
static double median(double *values, uint32_t count)
{
    for (uint32_t i = 1; i < count; i++)
        for (uint32_t j = i; j > 0 && values[j] < values[j - 1]; j--) {
            double swap = values[j];
            values[j] = values[j - 1];
            values[j - 1] = swap;
        }
    return (values[(count - 1) / 2] + values[count / 2]) / 2;
}

void plan_measure(struct plan *plan, struct plan_candidate *candidate, bool small, uint32_t draws)
{
    struct cmd_child_end end;
    struct times times;
    char text[128];
    const struct hatch_arena_mark mark = hatch_arena_mark(&plan->args->keep);
    draw(plan, candidate, small, draws, &times, &end);
    if (!plan_may_fail(&end))
        cmd_child_die("render-gl", &end);
    if (end.status != 0) {
        plan_note_failure(plan, "render-gl", &end);
        candidate->state = PLAN_OUT;
        return;
    }
    if (candidate->state != PLAN_MEASURED) {
        measure_error(plan, candidate, &sizes[small]);
        candidate->round_count = 0;
    }
    assert(candidate->round_count < PLAN_ROUNDS_MAX);
    candidate->round_ms[candidate->round_count++] = plan->scale[small] * times.work_ms;
    candidate->figures.ms = median(candidate->round_ms, candidate->round_count);
    candidate->state = small ? PLAN_LOOKED : PLAN_MEASURED;
    hatch_arena_rewind(&plan->args->keep, mark);
    plan_describe(plan, candidate, text, sizeof text);
    cmd_note("%s%s %s: %.4g ms, %.4g MB, %.3g s, tone error %.4f", small ? "small: " : "", candidate->technique->name,
             text, candidate->figures.ms, 1e-6 * candidate->figures.bytes, candidate->figures.setup_s,
             candidate->figures.error);
}
