/* hatchstat seeds FILE: measures seed sets; the report has one row per layer. */
#include <math.h>

#include "measure/seed_figures.h"
#include "subject.h"

static const char *const columns[] = {
    "layer",           "seeds",           "uneven",         "astray",      "distance",
    "distance_sparse", "distance_random", "distance_bayer", "discrepancy", "correlation",
    "power_1_4",       "power_1_2",       "power_3_4",      "power_1",     NULL};

static void report_row(struct cmd_report *report, uint32_t layer, const struct hatch_seed_figures *f)
{
    cmd_report_integer(report, layer);
    cmd_report_integer(report, f->seeds);
    cmd_report_integer(report, f->uneven);
    cmd_report_number(report, f->complete ? (double)f->astray : (double)NAN);
    cmd_report_number(report, f->distance);
    cmd_report_number(report, f->distance_sparse);
    cmd_report_number(report, f->distance_random);
    cmd_report_number(report, f->distance_bayer);
    cmd_report_number(report, f->complete ? f->discrepancy : (double)NAN);
    cmd_report_number(report, f->correlation);
    cmd_report_numbers(report, f->complete ? f->power : NULL, HATCH_SEED_RINGS);
}

enum hatch_status stat_seeds(struct cmd_args *args, const struct stat_options *options, struct cmd_output *output)
{
    const char *path = args->operand_count > 1 ? args->operands[1] : NULL;
    const char *name = cmd_input_name(path);
    struct cmd_report report;
    struct hatch_seeds seeds;
    struct hatch_err err;
    bool passed = true;
    cmd_check(hatch_seeds_read(cmd_read(args, path), &args->keep, &seeds, &err), name, &err);
    cmd_report_begin(&report, args, columns);
    for (uint32_t i = 0; i < seeds.layer_count; i++) {
        struct hatch_seed_figures figures;
        cmd_check(hatch_measure_seeds(&seeds.layers[i], (uint32_t)options->throws, &args->scratch, &figures, &err),
                  name, &err);
        report_row(&report, i + 1, &figures);
        passed = passed && !figures.uneven && !figures.astray;
    }
    cmd_report_write(&report, output);
    return options->check && !passed ? HATCH_DIFFERS : HATCH_OK;
}
