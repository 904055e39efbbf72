/* --needs: reports what the views need, as TSV or JSON, needs(5); and the check of a map that was made for such
 * needs. */
#include <math.h>

#include "render-gl/look/look.h"
#include "render-gl/mode/modes.h"
#include "render-gl/mode/needs/measure.h"
#include "render-gl/mode/needs/regions.h"
#include "shared/report.h"
#include "tam/volume.h"

#define LEEWAY 1.5 /* views between those that were measured may exceed the tolerance by this factor */

static void report_row(struct cmd_report *report, const char *thing, uint32_t index, double value, const char *unit)
{
    cmd_report_text(report, thing);
    cmd_report_integer(report, index);
    cmd_report_number(report, value);
    cmd_report_text(report, unit);
}

static uint32_t count_seen(const struct needs_item *item)
{
    uint32_t count = 0;
    for (uint32_t i = 0; i < item->faces; i++)
        count += item->unit_px[i] > 0;
    return count;
}

static void report_shares(struct cmd_report *report, const char *thing, const uint64_t *pixels, uint32_t count,
                          double drawn)
{
    for (uint32_t i = 0; i < count; i++)
        if (pixels[i])
            report_row(report, thing, i, (double)pixels[i] / drawn, "of the scene's pixels");
}

static void report_regions(struct cmd_report *report, struct job *job, const struct needs_measure *measure)
{
    struct hatch_needs_regions regions;
    uint32_t cells = 0;
    needs_find_regions(job, measure, &regions);
    for (uint32_t k = 0; k < 3; k++)
        report_row(report, "region-low", k, regions.low[k], "of the scene at rest");
    for (uint32_t k = 0; k < 3; k++)
        report_row(report, "region-side", k, regions.side[k], "of the scene at rest");
    for (uint32_t i = 0; i < HATCH_NEEDS_CELLS; i++)
        cells += regions.px[i] > 0;
    report_row(report, "region-cells", 0, cells, "");
    for (uint32_t i = 0; i < HATCH_NEEDS_CELLS; i++)
        if (regions.px[i] > 0)
            report_row(report, "region-unit-px", i, (double)regions.px[i], "px");
}

static void report_all(struct cmd_report *report, struct job *job, const struct needs_measure *measure)
{
    static const char *const tone[2] = {"tone", "tone-of-light-ink"};
    double drawn = measure->drawn ? (double)measure->drawn : 1;
    report_row(report, "tolerance", 0, measure->tolerance, "");
    report_row(report, "views", 0, measure->views, "");
    report_row(report, "width", 0, job->options->width, "px");
    report_row(report, "height", 0, job->options->height, "px");
    report_row(report, "drawn", 0, (double)measure->drawn / (double)measure->pixels, "of the picture's pixels");
    report_row(report, "relative", 0, !job->options->tone_range_given, "");
    for (uint32_t ink = 0; ink < measure->inks; ink++) {
        report_row(report, "darkest", ink, measure->darkest[ink], "tone");
        report_row(report, "lightest", ink, fmin(measure->lightest[ink], measure->darkest[ink]), "tone");
        report_shares(report, tone[ink], measure->tones[ink], HATCH_NEEDS_TONES, drawn);
    }
    for (uint32_t i = 0; i < HATCH_NEEDS_TONES; i++)
        if (measure->unit_px[i] > 0)
            report_row(report, "unit-px", i, measure->unit_px[i], "px");
    report_shares(report, "texels", measure->texels, HATCH_NEEDS_OCTAVES, drawn);
    if (look_options.period_px > 0)
        report_row(report, "solid-px", 0, look_options.period_px, "px");
    for (uint32_t i = 0; i < job->scene.unit.item_count; i++) {
        report_row(report, "item", i, (double)measure->items[i].pixels / drawn, "of the scene's pixels");
        if (measure->items[i].extent_px > 0)
            report_row(report, "item-px", i, measure->items[i].extent_px, "px");
        report_row(report, "faces", i, measure->items[i].faces, "");
        report_row(report, "faces-seen", i, count_seen(&measure->items[i]), "");
    }
    report_regions(report, job, measure);
}

void needs_report(struct job *job)
{
    static const char *const columns[] = {"thing", "index", "value", "unit", NULL};
    struct needs_measure measure;
    struct cmd_report report;
    needs_begin(job, job->options->tolerance, &measure);
    for (uint32_t frame = 0; frame < job->options->frames; frame++) {
        struct hatch_view view;
        cmd_progress("measuring", (double)frame / job->options->frames);
        job_set_frame(job, frame, &view);
        needs_add(job, &view, &measure);
    }
    needs_end(&measure);
    cmd_report_begin(&report, &job->args, columns);
    report_all(&report, job, &measure);
    cmd_report_write(&report, job->outputs[0]);
}

static const char again[] = "make it again with the needs of this view";

static bool is_unseen(const struct hatch_scene *scene)
{
    for (uint32_t m = 0; m < scene->mesh_count; m++)
        if (scene->meshes[m].unseen_tolerance > 0)
            return true;
    return false;
}

/* Exits with a message if a view shows parts of the scene that were made to be unseen. */
static void check_scene(const struct job *job, const struct needs_measure *measure, uint64_t drawn)
{
    struct hatch_err err;
    double allowed = LEEWAY * measure->unseen_tolerance;
    if ((double)measure->unseen <= allowed * (double)drawn)
        return;
    hatch_fail(&err, HATCH_BAD_INPUT, "was made for other views: %.3g %% of this one shows what they do not see; %s",
               100 * (double)measure->unseen / (double)drawn, again);
    cmd_die(job->name, &err);
}

/* Returns the smallest tolerance of strokes that no finer ones join; 0: there are none. */
static double find_tolerance(const struct job *job, const struct needs_strokes *items)
{
    double tolerance = 0;
    for (uint32_t i = 0; i < job->scene.unit.item_count; i++)
        if (items[i].tolerance > 0)
            tolerance = tolerance > 0 ? fmin(tolerance, items[i].tolerance) : items[i].tolerance;
    return tolerance;
}

/* Exits with a message if a view needs more strokes than there are where finer ones cannot be traced.
 *   tolerance  of the needs that they were made for; 0: there are enough for any view */
static void check_strokes(const struct job *job, const struct needs_measure *measure, double tolerance, uint64_t drawn)
{
    struct hatch_err err;
    if (tolerance <= 0 || (double)measure->few <= LEEWAY * tolerance * (double)drawn)
        return;
    hatch_fail(
        &err, HATCH_BAD_INPUT,
        "was made for surfaces seen from farther away: %.3g %% of this view needs finer strokes, and none can be "
        "traced on skins and morph targets; %s",
        100 * (double)measure->few / (double)drawn, again);
    cmd_die(job->name, &err);
}

/* Exits with a message if a view needs more than a map that was made for needs has.
 *   measure  after needs_add of the view
 *   drawn    number of the view's pixels that show the scene */
static void check_map(const struct job *job, const struct needs_measure *measure, uint64_t drawn)
{
    const char *name = cmd_input_name(job->options->map_path);
    const struct asset_part part = asset_part(&job->asset);
    double last = (double)part.last, allowed = LEEWAY * (double)part.tolerance;
    struct hatch_err err;
    for (uint32_t ink = 0; ink < measure->inks && part.cut_tones; ink++) {
        const struct hatch_needs_tones *tones = &measure->view_tones[ink];
        if (hatch_needs_excess(tones, drawn, last) <= allowed)
            continue;
        hatch_fail(&err, HATCH_BAD_INPUT, "was made for tones up to %.3g, this view needs %.3g: %s", last,
                   hatch_needs_darkest(tones, drawn, NEEDS_TONES_SHARE * measure->tolerance), again);
        cmd_die(name, &err);
    }
    if (part.cut_levels && (double)measure->finer > allowed * (double)drawn) {
        hatch_fail(&err, HATCH_BAD_INPUT,
                   "was made for surfaces seen from farther away: %.3g %% of this view needs finer levels; %s",
                   100 * (double)measure->finer / (double)drawn, again);
        cmd_die(name, &err);
    }
}

/* Exits with a message if a view shows levels of a volume that was made for needs on which strokes are grey, since
 * there are few slices.
 *   measure, drawn  as for check_map */
static void check_slices(const struct job *job, const struct needs_measure *measure, uint64_t drawn)
{
    struct hatch_err err;
    if ((double)measure->sparse <= LEEWAY * (double)asset_part(&job->asset).tolerance * (double)drawn)
        return;
    hatch_fail(&err, HATCH_BAD_INPUT,
               "%.3g %% of this view shows levels with fewer than %u slices of tone; want tamvol --layout array",
               100 * (double)measure->sparse / (double)drawn, HATCH_VOLUME_SLICES_FEW);
    cmd_die(cmd_input_name(job->options->map_path), &err);
}

void needs_check_mode(const struct job *job)
{
    struct hatch_err err;
    if (!job->options->window)
        return;
    if (asset_part(&job->asset).tolerance > 0)
        cmd_check(hatch_fail(&err, HATCH_BAD_INPUT, HATCH_TAM_NOT_WHOLE), cmd_input_name(job->options->map_path), &err);
    if (is_unseen(&job->values))
        cmd_check(hatch_fail(&err, HATCH_BAD_INPUT, "was made for the needs of some views; make it without --needs"),
                  job->name, &err);
}

/* Returns whether some strokes of the scene were made for the needs of views. */
static bool has_few_strokes(const struct hatch_scene *scene)
{
    for (uint32_t m = 0; m < scene->mesh_count; m++)
        if (scene->meshes[m].curves.needs > 0)
            return true;
    return false;
}

void needs_check(struct job *job)
{
    const struct asset_part part = asset_part(&job->asset);
    bool map = technique_asset(job->options->technique) && part.tolerance > 0;
    bool few = job->options->technique->features & TECHNIQUE_TRACED && has_few_strokes(&job->values);
    struct needs_measure measure;
    struct hatch_view view;
    if (!map && !few && !is_unseen(&job->values))
        return;
    needs_begin(job, map ? (double)part.tolerance : 1, &measure);
    needs_strokes_find(job, measure.strokes);
    double tolerance = find_tolerance(job, measure.strokes);
    for (uint32_t frame = 0; frame < job->options->frames; frame++) {
        job_set_frame(job, frame, &view);
        uint64_t drawn = needs_add(job, &view, &measure);
        check_scene(job, &measure, drawn);
        check_strokes(job, &measure, tolerance, drawn);
        if (map) {
            check_map(job, &measure, drawn);
            check_slices(job, &measure, drawn);
        }
    }
    needs_end(&measure);
    job_set_frame(job, 0, &view);
}
