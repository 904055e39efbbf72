#include "tam/fill.h"

#include <assert.h>
#include <math.h>
#include <string.h>

#include "filter/pyramid.h"
#include "tam/field.h"
#include "tam/place.h"

/* No image takes more strokes than this many for each of its pixels' worth: a target that the ink
 * cannot reach ends here. */
#define FRUITLESS_MAX 8u

struct filler {
    const struct hatch_style *style;
    const struct hatch_fill_options *options;
    struct hatch_canvas canvas;
    struct hatch_field field;                        /* method FIELD */
    float *pyramids[HATCH_MIP_LEVELS_MAX][HATCH_MIP_LEVELS_MAX]; /* method EXHAUSTIVE; [.][0] is paper */
    float targets[HATCH_TAM_TONES_MAX];
    struct hatch_arena *arena;
    struct hatch_stroke_list strokes;
    uint64_t choices;
    uint32_t growing_from; /* the first stroke that may still grow */
};

static enum hatch_status make_pyramids(struct filler *f, struct hatch_arena *arena,
                                       struct hatch_err *err)
{
    for (uint32_t level = 0; level < f->options->levels; level++) {
        f->pyramids[level][0] = f->canvas.paper[level];
        for (uint32_t p = 1, size = hatch_canvas_size(&f->canvas, level); size >> p; p++) {
            size_t pixels = (size_t)(size >> p) * (size >> p);
            float *paper = HATCH_NEW(arena, float, pixels, err);
            if (!paper)
                return HATCH_LIMIT;
            for (size_t i = 0; i < pixels; i++)
                paper[i] = 1;
            f->pyramids[level][p] = paper;
        }
    }
    return HATCH_OK;
}

/* Takes the change of the stroke just drawn into the pyramids of that level. */
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

/* Draws on every level that receives the stroke, finest to coarsest. */
static void draw(struct filler *f, const struct hatch_stroke *stroke, float scale_before, float scale)
{
    for (uint32_t level = 0; level <= stroke->level; level++) {
        hatch_canvas_draw(&f->canvas, stroke, level, scale_before, scale);
        if (f->options->method == HATCH_FILL_FIELD)
            hatch_field_deposit(&f->field, &f->canvas, level);
        else
            update_pyramid(f, level);
    }
    if (f->options->method == HATCH_FILL_FIELD)
        hatch_field_settle(&f->field);
}

static uint32_t candidates_of(const struct filler *f, uint32_t tone)
{
    uint32_t light = f->style->candidates_light, dark = f->style->candidates_dark;
    if (f->options->tones < 2)
        return light;
    double share = (double)tone / (double)(f->options->tones - 1);
    return (uint32_t)((double)light + ((double)dark - (double)light) * share + 0.5);
}

/* The directions of a column; where the schedule leaves a gap, all of them. */
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
    if (f->options->method == HATCH_FILL_FIELD)
        return hatch_place_by_field(&f->canvas, &f->field, choice);
    return hatch_place_exhaustively(&f->canvas, f->pyramids, choice);
}

/* Adds strokes to one image until no stroke brings its mean closer to the target. An image that is too
 * dark already, because a coarser one's strokes were dark, receives none. */
static enum hatch_status fill_image(struct filler *f, uint32_t tone, uint32_t level, float scale,
                                    struct hatch_err *err)
{
    float target = f->targets[tone];
    struct hatch_choice choice = {.seed = f->options->seed,
                                  .level = level,
                                  .candidates = candidates_of(f, tone),
                                  .length_max = f->style->length_max,
                                  .scale = scale};
    choice.direction_count = directions_of(f->style, target, choice.directions);
    if (f->options->method == HATCH_FILL_FIELD && f->canvas.darkness[level] < (double)target)
        hatch_field_start(&f->field, level);
    for (uint32_t fruitless = 0; fruitless < FRUITLESS_MAX;) {
        double missing = (double)target - f->canvas.darkness[level];
        if (!(missing > 0))
            break;
        choice.number = f->choices++;
        struct hatch_stroke stroke = place(f, &choice);
        double gain = hatch_canvas_try(&f->canvas, &stroke, level, scale);
        if (gain > 2 * missing) { /* worse than stopping: a shorter one may fit */
            choice.length_max = stroke.length * (float)(missing / gain);
            if (choice.length_max < f->style->length_min)
                fruitless = FRUITLESS_MAX - 1;
            fruitless++;
            continue;
        }
        if (!(gain > missing * 1e-9) && !(gain > 1e-9)) { /* no paper left where it went */
            fruitless++;
            continue;
        }
        stroke.id = f->strokes.count + 1;
        stroke.column = tone;
        HATCH_TRY(hatch_stroke_list_add(&f->strokes, f->arena, &stroke, err));
        draw(f, &stroke, 0, scale);
    }
    return HATCH_OK;
}

/* Hands the column over: the drawn levels are the canvas's own, the rest is box-filtered. */
static enum hatch_status deliver(struct filler *f, uint32_t tone, struct hatch_arena *scratch,
                                 hatch_tam_sink sink, void *context, struct hatch_err *err)
{
    struct hatch_arena_mark mark = hatch_arena_mark(scratch);
    struct hatch_image levels[HATCH_MIP_LEVELS_MAX] = {{0}};
    struct hatch_mipmap column = {.levels = levels};
    for (uint32_t level = 0; level < f->options->levels; level++) {
        uint32_t size = hatch_canvas_size(&f->canvas, level);
        struct hatch_image *image = &levels[level];
        *image = (struct hatch_image){.width = size, .height = size, .channel_count = 1};
        strcpy(image->channels[0].name, "Y");
        image->pixels = f->canvas.paper[level];
    }
    hatch_tam_label(tone, f->targets[tone], f->options->levels, f->options->seed, &column);
    enum hatch_status status = hatch_mipmap_complete(&column, f->options->levels, scratch, err);
    if (status == HATCH_OK)
        status = sink(context, tone, &column, err);
    hatch_arena_rewind(scratch, mark);
    return status;
}

enum hatch_status hatch_tam_fill(const struct hatch_style *style, const struct hatch_brush *brush,
                                 const struct hatch_fill_options *options, struct hatch_arena *arena,
                                 struct hatch_arena *scratch, hatch_tam_sink sink, void *context,
                                 struct hatch_stroke_list *list, struct hatch_err *err)
{
    assert(options->tones >= 1 && options->tones <= HATCH_TAM_TONES_MAX);
    assert(options->levels >= 1 && options->size_px >> (options->levels - 1) >= 1);
    struct filler f = {.style = style, .options = options, .arena = arena};
    hatch_style_targets(style, options->tones, f.targets);
    struct hatch_arena_mark mark = hatch_arena_mark(scratch);
    enum hatch_status status = hatch_canvas_make(scratch, style, brush, options->size_px,
                                                 options->levels, options->ids, &f.canvas, err);
    if (status == HATCH_OK)
        status = options->method == HATCH_FILL_FIELD
                     ? hatch_field_make(scratch, options->size_px, options->levels, &f.field, err)
                     : make_pyramids(&f, scratch, err);
    for (uint32_t tone = 0; status == HATCH_OK && tone < options->tones; tone++) {
        for (uint32_t level = options->levels; status == HATCH_OK && level-- > 0;)
            status = fill_image(&f, tone, level, 1, err);
        if (status == HATCH_OK)
            status = deliver(&f, tone, scratch, sink, context, err);
    }
    hatch_arena_rewind(scratch, mark);
    if (status == HATCH_OK && list)
        *list = f.strokes;
    return status;
}
