#include "placement/replay.h"

#include <assert.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/random.h"
#include "image/color.h"
#include "placement/column.h"
#include "placement/potential.h"

/* How many strokes --fit looks at for the one that lies emptiest, and at last for the one that closes the gap
 * best. More of the first are more even, and their colours less so. */
#define LOOKAHEAD 4u
#define CLOSING_CANDIDATES 64u

/* One stroke's place in the order in which --fit takes them. */
struct lot {
    uint32_t key, stroke;
};

struct replay {
    const struct hatch_style *style;
    const struct hatch_replay_options *options;
    struct hatch_stroke *strokes;
    uint32_t count;
    struct hatch_canvas canvas;
    float targets[HATCH_TAM_TONES_MAX];
    uint16_t *entered[HATCH_STROKE_LEVELS_MAX]; /* the column in which a level first has the stroke, from 1 */
    uint32_t cursor[HATCH_STROKE_LEVELS_MAX];   /* strokes before it were looked at in their order */
    struct hatch_potential field[HATCH_STROKE_LEVELS_MAX]; /* with fit, of each coarser level's own strokes */
    struct lot *lots;                                      /* strokes in the order in which fit takes them */
    double largest;                                        /* darkness that a stroke added or would have added */
    struct hatch_replay_result result;
};

/* What a level does with its next stroke. */
enum verdict { TAKE, LEAVE };

static enum verdict judge(struct replay *r, uint32_t level, uint32_t stroke, double target)
{
    double gain = hatch_canvas_try(&r->canvas, &r->strokes[stroke], level, 1);
    r->largest = fmax(r->largest, gain);
    return gain <= 2 * (target - r->canvas.darkness[level]) ? TAKE : LEAVE;
}

static void take(struct replay *r, uint32_t level, uint32_t stroke, uint32_t tone)
{
    hatch_canvas_draw(&r->canvas, &r->strokes[stroke], level, 0, 1);
    r->entered[level][stroke] = (uint16_t)(tone + 1);
    if (level && r->options->fit) {
        hatch_potential_deposit(&r->field[level], &r->canvas, level);
        hatch_potential_settle(&r->field[level]);
    }
}

/* Whether the next finer level has the stroke, and this one may take it. */
static bool offered(const struct replay *r, uint32_t level, uint32_t stroke)
{
    return !r->entered[level][stroke] && (level == 0 || r->entered[level - 1][stroke]);
}

/* Whether the stroke belongs to the level's share of the drawing: those of a coarser level are among those
 * of the finer ones. */
static bool is_kept(const struct replay *r, uint32_t level, uint32_t stroke)
{
    for (uint32_t l = 1; l <= level && r->options->keep < 1; l++)
        if (!(hatch_random_unit(r->options->seed, l, stroke) < r->options->keep))
            return false;
    return true;
}

/* The first strokes of the level's share, until another one would bring the image no closer. */
static bool fill_in_order(struct replay *r, uint32_t level, uint32_t tone, double target)
{
    uint32_t end = level ? r->cursor[level - 1] : r->count;
    for (; r->cursor[level] < end; r->cursor[level]++) {
        uint32_t stroke = r->cursor[level];
        if (!offered(r, level, stroke) || !is_kept(r, level, stroke))
            continue;
        if (judge(r, level, stroke, target) == LEAVE)
            return true;
        take(r, level, stroke, tone);
    }
    return false;
}

/* Strokes that were thrown out come back, the latest first, where the others leave the image too light:
 * the latest have this tone's colour. */
static bool fill_backwards(struct replay *r, uint32_t level, uint32_t tone, double target)
{
    for (uint32_t stroke = r->cursor[level]; stroke-- > 0;) {
        if (!offered(r, level, stroke))
            continue;
        if (judge(r, level, stroke, target) == LEAVE)
            return true;
        take(r, level, stroke, tone);
    }
    return false;
}

static int compare_lots(const void *a, const void *b)
{
    uint32_t first = ((const struct lot *)a)->key, second = ((const struct lot *)b)->key;
    return (first > second) - (first < second); /* no two are alike */
}

/* The strokes that the finer level has since this column, so ordered that the first ones, however many, are
 * spread evenly over the drawing: the i-th has the lot frac(i φ), and lots rise. How many there are. */
static uint32_t draw_lots(struct replay *r, uint32_t level, uint32_t tone)
{
    uint32_t count = 0, start = (uint32_t)hatch_random_u64(r->options->seed, level, tone);
    for (uint32_t stroke = 0; stroke < r->count; stroke++)
        if (r->entered[level - 1][stroke] == tone + 1 && !r->entered[level][stroke]) {
            r->lots[count] = (struct lot){start + count * 2654435769u, stroke}; /* 2^32 / φ, modulo 2^32 */
            count++;
        }
    qsort(r->lots, count, sizeof *r->lots, compare_lots);
    return count;
}

/* Moves that of the next few to the front that lies where the image is emptiest: a drawing that is even is as
 * uneven as chance when strokes leave it by lot. A path is judged along its chord. */
static void choose_emptiest(struct replay *r, uint32_t level, uint32_t from, uint32_t count)
{
    uint32_t best = from;
    float best_score = INFINITY;
    for (uint32_t i = from; i < count && i < from + LOOKAHEAD; i++) {
        float score = hatch_potential_score(&r->field[level], &r->strokes[r->lots[i].stroke], UINT32_MAX);
        if (score < best_score) {
            best_score = score;
            best = i;
        }
    }
    struct lot chosen = r->lots[best];
    memmove(&r->lots[from + 1], &r->lots[from], (best - from) * sizeof chosen);
    r->lots[from] = chosen;
}

/* Takes the stroke that brings the image closest, of those left in the lots from `from` on. */
static void close_gap(struct replay *r, uint32_t level, uint32_t tone, double target, uint32_t from, uint32_t count)
{
    double missing = target - r->canvas.darkness[level], best_left = fabs(missing);
    uint32_t best = UINT32_MAX;
    for (uint32_t i = from; i < count && i < from + CLOSING_CANDIDATES; i++) {
        double gain = hatch_canvas_try(&r->canvas, &r->strokes[r->lots[i].stroke], level, 1);
        if (fabs(missing - gain) < best_left) {
            best_left = fabs(missing - gain);
            best = r->lots[i].stroke;
        }
    }
    if (best != UINT32_MAX)
        take(r, level, best, tone);
}

/* The share of this column's new strokes at which its tone is met. It is found without a bisection: as they
 * enter in the order of their lots, the first that would overshoot says where one would end. */
static bool fill_by_share(struct replay *r, uint32_t level, uint32_t tone, double target)
{
    uint32_t count = draw_lots(r, level, tone);
    for (uint32_t i = 0; i < count; i++) {
        choose_emptiest(r, level, i, count);
        if (judge(r, level, r->lots[i].stroke, target) == LEAVE) {
            close_gap(r, level, tone, target, i + 1, count);
            return true;
        }
        take(r, level, r->lots[i].stroke, tone);
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
    r->result.exhausted += !met && error < -(double)HATCH_REPLAY_TONE;
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

/* How dark the whole drawing is on the finest level. Strokes get the style's colour, if it has any, of the
 * darkness that there is when they are drawn. */
static double draw_all(const struct replay *r, struct hatch_canvas *canvas)
{
    for (uint32_t stroke = 0; stroke < r->count; stroke++) {
        if (r->style->color_count)
            hatch_style_color_at(r->style, (float)canvas->darkness[0], r->strokes[stroke].rgb);
        hatch_canvas_draw(canvas, &r->strokes[stroke], 0, 0, 1);
    }
    return canvas->darkness[0];
}

/* Room for the longest and the widest stroke. style is kept by the canvas. */
static enum hatch_status make_canvas(const struct replay *r, const struct hatch_brush *brush, uint32_t levels, bool ids,
                                     struct hatch_style *style, struct hatch_arena *scratch,
                                     struct hatch_canvas *canvas, struct hatch_err *err)
{
    *style = *r->style;
    for (uint32_t i = 0; i < r->count; i++) {
        style->length_max = fmaxf(style->length_max, r->strokes[i].length);
        style->width_px = fmaxf(style->width_px, r->strokes[i].width_px);
    }
    return hatch_canvas_make(scratch, style, brush, r->options->size_px, levels, r->options->color, ids, canvas, err);
}

static enum hatch_status set_targets(struct replay *r, const struct hatch_brush *brush, const float *targets,
                                     struct hatch_arena *scratch, struct hatch_err *err)
{
    struct hatch_arena_mark mark = hatch_arena_mark(scratch);
    struct hatch_canvas canvas;
    struct hatch_style style;
    enum hatch_status status = make_canvas(r, brush, 1, false, &style, scratch, &canvas, err);
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

static enum hatch_status make_lists(struct replay *r, const struct hatch_brush *brush, struct hatch_arena *scratch,
                                    struct hatch_err *err)
{
    for (uint32_t level = 1; r->options->fit && level < r->options->levels; level++)
        HATCH_TRY(hatch_potential_make(scratch, r->options->size_px, r->options->levels, brush, &r->field[level], err));
    for (uint32_t level = 0; level < r->options->levels; level++) {
        r->entered[level] = HATCH_NEW(scratch, uint16_t, r->count, err);
        if (!r->entered[level])
            return HATCH_LIMIT;
    }
    r->lots = HATCH_NEW(scratch, struct lot, r->count, err);
    return r->lots ? HATCH_OK : HATCH_LIMIT;
}

/* Writes into the strokes where they stand, and leaves out those that stand nowhere. */
static void note_places(const struct replay *r, struct hatch_stroke_list *list)
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

static enum hatch_status replay(struct replay *r, const struct hatch_brush *brush, const float *targets,
                                const struct hatch_tam_label *label, struct hatch_arena *scratch, hatch_tam_sink sink,
                                void *context, struct hatch_err *err)
{
    struct hatch_style style;
    HATCH_TRY(set_targets(r, brush, targets, scratch, err));
    HATCH_TRY(make_lists(r, brush, scratch, err));
    HATCH_TRY(make_canvas(r, brush, r->options->levels, r->options->ids, &style, scratch, &r->canvas, err));
    for (uint32_t tone = 0; tone < r->options->tones; tone++) {
        for (uint32_t level = 0; level < r->options->levels; level++)
            fill_image(r, level, tone);
        if (r->options->color)
            compare_colors(r);
        HATCH_TRY(hatch_column_deliver(&r->canvas, label, tone, r->targets[tone], scratch, sink, context, err));
    }
    r->result.tone_bound = (float)(r->largest / 2);
    return HATCH_OK;
}

enum hatch_status hatch_tam_replay(const struct hatch_style *style, const struct hatch_brush *brush,
                                   const struct hatch_replay_options *options, const float *targets,
                                   struct hatch_stroke_list *strokes, struct hatch_arena *arena,
                                   struct hatch_arena *scratch, hatch_tam_sink sink, void *context,
                                   struct hatch_replay_result *result, struct hatch_err *err)
{
    assert((options->size_px & (options->size_px - 1)) == 0);
    assert(options->tones >= 1 && options->tones <= HATCH_TAM_TONES_MAX);
    assert(options->levels >= 1 && options->levels <= HATCH_STROKE_LEVELS_MAX);
    if (strokes->count == 0)
        return hatch_fail(err, HATCH_BAD_INPUT, "a drawing without strokes");
    struct replay r = {.style = style, .options = options, .strokes = strokes->items, .count = strokes->count};
    struct hatch_tam_label label;
    HATCH_TRY(hatch_column_label(style, options->levels, options->seed, 0, arena, &label, err));
    struct hatch_arena_mark mark = hatch_arena_mark(scratch);
    enum hatch_status status = replay(&r, brush, targets, &label, scratch, sink, context, err);
    if (status == HATCH_OK) {
        note_places(&r, strokes);
        *result = r.result;
    }
    hatch_arena_rewind(scratch, mark);
    return status;
}
