#include <math.h>
#include <string.h>

#include "shared/style.h"
#include "render-gl/job.h"
#include "seed/spread.h"

/* A drawing style's strokes are as long as a share of a tile of this many pixels. */
#define STYLE_TILE_PX 128
#define DARKEST 0.65 /* that all layers make, unless the tile is given */
#define LAYER_INK 0.35
#define LAYERS 4 /* unless somebody says how many */

/* Sets of 64, spread well. */
static void make_seeds(struct cmd_args *args, uint32_t layers, struct hatch_seeds *seeds)
{
    const struct hatch_seeds_options how = {.cycle = {.count = 64, .seed = 1}, .layers = layers, .candidates = 100};
    uint64_t steps;
    struct hatch_err err;
    cmd_check(hatch_seeds_make(&how, &args->keep, &args->scratch, seeds, &steps, &err), NULL, &err);
}

static void read_sets(struct job *job)
{
    const char *path = job->options.seeds.path;
    struct cmd_args *args = &job->args;
    uint32_t layers = job->source.layers.count;
    struct hatch_err err;
    if (!path)
        make_seeds(args, layers ? layers : LAYERS, &job->source.sets);
    else
        cmd_check(hatch_seeds_read(cmd_read(args, path), &args->keep, &job->source.sets, &err), cmd_input_name(path),
                  &err);
    if (job->source.sets.layer_count < layers) {
        hatch_fail(&err, HATCH_BAD_INPUT, "%u %s for the %u layers of %s", job->source.sets.layer_count,
                   cmd_plural(job->source.sets.layer_count, "seed set", "seed sets"), layers,
                   cmd_input_name(job->options.seeds.layers_path));
        cmd_die(cmd_input_name(path), &err);
    }
}

static void copy_pixels(struct cmd_args *args, const float *pixels, uint32_t width, uint32_t height,
                        struct hatch_image *image)
{
    struct hatch_err err;
    cmd_check(hatch_image_make(&args->keep, width, height, "A", image, &err), NULL, &err);
    memcpy(image->pixels, pixels, sizeof *pixels * width * height);
}

static void take_brush(struct cmd_args *args, const struct hatch_brush *brush, struct job_stroke *stroke)
{
    *stroke = (struct job_stroke){0};
    copy_pixels(args, brush->alpha, brush->width, brush->height, &stroke->alpha);
    if (brush->grain)
        copy_pixels(args, brush->grain, HATCH_GRAIN_SIZE, HATCH_GRAIN_SIZE, &stroke->grain);
    stroke->varied = brush->grain || brush->kind == HATCH_BRUSH_IMAGE;
}

/* By the name of a brush, or from a picture beside the file of layers. */
static void read_stroke(struct job *job, const char *name, struct job_stroke *stroke)
{
    struct hatch_brush brush;
    struct hatch_err err;
    int kind = 0;
    while (kind < HATCH_BRUSH_IMAGE && strcmp(name, hatch_brush_name((enum hatch_brush_kind)kind)) != 0)
        kind++;
    if (kind < HATCH_BRUSH_IMAGE)
        cmd_check(hatch_brush_make((enum hatch_brush_kind)kind, &job->args.keep, &brush, &err), NULL, &err);
    else
        cmd_read_brush(&job->args, cmd_path_beside(&job->args, job->options.seeds.layers_path, name), &brush);
    take_brush(&job->args, &brush, stroke);
}

static void read_layers(struct job *job)
{
    struct stroke_source *source = &job->source;
    const char *path = job->options.seeds.layers_path;
    struct hatch_err err;
    if (!path)
        return;
    cmd_check(hatch_layers_read(cmd_read(&job->args, path), &job->args.keep, &source->layers, &err),
              cmd_input_name(path), &err);
    source->layer_strokes = HATCH_NEW(&job->args.keep, struct job_stroke, source->layers.count, &err);
    cmd_check(source->layer_strokes ? HATCH_OK : HATCH_LIMIT, NULL, &err);
    for (uint32_t i = 0; i < source->layers.count; i++)
        if (source->layers.lines[i].stroke)
            read_stroke(job, source->layers.lines[i].stroke, &source->layer_strokes[i]);
}

static void read_drawing(struct job *job)
{
    struct hatch_brush brush;
    cmd_read_style(&job->args, job->options.seeds.drawing, NULL, NULL, &job->source.drawing, &brush);
    take_brush(&job->args, &brush, &job->source.stroke);
}

static double mean_of(const struct hatch_image *image)
{
    size_t count = (size_t)image->width * image->height;
    double sum = 0;
    for (size_t i = 0; i < count; i++)
        sum += (double)image->pixels[i];
    return sum / (double)count;
}

static void set_stroke(const struct job_stroke *stroke, struct hatch_rptam_layer_style *layer)
{
    layer->stroke = &stroke->alpha;
    layer->grain = stroke->grain.pixels ? &stroke->grain : NULL;
    layer->varied = stroke->varied;
}

/* The tile in which as many layers of these strokes as there are, are together as dark as DARKEST, if strokes lie as
 * by chance; but no layer holds more of them than hatching. */
static double tile_for(const struct stroke_source *source, const struct hatch_rptam_layer_style *strokes)
{
    uint32_t layers = source->layers.count ? source->layers.count : source->sets.layer_count;
    double ink = strokes->ink * mean_of(strokes->stroke) * (strokes->grain ? mean_of(strokes->grain) : 1);
    double share = fmin(-log(1 - DARKEST) / layers, LAYER_INK);
    double tile_px = sqrt(source->sets.layers[0].count * ink * strokes->length_px * strokes->width_px / share);
    return fmin(fmax(tile_px, 8), 8192);
}

/* What the options leave to the drawing style. */
static void settle(const struct stroke_source *source, struct seed_choice *choice)
{
    const struct hatch_style *drawing = &source->drawing;
    struct seed_style *style = &choice->style;
    if (!(style->ink > 0))
        style->ink = (double)drawing->ink;
    if (!(style->length_px > 0)) {
        style->length_px = STYLE_TILE_PX * ((double)drawing->length_min + (double)drawing->length_max) / 2;
        style->width_px = (double)drawing->width_px;
    }
    style->length_px = fmax(style->length_px, style->width_px); /* a dot */
    struct hatch_rptam_layer_style strokes = {
        .length_px = style->length_px, .width_px = style->width_px, .ink = style->ink};
    set_stroke(&source->stroke, &strokes);
    if (!choice->tile_given)
        style->tile_px = tile_for(source, &strokes);
}

/* Layers take the style's directions one after the other, and between them from the third time on; each comes in
 * where the one before it is complete. */
static void set_layer(const struct stroke_source *source, const struct seed_choice *choice, uint32_t index,
                      uint32_t count, struct hatch_rptam_layer_style *layer)
{
    const struct hatch_style *from = &source->drawing;
    const struct seed_style *common = &choice->style;
    int round = (int)(index / from->direction_count), turns = (round + 1) / 2 * (round % 2 ? 1 : -1);
    *layer = (struct hatch_rptam_layer_style){.low = (double)index / count,
                                              .high = (index + 1.0) / count,
                                              .angle_rad =
                                                  (double)from->directions[index % from->direction_count].angle_rad +
                                                  choice->turn_rad * turns + choice->stroke_turn_rad,
                                              .length_px = common->length_px,
                                              .width_px = common->width_px,
                                              .tile_px = common->tile_px,
                                              .ink = common->ink};
    set_stroke(&source->stroke, layer);
}

/* What a line of the file of layers says goes before all else. */
static void change_layer(const struct stroke_source *source, const struct seed_choice *choice, uint32_t index,
                         struct hatch_rptam_layer_style *layer)
{
    const struct hatch_layer_line *line = &source->layers.lines[index];
    if (line->tone_given) {
        layer->low = line->low;
        layer->high = line->high;
    }
    if (line->turn_given)
        layer->angle_rad = line->turn_rad + choice->stroke_turn_rad;
    if (line->width_px > 0)
        layer->width_px = line->width_px;
    if (line->length_px > 0)
        layer->length_px = line->length_px;
    layer->length_px = fmax(layer->length_px, layer->width_px); /* a dot */
    if (line->ink > 0)
        layer->ink = line->ink;
    if (line->stroke)
        set_stroke(&source->layer_strokes[index], layer);
    if (line->tile_px > 0)
        layer->tile_px = line->tile_px;
    else if (!choice->tile_given && (line->length_px > 0 || line->width_px > 0 || line->ink > 0 || line->stroke))
        layer->tile_px = tile_for(source, layer);
}

/* As many layers as there are sets or lines, but no more than the option says. */
static uint32_t count_layers(const struct job *job)
{
    uint32_t most = job->source.layers.count ? job->source.layers.count : job->source.sets.layer_count;
    return (uint32_t)lround(fmin(job->options.seeds.layers, most));
}

enum hatch_status job_make_strokes(struct job *job, struct hatch_err *err)
{
    struct seed_choice *choice = &job->options.seeds;
    struct hatch_arena *arena = &job->source.arenas[job->source.arena ^ 1];
    struct hatch_rptam_style style;
    uint32_t count = count_layers(job);
    choice->layers = fmin(choice->layers, count);
    if (count > HATCH_RPTAM_LAYERS_MAX)
        return hatch_fail(err, HATCH_LIMIT, "%u layers of seeds: %u are the most", count, HATCH_RPTAM_LAYERS_MAX);
    settle(&job->source, choice);
    style = (struct hatch_rptam_style){.law = choice->style.law,
                                       .fade_size = choice->style.fade_size,
                                       .overlap = choice->style.overlap,
                                       .layer_count = count};
    for (uint32_t i = 0; i < count; i++) {
        set_layer(&job->source, choice, i, count, &style.layers[i]);
        if (job->source.layers.count)
            change_layer(&job->source, choice, i, &style.layers[i]);
    }
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
    read_layers(job);
    read_sets(job);
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
    if (job->view_changed && hatch_view_is_fixed(&job->options.view, &job->scene))
        HATCH_TRY(hatch_view_make(&job->options.view, &job->gpu.pose, &job->span, &job->gpu.bounds,
                                  job->fixed_view.aspect, &job->args.scratch, &job->fixed_view, err));
    job->view_changed = false;
    return HATCH_OK;
}
