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

/* Returns the alpha of a stroke at a position, in pixels from its middle. */
static double stroke_alpha(const struct hatch_rptam_layer *layer, uint32_t variant, double along_px, double across_px)
{
    struct hatch_image image = layer->stroke;
    image.pixels += (size_t)(variant & (layer->images - 1)) * image.width * image.height;
    double x = 1 + (along_px / layer->style.length_px + 0.5) * (image.width - 2);
    double y = 1 + ((variant & 8u ? -across_px : across_px) / layer->style.width_px + 0.5) * (image.height - 2);
    return bilinear(&image, x, y);
}

static int odd(double tile)
{
    return tile - 2 * floor(tile / 2) != 0;
}

/* Returns the weight of the stroke of a seed point in one tile. */
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

/* Returns the transmittance of the stroke of a seed point in one tile.
 *   du, dv  position relative to the stroke's middle, in tiles */
static double stroke_transmittance(const struct hatch_rptam_pattern *pattern, uint32_t seed, double tile_u,
                                   double tile_v, double du, double dv)
{
    const struct hatch_rptam_layer *layer = pattern->layer;
    /* Outside the full-size stroke and its soft border the weight does not matter. */
    double across = (layer->cosine * dv - layer->sine * du) * pattern->tile_px;
    if (fabs(across) > layer->style.width_px / 2 + 1)
        return 1;
    double along = (layer->cosine * du + layer->sine * dv) * pattern->tile_px;
    if (fabs(along) > layer->style.length_px / 2 + 1)
        return 1;
    double weight = weight_of(pattern, seed, tile_u, tile_v);
    if (!(weight > 0))
        return 1;
    uint32_t variant = layer->style.varied ? hatch_rptam_variant(seed, pattern->level, layer->count) : 0;
    if (pattern->shrinks && weight < 1) {
        double length = fmax(sqrt(weight), fmin(1, HATCH_RPTAM_THIN_PX / layer->style.length_px));
        double width = fmax(sqrt(weight), fmin(1, HATCH_RPTAM_THIN_PX / layer->style.width_px));
        along /= length;
        across /= width;
        weight /= length * width;
    }
    return 1 - layer->style.ink * stroke_alpha(layer, variant, along, across) * weight;
}

/* Returns the transmittance, testing the strokes of every seed point in all tiles within reach. */
static double transmittance_of_all(const struct hatch_rptam_pattern *pattern, double u, double v)
{
    const struct hatch_rptam_layer *layer = pattern->layer;
    double transmittance = 1;
    double reach = hypot(layer->style.length_px + 1, layer->style.width_px + 1) / 2 / pattern->tile_px;
    for (uint32_t seed = 0; seed < layer->count; seed++) {
        double du = u - layer->positions[seed][0], dv = v - layer->positions[seed][1];
        for (double tile_v = ceil(dv - reach); tile_v <= dv + reach; tile_v++)
            for (double tile_u = ceil(du - reach); tile_u <= du + reach; tile_u++)
                transmittance *= stroke_transmittance(pattern, seed, tile_u, tile_v, du - tile_u, dv - tile_v);
    }
    return transmittance;
}

static uint32_t texel_at(double fraction, uint32_t side)
{
    uint32_t texel = (uint32_t)(fraction * side);
    return texel < side ? texel : side - 1; /* the fraction of a tiny negative number rounds to 1 */
}

static double transmittance_of_listed(const struct hatch_rptam_pattern *pattern, double u, double v)
{
    const struct hatch_coverage *lists = pattern->lists;
    const double(*positions)[2] = (const double(*)[2])pattern->layer->positions;
    double base_u = floor(u), base_v = floor(v), transmittance = 1;
    uint32_t column = texel_at(u - base_u, lists->side), row = texel_at(v - base_v, lists->side);
    const uint32_t *list = lists->first + (size_t)row * lists->side + column;
    for (uint32_t i = list[0]; i < list[1]; i++) {
        const struct hatch_coverage_copy *copy = &lists->copies[i];
        double tile_u = base_u + copy->tile_u, tile_v = base_v + copy->tile_v;
        transmittance *=
            stroke_transmittance(pattern, copy->seed, tile_u, tile_v, u - positions[copy->seed][0] - tile_u,
                                 v - positions[copy->seed][1] - tile_v);
    }
    return transmittance;
}

void hatch_rptam_pattern_make(const struct hatch_rptam *rptam, uint32_t layer_index, double depth, double amount,
                              bool all, struct hatch_rptam_pattern *pattern)
{
    const struct hatch_rptam_layer *layer = &rptam->layers[layer_index];
    const struct hatch_rptam_style *style = &rptam->style;
    *pattern = (struct hatch_rptam_pattern){.empty = !(amount >= HATCH_RPTAM_AMOUNT_MIN)};
    if (pattern->empty)
        return;
    double outer = depth - log2(amount) / 2, level = floor(outer);
    double list_size = floor(2 * (1 - depth + level));
    *pattern = (struct hatch_rptam_pattern){
        .layer = layer,
        .lists = all ? NULL : &layer->coverage[(uint32_t)fmin(fmax(list_size, 0), HATCH_RPTAM_COVERAGE_SIZES - 1)],
        .weighted = style->law == HATCH_FADE_WEIGHTED,
        .shrinks = style->fade_size,
        .fade = hatch_fade_at(style->law, outer - level, style->overlap),
        .level = (int)level,
        .scale = exp2(-level),
        .tile_px = layer->style.tile_px * exp2(level - depth)};
}

double hatch_rptam_transmittance(const struct hatch_rptam_pattern *pattern, const double uv[2])
{
    if (pattern->empty)
        return 1;
    double u = uv[0] * pattern->scale, v = uv[1] * pattern->scale;
    return pattern->lists ? transmittance_of_listed(pattern, u, v) : transmittance_of_all(pattern, u, v);
}
