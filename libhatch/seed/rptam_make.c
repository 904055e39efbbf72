/* Makes the model: lists, and the table of tones. */
#include <assert.h>
#include <math.h>
#include <stdlib.h>

#include "seed/rptam.h"

#define SIDE_MIN 16u
#define SIDE_MAX 256u     /* texels along a tile, of the lists */
#define GROWTH 1.0001     /* of listed strokes, against rounding on the GPU */
#define TONE_POINTS 4181u /* for the table of tones, and what spreads them: Fibonacci numbers */
#define TONE_STRIDE 2584u
#define TONE_TILES 4.0 /* along the square that they are spread over, for amounts down to 1/16 */
#define TONE_PARTS 5u  /* of each layer's stretch */

static bool is_same_stroke(const struct hatch_rptam_layer_style *a, const struct hatch_rptam_layer_style *b)
{
    return a->stroke == b->stroke && a->grain == b->grain && a->varied == b->varied && !(a->length_px < b->length_px) &&
           !(a->length_px > b->length_px) && !(a->width_px < b->width_px) && !(a->width_px > b->width_px);
}

/* Texels about as wide as the thinnest strokes that the lists are for. */
static uint32_t side_for(double width)
{
    uint32_t side = SIDE_MIN;
    while (side < SIDE_MAX && side * width < 1)
        side *= 2;
    return side;
}

static enum hatch_status list_strokes(struct hatch_arena *arena, struct hatch_rptam_layer *layer, struct hatch_err *err)
{
    const struct hatch_rptam_layer_style *style = &layer->style;
    for (uint32_t i = 0; i < HATCH_RPTAM_SIZES; i++) {
        double scale = exp2(1 - i / 2.0) * GROWTH / style->tile_px;
        const struct hatch_coverage_stroke stroke = {(style->length_px + 1) * scale, (style->width_px + 1) * scale,
                                                     layer->cosine, layer->sine};
        uint32_t side = side_for((style->width_px + 1) / style->tile_px);
        HATCH_TRY(hatch_coverage_make(layer->places, layer->count, &stroke, side, arena, &layer->coverage[i], err));
    }
    return HATCH_OK;
}

static enum hatch_status make_layer(const struct hatch_seed_set *set, uint32_t index,
                                    const struct hatch_rptam_style *style, struct hatch_arena *arena,
                                    struct hatch_arena *scratch, struct hatch_rptam *rptam, struct hatch_err *err)
{
    const struct hatch_rptam_layer_style *own = &style->layers[index];
    struct hatch_rptam_layer made = {
        .style = *own, .count = set->count, .cosine = cos(own->angle_rad), .sine = sin(own->angle_rad)};
    if (set->count > HATCH_RPTAM_SEEDS_MAX)
        return hatch_fail(err, HATCH_LIMIT, "layer %u: %u seeds: %u are the most", index + 1, set->count,
                          HATCH_RPTAM_SEEDS_MAX);
    if (!(fmax(own->length_px, own->width_px) <= HATCH_RPTAM_REACH * own->tile_px))
        return hatch_fail(err, HATCH_LIMIT,
                          "layer %u: strokes of %g by %g pixels in a tile of %g: %g tiles are the most", index + 1,
                          own->length_px, own->width_px, own->tile_px, HATCH_RPTAM_REACH);
    made.places = HATCH_NEW(arena, struct hatch_seed_place, set->count, err);
    made.at = made.places ? hatch_arena_array(arena, set->count, sizeof *made.at, err) : NULL;
    made.life = made.at ? HATCH_NEW(arena, uint8_t, 4 * (size_t)set->count, err) : NULL;
    if (!made.life)
        return HATCH_LIMIT;
    hatch_seed_places(set, made.places);
    for (uint32_t i = 0; i < set->count; i++) {
        made.at[i][0] = (double)made.places[i].u * 0x1p-64;
        made.at[i][1] = (double)made.places[i].v * 0x1p-64;
    }
    HATCH_TRY(hatch_life_make(set, made.places, style->law, scratch, made.life, err));
    for (uint32_t i = 0; i < rptam->layer_count && !made.stroke.pixels; i++)
        if (is_same_stroke(&rptam->layers[i].style, own)) {
            made.stroke = rptam->layers[i].stroke;
            made.images = rptam->layers[i].images;
        }
    if (!made.stroke.pixels)
        HATCH_TRY(hatch_rptam_stroke(own, arena, scratch, &made.stroke, &made.images, err));
    HATCH_TRY(list_strokes(arena, &made, err));
    uint32_t at = rptam->layer_count++; /* behind those whose stretches begin no later */
    for (; at > 0 && rptam->layers[at - 1].style.low > own->low; at--)
        rptam->layers[at] = rptam->layers[at - 1];
    rptam->layers[at] = made;
    return HATCH_OK;
}

/* The mean ink at each of rising places on the way. */
struct curve {
    uint32_t count;
    double *way, *darkness;
};

static int compare(const void *a, const void *b)
{
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

/* paper[i] *= what a layer leaves at point i. */
static void draw_layer(const struct hatch_rptam *rptam, uint32_t layer, double amount, double *paper)
{
    struct hatch_rptam_pattern pattern;
    hatch_rptam_pattern(rptam, layer, 0, amount, false, &pattern);
    double tiles = TONE_TILES * exp2(fmax(pattern.level - 1, 0));
    for (uint32_t i = 0; i < TONE_POINTS; i++) {
        /* Down the rows slowly, so that the lists of a row are near by for many points. */
        const double uv[2] = {tiles * (i * TONE_STRIDE % TONE_POINTS) / TONE_POINTS, tiles * (i + 0.5) / TONE_POINTS};
        paper[i] *= hatch_rptam_left(&pattern, uv);
    }
}

/* Darkness at one place of the way. full: what the layers leave whose stretches have ended, as `ended` says; both
 * go on from call to call. */
static double darkness_at(const struct hatch_rptam *rptam, double way, bool *ended, double *full, double *paper)
{
    double sum = 0;
    for (uint32_t i = 0; i < rptam->layer_count; i++)
        if (!ended[i] && way >= rptam->layers[i].style.high) {
            draw_layer(rptam, i, 1, full);
            ended[i] = true;
        }
    for (uint32_t i = 0; i < TONE_POINTS; i++)
        paper[i] = full[i];
    for (uint32_t i = 0; i < rptam->layer_count; i++) {
        const struct hatch_rptam_layer_style *style = &rptam->layers[i].style;
        if (!ended[i] && way > style->low)
            draw_layer(rptam, i, (way - style->low) / (style->high - style->low), paper);
    }
    for (uint32_t i = 0; i < TONE_POINTS; i++)
        sum += 1 - paper[i];
    return sum / TONE_POINTS;
}

/* How much of a layer to measure: rising amounts from 0 on, to which 1 comes. Even ones; but where strokes lie many
 * times over one another, so that a part of them is all black, twice as many, and the first where they are a
 * third of what covers a place. Returns their number. */
static uint32_t amounts_to_measure(const struct hatch_rptam_layer *layer, double amounts[2 * TONE_PARTS])
{
    const struct hatch_rptam_layer_style *style = &layer->style;
    double covers = layer->count * style->length_px * style->width_px / (style->tile_px * style->tile_px);
    bool dense = covers > 2;
    uint32_t parts = dense ? 2 * TONE_PARTS : TONE_PARTS;
    for (uint32_t k = 0; k < parts; k++)
        amounts[k] = pow((double)k / parts, dense ? fmax(1, log(3 * covers) / log(parts)) : 1);
    return parts;
}

static enum hatch_status measure(const struct hatch_rptam *rptam, struct hatch_arena *scratch, struct curve *curve,
                                 struct hatch_err *err)
{
    uint32_t most = rptam->layer_count * (2 * TONE_PARTS + 1) + 1;
    bool ended[HATCH_RPTAM_LAYERS_MAX] = {false};
    curve->way = HATCH_NEW(scratch, double, most, err);
    curve->darkness = curve->way ? HATCH_NEW(scratch, double, most, err) : NULL;
    double *full = curve->darkness ? HATCH_NEW(scratch, double, TONE_POINTS, err) : NULL;
    double *paper = full ? HATCH_NEW(scratch, double, TONE_POINTS, err) : NULL;
    if (!paper)
        return HATCH_LIMIT;
    curve->count = 1; /* at 0 */
    for (uint32_t i = 0; i < rptam->layer_count; i++) {
        const struct hatch_rptam_layer_style *style = &rptam->layers[i].style;
        double amounts[2 * TONE_PARTS];
        uint32_t parts = amounts_to_measure(&rptam->layers[i], amounts);
        for (uint32_t k = 0; k < parts; k++)
            curve->way[curve->count++] = style->low + amounts[k] * (style->high - style->low);
        curve->way[curve->count++] = style->high;
    }
    qsort(curve->way, curve->count, sizeof *curve->way, compare);
    for (uint32_t i = 0; i < TONE_POINTS; i++)
        full[i] = 1;
    for (uint32_t i = 0; i < curve->count; i++) {
        bool again = i && !(curve->way[i] > curve->way[i - 1]);
        double darkness = again ? 0 : darkness_at(rptam, curve->way[i], ended, full, paper);
        curve->darkness[i] = i ? fmax(darkness, curve->darkness[i - 1]) : darkness;
    }
    return HATCH_OK;
}

/* How often strokes cover a place that are so dark together, if they lie by chance: in proportion to their number. */
static double covers_of(double darkness)
{
    return -log(fmax(1 - darkness, 1e-9));
}

/* Turns the curve round: the way to tones at equal steps. */
static enum hatch_status make_table(struct hatch_arena *scratch, struct hatch_rptam *rptam, struct hatch_err *err)
{
    struct hatch_arena_mark mark = hatch_arena_mark(scratch);
    struct curve curve;
    enum hatch_status status = measure(rptam, scratch, &curve, err);
    if (status != HATCH_OK) {
        hatch_arena_rewind(scratch, mark);
        return status;
    }
    rptam->darkest = curve.darkness[curve.count - 1];
    for (uint32_t step = 0, k = 0; step <= HATCH_RPTAM_STEPS; step++) {
        double wanted = rptam->darkest * step / HATCH_RPTAM_STEPS;
        while (k + 2 < curve.count && curve.darkness[k + 1] < wanted)
            k++;
        if (k + 1 == curve.count)
            break; /* no layer */
        double from = covers_of(curve.darkness[k]), rise = covers_of(curve.darkness[k + 1]) - from;
        double part = rise > 0 ? (covers_of(wanted) - from) / rise : 0;
        rptam->way[step] = curve.way[k] + part * (curve.way[k + 1] - curve.way[k]);
    }
    hatch_arena_rewind(scratch, mark);
    return HATCH_OK;
}

enum hatch_status hatch_rptam_make(const struct hatch_seeds *seeds, const struct hatch_rptam_style *style,
                                   struct hatch_arena *arena, struct hatch_arena *scratch, struct hatch_rptam *rptam,
                                   struct hatch_err *err)
{
    struct hatch_rptam made = {.style = *style};
    assert(style->layer_count <= HATCH_RPTAM_LAYERS_MAX);
    if (seeds->layer_count < style->layer_count)
        return hatch_fail(err, HATCH_BAD_INPUT, "%u seed set%s for %u layers: each needs its own", seeds->layer_count,
                          seeds->layer_count == 1 ? "" : "s", style->layer_count);
    for (uint32_t i = 0; i < style->layer_count; i++)
        HATCH_TRY(make_layer(&seeds->layers[i], i, style, arena, scratch, &made, err));
    HATCH_TRY(make_table(scratch, &made, err));
    *rptam = made;
    return HATCH_OK;
}
