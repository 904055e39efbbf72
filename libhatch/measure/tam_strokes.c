/* Measurements that need the strokes: nesting by stroke, a stroke's darkness, evenness. */
#include <assert.h>

#include "base/random.h"
#include "measure/tam_figures.h"
#include "placement/canvas.h"
#include "tam/whole.h"

/* Rounding error of reflectances, which are stored as halves: 11 bits. */
#define HALF_STEP 0x1p-11f

/* Makes a canvas of the map's size with white paper on its first levels.
 *   style  out: the strokes' style, with length_max and width_px raised to those of the list's strokes; the canvas
 *          refers to it, so it must outlive the canvas */
static enum hatch_status white_canvas(const struct hatch_tam *tam, const struct hatch_tam_strokes *strokes,
                                      uint32_t levels, struct hatch_style *style, struct hatch_arena *scratch,
                                      struct hatch_canvas *canvas, struct hatch_err *err)
{
    const struct hatch_canvas_options options = {style, strokes->brush, tam->size_px, levels, tam->color, false};
    *style = *strokes->style;
    for (uint32_t i = 0; i < strokes->list->count; i++) {
        const struct hatch_stroke *stroke = &strokes->list->items[i];
        style->length_max = fmaxf(style->length_max, stroke->length);
        style->width_px = fmaxf(style->width_px, stroke->width_px);
    }
    return hatch_canvas_make(&options, scratch, canvas, err);
}

/* Returns whether a pixel of the footprint is lighter in any channel than the stroke alone would make it and
 * rounding. */
static bool is_missing(const struct hatch_tam *tam, const struct hatch_canvas *canvas,
                       const struct hatch_stroke *stroke, const struct hatch_image *image)
{
    const struct hatch_footprint *f = &canvas->footprint;
    float off = HALF_STEP + hatch_tam_step_max((double)tam->whole.tolerance) / 2;
    float grey = (stroke->rgb[0] + stroke->rgb[1] + stroke->rgb[2]) / 3;
    for (uint32_t i = 0; i < f->count; i++)
        for (uint32_t c = 0; c < (tam->color ? 3 : 1); c++)
            if (image->pixels[(size_t)f->at[i] * image->channel_count + c] >
                1 - f->alpha[i] * (1 - (tam->color ? stroke->rgb[c] : grey)) + off)
                return true;
    return false;
}

static bool is_in_map(const struct hatch_tam *tam, const struct hatch_stroke *stroke)
{
    return stroke->level < tam->levels && stroke->level < HATCH_STROKE_LEVELS_MAX &&
           stroke->column + stroke->delay[stroke->level] < tam->tones;
}

enum hatch_status hatch_measure_tam_nesting(const struct hatch_tam *tam, const struct hatch_tam_strokes *strokes,
                                            struct hatch_arena *scratch, uint64_t *missing, struct hatch_err *err)
{
    struct hatch_arena_mark mark = hatch_arena_mark(scratch);
    struct hatch_canvas canvas;
    struct hatch_style style;
    uint64_t count = 0;
    enum hatch_status status = white_canvas(tam, strokes, tam->levels, &style, scratch, &canvas, err);
    for (uint32_t i = 0; status == HATCH_OK && i < strokes->list->count; i++) {
        const struct hatch_stroke *stroke = &strokes->list->items[i];
        if (!is_in_map(tam, stroke)) {
            status = hatch_fail(err, HATCH_BAD_INPUT,
                                "stroke %u: column %u, level %u, but the map has %u columns, %u levels", i + 1,
                                stroke->column, stroke->level, tam->tones, tam->levels);
            break;
        }
        for (uint32_t level = 0; level <= stroke->level; level++) {
            (void)hatch_canvas_try(&canvas, stroke, level, 1 - strokes->growth);
            uint32_t column = stroke->column + stroke->delay[level];
            count += is_missing(tam, &canvas, stroke, &tam->columns[column].levels[level]);
        }
    }
    hatch_arena_rewind(scratch, mark);
    if (status == HATCH_OK)
        *missing = count;
    return status;
}

enum hatch_status hatch_measure_stroke_darkness(const struct hatch_tam *tam, const struct hatch_tam_strokes *strokes,
                                                uint32_t level, struct hatch_arena *scratch, double *darkness,
                                                struct hatch_err *err)
{
    struct hatch_arena_mark mark = hatch_arena_mark(scratch);
    struct hatch_canvas canvas;
    struct hatch_style style;
    enum hatch_status status = white_canvas(tam, strokes, level + 1, &style, scratch, &canvas, err);
    double sum = 0;
    for (uint32_t i = 0; status == HATCH_OK && i < strokes->list->count; i++)
        sum += hatch_canvas_try(&canvas, &strokes->list->items[i], level, 1);
    hatch_arena_rewind(scratch, mark);
    if (status == HATCH_OK)
        *darkness = strokes->list->count ? sum / strokes->list->count : 0;
    return status;
}

/* Draws the strokes that a column adds, at random positions. */
static void draw_at_random(struct hatch_canvas *canvas, const struct hatch_stroke_list *list, uint32_t column,
                           uint32_t draw)
{
    for (uint32_t i = 0; i < list->count; i++) {
        struct hatch_stroke stroke = list->items[i];
        if (stroke.column != column)
            continue;
        stroke.x = hatch_random_unit(draw, 1, i);
        stroke.y = hatch_random_unit(draw, 2, i);
        hatch_canvas_draw(canvas, &stroke, 0, 0, 1);
    }
}

/* Adds the squared spreads of each tone in one random drawing to ratio. */
static enum hatch_status add_drawing(const struct hatch_tam *tam, const struct hatch_tam_strokes *strokes,
                                     uint32_t draw, struct hatch_arena *scratch, double *ratio, struct hatch_err *err)
{
    struct hatch_canvas canvas;
    struct hatch_style style;
    HATCH_TRY(white_canvas(tam, strokes, 1, &style, scratch, &canvas, err));
    struct hatch_image image = {
        .width = tam->size_px, .height = tam->size_px, .channel_count = 1, .pixels = canvas.paper[0]};
    if (tam->color) { /* the first channel is measured, as in the map */
        image.channel_count = 3;
        image.pixels = canvas.rgb[0];
    }
    for (uint32_t tone = 0; tone < tam->tones; tone++) {
        double spread[HATCH_EVENNESS_BOXES];
        draw_at_random(&canvas, strokes->list, tone, draw);
        HATCH_TRY(hatch_measure_spreads(&image, scratch, spread, err));
        for (uint32_t box = 0; box < HATCH_EVENNESS_BOXES; box++)
            ratio[tone * HATCH_EVENNESS_BOXES + box] += spread[box] * spread[box];
    }
    return HATCH_OK;
}

enum hatch_status hatch_measure_evenness(const struct hatch_tam *tam, const struct hatch_tam_strokes *strokes,
                                         uint32_t draws, struct hatch_arena *scratch, double *ratio,
                                         struct hatch_err *err)
{
    assert(draws > 0);
    for (uint32_t i = 0; i < tam->tones * HATCH_EVENNESS_BOXES; i++)
        ratio[i] = strokes->growth > 0 ? NAN : 0;
    if (strokes->growth > 0)
        return HATCH_OK;
    struct hatch_arena_mark mark = hatch_arena_mark(scratch);
    for (uint32_t draw = 0; draw < draws; draw++) {
        enum hatch_status status = add_drawing(tam, strokes, draw, scratch, ratio, err);
        hatch_arena_rewind(scratch, mark);
        HATCH_TRY(status);
    }
    for (uint32_t tone = 0; tone < tam->tones; tone++) {
        double spread[HATCH_EVENNESS_BOXES];
        HATCH_TRY(hatch_measure_spreads(&tam->columns[tone].levels[0], scratch, spread, err));
        for (uint32_t box = 0; box < HATCH_EVENNESS_BOXES; box++) {
            double random = sqrt(ratio[tone * HATCH_EVENNESS_BOXES + box] / draws);
            ratio[tone * HATCH_EVENNESS_BOXES + box] = random > 0 ? spread[box] / random : 0;
        }
    }
    return HATCH_OK;
}
