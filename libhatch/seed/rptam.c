#include "seed/rptam.h"

#include <math.h>

static double bilinear(const struct hatch_image *image, double x, double y)
{
    x -= 0.5;
    y -= 0.5;
    if (!(x >= 0 && y >= 0 && x < image->width - 1 && y < image->height - 1))
        return 0;
    uint32_t column = (uint32_t)x, row = (uint32_t)y;
    double right = x - column, low = y - row;
    const float *upper = image->pixels + (size_t)row * image->width + column;
    const float *lower = upper + image->width;
    return (1 - low) * ((1 - right) * (double)upper[0] + right * (double)upper[1]) +
           low * ((1 - right) * (double)lower[0] + right * (double)lower[1]);
}

/* Alpha at a place in pixels from the stroke's middle, along and across. */
static double stroke_alpha(const struct hatch_rptam_layer *layer, uint32_t look, double along_px, double across_px)
{
    struct hatch_image image = layer->stroke;
    image.pixels += (size_t)(look & (layer->images - 1)) * image.width * image.height;
    double x = 1 + (along_px / layer->style.length_px + 0.5) * (image.width - 2);
    double y = 1 + ((look & 8u ? -across_px : across_px) / layer->style.width_px + 0.5) * (image.height - 2);
    return bilinear(&image, x, y);
}

static int odd(double tile)
{
    return tile - 2 * floor(tile / 2) != 0;
}

/* The weight of a seed's stroke in a tile. */
static double weight_of(const struct hatch_rptam_pattern *pattern, uint32_t seed, double tile_u, double tile_v)
{
    const struct hatch_rptam_layer *layer = pattern->layer;
    uint8_t life = layer->life[4 * seed + 2u * (uint32_t)odd(tile_v) + (uint32_t)odd(tile_u)];
    if (life != HATCH_LIFE_STAYS)
        return hatch_fade_weight(&pattern->fade, hatch_life_value(life), 0);
    if (!pattern->weighted)
        return 1;
    uint32_t above = (seed + layer->count - 1) % layer->count;
    int right = odd(floor(tile_u / 2)), low = odd(floor(tile_v / 2));
    life = layer->life[4 * above + 2u * (uint32_t)low + (uint32_t)right];
    return life == HATCH_LIFE_STAYS ? 1 : hatch_fade_weight(&pattern->fade, hatch_life_value(life), pattern->fade.next);
}

/* The paper that a seed's stroke in a tile leaves at (du, dv) tiles from its middle. */
static double left_by(const struct hatch_rptam_pattern *pattern, uint32_t seed, double tile_u, double tile_v, double du,
                      double dv)
{
    const struct hatch_rptam_layer *layer = pattern->layer;
    /* Beyond a stroke of full size and the softness of its border there is no need to ask how large it is. */
    double across = (layer->cosine * dv - layer->sine * du) * pattern->tile_px;
    if (fabs(across) > layer->style.width_px / 2 + 1)
        return 1;
    double along = (layer->cosine * du + layer->sine * dv) * pattern->tile_px;
    if (fabs(along) > layer->style.length_px / 2 + 1)
        return 1;
    double weight = weight_of(pattern, seed, tile_u, tile_v);
    if (!(weight > 0))
        return 1;
    uint32_t look = layer->style.varied ? hatch_rptam_look(seed, pattern->level, layer->count) : 0;
    if (pattern->shrinks && weight < 1) {
        double length = fmax(sqrt(weight), fmin(1, HATCH_RPTAM_THIN_PX / layer->style.length_px));
        double width = fmax(sqrt(weight), fmin(1, HATCH_RPTAM_THIN_PX / layer->style.width_px));
        along /= length;
        across /= width;
        weight /= length * width;
    }
    return 1 - layer->style.ink * stroke_alpha(layer, look, along, across) * weight;
}

/* Every copy of every seed that could reach so far. */
static double left_by_all(const struct hatch_rptam_pattern *pattern, double u, double v)
{
    const struct hatch_rptam_layer *layer = pattern->layer;
    double paper = 1;
    double reach = hypot(layer->style.length_px + 1, layer->style.width_px + 1) / 2 / pattern->tile_px;
    for (uint32_t seed = 0; seed < layer->count; seed++) {
        double du = u - layer->at[seed][0], dv = v - layer->at[seed][1];
        for (double tile_v = ceil(dv - reach); tile_v <= dv + reach; tile_v++)
            for (double tile_u = ceil(du - reach); tile_u <= du + reach; tile_u++)
                paper *= left_by(pattern, seed, tile_u, tile_v, du - tile_u, dv - tile_v);
    }
    return paper;
}

static uint32_t texel_at(double share, uint32_t side)
{
    uint32_t texel = (uint32_t)(share * side);
    return texel < side ? texel : side - 1; /* a hair below 0 is rounded up to 1 */
}

static double left_by_listed(const struct hatch_rptam_pattern *pattern, double u, double v)
{
    const struct hatch_coverage *lists = pattern->lists;
    const double(*at)[2] = (const double(*)[2])pattern->layer->at;
    double base_u = floor(u), base_v = floor(v), paper = 1;
    uint32_t column = texel_at(u - base_u, lists->side), row = texel_at(v - base_v, lists->side);
    const uint32_t *list = lists->first + (size_t)row * lists->side + column;
    for (uint32_t i = list[0]; i < list[1]; i++) {
        const struct hatch_coverage_copy *copy = &lists->copies[i];
        double tile_u = base_u + copy->tile_u, tile_v = base_v + copy->tile_v;
        paper *= left_by(pattern, copy->seed, tile_u, tile_v, u - at[copy->seed][0] - tile_u,
                         v - at[copy->seed][1] - tile_v);
    }
    return paper;
}

void hatch_rptam_pattern(const struct hatch_rptam *rptam, uint32_t layer_index, double depth, double amount, bool all,
                         struct hatch_rptam_pattern *pattern)
{
    const struct hatch_rptam_layer *layer = &rptam->layers[layer_index];
    const struct hatch_rptam_style *style = &rptam->style;
    *pattern = (struct hatch_rptam_pattern){.nothing = !(amount >= HATCH_RPTAM_AMOUNT_MIN)};
    if (pattern->nothing)
        return;
    double far = depth - log2(amount) / 2, level = floor(far), smaller = floor(2 * (1 - depth + level));
    *pattern = (struct hatch_rptam_pattern){
        .layer = layer,
        .lists = all ? NULL : &layer->coverage[(uint32_t)fmin(fmax(smaller, 0), HATCH_RPTAM_SIZES - 1)],
        .weighted = style->law == HATCH_FADE_WEIGHTED,
        .shrinks = style->fade_size,
        .fade = hatch_fade_at(style->law, far - level, style->overlap),
        .level = (int)level,
        .scale = exp2(-level),
        .tile_px = layer->style.tile_px * exp2(level - depth)};
}

double hatch_rptam_left(const struct hatch_rptam_pattern *pattern, const double uv[2])
{
    if (pattern->nothing)
        return 1;
    double u = uv[0] * pattern->scale, v = uv[1] * pattern->scale;
    return pattern->lists ? left_by_listed(pattern, u, v) : left_by_all(pattern, u, v);
}

double hatch_rptam_layer_ink(const struct hatch_rptam *rptam, uint32_t layer, const double uv[2], double depth,
                             double amount, bool all)
{
    struct hatch_rptam_pattern pattern;
    hatch_rptam_pattern(rptam, layer, depth, amount, all, &pattern);
    return 1 - hatch_rptam_left(&pattern, uv);
}

double hatch_rptam_ink(const struct hatch_rptam *rptam, const double uv[2], double depth, const double *amounts,
                       bool all)
{
    double paper = 1;
    for (uint32_t i = 0; i < rptam->layer_count; i++)
        paper *= 1 - hatch_rptam_layer_ink(rptam, i, uv, depth, amounts[i], all);
    return 1 - paper;
}

void hatch_rptam_amounts(const struct hatch_rptam *rptam, double darkness, double *amounts)
{
    double at = rptam->darkest > 0 ? darkness / rptam->darkest * HATCH_RPTAM_STEPS : 0;
    at = fmin(fmax(at, 0), HATCH_RPTAM_STEPS);
    uint32_t step = (uint32_t)fmin(at, HATCH_RPTAM_STEPS - 1);
    double way = rptam->way[step] + (at - step) * (rptam->way[step + 1] - rptam->way[step]);
    for (uint32_t i = 0; i < rptam->layer_count; i++) {
        const struct hatch_rptam_layer_style *style = &rptam->layers[i].style;
        amounts[i] = fmin(fmax((way - style->low) / (style->high - style->low), 0), 1);
    }
}
