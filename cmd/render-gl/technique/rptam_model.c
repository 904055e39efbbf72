#include <math.h>
#include <string.h>
#include <unistd.h>

#include "math/angle.h"
#include "render-gl/technique/rptam.h"
#include "seed/seeds_make.h"
#include "shared/style.h"

#define STYLE_TILE_PX 128 /* side of the tile that a drawing style's stroke lengths refer to */
#define DARKEST 0.65      /* tone of all layers together, unless the tile's side is given */
#define LAYER_INK 0.35    /* largest ink coverage of one layer, unless the tile's side is given */
#define LAYERS 4          /* number of seed sets made if no file is given */
#define LAYER_TURN 25     /* degrees between layers that share a direction of the style */

/* Makes seed sets of 64 seed points each. */
static void make_seeds(struct cmd_args *args, uint32_t layers, struct hatch_seeds *seeds)
{
    const struct hatch_seeds_options how = {.cycle = {.count = 64, .seed = 1}, .layers = layers, .candidates = 100};
    uint64_t steps;
    struct hatch_err err;
    cmd_check(hatch_seeds_make(&how, &args->keep, &args->scratch, seeds, &steps, &err), NULL, &err);
}

static void read_sets(struct cmd_args *args, struct rptam_source *source)
{
    const char *path = rptam_options.seeds, *name = cmd_input_name(path);
    uint32_t layers = source->layers.count;
    struct hatch_err err;
    if (!path)
        make_seeds(args, layers ? layers : LAYERS, &source->sets);
    else
        cmd_check(hatch_seeds_read(cmd_read(args, path), &args->keep, &source->sets, &err), name, &err);
    if (source->sets.layer_count < layers) {
        hatch_fail(&err, HATCH_BAD_INPUT, "%u %s, but %u layers in %s", source->sets.layer_count,
                   cmd_plural(source->sets.layer_count, "seed set", "seed sets"), layers,
                   cmd_input_name(rptam_options.layers));
        cmd_die(name, &err);
    }
}

static void copy_pixels(struct cmd_args *args, const float *pixels, uint32_t width, uint32_t height,
                        struct hatch_image *image)
{
    struct hatch_err err;
    cmd_check(hatch_image_make(&args->keep, width, height, "A", image, &err), NULL, &err);
    memcpy(image->pixels, pixels, sizeof *pixels * width * height);
}

static void take_brush(struct cmd_args *args, const struct hatch_brush *brush, struct rptam_stroke *stroke)
{
    *stroke = (struct rptam_stroke){0};
    copy_pixels(args, brush->alpha, brush->width, brush->height, &stroke->alpha);
    if (brush->grain)
        copy_pixels(args, brush->grain, HATCH_GRAIN_SIZE, HATCH_GRAIN_SIZE, &stroke->grain);
    stroke->varied = brush->grain || brush->kind == HATCH_BRUSH_IMAGE;
}

/* Reads the stroke of a layer.
 *   name  a brush, or an image whose path is relative to the file of layers */
static void read_stroke(struct cmd_args *args, const char *name, struct rptam_stroke *stroke)
{
    struct hatch_brush brush;
    struct hatch_err err;
    const char *path = cmd_path_beside(args, rptam_options.layers, name);
    int kind = 0;
    while (kind < HATCH_BRUSH_IMAGE && strcmp(name, hatch_brush_name((enum hatch_brush_kind)kind)) != 0)
        kind++;
    if (kind == HATCH_BRUSH_IMAGE && !strpbrk(name, "/.") && access(path, F_OK) != 0)
        cmd_check(hatch_fail(&err, HATCH_BAD_INPUT,
                             "stroke: '%s', want ink, pencil, crayon, charcoal, stipple, round or the file of an image",
                             name),
                  cmd_input_name(rptam_options.layers), &err);
    if (kind < HATCH_BRUSH_IMAGE)
        cmd_check(hatch_brush_make((enum hatch_brush_kind)kind, &args->keep, &brush, &err), NULL, &err);
    else
        cmd_read_brush(args, path, &brush);
    take_brush(args, &brush, stroke);
}

static void read_layers(struct cmd_args *args, struct rptam_source *source)
{
    const char *path = rptam_options.layers;
    struct hatch_err err;
    if (!path)
        return;
    cmd_check(hatch_layers_read(cmd_read(args, path), &args->keep, &source->layers, &err), cmd_input_name(path), &err);
    source->layer_strokes = HATCH_NEW(&args->keep, struct rptam_stroke, source->layers.count, &err);
    cmd_check(source->layer_strokes ? HATCH_OK : HATCH_LIMIT, NULL, &err);
    for (uint32_t i = 0; i < source->layers.count; i++)
        if (source->layers.lines[i].stroke)
            read_stroke(args, source->layers.lines[i].stroke, &source->layer_strokes[i]);
}

/* Warns of keys of the style that seed points do not have. All styles have a jitter, of which the manual tells. */
static void warn_of_style(const struct hatch_style *style)
{
    const char *const keys[] = {style->bend_max_rad > 0 ? "bend" : NULL,
                                style->overlap != HATCH_OVERLAP_DARKENS ? "overlap" : NULL,
                                style->color_count > 0 ? "color" : NULL};
    for (size_t i = 0; i < sizeof keys / sizeof *keys; i++)
        if (keys[i])
            cmd_warn(NULL, "the key '%s' of the style %s has no effect without a map", keys[i], style->name);
}

static void read_drawing(struct cmd_args *args, struct rptam_source *source)
{
    struct hatch_brush brush;
    cmd_read_style(args, rptam_options.style, NULL, NULL, &source->drawing, &brush);
    take_brush(args, &brush, &source->stroke);
}

static double mean_of(const struct hatch_image *image)
{
    size_t count = (size_t)image->width * image->height;
    double sum = 0;
    for (size_t i = 0; i < count; i++)
        sum += (double)image->pixels[i];
    return sum / (double)count;
}

static void set_stroke(const struct rptam_stroke *stroke, struct hatch_rptam_layer_style *layer)
{
    layer->stroke = &stroke->alpha;
    layer->grain = stroke->grain.pixels ? &stroke->grain : NULL;
    layer->varied = stroke->varied;
}

double rptam_mean_ink(const struct hatch_image *alpha, const struct hatch_image *grain)
{
    return mean_of(alpha) * (grain && grain->pixels ? mean_of(grain) : 1);
}

/* Returns the side of the tile at which all layers together have the tone DARKEST, assuming that strokes overlap at
 * random. The tile is larger if a layer would otherwise have more ink than LAYER_INK. */
static double tile_for(const struct rptam_source *source, const struct hatch_rptam_layer_style *strokes)
{
    uint32_t layers = source->layers.count ? source->layers.count : source->sets.layer_count;
    double ink = strokes->ink * rptam_mean_ink(strokes->stroke, strokes->grain);
    double share = fmin(-log(1 - DARKEST) / layers, LAYER_INK);
    double tile_px = sqrt(source->sets.layers[0].count * ink * strokes->length_px * strokes->width_px / share);
    return fmin(fmax(tile_px, 8), 8192);
}

/* Sets the options that were not given from the drawing style. */
static void fill_from_style(const struct rptam_source *source, struct rptam_options *options)
{
    const struct hatch_style *drawing = &source->drawing;
    if (!(options->ink > 0))
        options->ink = (double)drawing->ink;
    if (!(options->stroke_px[0] > 0)) {
        options->stroke_px[0] = STYLE_TILE_PX * ((double)drawing->length_min + (double)drawing->length_max) / 2;
        options->stroke_px[1] = (double)drawing->width_px;
    }
    options->stroke_px[0] = fmax(options->stroke_px[0], options->stroke_px[1]); /* a dot is as long as it is wide */
    struct hatch_rptam_layer_style strokes = {
        .length_px = options->stroke_px[0], .width_px = options->stroke_px[1], .ink = options->ink};
    set_stroke(&source->stroke, &strokes);
    if (!options->tile_given)
        options->tile_px = tile_for(source, &strokes);
}

/* Sets a layer to the values of the drawing style and the options. Successive layers take successive directions of the
 * style. When all have been taken, they start over, rotated by LAYER_TURN degrees to one side, then to the other side,
 * then by twice as much, and so on. Each layer begins at the tone at which the previous one is complete. */
static void set_layer(const struct rptam_source *source, uint32_t index, uint32_t count,
                      struct hatch_rptam_layer_style *layer)
{
    const struct rptam_options *options = &rptam_options;
    const struct hatch_style *from = &source->drawing;
    int round = (int)(index / from->direction_count), turns = (round + 1) / 2 * (round % 2 ? 1 : -1);
    *layer = (struct hatch_rptam_layer_style){
        .low = (double)index / count,
        .high = (index + 1.0) / count,
        .angle_rad = (double)from->directions[index % from->direction_count].angle_rad +
                     LAYER_TURN * HATCH_RADIANS * turns + options->turn_deg * HATCH_RADIANS,
        .length_px = options->stroke_px[0],
        .width_px = options->stroke_px[1],
        .tile_px = options->tile_px,
        .ink = options->ink};
    set_stroke(&source->stroke, layer);
}

/* Applies a line of the file of layers to a layer. It takes precedence over the options and the style. */
static void change_layer(const struct rptam_source *source, uint32_t index, struct hatch_rptam_layer_style *layer)
{
    const struct hatch_layer_line *line = &source->layers.lines[index];
    if (line->tone_given) {
        layer->low = line->low;
        layer->high = line->high;
    }
    if (line->turn_given)
        layer->angle_rad = line->turn_rad + rptam_options.turn_deg * HATCH_RADIANS;
    if (line->width_px > 0)
        layer->width_px = line->width_px;
    if (line->length_px > 0)
        layer->length_px = line->length_px;
    layer->length_px = fmax(layer->length_px, layer->width_px); /* a dot is as long as it is wide */
    if (line->ink > 0)
        layer->ink = line->ink;
    if (line->stroke)
        set_stroke(&source->layer_strokes[index], layer);
    if (line->tile_px > 0)
        layer->tile_px = line->tile_px;
    else if (!rptam_options.tile_given && (line->length_px > 0 || line->width_px > 0 || line->ink > 0 || line->stroke))
        layer->tile_px = tile_for(source, layer);
}

enum hatch_status rptam_make_model(struct cmd_args *args, struct rptam_state *state, struct hatch_err *err)
{
    struct rptam_source *source = &state->source;
    struct hatch_arena *arena = &source->arenas[source->arena ^ 1];
    struct rptam_options *options = &rptam_options;
    uint32_t most = source->layers.count ? source->layers.count : source->sets.layer_count;
    if (options->layers_max > most)
        options->layers_max = most;
    uint32_t count = (uint32_t)options->layers_max;
    if (count > HATCH_RPTAM_LAYERS_MAX)
        return hatch_fail(err, HATCH_LIMIT, "%u layers of seed points, want %u at most", count, HATCH_RPTAM_LAYERS_MAX);
    fill_from_style(source, options);
    struct hatch_rptam_style style = {.law = (enum hatch_fade_law)options->fade,
                                      .fade_size = options->fade_by == 1,
                                      .overlap = options->overlap,
                                      .layer_count = count};
    for (uint32_t i = 0; i < count; i++) {
        set_layer(source, i, count, &style.layers[i]);
        if (source->layers.count)
            change_layer(source, i, &style.layers[i]);
    }
    hatch_arena_free(arena);
    hatch_arena_init(arena, args->max_memory);
    HATCH_TRY(hatch_rptam_make(&source->sets, &style, arena, &args->scratch, &state->own, err));
    source->arena ^= 1;
    state->model = &state->own;
    return HATCH_OK;
}

void rptam_read(struct technique_context *context, struct technique_instance *instance)
{
    struct rptam_state *state = instance->state;
    struct hatch_err err;
    read_layers(context->args, &state->source);
    read_sets(context->args, &state->source);
    read_drawing(context->args, &state->source);
    if (!instance->technique->extra) /* else there may be a map, whose strokes have them */
        warn_of_style(&state->source.drawing);
    cmd_check(rptam_make_model(context->args, state, &err),
              rptam_options.seeds ? cmd_input_name(rptam_options.seeds) : NULL, &err);
}
