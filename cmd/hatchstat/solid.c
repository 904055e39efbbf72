/* hatchstat solid [FILE]: measures a solid texture, alone and against the picture from which it was made. */
#include "measure/solid_figures.h"
#include "shared/solid/solid.h"
#include "subject.h"

#define SAMPLES 1024u

static const char *const columns[] = {"size",           "channels",       "mean_r",       "mean_g",    "mean_b",
                                      "deviation_r",    "deviation_g",    "deviation_b",  "step_x",    "step_y",
                                      "step_z",         "isotropy",       "seam",         "histogram", "neighborhood_x",
                                      "neighborhood_y", "neighborhood_z", "neighborhood", NULL};

static void put(struct cmd_report *report, const struct hatch_solid *solid, const struct hatch_solid_figures *f)
{
    cmd_report_integer(report, solid->size);
    cmd_report_integer(report, solid->channels);
    cmd_report_numbers(report, f->mean, 3);
    cmd_report_numbers(report, f->deviation, 3);
    cmd_report_numbers(report, f->step, 3);
    cmd_report_number(report, f->isotropy);
    cmd_report_number(report, f->seam);
    cmd_report_number(report, f->histogram);
    cmd_report_numbers(report, f->neighborhood, 3);
    cmd_report_number(report, f->neighborhood_all);
}

enum hatch_status stat_solid(struct cmd_args *args, const struct stat_options *options, struct cmd_output *output)
{
    const char *path = args->operand_count > 1 ? args->operands[1] : NULL, *name = cmd_input_name(path);
    struct hatch_solid solid;
    struct hatch_image exemplar;
    struct hatch_solid_figures figures;
    struct cmd_report report;
    struct hatch_err err;
    if (!cmd_parse_solid(args, name, cmd_read(args, path), &solid))
        cmd_check(hatch_fail(&err, HATCH_BAD_INPUT, "neither KTX2 nor slices in OpenEXR"), name, &err);
    if (solid.depth == 1)
        cmd_check(hatch_fail(&err, HATCH_BAD_INPUT, "a flat texture, want a cube"), name, &err);
    if (options->reference)
        stat_read_picture(args, options->reference, false, NULL, &exemplar);
    cmd_check(hatch_measure_solid(&solid, options->reference ? &exemplar : NULL, SAMPLES, cmd_pool(args),
                                  &args->scratch, &figures, &err),
              name, &err);
    cmd_report_begin(&report, args, columns);
    put(&report, &solid, &figures);
    cmd_report_write(&report, output);
    return HATCH_OK;
}
