#include "placement/replay.h"

#include <assert.h>
#include <stdlib.h>
#include <string.h>

#include "base/random.h"
#include "image/color.h"
#include "placement/column.h"
#include "placement/potential.h"

/* With fit: of this many next strokes, the one in the emptiest part of the image is taken first. A larger number makes
 * the image more even and its colours less so. */
#define LOOKAHEAD 4u
/* With fit: number of strokes considered for the last one of an image. */
#define LAST_CANDIDATES 64u

/* A stroke and the key by which fit orders strokes. */
struct ordered_stroke {
    uint32_t key, stroke;
};

struct replay {
    const struct hatch_replay_options *options;
    struct hatch_stroke *strokes;
    uint32_t count;
    struct hatch_canvas canvas;
    float targets[HATCH_TAM_TONES_MAX];
    uint16_t *entered[HATCH_STROKE_LEVELS_MAX]; /* per stroke: first column that holds it on a level, plus 1; 0: none */
    uint32_t cursor[HATCH_STROKE_LEVELS_MAX];   /* per level: next stroke in drawing order */
    /* With fit: per level but the finest, the potential of its strokes. */
    struct hatch_potential field[HATCH_STROKE_LEVELS_MAX];
    struct ordered_stroke *order; /* with fit: the new strokes of an image */
    double largest;               /* largest darkness that a stroke adds to an image */
    struct hatch_replay_result result;
};

/* Returns whether the stroke brings the image closer to its target. */
static bool improves(struct replay *r, uint32_t level, uint32_t stroke, double target)
{
    double gain = hatch_canvas_try(&r->canvas, &r->strokes[stroke], level, 1);
    r->largest = fmax(r->largest, gain);
    return gain <= 2 * (target - r->canvas.darkness[level]);
}

static void take(struct replay *r, uint32_t level, uint32_t stroke, uint32_t tone)
{
    hatch_canvas_draw(&r->canvas, &r->strokes[stroke], level, 0, 1);
    r->entered[level][stroke] = (uint16_t)(tone + 1);
    if (level && r->options->fit) {
        hatch_potential_deposit(&r->field[level], &r->canvas, level);
        hatch_potential_update(&r->field[level]);
    }
}

/* Returns whether the level may take the stroke: it does not hold it yet, but the next finer level does. */
static bool is_available(const struct replay *r, uint32_t level, uint32_t stroke)
{
    return !r->entered[level][stroke] && (level == 0 || r->entered[level - 1][stroke]);
}

/* Returns whether the stroke is in the random selection of the level, a subset of those of the finer levels. */
static bool is_kept(const struct replay *r, uint32_t level, uint32_t stroke)
{
    for (uint32_t l = 1; l <= level && r->options->keep < 1; l++)
        if (!(hatch_random_unit(r->options->seed, l, stroke) < r->options->keep))
            return false;
    return true;
}

/* Takes the first strokes of the level's selection until the next one does not improve the image. Returns whether the
 * tone is met. */
static bool fill_in_order(struct replay *r, uint32_t level, uint32_t tone, double target)
{
    uint32_t end = level ? r->cursor[level - 1] : r->count;
    for (; r->cursor[level] < end; r->cursor[level]++) {
        uint32_t stroke = r->cursor[level];
        if (!is_available(r, level, stroke) || !is_kept(r, level, stroke))
            continue;
        if (!improves(r, level, stroke, target))
            return true;
        take(r, level, stroke, tone);
    }
    return false;
}

/* Takes strokes that were left out, if the others leave the image too light. The latest come first, because they have
 * the colour of this tone. */
static bool fill_backwards(struct replay *r, uint32_t level, uint32_t tone, double target)
{
    for (uint32_t stroke = r->cursor[level]; stroke-- > 0;) {
        if (!is_available(r, level, stroke))
            continue;
        if (!improves(r, level, stroke, target))
            return true;
        take(r, level, stroke, tone);
    }
    return false;
}

static int compare_keys(const void *a, const void *b)
{
    uint32_t first = ((const struct ordered_stroke *)a)->key;
    uint32_t second = ((const struct ordered_stroke *)b)->key;
    return (first > second) - (first < second); /* keys are distinct */
}

/* Lists the strokes that the finer level received in this column and returns their number. The i-th has the key frac(i
 * / φ), so that the first n strokes in the order of keys are spread evenly over the drawing for any n. */
static uint32_t order_new_strokes(struct replay *r, uint32_t level, uint32_t tone)
{
    uint32_t count = 0, start = (uint32_t)hatch_random_u64(r->options->seed, level, tone);
    for (uint32_t stroke = 0; stroke < r->count; stroke++)
        if (r->entered[level - 1][stroke] == tone + 1 && !r->entered[level][stroke]) {
            r->order[count] = (struct ordered_stroke){start + count * 2654435769u, stroke}; /* 2^32 / φ, modulo 2^32 */
            count++;
        }
    qsort(r->order, count, sizeof *r->order, compare_keys);
    return count;
}

/* Of the next few strokes, moves the one in the emptiest part of the image to the front. Without this, a random
 * selection of the strokes of an even drawing would be uneven. A path is scored along its chord. */
static void choose_emptiest(struct replay *r, uint32_t level, uint32_t from, uint32_t count)
{
    uint32_t best = from;
    float best_score = INFINITY;
    for (uint32_t i = from; i < count && i < from + LOOKAHEAD; i++) {
        float score = hatch_potential_score(&r->field[level], &r->strokes[r->order[i].stroke], UINT32_MAX);
        if (score < best_score) {
            best_score = score;
            best = i;
        }
    }
    struct ordered_stroke chosen = r->order[best];
    memmove(&r->order[from + 1], &r->order[from], (best - from) * sizeof chosen);
    r->order[from] = chosen;
}

/* Takes that one of the next strokes in order that brings the image closest to its target. */
static void take_last(struct replay *r, uint32_t level, uint32_t tone, double target, uint32_t from, uint32_t count)
{
    double missing = target - r->canvas.darkness[level], best_error = fabs(missing);
    uint32_t best = UINT32_MAX;
    for (uint32_t i = from; i < count && i < from + LAST_CANDIDATES; i++) {
        double gain = hatch_canvas_try(&r->canvas, &r->strokes[r->order[i].stroke], level, 1);
        if (fabs(missing - gain) < best_error) {
            best_error = fabs(missing - gain);
            best = r->order[i].stroke;
        }
    }
    if (best != UINT32_MAX)
        take(r, level, best, tone);
}

/* Takes the share of this column's new strokes that meets its tone. Because strokes are taken in order, the first one
 * that overshoots ends the search, and no bisection is needed. Returns whether the tone is met. */
static bool fill_by_share(struct replay *r, uint32_t level, uint32_t tone, double target)
{
    uint32_t count = order_new_strokes(r, level, tone);
    for (uint32_t i = 0; i < count; i++) {
        choose_emptiest(r, level, i, count);
        if (!improves(r, level, r->order[i].stroke, target)) {
            take_last(r, level, tone, target, i + 1, count);
            return true;
        }
        take(r, level, r->order[i].stroke, tone);
    }
    return false;
}

static void fill_image(struct replay *r, uint32_t level, uint32_t tone)
{
    double target = (double)r->targets[tone];
    bool met;
    if (level && r->options->fit) {
        r->cursor[level] = r->count;
        met = r->canvas.darkness[level] >= target || fill_by_share(r, level, tone, target);
    } else {
        met = fill_in_order(r, level, tone, target);
    }
    if (!met && level)
        met = fill_backwards(r, level, tone, target);
    double error = r->canvas.darkness[level] - target;
    r->result.tone_error = fmaxf(r->result.tone_error, (float)fabs(error));
    if (met || !(error < -(double)HATCH_REPLAY_TONE))
        return;
    r->result.exhausted++;
    r->result.shortfall = fmaxf(r->result.shortfall, (float)-error);
}

static void mean_chroma(const struct replay *r, uint32_t level, double chroma[2])
{
    uint32_t size = hatch_canvas_size(&r->canvas, level);
    struct hatch_image image = {.width = size, .height = size, .channel_count = 3, .pixels = r->canvas.rgb[level]};
    hatch_color_chroma(&image, chroma);
}

static void compare_colors(struct replay *r)
{
    double finest[2], chroma[2];
    mean_chroma(r, 0, finest);
    for (uint32_t level = 1; level < r->options->levels; level++) {
        mean_chroma(r, level, chroma);
        double off = hypot(chroma[0] - finest[0], chroma[1] - finest[1]);
        r->result.chroma_error = fmaxf(r->result.chroma_error, (float)off);
        if (hypot(finest[0], finest[1]) >= HATCH_COLOR_CHROMA_MIN)
            r->result.hue_error_deg = fmaxf(r->result.hue_error_deg, (float)hatch_color_hue_between(finest, chroma));
    }
}

/* Draws all strokes on the finest level and returns its darkness. If the style has colours, gives each stroke the
 * colour of the darkness at which it is drawn. */
static double draw_all(const struct replay *r, struct hatch_canvas *canvas)
{
    for (uint32_t stroke = 0; stroke < r->count; stroke++) {
        if (r->options->style->color_count)
            hatch_ramp_color(r->options->style->colors, r->options->style->color_count, (float)canvas->darkness[0],
                             r->strokes[stroke].rgb);
        hatch_canvas_draw(canvas, &r->strokes[stroke], 0, 0, 1);
    }
    return canvas->darkness[0];
}

/* Makes a canvas with room for the longest and the widest stroke.
 *   style  out: the options' style, with length_max and width_px raised to those of the strokes; the canvas refers to
 *          it, so it must outlive the canvas */
static enum hatch_status make_canvas(const struct replay *r, uint32_t levels, bool ids, struct hatch_style *style,
                                     struct hatch_arena *scratch, struct hatch_canvas *canvas, struct hatch_err *err)
{
    const struct hatch_canvas_options options = {style,  r->options->brush, r->options->size_px,
                                                 levels, r->options->color, ids};
    *style = *r->options->style;
    for (uint32_t i = 0; i < r->count; i++) {
        style->length_max = fmaxf(style->length_max, r->strokes[i].length);
        style->width_px = fmaxf(style->width_px, r->strokes[i].width_px);
    }
    return hatch_canvas_make(&options, scratch, canvas, err);
}

static enum hatch_status set_targets(struct replay *r, struct hatch_arena *scratch, struct hatch_err *err)
{
    const float *targets = r->options->targets;
    struct hatch_arena_mark mark = hatch_arena_mark(scratch);
    struct hatch_canvas canvas;
    struct hatch_style style;
    enum hatch_status status = make_canvas(r, 1, false, &style, scratch, &canvas, err);
    if (status == HATCH_OK)
        r->result.darkest = (float)draw_all(r, &canvas);
    hatch_arena_rewind(scratch, mark);
    HATCH_TRY(status);
    style.tone_max = r->result.darkest;
    if (!targets)
        hatch_style_targets(&style, r->options->tones, r->targets);
    for (uint32_t tone = 0; tone < r->options->tones; tone++) {
        r->targets[tone] = targets ? targets[tone] : r->targets[tone];
        r->result.short_columns += r->targets[tone] > r->result.darkest + HATCH_REPLAY_TONE;
    }
    return HATCH_OK;
}

static enum hatch_status make_lists(struct replay *r, struct hatch_arena *scratch, struct hatch_err *err)
{
    const struct hatch_replay_options *options = r->options;
    for (uint32_t level = 1; options->fit && level < options->levels; level++)
        HATCH_TRY(
            hatch_potential_make(scratch, options->size_px, options->levels, options->brush, &r->field[level], err));
    for (uint32_t level = 0; level < options->levels; level++) {
        HATCH_TRY(HATCH_ALLOC(scratch, &r->entered[level], r->count, err));
    }
    return HATCH_ALLOC(scratch, &r->order, r->count, err);
}

/* Sets column, level and delay of the strokes, and removes those that no image holds. */
static void set_columns(const struct replay *r, struct hatch_stroke_list *list)
{
    uint32_t kept = 0;
    for (uint32_t i = 0; i < r->count; i++) {
        if (!r->entered[0][i])
            continue;
        struct hatch_stroke stroke = r->strokes[i];
        stroke.column = r->entered[0][i] - 1u;
        stroke.level = 0;
        for (uint32_t level = 0; level < HATCH_STROKE_LEVELS_MAX; level++) {
            uint32_t entered = level < r->options->levels ? r->entered[level][i] : 0;
            stroke.delay[level] = (uint8_t)(entered ? entered - r->entered[0][i] : 0);
            stroke.level = entered ? level : stroke.level;
        }
        list->items[kept++] = stroke;
    }
    list->count = kept;
}

static enum hatch_status replay(struct replay *r, const struct hatch_tam_metadata *metadata,
                                struct hatch_stroke_list *strokes, struct hatch_arena *arena,
                                struct hatch_arena *scratch, const struct hatch_tam_sink *sink, struct hatch_err *err)
{
    struct hatch_style style;
    HATCH_TRY(set_targets(r, scratch, err));
    HATCH_TRY(make_lists(r, scratch, err));
    HATCH_TRY(make_canvas(r, r->options->levels, r->options->ids, &style, scratch, &r->canvas, err));
    for (uint32_t tone = 0; tone < r->options->tones; tone++) {
        for (uint32_t level = 0; level < r->options->levels; level++)
            fill_image(r, level, tone);
        if (r->options->color)
            compare_colors(r);
        bool last = tone + 1 == r->options->tones;
        if (last)
            set_columns(r, strokes);
        HATCH_TRY(hatch_column_deliver(&r->canvas, metadata, tone, r->targets[tone],
                                       last && r->options->ids ? strokes : NULL, arena, scratch, sink, err));
    }
    r->result.tone_bound = (float)(r->largest / 2);
    return HATCH_OK;
}

enum hatch_status hatch_tam_replay(const struct hatch_replay_options *options, struct hatch_stroke_list *strokes,
                                   struct hatch_arena *arena, struct hatch_arena *scratch,
                                   const struct hatch_tam_sink *sink, struct hatch_replay_result *result,
                                   struct hatch_err *err)
{
    assert((options->size_px & (options->size_px - 1)) == 0);
    assert(options->tones >= 1 && options->tones <= HATCH_TAM_TONES_MAX);
    assert(options->levels >= 1 && options->levels <= HATCH_STROKE_LEVELS_MAX);
    if (strokes->count == 0)
        return hatch_fail(err, HATCH_BAD_INPUT, "the drawing has no strokes");
    struct replay r = {.options = options, .strokes = strokes->items, .count = strokes->count};
    struct hatch_tam_metadata metadata;
    HATCH_TRY(hatch_column_metadata(options->style, options->tones, options->levels, options->seed, 0, arena, &metadata,
                                    err));
    struct hatch_arena_mark mark = hatch_arena_mark(scratch);
    enum hatch_status status = replay(&r, &metadata, strokes, arena, scratch, sink, err);
    if (status == HATCH_OK)
        *result = r.result;
    hatch_arena_rewind(scratch, mark);
    return status;
}
