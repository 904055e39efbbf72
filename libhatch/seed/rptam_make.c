/* Makes the model: coverage lists and the table of tones. */
#include <assert.h>
#include <math.h>
#include <stdlib.h>

#include "seed/rptam.h"

#define SIDE_MIN 16u
#define SIDE_MAX 256u     /* SIDE_MIN .. SIDE_MAX: texels of the coverage lists along the tile */
#define MARGIN 1.0001     /* factor by which listed strokes are enlarged, against rounding on the GPU */
#define TONE_POINTS 4181u /* sample points for the table of tones: a Fibonacci lattice */
#define TONE_STRIDE 2584u /* of the lattice: the preceding Fibonacci number */
/* Side of the lattice in texture coordinates, for amounts over 1/16; it doubles with each further nesting level. */
#define TONE_TILES 4.0
#define TONE_PARTS 5u     /* number of amounts at which a layer is measured */
#define DENSE_PARTS 24u   /* the same for a dense layer: the first half at even steps of DENSE_COVERS, */
#define DENSE_COVERS 0.25 /* mean strokes over a point; the others each by the same factor larger */

static bool is_same_stroke(const struct hatch_rptam_layer_style *a, const struct hatch_rptam_layer_style *b)
{
    return a->stroke == b->stroke && a->grain == b->grain && a->varied == b->varied && !(a->length_px < b->length_px) &&
           !(a->length_px > b->length_px) && !(a->width_px < b->width_px) && !(a->width_px > b->width_px);
}

/* Returns the number of texels along the tile, SIDE_MIN .. SIDE_MAX: the lowest power of two for which a texel is no
 * wider than a stroke.
 *   width  of a stroke, in tiles */
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
    for (uint32_t i = 0; i < HATCH_RPTAM_COVERAGE_SIZES; i++) {
        double scale = exp2(1 - i / 2.0) * MARGIN / style->tile_px;
        const struct hatch_coverage_stroke stroke = {(style->length_px + 1) * scale, (style->width_px + 1) * scale,
                                                     layer->cosine, layer->sine};
        uint32_t side = side_for((style->width_px + 1) / style->tile_px);
        HATCH_TRY(hatch_coverage_make(layer->points, layer->count, &stroke, side, arena, &layer->coverage[i], err));
    }
    return HATCH_OK;
}

static enum hatch_status make_layer(const struct hatch_seed_set *set, uint32_t index,
                                    const struct hatch_rptam_style *style, struct hatch_arena *arena,
                                    struct hatch_arena *scratch, struct hatch_rptam *rptam, struct hatch_err *err)
{
    const struct hatch_rptam_layer_style *layer_style = &style->layers[index];
    struct hatch_rptam_layer made = {.style = *layer_style,
                                     .count = set->count,
                                     .cosine = cos(layer_style->angle_rad),
                                     .sine = sin(layer_style->angle_rad)};
    if (set->count > HATCH_RPTAM_SEEDS_MAX)
        return hatch_fail(err, HATCH_LIMIT, "layer %u: %u seed points, want %u at most", index + 1, set->count,
                          HATCH_RPTAM_SEEDS_MAX);
    if (!(fmax(layer_style->length_px, layer_style->width_px) <= HATCH_RPTAM_STROKE_TILES_MAX * layer_style->tile_px))
        return hatch_fail(err, HATCH_LIMIT,
                          "layer %u: strokes of %g by %g pixels are too large: the limit is %g tiles of %g pixels",
                          index + 1, layer_style->length_px, layer_style->width_px, HATCH_RPTAM_STROKE_TILES_MAX,
                          layer_style->tile_px);
    HATCH_TRY(HATCH_ALLOC(arena, &made.points, set->count, err));
    HATCH_TRY(HATCH_ALLOC(arena, &made.positions, set->count, err));
    HATCH_TRY(HATCH_ALLOC(arena, &made.life, 4 * (size_t)set->count, err));
    hatch_seed_points(set, made.points);
    for (uint32_t i = 0; i < set->count; i++) {
        made.positions[i][0] = (double)made.points[i].u * 0x1p-64;
        made.positions[i][1] = (double)made.points[i].v * 0x1p-64;
    }
    HATCH_TRY(hatch_life_make(set, made.points, style->law, scratch, made.life, err));
    for (uint32_t i = 0; i < rptam->layer_count && !made.stroke.pixels; i++)
        if (is_same_stroke(&rptam->layers[i].style, layer_style)) {
            made.stroke = rptam->layers[i].stroke;
            made.images = rptam->layers[i].images;
        }
    if (!made.stroke.pixels)
        HATCH_TRY(hatch_rptam_stroke_images(layer_style, arena, scratch, &made.stroke, &made.images, err));
    HATCH_TRY(list_strokes(arena, &made, err));
    uint32_t at = rptam->layer_count++; /* sorted by low, stable */
    for (; at > 0 && rptam->layers[at - 1].style.low > layer_style->low; at--)
        rptam->layers[at] = rptam->layers[at - 1];
    rptam->layers[at] = made;
    return HATCH_OK;
}

/* Samples of the mean darkness as a function of progress, both ascending. */
struct curve {
    uint32_t count;
    double *progress, *darkness;
};

static int compare(const void *a, const void *b)
{
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

/* Multiplies the transmittance at each sample point by that of a layer. */
static void draw_layer(const struct hatch_rptam *rptam, uint32_t layer, double amount, double *transmittance)
{
    struct hatch_rptam_pattern pattern;
    hatch_rptam_pattern_make(rptam, layer, 0, amount, false, &pattern);
    double tiles = TONE_TILES * exp2(fmax(pattern.level - 1, 0));
    for (uint32_t i = 0; i < TONE_POINTS; i++) {
        /* v rises slowly, so that many consecutive points use the coverage lists of one row. */
        const double uv[2] = {tiles * (i * TONE_STRIDE % TONE_POINTS) / TONE_POINTS, tiles * (i + 0.5) / TONE_POINTS};
        transmittance[i] *= hatch_rptam_transmittance(&pattern, uv);
    }
}

/* Returns the mean darkness at a progress, which must not fall from call to call.
 *   complete       in and out: per layer, whether its range has ended
 *   base           in and out: transmittance of the complete layers at each sample point
 *   transmittance  scratch: one entry per sample point */
static double darkness_at(const struct hatch_rptam *rptam, double progress, bool *complete, double *base,
                          double *transmittance)
{
    double sum = 0;
    for (uint32_t i = 0; i < rptam->layer_count; i++)
        if (!complete[i] && progress >= rptam->layers[i].style.high) {
            draw_layer(rptam, i, 1, base);
            complete[i] = true;
        }
    for (uint32_t i = 0; i < TONE_POINTS; i++)
        transmittance[i] = base[i];
    for (uint32_t i = 0; i < rptam->layer_count; i++) {
        const struct hatch_rptam_layer_style *style = &rptam->layers[i].style;
        if (!complete[i] && progress > style->low)
            draw_layer(rptam, i, (progress - style->low) / (style->high - style->low), transmittance);
    }
    for (uint32_t i = 0; i < TONE_POINTS; i++)
        sum += 1 - transmittance[i];
    return sum / TONE_POINTS;
}

/* Chooses the amounts in [0, 1) at which a layer is measured, and returns their number. They are evenly spaced, unless
 * the strokes overlap so much that a part of them already makes the tile nearly black. */
static uint32_t amounts_to_measure(const struct hatch_rptam_layer *layer, double amounts[DENSE_PARTS])
{
    const struct hatch_rptam_layer_style *style = &layer->style;
    double covers = layer->count * style->length_px * style->width_px / (style->tile_px * style->tile_px);
    bool dense = covers > DENSE_PARTS / 2 * DENSE_COVERS;
    uint32_t parts = dense ? DENSE_PARTS : TONE_PARTS, even = dense ? DENSE_PARTS / 2 : TONE_PARTS;
    double step = dense ? DENSE_COVERS / covers : 1.0 / TONE_PARTS;
    for (uint32_t k = 0; k < parts; k++)
        amounts[k] = k <= even ? k * step : pow(even * step, (double)(parts - k) / (parts - even));
    return parts;
}

static enum hatch_status measure(const struct hatch_rptam *rptam, struct hatch_arena *scratch, struct curve *curve,
                                 struct hatch_err *err)
{
    uint32_t capacity = rptam->layer_count * (DENSE_PARTS + 1) + 1;
    bool complete[HATCH_RPTAM_LAYERS_MAX] = {false};
    double *base, *transmittance;
    HATCH_TRY(HATCH_ALLOC(scratch, &curve->progress, capacity, err));
    HATCH_TRY(HATCH_ALLOC(scratch, &curve->darkness, capacity, err));
    HATCH_TRY(HATCH_ALLOC(scratch, &base, TONE_POINTS, err));
    HATCH_TRY(HATCH_ALLOC(scratch, &transmittance, TONE_POINTS, err));
    curve->count = 1; /* progress 0 */
    for (uint32_t i = 0; i < rptam->layer_count; i++) {
        const struct hatch_rptam_layer_style *style = &rptam->layers[i].style;
        double amounts[DENSE_PARTS];
        uint32_t parts = amounts_to_measure(&rptam->layers[i], amounts);
        for (uint32_t k = 0; k < parts; k++)
            curve->progress[curve->count++] = style->low + amounts[k] * (style->high - style->low);
        curve->progress[curve->count++] = style->high;
    }
    qsort(curve->progress, curve->count, sizeof *curve->progress, compare);
    for (uint32_t i = 0; i < TONE_POINTS; i++)
        base[i] = 1;
    for (uint32_t i = 0; i < curve->count; i++) {
        bool repeated = i && !(curve->progress[i] > curve->progress[i - 1]);
        double darkness = repeated ? 0 : darkness_at(rptam, curve->progress[i], complete, base, transmittance);
        curve->darkness[i] = i ? fmax(darkness, curve->darkness[i - 1]) : darkness;
    }
    return HATCH_OK;
}

/* Returns the mean number of randomly placed opaque strokes over a point that gives a mean darkness. */
static double mean_covers(double darkness)
{
    return -log(fmax(1 - darkness, 1e-9));
}

/* Inverts the curve: finds the progress at equal steps of darkness. */
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
    for (uint32_t step = 0, k = 0; step <= HATCH_RPTAM_TONE_STEPS; step++) {
        double target = rptam->darkest * step / HATCH_RPTAM_TONE_STEPS;
        while (k + 2 < curve.count && curve.darkness[k + 1] < target)
            k++;
        if (k + 1 == curve.count)
            break; /* there is no layer */
        double from = mean_covers(curve.darkness[k]), rise = mean_covers(curve.darkness[k + 1]) - from;
        double part = rise > 0 ? (mean_covers(target) - from) / rise : 0;
        rptam->progress[step] = curve.progress[k] + part * (curve.progress[k + 1] - curve.progress[k]);
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
        return hatch_fail(err, HATCH_BAD_INPUT, "%u seed set%s for %u layers: each layer needs one", seeds->layer_count,
                          seeds->layer_count == 1 ? "" : "s", style->layer_count);
    for (uint32_t i = 0; i < style->layer_count; i++)
        HATCH_TRY(make_layer(&seeds->layers[i], i, style, arena, scratch, &made, err));
    HATCH_TRY(make_table(scratch, &made, err));
    *rptam = made;
    return HATCH_OK;
}
