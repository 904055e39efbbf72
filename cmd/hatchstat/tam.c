/* hatchstat tam FILE: measures tone, nesting, seams and evenness of a tonal art map; the report has one row per
 * image. */
#include <math.h>

#include "shared/map.h"
#include "shared/style.h"
#include "measure/tam_figures.h"
#include "stroke/script.h"
#include "subject.h"

/* Allowed errors of tone, at the finest level and at the others. */
#define FINEST_ERROR_MAX 0.003
#define ERROR_MAX 0.02

static const char *const columns[] = {"tone",    "level",      "size",     "target",  "mean",      "error",
                                      "allowed", "allowed_by", "stroke",   "lighter", "missing",   "seam_x",
                                      "seam_y",  "spread32",   "spread16", "spread8", "spread4",   "even32",
                                      "even16",  "even8",      "even4",    "chroma",  "hue_error", NULL};

/* A map and, if they are given, its strokes. */
struct subject {
    struct hatch_tam tam;
    bool has_strokes;
    struct hatch_stroke_list list;
    struct hatch_style style;
    struct hatch_brush brush;
    struct hatch_tam_strokes strokes;
    double stroke_darkness[HATCH_MIP_LEVELS_MAX]; /* per level; NaN without strokes */
    double *evenness;                             /* per tone and box; NULL without strokes */
};

/* Sums and maxima for the last row of the report. */
struct summary {
    uint32_t failed; /* number of images whose error of tone exceeds the allowed one */
    uint64_t lighter, missing;
    double hue_error; /* the largest; NaN in grey maps */
    double error, seam[2], spread[HATCH_EVENNESS_BOXES], even[HATCH_EVENNESS_BOXES], images;
};

static double growth_of(const struct hatch_tam *tam)
{
    const struct hatch_attribute *growth = hatch_mipmap_attribute(&tam->columns[0], HATCH_TAM_ATTR_GROWTH);
    return growth && growth->number > 0 && growth->number < 1 ? growth->number : 0;
}

/* Returns the style of the strokes: that of the option, else the one that the map names, else "ink". */
static const char *style_of(struct cmd_args *args, const struct stat_options *options, const struct hatch_tam *tam)
{
    const struct hatch_attribute *named = hatch_mipmap_attribute(&tam->columns[0], HATCH_TAM_ATTR_STYLE);
    if (options->style)
        return options->style;
    if (!named || !named->text)
        return "ink";
    if (!cmd_has_style(args, named->text))
        cmd_usage("the map's style '%s' is not installed; give its file with --style", named->text);
    return named->text;
}

static void read_strokes(struct cmd_args *args, const struct stat_options *options, struct subject *subject)
{
    struct hatch_err err;
    struct hatch_tam *tam = &subject->tam;
    cmd_read_style(args, style_of(args, options, tam), &options->settings, options->brush, &subject->style,
                   &subject->brush);
    cmd_check(hatch_script_parse(cmd_read(args, options->strokes), tam->size_px, &args->keep, &subject->list, &err),
              cmd_input_name(options->strokes), &err);
    subject->has_strokes = true;
    subject->strokes =
        (struct hatch_tam_strokes){&subject->list, &subject->style, &subject->brush, (float)growth_of(tam)};
}

static void measure_strokes(struct cmd_args *args, const struct stat_options *options, struct subject *subject,
                            struct summary *summary)
{
    struct hatch_err err;
    const struct hatch_tam *tam = &subject->tam;
    const char *name = cmd_input_name(options->strokes);
    for (uint32_t level = 0; level < tam->levels; level++)
        cmd_check(hatch_measure_stroke_darkness(tam, &subject->strokes, level, &args->scratch,
                                                &subject->stroke_darkness[level], &err),
                  name, &err);
    cmd_check(hatch_measure_tam_nesting(tam, &subject->strokes, &args->scratch, &summary->missing, &err), name, &err);
    cmd_check(HATCH_ALLOC(&args->keep, &subject->evenness, (size_t)tam->tones * HATCH_EVENNESS_BOXES, &err), NULL,
              &err);
    cmd_check(hatch_measure_evenness(tam, &subject->strokes, (uint32_t)options->throws, &args->scratch,
                                     subject->evenness, &err),
              name, &err);
}

/* Returns the allowed error of tone of an image; NaN for a level without strokes of its own.
 *   by  out: text of the column allowed_by: the limit that applies */
static double allowed_error(const struct subject *subject, uint32_t level, const char **by)
{
    double stroke = subject->stroke_darkness[level], limit = level ? ERROR_MAX : FINEST_ERROR_MAX;
    *by = level >= subject->tam.levels ? "-" : stroke > limit ? "stroke" : "tone";
    return level >= subject->tam.levels ? NAN : fmax(stroke, limit);
}

static void put_image(struct cmd_report *report, const struct subject *subject, uint32_t tone, uint32_t level,
                      const struct hatch_tam_image_figures *f, struct summary *summary)
{
    const char *by;
    double allowed = allowed_error(subject, level, &by);
    cmd_report_integer(report, tone);
    cmd_report_integer(report, level);
    cmd_report_integer(report, f->size_px);
    const double tones[] = {(double)subject->tam.target[tone], f->mean, f->error, allowed};
    cmd_report_numbers(report, tones, 4);
    cmd_report_text(report, by);
    cmd_report_number(report, subject->stroke_darkness[level]);
    cmd_report_integer(report, f->lighter_pixels);
    cmd_report_number(report, NAN);
    cmd_report_numbers(report, f->seam_z, 2);
    cmd_report_numbers(report, f->spread, HATCH_EVENNESS_BOXES);
    const double *even = level || !subject->evenness ? NULL : subject->evenness + tone * HATCH_EVENNESS_BOXES;
    cmd_report_numbers(report, even, HATCH_EVENNESS_BOXES);
    cmd_report_number(report, f->chroma);
    cmd_report_number(report, f->hue_error_deg);

    summary->lighter += f->lighter_pixels;
    for (uint32_t box = 0; level == 0 && box < HATCH_EVENNESS_BOXES; box++) {
        summary->spread[box] += f->spread[box] / subject->tam.tones;
        summary->even[box] += even ? even[box] / subject->tam.tones : NAN;
    }
    if (level >= subject->tam.levels)
        return;
    summary->failed += !(fabs(f->error) <= allowed);
    summary->error = fmax(summary->error, fabs(f->error));
    summary->hue_error = fmax(summary->hue_error, f->hue_error_deg); /* fmax ignores NaN */
    summary->images++;
    for (int axis = 0; axis < 2; axis++)
        summary->seam[axis] += f->seam_z[axis];
}

static void put_summary(struct cmd_report *report, const struct subject *subject, const struct summary *s)
{
    const double seam[] = {s->seam[0] / s->images, s->seam[1] / s->images};
    cmd_report_text(report, "all");
    cmd_report_numbers(report, NULL, 1);
    cmd_report_integer(report, subject->tam.size_px);
    cmd_report_numbers(report, NULL, 2);
    cmd_report_number(report, s->error);
    cmd_report_numbers(report, NULL, 1);
    cmd_report_text(report, s->failed ? "no" : "yes");
    cmd_report_numbers(report, NULL, 1);
    cmd_report_integer(report, s->lighter);
    if (subject->has_strokes)
        cmd_report_integer(report, s->missing);
    else
        cmd_report_numbers(report, NULL, 1);
    cmd_report_numbers(report, seam, 2);
    cmd_report_numbers(report, s->spread, HATCH_EVENNESS_BOXES);
    cmd_report_numbers(report, s->even, HATCH_EVENNESS_BOXES);
    cmd_report_numbers(report, NULL, 1);
    cmd_report_number(report, s->hue_error);
}

enum hatch_status stat_tam(struct cmd_args *args, const struct stat_options *options, struct cmd_output *output)
{
    struct hatch_err err;
    struct subject subject = {.has_strokes = false};
    struct summary summary = {.hue_error = NAN};
    const char *path = args->operand_count > 1 ? args->operands[1] : NULL;
    for (uint32_t level = 0; level < HATCH_MIP_LEVELS_MAX; level++)
        subject.stroke_darkness[level] = NAN;
    cmd_read_map(args, path, &subject.tam);
    if (options->strokes) {
        read_strokes(args, options, &subject);
        measure_strokes(args, options, &subject, &summary);
    }
    struct cmd_report report;
    cmd_report_begin(&report, args, columns);
    for (uint32_t tone = 0; tone < subject.tam.tones; tone++)
        for (uint32_t level = 0; level < subject.tam.columns[tone].level_count; level++) {
            struct hatch_tam_image_figures figures;
            cmd_check(hatch_measure_tam_image(&subject.tam, tone, level, &args->scratch, &figures, &err),
                      cmd_input_name(path), &err);
            put_image(&report, &subject, tone, level, &figures, &summary);
        }
    put_summary(&report, &subject, &summary);
    cmd_report_write(&report, output);
    bool passed = !summary.failed && !summary.lighter && !summary.missing;
    return passed || !options->check ? HATCH_OK : HATCH_DIFFERS;
}
