#include <math.h>
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

static void read_drawing(struct job *job)
{
    struct stroke_source *source = &job->source;
    struct hatch_brush brush;
    struct hatch_err err;
    cmd_read_style(&job->args, job->options.seeds.drawing, NULL, NULL, &source->drawing, &brush);
    cmd_check(hatch_image_make(&job->args.keep, brush.width, brush.height, "A", &source->stroke, &err), NULL,
              &err);
    memcpy(source->stroke.pixels, brush.alpha, sizeof *source->stroke.pixels * brush.width * brush.height);
}

/* What the options leave to the drawing style. */
static void settle(const struct hatch_style *drawing, struct seed_choice *choice)
{
    struct seed_style *style = &choice->style;
    if (!(style->ink > 0))
        style->ink = (double)drawing->ink;
    if (!(style->length_px > 0)) {
        style->length_px = STYLE_TILE_PX * ((double)drawing->length_min + (double)drawing->length_max) / 2;
        style->width_px = (double)drawing->width_px;
    }
    style->length_px = fmax(style->length_px, style->width_px); /* a dot */
}

/* Layers take the style's directions one after the other, and between them from the third time on; each comes in
 * where the one before it is complete. */
static void set_layers(const struct stroke_source *source, const struct seed_choice *choice, uint32_t count,
                       struct hatch_rptam_style *style)
{
    const struct hatch_style *from = &source->drawing;
    const struct seed_style *common = &choice->style;
    *style = (struct hatch_rptam_style){.law = common->law,
                                        .fade_size = common->fade_size,
                                        .overlap = common->overlap,
                                        .layer_count = count};
    for (uint32_t i = 0; i < count; i++) {
        uint32_t round = i / from->direction_count;
        style->layers[i] = (struct hatch_rptam_layer_style){
            .low = (double)i / count,
            .high = (i + 1.0) / count,
            .angle_rad = (double)from->directions[i % from->direction_count].angle_rad +
                         choice->turn_rad * (round + 1) / 2 * (round % 2 ? 1 : -1) + choice->stroke_turn_rad,
            .length_px = common->length_px,
            .width_px = common->width_px,
            .tile_px = common->tile_px,
            .ink = common->ink,
            .stroke = &source->stroke};
    }
}

enum hatch_status job_make_strokes(struct job *job, struct hatch_err *err)
{
    struct seed_choice *choice = &job->options.seeds;
    struct hatch_arena *arena = &job->source.arenas[job->source.arena ^ 1];
    struct hatch_rptam_style style;
    choice->layers = fmin(choice->layers, job->source.sets.layer_count);
    uint32_t count = (uint32_t)lround(choice->layers);
    if (count > HATCH_RPTAM_LAYERS_MAX)
        return hatch_fail(err, HATCH_LIMIT, "%u layers of seeds: %u are the most", count, HATCH_RPTAM_LAYERS_MAX);
    settle(&job->source.drawing, choice);
    set_layers(&job->source, choice, count, &style);
    hatch_arena_free(arena);
    hatch_arena_init(arena, job->args.max_memory);
    HATCH_TRY(hatch_rptam_make(&job->source.sets, &style, arena, &job->args.scratch, &job->rptam, err));
    job->source.arena ^= 1;
    return HATCH_OK;
}

void job_read_seeds(struct job *job)
{
    const struct seed_choice *choice = &job->options.seeds;
    struct hatch_err err;
    read_seeds(&job->args, choice->path, &job->source.sets);
    read_drawing(job);
    cmd_check(job_make_strokes(job, &err), choice->path ? cmd_input_name(choice->path) : NULL, &err);
    job->renderer.rptam = &job->rptam;
}

void job_set_darkest(struct job *job)
{
    const struct options *options = &job->options;
    if (techniques[options->technique]->seeds && !options->high_given)
        job->renderer.style.curve.high = job->rptam.darkest;
}

enum hatch_status job_refresh(struct job *job, struct hatch_err *err)
{
    if (job->strokes_changed && job->renderer.rptam) {
        double begin_ms = cmd_elapsed_ms();
        HATCH_TRY(job_make_strokes(job, err));
        job_set_darkest(job);
        HATCH_TRY(renderer_take_strokes(&job->renderer, &job->args.scratch, err));
        job->strokes_made++;
        job->strokes_ms += cmd_elapsed_ms() - begin_ms;
    }
    job->strokes_changed = false;
    if (job->view_changed && view_is_fixed(&job->options.view, &job->scene))
        HATCH_TRY(view_make(&job->options.view, &job->gpu.pose, &job->span, &job->gpu.bounds,
                            job->fixed_view.aspect, &job->args.scratch, &job->fixed_view, err));
    job->view_changed = false;
    return HATCH_OK;
}
