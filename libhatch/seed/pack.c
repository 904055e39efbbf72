#include "seed/pack.h"

#include <math.h>
#include <string.h>

/* Returns the life of the stroke of a seed point in a tile. */
static uint32_t life_in(const struct hatch_rptam_layer *layer, uint32_t seed, int32_t tile_u, int32_t tile_v)
{
    return layer->life[4 * seed + 2 * ((uint32_t)tile_v & 1u) + ((uint32_t)tile_u & 1u)];
}

/* The lives of a stroke for which only the offset of its tile from the drawn tile is known. `here` has a byte for each
 * position of the drawn tile modulo 2; for a stroke that stays, `next_level` has a byte for each position, modulo 2, of
 * the next level's tile that contains the drawn one. */
struct hatch_rptam_lives {
    uint32_t here, next_level;
};

static struct hatch_rptam_lives lives_of(const struct hatch_rptam_layer *layer, bool weighted, uint32_t seed,
                                         int32_t tile_u, int32_t tile_v)
{
    struct hatch_rptam_lives lives = {0, 0};
    uint32_t above = (seed + layer->count - 1) % layer->count;
    for (int32_t tile = 0; tile < 4; tile++) {
        uint32_t life = life_in(layer, seed, (tile & 1) + tile_u, (tile >> 1) + tile_v);
        lives.here |= life << 8 * tile;
        if (life != HATCH_LIFE_STAYS)
            continue;
        for (int32_t next = 0; next < 4; next++) {
            int32_t u = (tile & 1) + 2 * (next & 1) + tile_u;
            int32_t v = (tile >> 1) + 2 * (next >> 1) + tile_v;
            uint32_t later = weighted ? life_in(layer, above, (u & 3) >> 1, (v & 3) >> 1) : HATCH_LIFE_STAYS;
            lives.next_level |= later << 8 * next;
        }
    }
    return lives;
}

/* Computes lives[16 * seed + 4 * v + u] for strokes whose tile is u columns and v rows, modulo 4, from the drawn
 * one. */
static void make_lives(const struct hatch_rptam_layer *layer, bool weighted, struct hatch_rptam_lives *lives)
{
    for (uint32_t i = 0; i < 16 * layer->count; i++)
        lives[i] = lives_of(layer, weighted, i / 16, (int32_t)(i & 3), (int32_t)(i >> 2 & 3));
}

/* Writes one entry of seeds: the position as bits of floats, and the lives. */
static void put_seed(const struct hatch_rptam_layer *layer, const struct hatch_rptam_lives *lives,
                     const struct hatch_coverage_copy *copy, uint32_t to[4])
{
    const float at[2] = {(float)(layer->positions[copy->seed][0] + copy->tile_u),
                         (float)(layer->positions[copy->seed][1] + copy->tile_v)};
    const struct hatch_rptam_lives *own =
        &lives[16 * copy->seed + 4 * ((uint32_t)copy->tile_v & 3) + ((uint32_t)copy->tile_u & 3)];
    memcpy(to, at, sizeof at);
    to[2] = own->here;
    to[3] = own->next_level;
}

/* Returns an entry of seed_numbers. Seed point i of a level is seed point i - 1 of the next. */
static uint32_t numbers_of(const struct hatch_rptam_layer *layer, uint32_t seed)
{
    uint32_t numbers = seed;
    for (uint32_t k = 0; k < HATCH_RPTAM_CRUMBS; k++, seed = (seed + layer->count - 1) % layer->count) {
        uint32_t crumb = 0;
        while (crumb < 3 && layer->life[4 * seed + crumb] != HATCH_LIFE_STAYS)
            crumb++;
        numbers |= crumb << (16 + 2 * k);
    }
    return numbers;
}

static void pack_lists(const struct hatch_rptam_layer *layer, const struct hatch_coverage *coverage,
                       struct hatch_rptam_packed *packed)
{
    size_t texels = (size_t)coverage->side * coverage->side;
    for (size_t t = 0; t < texels; t++) {
        packed->lists[2 * packed->list_count] = (int32_t)packed->seed_count;
        for (uint32_t i = coverage->first[t]; i < coverage->first[t + 1]; i++) {
            packed->seed_numbers[packed->seed_count] = numbers_of(layer, coverage->copies[i].seed);
            put_seed(layer, packed->lives, &coverage->copies[i], packed->seeds + 4 * packed->seed_count++);
        }
        packed->lists[2 * packed->list_count++ + 1] = (int32_t)packed->seed_count;
    }
}

/* Returns the alpha of a texel in 1/255; 0 outside the image. */
static uint8_t byte_at(const struct hatch_image *image, uint32_t x, uint32_t y)
{
    bool inside = x < image->width && y < image->height;
    return inside ? (uint8_t)(image->pixels[(size_t)y * image->width + x] * 255 + 0.5f) : 0;
}

static void pack_stroke(const struct hatch_rptam_layer *layer, struct hatch_rptam_packed *packed)
{
    struct hatch_image image = layer->stroke;
    for (uint32_t i = 0; i < layer->images; i++, image.pixels += (size_t)image.width * image.height)
        for (uint32_t y = 0; y < image.height; y++)
            for (uint32_t x = 0; x < image.width; x++) {
                const uint8_t alpha[4] = {byte_at(&image, x, y), byte_at(&image, x + 1, y), byte_at(&image, x, y + 1),
                                          byte_at(&image, x + 1, y + 1)};
                memcpy(packed->strokes + 4 * packed->stroke_count++, alpha, sizeof alpha);
            }
}

/* Returns whether an earlier layer has the same stroke.
 *   other  out: the first such layer */
static bool shares_stroke(const struct hatch_rptam *rptam, uint32_t index, uint32_t *other)
{
    for (*other = 0; *other < index; ++*other)
        if (rptam->layers[*other].stroke.pixels == rptam->layers[index].stroke.pixels)
            return true;
    return false;
}

static void pack_layer(const struct hatch_rptam *rptam, uint32_t index, const struct hatch_coverage *all,
                       struct hatch_rptam_packed *packed)
{
    const struct hatch_rptam_layer *layer = &rptam->layers[index];
    const struct hatch_rptam_layer_style *style = &layer->style;
    const struct hatch_image *image = &layer->stroke;
    double range = style->high - style->low;
    bool weighted = rptam->style.law == HATCH_FADE_WEIGHTED;
    uint32_t other;
    bool shared = shares_stroke(rptam, index, &other);
    packed->block.layers[index] = (struct hatch_rptam_layer_block){
        .turn = {(float)layer->cosine, (float)layer->sine, (float)(style->tile_px * style->tile_px), (float)style->ink},
        .tone = {(float)(1 / range), (float)(-style->low / range), (float)style->low,
                 all ? 0 : HATCH_RPTAM_COVERAGE_SIZES - 1},
        .stroke = {(float)((image->width - 2) / style->length_px), (float)((image->height - 2) / style->width_px),
                   (float)image->width - 1, (float)image->height - 1},
        .at = {(int32_t)packed->list_count, (int32_t)(all ? all->side : layer->coverage[0].side),
               shared ? packed->block.layers[other].at[2] : (int32_t)packed->stroke_count,
               style->varied ? (int32_t)(layer->images << HATCH_RPTAM_IMAGES_SHIFT | layer->count) : 0},
        .thin = {(float)fmin(1, HATCH_RPTAM_THIN_PX / style->length_px),
                 (float)fmin(1, HATCH_RPTAM_THIN_PX / style->width_px), (float)layer->count}};
    if (!shared)
        pack_stroke(layer, packed);
    make_lives(layer, weighted, packed->lives);
    if (all)
        pack_lists(layer, all, packed);
    for (uint32_t i = 0; !all && i < HATCH_RPTAM_COVERAGE_SIZES; i++)
        pack_lists(layer, &layer->coverage[i], packed);
}

static void pack_style(const struct hatch_rptam *rptam, struct hatch_rptam_block *block)
{
    const struct hatch_rptam_style *style = &rptam->style;
    bool weighted = style->law == HATCH_FADE_WEIGHTED;
    double p = fmax(style->overlap, HATCH_FADE_OVERLAP_MIN), q = 1 - p, less = fmin(p, q), more = fmax(p, q);
    double slope = weighted ? 1 / p : q / p;
    *block = (struct hatch_rptam_block){
        .front = {(float)(2 * p * q), (float)(less / (2 * more)), (float)more, (float)(less / 2)},
        .fade = {(float)(weighted ? -1 / p : 1 / p), (float)((weighted ? 0 : -q / p) + slope * hatch_life_value(0)),
                 (float)(slope / HATCH_LIFE_STAYS), weighted ? (float)(1 / p) : 0},
        .law = {weighted, style->law == HATCH_FADE_PAPER, 0,
                rptam->darkest > 0 ? (float)(HATCH_RPTAM_TONE_STEPS / rptam->darkest) : 0},
        .counts = {(int32_t)rptam->layer_count}};
}

static enum hatch_status pack(const struct hatch_rptam *rptam, const struct hatch_coverage *all,
                              struct hatch_arena *scratch, struct hatch_rptam_packed *packed, struct hatch_err *err)
{
    size_t seeds = 0, lists = 0, strokes = 0;
    bool varied = false;
    for (uint32_t i = 0; i < rptam->layer_count; i++) {
        const struct hatch_coverage *coverage = all ? &all[i] : rptam->layers[i].coverage;
        const struct hatch_image *stroke = &rptam->layers[i].stroke;
        for (uint32_t k = 0; k < (all ? 1 : HATCH_RPTAM_COVERAGE_SIZES); k++) {
            size_t texels = (size_t)coverage[k].side * coverage[k].side;
            lists += texels;
            seeds += coverage[k].first[texels];
        }
        strokes += (size_t)stroke->width * stroke->height * rptam->layers[i].images;
        varied = varied || rptam->layers[i].style.varied;
    }
    *packed = (struct hatch_rptam_packed){0};
    pack_style(rptam, &packed->block);
    packed->lives = HATCH_NEW_UNSET(scratch, struct hatch_rptam_lives, 16 * HATCH_RPTAM_SEEDS_MAX, err);
    packed->seeds = packed->lives ? HATCH_NEW_UNSET(scratch, uint32_t, 4 * seeds, err) : NULL;
    packed->lists = packed->seeds ? HATCH_NEW_UNSET(scratch, int32_t, 2 * lists, err) : NULL;
    packed->strokes = packed->lists ? HATCH_NEW_UNSET(scratch, uint8_t, 4 * strokes, err) : NULL;
    packed->seed_numbers = packed->strokes ? HATCH_NEW_UNSET(scratch, uint32_t, seeds, err) : NULL;
    if (!packed->seed_numbers)
        return HATCH_LIMIT;
    packed->varied = varied;
    for (uint32_t i = 0; i < rptam->layer_count; i++)
        pack_layer(rptam, i, all ? &all[i] : NULL, packed);
    for (uint32_t i = 0; i < HATCH_RPTAM_TONE_STEPS; i++) {
        packed->progress[2 * i] = (float)rptam->progress[i];
        packed->progress[2 * i + 1] = (float)(rptam->progress[i + 1] - rptam->progress[i]);
    }
    return HATCH_OK;
}

/* Lists every stroke that may reach into the tile, for each layer. */
static enum hatch_status list_all(const struct hatch_rptam *rptam, struct hatch_arena *scratch,
                                  struct hatch_coverage **all, struct hatch_err *err)
{
    HATCH_TRY(HATCH_ALLOC(scratch, all, rptam->layer_count, err));
    for (uint32_t i = 0; i < rptam->layer_count; i++) {
        const struct hatch_rptam_layer *layer = &rptam->layers[i];
        const struct hatch_rptam_layer_style *style = &layer->style;
        const struct hatch_coverage_stroke largest = {2 * (style->length_px + 1) / style->tile_px,
                                                      2 * (style->width_px + 1) / style->tile_px, layer->cosine,
                                                      layer->sine};
        HATCH_TRY(hatch_coverage_make(layer->points, layer->count, &largest, 1, scratch, &(*all)[i], err));
    }
    return HATCH_OK;
}

enum hatch_status hatch_rptam_pack(const struct hatch_rptam *rptam, bool all, struct hatch_arena *arena,
                                   struct hatch_rptam_packed *packed, struct hatch_err *err)
{
    struct hatch_coverage *lists = NULL;
    if (all)
        HATCH_TRY(list_all(rptam, arena, &lists, err));
    return pack(rptam, lists, arena, packed, err);
}
