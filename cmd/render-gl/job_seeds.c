#include <string.h>

#include "cmd_style.h"
#include "render-gl/job.h"
#include "seed/spread.h"

/* A drawing style's strokes are as long as a share of a tile of this many pixels. */
#define STYLE_TILE_PX 128

/* Four layers of 64, spread well. */
static void make_seeds(struct cmd_args *args, struct hatch_seeds *seeds)
{
    const struct hatch_seeds_options how = {
        .cycle = {.count = 64, .seed = 1}, .layers = 4, .candidates = 100};
    uint64_t steps;
    struct hatch_err err;
    cmd_check(hatch_seeds_make(&how, &args->keep, &args->scratch, seeds, &steps, &err), NULL, &err);
}

static void read_seeds(struct cmd_args *args, const char *path, struct hatch_seeds *seeds)
{
    struct hatch_err err;
    if (path)
        cmd_check(hatch_seeds_read(cmd_read(args, path), &args->keep, seeds, &err), cmd_input_name(path),
                  &err);
    else
        make_seeds(args, seeds);
}

/* Layers take the style's directions one after the other, and between them from the third time on. */
static void set_strokes(const struct hatch_style *from, const struct seed_choice *choice,
                        struct hatch_rptam_style *style)
{
    *style = choice->style;
    style->ink = (double)from->ink;
    if (!(style->length_px > 0)) {
        style->length_px = STYLE_TILE_PX * ((double)from->length_min + (double)from->length_max) / 2;
        style->width_px = (double)from->width_px;
    }
    if (style->length_px < style->width_px)
        style->length_px = style->width_px; /* a dot */
    for (uint32_t i = 0; i < HATCH_RPTAM_LAYERS_MAX; i++) {
        uint32_t round = i / from->direction_count;
        style->angle_rad[i] = (double)from->directions[i % from->direction_count].angle_rad +
                              choice->turn_rad * (round + 1) / 2 * (round % 2 ? 1 : -1);
    }
}

void job_read_seeds(struct job *job)
{
    const struct seed_choice *choice = &job->options.seeds;
    struct cmd_args *args = &job->args;
    struct hatch_rptam_style style;
    struct hatch_style drawing;
    struct hatch_brush brush;
    struct hatch_seeds seeds;
    struct hatch_image stroke;
    struct hatch_err err;
    read_seeds(args, choice->path, &seeds);
    cmd_read_style(args, choice->drawing, NULL, NULL, &drawing, &brush);
    set_strokes(&drawing, choice, &style);
    cmd_check(hatch_image_make(&args->keep, brush.width, brush.height, "A", &stroke, &err), NULL, &err);
    memcpy(stroke.pixels, brush.alpha, sizeof *stroke.pixels * brush.width * brush.height);
    cmd_check(hatch_rptam_make(&seeds, &style, &stroke, &args->keep, &args->scratch, &job->rptam, &err),
              choice->path ? cmd_input_name(choice->path) : NULL, &err);
    if (!(style.length_px * 2 <= style.tile_px))
        cmd_warn(NULL, "strokes of %g pixels are cut: they grow to twice that in a tile of %g",
                 style.length_px, style.tile_px);
}
