/* tamgen --replay: makes a map of the strokes of a drawing. */
#include <stdlib.h>

#include "io/svg/svg.h"
#include "job.h"
#include "kept.h"
#include "stroke/path.h"
#include "stroke/script.h"

/* Warns of the parts of a drawing that are not replayed; dies if there is no stroke to replay. */
static void warn_of_skipped(const struct job *job, const char *file, const struct hatch_svg_notes *notes)
{
    struct hatch_err err;
    uint32_t sum = notes->fills + notes->texts + notes->images + notes->gradients + notes->others;
    hatch_fail(&err, HATCH_BAD_INPUT, "%u fills, %u texts, %u images, %u strokes with a gradient, %u other elements",
               notes->fills, notes->texts, notes->images, notes->gradients, notes->others);
    if (job->strokes.count == 0) {
        hatch_fail_at(&err, "no strokes to replay; left out: %u outside the page, %u that reach far beyond it, ",
                      notes->outside, notes->far);
        cmd_die(file, &err);
    }
    if (sum)
        cmd_warn(file, "only plain strokes are replayed; left out: %s", err.text);
    if (notes->far)
        cmd_warn(file, "left out: %u %s more than %g page widths beyond the page", notes->far,
                 cmd_plural(notes->far, "stroke that reaches", "strokes that reach"), HATCH_PATH_REACH_MAX);
    if (notes->outside)
        cmd_warn(file, "%u of %u strokes lie outside the page", notes->outside, notes->outside + notes->strokes);
}

static bool is_colored(const struct hatch_stroke_list *strokes)
{
    for (uint32_t i = 0; i < strokes->count; i++)
        if (strokes->items[i].rgb[0] != strokes->items[i].rgb[1] ||
            strokes->items[i].rgb[1] != strokes->items[i].rgb[2])
            return true;
    return false;
}

static int compare_ids(const void *a, const void *b)
{
    const uint32_t x = *(const uint32_t *)a, y = *(const uint32_t *)b;
    return (x > y) - (x < y);
}

/* Numbers strokes in drawing order if the script gave them no numbers of their own. */
static void number_strokes(struct job *job)
{
    struct hatch_arena_mark mark = hatch_arena_mark(&job->args.scratch);
    struct hatch_stroke *items = job->strokes.items;
    uint32_t *ids, count = job->strokes.count;
    struct hatch_err err;
    cmd_check(HATCH_ALLOC_UNSET(&job->args.scratch, &ids, count, &err), NULL, &err);
    for (uint32_t i = 0; i < count; i++)
        ids[i] = items[i].id;
    qsort(ids, count, sizeof *ids, compare_ids);
    bool own = count == 0 || ids[0] > 0;
    for (uint32_t i = 1; i < count; i++)
        own = own && ids[i] != ids[i - 1];
    for (uint32_t i = 0; i < count && !own; i++)
        items[i].id = i + 1;
    hatch_arena_rewind(&job->args.scratch, mark);
}

void read_drawing(struct job *job, const struct replay_job *replay)
{
    struct hatch_err err;
    const char *name = cmd_input_name(replay->path);
    struct hatch_svg_notes notes = {0};
    cmd_check(replay->is_svg ? hatch_svg_read(replay->file, job->size_px, &job->args.keep, &job->args.scratch,
                                              &job->strokes, &notes, &err)
                             : hatch_script_parse(replay->file, job->size_px, &job->args.keep, &job->strokes, &err),
              name, &err);
    warn_of_skipped(job, name, &notes);
    number_strokes(job);
    job->color = job->style.color_count > 0 || is_colored(&job->strokes);
}

static void warn_of_range(const struct job *job, const char *name, const struct hatch_replay_result *result)
{
    if (result->short_columns)
        cmd_warn(
            name,
            "the whole drawing has a tone of %.3f: %u of %u columns are meant to be darker, and hold all its strokes",
            (double)result->darkest, result->short_columns, job->tones);
    if (result->exhausted)
        cmd_warn(name, "%u %s lighter than the target, by up to %.4f: the next finer level has no more strokes",
                 result->exhausted, cmd_plural(result->exhausted, "image stays", "images stay"),
                 (double)result->shortfall);
}

/* Reports the errors: with --fit unless --quiet, else only with --verbose. */
static void report_errors(const struct job *job, const struct replay_job *replay,
                          const struct hatch_replay_result *result)
{
    void (*say)(const char *, ...) = replay->fit && !job->args.quiet ? cmd_say : cmd_note;
    say("tone within %.4f (bound %.4f) on every level", (double)result->tone_error, (double)result->tone_bound);
    if (job->color)
        say("chroma within %.4f, hue within %.1f degrees of the finest level's", (double)result->chroma_error,
            (double)result->hue_error_deg);
}

void replay_drawing(struct job *job, const struct replay_job *replay)
{
    struct hatch_err err;
    struct hatch_replay_result result;
    struct hatch_replay_options options = {.style = &job->style,
                                           .brush = &job->brush,
                                           .size_px = job->size_px,
                                           .tones = job->tones,
                                           .levels = job->levels,
                                           .seed = job->args.seed,
                                           .ids = job->ids,
                                           .color = job->color,
                                           .keep = (float)replay->keep,
                                           .fit = replay->fit};
    static struct kept_columns kept;
    kept.arena = &job->args.keep;
    const struct hatch_tam_sink sink = replay->needs ? (struct hatch_tam_sink){kept_take, &kept}
                                                     : (struct hatch_tam_sink){columns_take, &job->columns};
    float targets[HATCH_TAM_TONES_MAX];
    const char *name = cmd_input_name(replay->path);
    uint32_t drawn = job->strokes.count;
    hatch_style_targets(&job->style, job->tones, targets);
    options.targets = job->style.tone_max_given ? targets : NULL;
    cmd_check(hatch_tam_replay(&options, &job->strokes, &job->args.keep, &job->args.scratch, &sink, &result, &err),
              name, &err);
    warn_of_range(job, name, &result);
    cmd_note("%u of %u strokes, tone up to %.3f", job->strokes.count, drawn, (double)result.darkest);
    report_errors(job, replay, &result);
    if (replay->needs)
        kept_pass_on(job, replay->needs, replay->all_levels, &kept);
}
