/* hatchstat diff A B: measures the difference of two pictures. */
#include "filter/difference.h"
#include "subject.h"

static const char *const columns[] = {"max",      "mean",      "bias",      "rmse",      "psnr_db", "differing",
                                      "max_box8", "max_box16", "max_box32", "max_box64", NULL};
static const uint32_t boxes_px[] = {8, 16, 32, 64};
#define BOXES (sizeof boxes_px / sizeof *boxes_px)

enum hatch_status stat_diff(struct cmd_args *args, const struct stat_options *options, struct cmd_output *output)
{
    struct hatch_image a, b;
    const char *const *paths = (const char *const *)args->operands + 1;
    stat_read_picture_as_is(args, paths[0], options->srgb, &a);
    stat_read_picture_as_is(args, paths[1], options->srgb, &b);
    stat_make_alike(&args->keep, paths[1], &a, &b);

    struct hatch_err err;
    struct hatch_difference difference;
    double low[BOXES];
    hatch_image_difference(&a, &b, &difference);
    for (size_t i = 0; i < BOXES; i++)
        cmd_check(hatch_image_low_difference(&a, &b, boxes_px[i], &args->scratch, &low[i], &err), NULL, &err);

    struct cmd_report report;
    cmd_report_begin(&report, args, columns);
    const double whole[] = {difference.max,  difference.mean,    difference.bias,
                            difference.rmse, difference.psnr_db, difference.differing};
    cmd_report_numbers(&report, whole, sizeof whole / sizeof *whole);
    cmd_report_numbers(&report, low, BOXES);
    cmd_report_write(&report, output);
    bool passed = options->max_difference < 0 || difference.max <= options->max_difference;
    return passed ? HATCH_OK : HATCH_DIFFERS;
}
