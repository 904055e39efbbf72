/* hatchstat ink FILE ...: measures grey strokes, errors of tone and of edges, and continuity at borders in pictures;
 * the report has one row per file. */
#include <math.h>

#include "measure/border_figures.h"
#include "measure/ink_figures.h"
#include "subject.h"

static const char *const columns[] = {"file",       "inked",      "grey",       "grey_strokes", "tone_error",
                                      "tone_worst", "edge_error", "tone_rms",   "uneven24",     "black",
                                      "across",     "inside",     "continuity", "width",        NULL};

static void check_size(const char *path, const struct hatch_image *picture, const struct hatch_image *reference,
                       const char *name)
{
    struct hatch_err err;
    if (picture->width == reference->width && picture->height == reference->height)
        return;
    hatch_fail(&err, HATCH_BAD_INPUT, "%ux%u pixels, %s %ux%u", picture->width, picture->height, name, reference->width,
               reference->height);
    cmd_die(cmd_input_name(path), &err);
}

enum hatch_status stat_ink(struct cmd_args *args, const struct stat_options *options, struct cmd_output *output)
{
    struct hatch_image picture, reference, patches;
    struct hatch_arena arena;
    struct cmd_report report;
    struct hatch_err err;
    if (options->reference)
        stat_read_picture(args, options->reference, options->srgb, NULL, &reference);
    if (options->patches)
        stat_read_picture(args, options->patches, false, NULL, &patches);
    /* The name column is omitted for a single file, so that the output does not depend on its path. */
    bool named = args->operand_count > 2;
    cmd_report_begin(&report, args, named ? columns : columns + 1);
    for (int i = 1; i < args->operand_count; i++) {
        const char *path = args->operands[i];
        struct hatch_ink_figures f;
        hatch_arena_init(&arena, args->max_memory);
        stat_read_picture(args, path, options->srgb, &arena, &picture);
        if (options->reference)
            check_size(path, &picture, &reference, "the reference has");
        if (options->patches)
            check_size(path, &picture, &patches, "the patches have");
        cmd_check(hatch_measure_ink(&picture, options->reference ? &reference : NULL, &args->scratch, &f, &err),
                  cmd_input_name(path), &err);
        struct hatch_border_figures b = {NAN, NAN, NAN};
        if (options->patches)
            cmd_check(hatch_measure_borders(&picture, &patches, &args->scratch, &b, &err), cmd_input_name(path), &err);
        hatch_arena_free(&arena);
        if (named)
            cmd_report_text(&report, cmd_input_name(path));
        const double numbers[] = {f.inked,      f.grey,       f.grey_strokes, f.tone_error, f.tone_worst,
                                  f.edge_error, f.tone_rms,   f.uneven24,     f.black,      b.across,
                                  b.inside,     b.continuity, f.width_px};
        for (size_t n = 0; n < sizeof numbers / sizeof *numbers; n++)
            cmd_report_number(&report, numbers[n]);
    }
    cmd_report_write(&report, output);
    return HATCH_OK;
}
