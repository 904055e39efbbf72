#include "placement/fill.h"

#include <assert.h>
#include <string.h>

#include "placement/column.h"
#include "placement/place.h"

/* An image counts as full after this many choices in a row that yield no stroke that darkens it, or none that is short
 * enough: the ink may be too light to reach the target. */
#define FRUITLESS_MAX 8u
/* Lower bound of a stroke's darkness per length, relative to that of the stroke before it; it falls because more paper
 * is covered. */
#define OVERLAP_SHARE 0.8

struct filler {
    const struct hatch_style *style;
    const struct hatch_fill_options *options;
    struct hatch_canvas canvas;
    struct hatch_potential field; /* for HATCH_FILL_FIELD */
    /* For HATCH_FILL_EXHAUSTIVE; [level][0] is canvas.paper. */
    float *pyramids[HATCH_MIP_LEVELS_MAX][HATCH_MIP_LEVELS_MAX];
    float targets[HATCH_TAM_TONES_MAX];
    double gain_per_length[HATCH_MIP_LEVELS_MAX]; /* of the last stroke tried on a level; 0: none */
    struct hatch_arena *arena;
    struct hatch_stroke_list strokes;
    uint64_t choices; /* number of choices so far, which selects the random numbers of the next one */
    bool fruitless[HATCH_MIP_LEVELS_MAX]; /* per level: the image of this column was given up, since strokes do not
                                             darken it */
    struct hatch_fill_misses misses;
    float *scale; /* per stroke: share of its full length at which it is drawn */
    uint32_t scale_capacity;
};

static enum hatch_status make_pyramids(struct filler *f, struct hatch_arena *arena, struct hatch_err *err)
{
    for (uint32_t level = 0; level < f->options->levels; level++) {
        f->pyramids[level][0] = f->canvas.paper[level];
        for (uint32_t p = 1, size = hatch_canvas_size(&f->canvas, level); size >> p; p++) {
            size_t pixels = (size_t)(size >> p) * (size >> p);
            float *paper;
            HATCH_TRY(HATCH_ALLOC(arena, &paper, pixels, err));
            for (size_t i = 0; i < pixels; i++)
                paper[i] = 1;
            f->pyramids[level][p] = paper;
        }
    }
    return HATCH_OK;
}

/* Applies the change of the stroke just drawn to the pyramid of the level. */
static void update_pyramid(struct filler *f, uint32_t level)
{
    const struct hatch_footprint *print = &f->canvas.footprint;
    uint32_t size = hatch_canvas_size(&f->canvas, level);
    float share = 1;
    for (uint32_t p = 1; size >> p; p++) {
        share *= 0.25f;
        for (uint32_t i = 0; i < print->count; i++) {
            uint32_t x = print->at[i] % size >> p, y = print->at[i] / size >> p;
            f->pyramids[level][p][y * (size >> p) + x] -= f->canvas.change[i] * share;
        }
    }
}

/* Draws the stroke on all of its levels. */
static void draw(struct filler *f, const struct hatch_stroke *stroke, float scale_before, float scale)
{
    for (uint32_t level = 0; level <= stroke->level; level++) {
        hatch_canvas_draw(&f->canvas, stroke, level, scale_before, scale);
        if (f->options->method == HATCH_FILL_FIELD)
            hatch_potential_deposit(&f->field, &f->canvas, level);
        else
            update_pyramid(f, level);
    }
    if (f->options->method == HATCH_FILL_FIELD)
        hatch_potential_update(&f->field);
}

static uint32_t candidates_of(const struct filler *f, uint32_t tone)
{
    uint32_t light = f->style->candidates_light, dark = f->style->candidates_dark;
    if (f->options->tones < 2)
        return light;
    double share = (double)tone / (double)(f->options->tones - 1);
    return (uint32_t)((double)light + ((double)dark - (double)light) * share + 0.5);
}

/* Lists the directions for a target tone, or all directions if there is none for it. Returns their number. */
static uint32_t directions_of(const struct hatch_style *style, float target, float *angles)
{
    uint32_t count = 0;
    for (uint32_t i = 0; i < style->direction_count; i++)
        if (target >= style->directions[i].from && target <= style->directions[i].to)
            angles[count++] = style->directions[i].angle_rad;
    for (uint32_t i = 0; count == 0 && i < style->direction_count; i++)
        angles[i] = style->directions[i].angle_rad;
    return count ? count : style->direction_count;
}

static struct hatch_stroke place(struct filler *f, const struct hatch_choice *choice)
{
    if (f->options->method == HATCH_FILL_FIELD) {
        hatch_potential_select(&f->field, choice->level);
        return hatch_place_by_field(f->style, &f->field, choice);
    }
    return hatch_place_exhaustively(&f->canvas, f->pyramids, choice);
}

/* Appends the stroke and its scale. */
static enum hatch_status add_stroke(struct filler *f, struct hatch_stroke *stroke, float scale, struct hatch_err *err)
{
    if (f->strokes.count == f->scale_capacity) {
        uint32_t capacity = f->scale_capacity ? 2 * f->scale_capacity : 1024;
        float *larger;
        HATCH_TRY(HATCH_ALLOC(f->arena, &larger, capacity, err));
        if (f->scale)
            memcpy(larger, f->scale, f->scale_capacity * sizeof *larger);
        f->scale = larger;
        f->scale_capacity = capacity;
    }
    f->scale[f->strokes.count] = scale;
    stroke->id = f->strokes.count + 1;
    return hatch_stroke_list_add(&f->strokes, f->arena, stroke, err);
}

/* While the image is lighter than its target, grows the strokes whose coarsest level is this one, by one step each, the
 * oldest first. */
static void grow_strokes(struct filler *f, uint32_t tone, uint32_t level)
{
    if (!(f->options->growth > 0))
        return;
    uint32_t columns = f->options->tones / 3 > 1 ? f->options->tones / 3 : 1;
    float step = f->options->growth / (float)columns;
    for (uint32_t i = 0; i < f->strokes.count; i++) {
        const struct hatch_stroke *stroke = &f->strokes.items[i];
        if (stroke->level != level || stroke->column == tone || !(f->scale[i] < 1))
            continue;
        if (!(f->canvas.darkness[level] < (double)f->targets[tone]))
            return;
        float scale = f->scale[i] + step < 0.999f ? f->scale[i] + step : 1;
        draw(f, stroke, f->scale[i], scale);
        f->scale[i] = scale;
    }
}

/* Returns the darkness of the stroke that fits best; 0 or less if no stroke fits in this column. Finer images receive
 * the stroke too, each half as dark as the next coarser one. If one of them is closer to its target than this image,
 * the errors of both are made equal. */
static double room_for_stroke(const struct filler *f, uint32_t level, double target)
{
    double missing = target - f->canvas.darkness[level], room = missing;
    for (uint32_t finer = 0; finer < level; finer++) {
        double spare = ldexp(target - f->canvas.darkness[finer], (int)(level - finer));
        room = fmin(room, (missing + spare) / 2);
    }
    return room;
}

/* Returns whether even the shortest stroke would be too dark. With many columns the step between two is smaller than a
 * stroke, and most images receive none. */
static bool is_shortest_too_dark(const struct filler *f, uint32_t tone, uint32_t level, double room)
{
    double shortest = f->gain_per_length[level] * (double)f->style->length_min * OVERLAP_SHARE;
    double step = (double)f->targets[tone] - (tone ? (double)f->targets[tone - 1] : 0);
    return shortest > step && shortest > 2 * room;
}

/* TAKE: the stroke brings the image closer to its target. SHORTER: a shorter one may. FRUITLESS: it does not darken the
 * image. */
enum verdict { TAKE, SHORTER, FRUITLESS };

static enum verdict judge(double gain, double room)
{
    if (gain > 2 * room)
        return SHORTER;
    return gain > 1e-9 ? TAKE : FRUITLESS;
}

/* Reports how far the images are filled, all with the same weight. */
static void report(const struct filler *f, uint32_t tone, uint32_t level)
{
    const struct hatch_fill_options *options = f->options;
    uint32_t columns = options->needed ? options->needed : options->tones;
    double share = fmin(f->canvas.darkness[level] / (double)f->targets[tone], 1);
    double done = (double)tone * options->levels + (options->levels - 1 - level) + share;
    hatch_progress_report(options->progress, done / ((double)columns * options->levels));
}

/* Adds strokes to one image until none brings its mean closer to the target. An image that is too dark already,
 * because of the strokes of coarser levels, receives none. */
static enum hatch_status fill_image(struct filler *f, uint32_t tone, uint32_t level, struct hatch_err *err)
{
    double target = (double)f->targets[tone];
    struct hatch_choice choice = {.seed = f->options->seed,
                                  .level = level,
                                  .candidates = candidates_of(f, tone),
                                  .length_max = f->style->length_max,
                                  .scale = 1 - f->options->growth};
    choice.direction_count = directions_of(f->style, f->targets[tone], choice.directions);
    if (f->options->color)
        hatch_ramp_color(f->style->colors, f->style->color_count, f->targets[tone], choice.rgb);
    grow_strokes(f, tone, level);
    f->fruitless[level] = false;
    for (uint32_t fruitless = 0; fruitless < FRUITLESS_MAX && f->canvas.darkness[level] < target;) {
        double room = room_for_stroke(f, level, target);
        if (!(room > 0) || is_shortest_too_dark(f, tone, level, room))
            return HATCH_OK;
        report(f, tone, level);
        choice.number = f->choices++;
        struct hatch_stroke stroke = place(f, &choice);
        double gain = hatch_canvas_try(&f->canvas, &stroke, level, choice.scale);
        f->gain_per_length[level] = gain / (double)stroke.length;
        enum verdict verdict = judge(gain, room);
        f->fruitless[level] = verdict == FRUITLESS;
        switch (verdict) {
        case TAKE:
            fruitless = 0;
            stroke.column = tone;
            HATCH_TRY(add_stroke(f, &stroke, choice.scale, err));
            draw(f, &stroke, 0, choice.scale);
            break;
        case SHORTER:
            fruitless = choice.length_max > f->style->length_min ? fruitless + 1 : FRUITLESS_MAX;
            choice.length_max = stroke.length * (float)(room / gain);
            break;
        case FRUITLESS:
            fruitless++;
            break;
        }
    }
    return HATCH_OK;
}

/* Compares the means of a column's images with its target. */
static void note_misses(struct filler *f, uint32_t tone)
{
    struct hatch_fill_misses *misses = &f->misses;
    for (uint32_t level = 0; level < f->options->levels; level++) {
        float off = (float)(f->canvas.darkness[level] - (double)f->targets[tone]);
        misses->images += fabsf(off) > HATCH_FILL_TONE;
        if (!(fabsf(off) > misses->most))
            continue;
        misses->most = fabsf(off);
        misses->level = level;
        misses->light_ink = off < 0 && f->fruitless[level];
    }
}

/* Counts the columns of strokes in those that are delivered: each n-th one. */
static void renumber(struct hatch_stroke_list *strokes, uint32_t every)
{
    for (uint32_t i = 0; i < strokes->count; i++)
        strokes->items[i].column /= every;
}

/* Collects the metadata of the map.
 *   columns, every  as in struct hatch_fill_options, over 0 */
static enum hatch_status make_metadata(const struct filler *f, uint32_t columns, uint32_t every,
                                       struct hatch_tam_metadata *metadata, struct hatch_err *err)
{
    const struct hatch_fill_options *options = f->options;
    HATCH_TRY(hatch_column_metadata(f->style, columns / every, options->levels, options->seed, options->growth,
                                    f->arena, metadata, err));
    if (columns < options->tones || options->whole_size_px > options->size_px || options->tolerance > 0)
        metadata->whole =
            (struct hatch_tam_whole){.size_px = options->whole_size_px ? options->whole_size_px : options->size_px,
                                     .tones = options->tones / every,
                                     .darkest = f->targets[options->tones - 1],
                                     .tolerance = options->tolerance};
    return HATCH_OK;
}

enum hatch_status hatch_tam_fill(const struct hatch_fill_options *options, struct hatch_arena *arena,
                                 struct hatch_arena *scratch, const struct hatch_tam_sink *sink,
                                 struct hatch_stroke_list *strokes, struct hatch_fill_misses *misses,
                                 struct hatch_err *err)
{
    const struct hatch_style *style = options->style;
    assert((options->size_px & (options->size_px - 1)) == 0);
    assert(options->tones >= 1 && options->tones <= HATCH_TAM_TONES_MAX && options->needed <= options->tones);
    assert(options->levels >= 1 && options->size_px >> (options->levels - 1) >= 1);
    struct filler f = {.style = style, .options = options, .arena = arena};
    hatch_style_targets(style, options->tones, f.targets);
    struct hatch_tam_metadata metadata;
    uint32_t columns = options->needed ? options->needed : options->tones, every = options->every ? options->every : 1;
    assert(options->tones % every == 0 && columns % every == 0);
    HATCH_TRY(make_metadata(&f, columns, every, &metadata, err));
    const struct hatch_canvas_options canvas = {style,           options->brush, options->size_px,
                                                options->levels, options->color, options->ids};
    struct hatch_arena_mark mark = hatch_arena_mark(scratch);
    enum hatch_status status = hatch_canvas_make(&canvas, scratch, &f.canvas, err);
    if (status == HATCH_OK)
        status = options->method == HATCH_FILL_FIELD
                     ? hatch_potential_make(scratch, options->size_px, options->levels, options->brush, &f.field, err)
                     : make_pyramids(&f, scratch, err);
    for (uint32_t tone = 0; status == HATCH_OK && tone < columns; tone++) {
        for (uint32_t level = options->levels; status == HATCH_OK && level-- > 0;)
            status = fill_image(&f, tone, level, err);
        if (status == HATCH_OK && tone + 1 == columns)
            renumber(&f.strokes, every);
        if (status == HATCH_OK && (tone + 1) % every == 0)
            note_misses(&f, tone);
        if (status == HATCH_OK && (tone + 1) % every == 0)
            status = hatch_column_deliver(&f.canvas, &metadata, tone / every, f.targets[tone],
                                          options->ids && tone + 1 == columns ? &f.strokes : NULL, arena, scratch, sink,
                                          err);
    }
    hatch_arena_rewind(scratch, mark);
    if (status == HATCH_OK && strokes)
        *strokes = f.strokes;
    if (status == HATCH_OK && misses)
        *misses = f.misses;
    return status;
}
