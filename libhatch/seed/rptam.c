#include "seed/rptam_parts.h"

#include <assert.h>
#include <math.h>
#include <string.h>

#define COVERAGE_SIDE 64u

/* Each seed's rank among those that fade with tone: a stride of about the golden section through them. */
static void rank_by_tone(struct hatch_rptam_layer *layer)
{
    uint64_t stride = (uint64_t)(0.6180339887498949 * layer->count) | 1u;
    for (uint64_t a = layer->count, b = stride; b;) {
        uint64_t rest = a % b;
        a = b;
        b = rest;
        if (!b && a != 1) { /* they share a divisor: the stride would not reach all */
            stride += 2;
            a = layer->count;
            b = stride;
        }
    }
    for (uint64_t i = 0; i < layer->count; i++)
        layer->tone_rank[i] = ((double)(i * stride % layer->count) + 0.5) / layer->count;
}

static double bilinear(const struct hatch_image *image, double x, double y)
{
    double column = floor(x - 0.5), row = floor(y - 0.5), right = x - 0.5 - column, low = y - 0.5 - row;
    if (!(column >= 0 && row >= 0 && column + 1 < image->width && row + 1 < image->height))
        return 0;
    const float *upper = image->pixels + (size_t)row * image->width + (size_t)column;
    const float *lower = upper + image->width;
    return (1 - low) * ((1 - right) * (double)upper[0] + right * (double)upper[1]) +
           low * ((1 - right) * (double)lower[0] + right * (double)lower[1]);
}

/* Alpha at a place in pixels from the stroke's middle, along and across. */
static double stroke_alpha(const struct hatch_rptam *rptam, double along_px, double across_px)
{
    const struct hatch_image *image = &rptam->stroke;
    double x = 1 + (along_px / rptam->style.length_px + 0.5) * (image->width - 2);
    double y = 1 + (across_px / rptam->style.width_px + 0.5) * (image->height - 2);
    return bilinear(image, x, y);
}

double hatch_rptam_depth_weight(const struct hatch_rptam *rptam, const struct hatch_rptam_layer *layer,
                                uint32_t seed, uint8_t tile, double m)
{
    const struct hatch_rptam_style *style = &rptam->style;
    if (layer->stays_in[seed] == tile)
        return 1;
    return hatch_fade_weight(hatch_fade_share(style->law, m),
                             (seed + (tile + layer->rank_offset) / 4) / layer->count, style->overlap);
}

double hatch_rptam_tone_weight(const struct hatch_rptam *rptam, const struct hatch_rptam_layer *layer,
                               uint32_t seed, double amount)
{
    return hatch_fade_weight(amount, layer->tone_rank[seed], rptam->style.tone_overlap);
}

double hatch_rptam_stroke_ink(const struct hatch_rptam *rptam, const struct hatch_rptam_layer *layer,
                              const double d[2], double tile_px, double weight)
{
    const struct hatch_rptam_style *style = &rptam->style;
    if (!(weight > 0))
        return 0;
    double px = style->fade_size && weight < 1 ? tile_px / sqrt(weight) : tile_px;
    double along = (layer->cosine * d[0] + layer->sine * d[1]) * px;
    double across = (layer->cosine * d[1] - layer->sine * d[0]) * px;
    return style->ink * stroke_alpha(rptam, along, across) * (style->fade_size ? 1 : weight);
}

double hatch_rptam_layer_ink(const struct hatch_rptam *rptam, uint32_t layer_index, const double uv[2],
                             double depth, double amount, bool all)
{
    const struct hatch_rptam_layer *layer = &rptam->layers[layer_index];
    const struct hatch_coverage *coverage = &layer->coverage;
    double whole = floor(depth), m = depth - whole, paper = 1, tile_px = rptam->style.tile_px / exp2(m);
    double at[2] = {ldexp(uv[0], -(int)whole), ldexp(uv[1], -(int)whole)};
    double u = at[0] - floor(at[0]), v = at[1] - floor(at[1]);
    uint32_t side = coverage->side, column = (uint32_t)(u * side), row = (uint32_t)(v * side);
    size_t texel = (size_t)(row < side ? row : side - 1) * side + (column < side ? column : side - 1);
    uint32_t begin = all ? 0 : coverage->first[texel];
    uint32_t end = all ? layer->count : coverage->first[texel + 1];
    for (uint32_t i = begin; i < end; i++) {
        uint32_t seed = all ? i : coverage->ids[i];
        double du = at[0] - (double)layer->places[seed].u * 0x1p-64;
        double dv = at[1] - (double)layer->places[seed].v * 0x1p-64;
        double tile_u = floor(du + 0.5), tile_v = floor(dv + 0.5);
        const double d[2] = {du - tile_u, dv - tile_v};
        uint8_t tile = (uint8_t)(2 * (fmod(tile_v, 2) != 0) + (fmod(tile_u, 2) != 0));
        double weight = hatch_rptam_depth_weight(rptam, layer, seed, tile, m) *
                        hatch_rptam_tone_weight(rptam, layer, seed, amount);
        paper *= 1 - hatch_rptam_stroke_ink(rptam, layer, d, tile_px, weight);
    }
    return 1 - paper;
}

double hatch_rptam_ink(const struct hatch_rptam *rptam, const double uv[2], double depth,
                       const double *amounts, bool all)
{
    double paper = 1;
    for (uint32_t i = 0; i < rptam->layer_count; i++)
        if (amounts[i] > 0)
            paper *= 1 - hatch_rptam_layer_ink(rptam, i, uv, depth, amounts[i], all);
    return 1 - paper;
}

void hatch_rptam_amounts(const struct hatch_rptam *rptam, double darkness, double *amounts)
{
    for (uint32_t i = 0; i < rptam->layer_count; i++) {
        const double *table = rptam->layers[i].darkness;
        uint32_t step = 0;
        while (step + 2 < HATCH_RPTAM_STEPS && darkness > table[step + 1])
            step++;
        double rise = table[step + 1] - table[step];
        double part = rise > 0 ? (darkness - table[step]) / rise : darkness >= table[step + 1];
        amounts[i] = fmin(fmax((step + part) / (HATCH_RPTAM_STEPS - 1), 0), 1);
    }
}

/* The mean of the source over each target texel, and a border of nothing. */
static enum hatch_status size_stroke(const struct hatch_image *from,
                                     const struct hatch_rptam_style *style, struct hatch_arena *arena,
                                     struct hatch_image *to, struct hatch_err *err)
{
    uint32_t width = (uint32_t)ceil(2 * style->length_px), height = (uint32_t)ceil(2 * style->width_px);
    HATCH_TRY(hatch_image_make(arena, width + 2, height + 2, "A", to, err));
    for (uint32_t y = 0; y < height; y++)
        for (uint32_t x = 0; x < width; x++) {
            double left = (double)x * from->width / width, right = (double)(x + 1) * from->width / width;
            double top = (double)y * from->height / height;
            double bottom = (double)(y + 1) * from->height / height, sum = 0;
            for (uint32_t row = (uint32_t)top; row < bottom && row < from->height; row++)
                for (uint32_t column = (uint32_t)left; column < right && column < from->width; column++)
                    sum += (double)from->pixels[(size_t)row * from->width + column] *
                           (fmin(right, column + 1.0) - fmax(left, column)) *
                           (fmin(bottom, row + 1.0) - fmax(top, row));
            to->pixels[(size_t)(y + 1) * to->width + x + 1] =
                (float)(sum / ((right - left) * (bottom - top)));
        }
    return HATCH_OK;
}

static enum hatch_status make_layer(const struct hatch_seed_set *set, uint32_t index,
                                    const struct hatch_rptam_style *style,
                                    struct hatch_arena *arena, struct hatch_arena *scratch,
                                    struct hatch_rptam_layer *layer, struct hatch_err *err)
{
    double angle_rad = style->angle_rad[index];
    *layer = (struct hatch_rptam_layer){
        .count = set->count,
        .cosine = cos(angle_rad),
        .sine = sin(angle_rad),
        .rank_offset = (index + 0.5) / HATCH_RPTAM_LAYERS_MAX};
    layer->places = HATCH_NEW(arena, struct hatch_seed_place, set->count, err);
    layer->stays_in = layer->places ? HATCH_NEW(arena, uint8_t, set->count, err) : NULL;
    layer->tone_rank = layer->stays_in ? HATCH_NEW(arena, double, set->count, err) : NULL;
    if (!layer->tone_rank)
        return HATCH_LIMIT;
    hatch_seed_places(set, layer->places);
    rank_by_tone(layer);
    for (uint32_t i = 0; i < set->count; i++)
        layer->stays_in[i] = set->crumbs[(i + set->count - 1) % set->count];
    const struct hatch_coverage_stroke largest = {2 * (style->length_px + 1) / style->tile_px,
                                                  2 * (style->width_px + 1) / style->tile_px,
                                                  layer->cosine, layer->sine};
    return hatch_coverage_make(layer->places, set->count, &largest, COVERAGE_SIDE, arena, scratch,
                               &layer->coverage, err);
}

enum hatch_status hatch_rptam_make(const struct hatch_seeds *seeds,
                                   const struct hatch_rptam_style *style,
                                   const struct hatch_image *stroke, struct hatch_arena *arena,
                                   struct hatch_arena *scratch, struct hatch_rptam *rptam,
                                   struct hatch_err *err)
{
    struct hatch_rptam made = {.style = *style, .layer_count = seeds->layer_count};
    assert(stroke->channel_count == 1);
    if (seeds->layer_count > HATCH_RPTAM_LAYERS_MAX)
        return hatch_fail(err, HATCH_LIMIT, "%u layers of seeds: %u are the most", seeds->layer_count,
                          HATCH_RPTAM_LAYERS_MAX);
    HATCH_TRY(size_stroke(stroke, style, arena, &made.stroke, err));
    for (uint32_t i = 0; i < seeds->layer_count; i++) {
        if (seeds->layers[i].count > HATCH_RPTAM_SEEDS_MAX)
            return hatch_fail(err, HATCH_LIMIT, "layer %u: %u seeds: %u are the most", i + 1,
                              seeds->layers[i].count, HATCH_RPTAM_SEEDS_MAX);
        HATCH_TRY(make_layer(&seeds->layers[i], i, style, arena, scratch, &made.layers[i], err));
    }
    HATCH_TRY(hatch_rptam_measure(&made, scratch, err));
    *rptam = made;
    return HATCH_OK;
}
