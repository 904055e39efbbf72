#include "stroke/brush.h"

#include <assert.h>

#include "base/random.h"
#include "image/color.h"

#define ENVELOPE_WIDTH 64u
#define ENVELOPE_HEIGHT 32u

const char *hatch_brush_name(enum hatch_brush_kind kind)
{
    static const char *const names[] = {"ink", "pencil", "crayon", "charcoal", "stipple", "round"};
    return (unsigned)kind < sizeof names / sizeof *names ? names[kind] : NULL;
}

static float smooth_step(float from, float to, float x)
{
    float t = (x - from) / (to - from);
    t = t < 0 ? 0 : t > 1 ? 1 : t;
    return t * t * (3 - 2 * t);
}

struct pressure {
    float thickness; /* share of the full width, 0 .. 1 */
    float alpha;     /* 0 .. 1 */
};

/* Returns the pressure at s, 0 .. 1 along the stroke. */
static struct pressure pressure_at(enum hatch_brush_kind kind, float s)
{
    float from_end = s < 0.5f ? s : 1 - s;
    switch (kind) {
    case HATCH_BRUSH_INK: /* starts blunt and ends in a long taper */
        return (struct pressure){0.25f + 0.75f * smooth_step(0, s < 0.5f ? 0.10f : 0.30f, from_end), 1};
    case HATCH_BRUSH_PENCIL:
        return (struct pressure){0.6f + 0.4f * smooth_step(0, 0.25f, from_end),
                                 0.45f + 0.55f * smooth_step(0, 0.35f, from_end)};
    case HATCH_BRUSH_CRAYON:
        return (struct pressure){0.55f + 0.45f * smooth_step(0, 0.12f, from_end),
                                 0.75f + 0.25f * smooth_step(0, 0.2f, from_end)};
    case HATCH_BRUSH_CHARCOAL:
        return (struct pressure){0.7f + 0.3f * smooth_step(0, 0.2f, from_end),
                                 0.6f + 0.4f * smooth_step(0, 0.3f, from_end)};
    case HATCH_BRUSH_STIPPLE: { /* a disc */
        float x = 2 * s - 1;
        return (struct pressure){sqrtf(1 - x * x), 1};
    }
    default:
        return (struct pressure){1, 1};
    }
}

/* Returns the width of the fall-off at the edge, as a share of half the stroke's width. */
static float edge_softness(enum hatch_brush_kind kind)
{
    switch (kind) {
    case HATCH_BRUSH_PENCIL:
        return 0.8f;
    case HATCH_BRUSH_CRAYON:
        return 0.5f;
    case HATCH_BRUSH_CHARCOAL:
        return 0.7f;
    default:
        return 2.0f / (float)ENVELOPE_HEIGHT;
    }
}

static void draw_envelope(struct hatch_brush *brush)
{
    float softness = edge_softness(brush->kind);
    for (uint32_t x = 0; x < brush->width; x++) {
        struct pressure p = pressure_at(brush->kind, ((float)x + 0.5f) / (float)brush->width);
        for (uint32_t y = 0; y < brush->height; y++) {
            float across = fabsf(2 * ((float)y + 0.5f) / (float)brush->height - 1);
            float inside = smooth_step(0, softness, (p.thickness - across) + softness / 2);
            brush->alpha[y * brush->width + x] = p.alpha * inside;
        }
    }
}

/* Returns toroidal value noise, 0 .. 1.
 *   cell  side of a noise cell in pixels, a divisor of HATCH_GRAIN_SIZE */
static float value_noise(uint32_t x, uint32_t y, uint32_t cell, uint64_t stream)
{
    uint32_t cells = HATCH_GRAIN_SIZE / cell;
    float corner[2][2];
    for (uint32_t j = 0; j < 2; j++)
        for (uint32_t i = 0; i < 2; i++) {
            uint32_t cx = (x / cell + i) % cells, cy = (y / cell + j) % cells;
            corner[j][i] = hatch_random_unit(0, stream, cy * cells + cx);
        }
    float u = smooth_step(0, 1, (float)(x % cell) / (float)cell);
    float v = smooth_step(0, 1, (float)(y % cell) / (float)cell);
    float top = corner[0][0] + (corner[0][1] - corner[0][0]) * u;
    float bottom = corner[1][0] + (corner[1][1] - corner[1][0]) * u;
    return top + (bottom - top) * v;
}

/* Draws the tooth of the paper: less ink where noise is below a threshold. */
static void draw_grain(struct hatch_brush *brush)
{
    struct {
        uint32_t cell;
        float threshold, softness, floor;
    } look = {2, 0.35f, 0.5f, 0.45f};
    if (brush->kind == HATCH_BRUSH_CRAYON) {
        look.threshold = 0.42f;
        look.softness = 0.3f;
        look.floor = 0.15f;
    } else if (brush->kind == HATCH_BRUSH_CHARCOAL) {
        look.threshold = 0.42f;
        look.softness = 0.6f;
        look.floor = 0.2f;
    }
    for (uint32_t y = 0; y < HATCH_GRAIN_SIZE; y++)
        for (uint32_t x = 0; x < HATCH_GRAIN_SIZE; x++) {
            float tooth = 0.65f * value_noise(x, y, look.cell, 1) + 0.35f * value_noise(x, y, 2 * look.cell, 2);
            float held = smooth_step(look.threshold - look.softness / 2, look.threshold + look.softness / 2, tooth);
            brush->grain[y * HATCH_GRAIN_SIZE + x] = look.floor + (1 - look.floor) * held;
        }
}

/* Computes running sums across the stroke; the difference of two is a box filter. */
static enum hatch_status accumulate(struct hatch_arena *arena, struct hatch_brush *brush, struct hatch_err *err)
{
    uint32_t rows = brush->height + 1;
    HATCH_TRY(HATCH_ALLOC(arena, &brush->cumulative, (size_t)brush->width * rows, err));
    for (uint32_t x = 0; x < brush->width; x++) {
        float sum = 0;
        for (uint32_t y = 0; y < brush->height; y++) {
            sum += brush->alpha[(size_t)y * brush->width + x];
            brush->cumulative[(size_t)x * rows + y + 1] = sum / (float)brush->height;
        }
    }
    return HATCH_OK;
}

enum hatch_status hatch_brush_make(enum hatch_brush_kind kind, struct hatch_arena *arena, struct hatch_brush *brush,
                                   struct hatch_err *err)
{
    assert(kind < HATCH_BRUSH_IMAGE);
    struct hatch_brush made = {.kind = kind, .width = ENVELOPE_WIDTH, .height = ENVELOPE_HEIGHT};
    HATCH_TRY(HATCH_ALLOC(arena, &made.alpha, made.width * made.height, err));
    draw_envelope(&made);
    if (kind == HATCH_BRUSH_PENCIL || kind == HATCH_BRUSH_CRAYON || kind == HATCH_BRUSH_CHARCOAL) {
        HATCH_TRY(HATCH_ALLOC(arena, &made.grain, HATCH_GRAIN_SIZE * HATCH_GRAIN_SIZE, err));
        draw_grain(&made);
    }
    HATCH_TRY(accumulate(arena, &made, err));
    *brush = made;
    return HATCH_OK;
}

static float ink_at(const struct hatch_image *image, size_t pixel, int alpha)
{
    const float *p = image->pixels + pixel * image->channel_count;
    float paper = image->channel_count >= 3 ? hatch_color_luminance(p) : p[0];
    float ink = alpha >= 0 ? p[alpha] : 1 - paper;
    return ink > 0 ? (ink < 1 ? ink : 1) : 0; /* NaN becomes 0 */
}

/* Returns the index of the A channel if its values vary, else -1. */
static int varying_alpha(const struct hatch_image *image, size_t pixels)
{
    int alpha = hatch_image_channel(image, "A");
    if (alpha < 0)
        return -1;
    for (size_t i = 1; i < pixels; i++)
        if (image->pixels[i * image->channel_count + (size_t)alpha] != image->pixels[alpha])
            return alpha;
    return -1;
}

enum hatch_status hatch_brush_from_image(const struct hatch_image *image, struct hatch_arena *arena,
                                         struct hatch_brush *brush, struct hatch_err *err)
{
    size_t pixels = (size_t)image->width * image->height;
    struct hatch_brush made = {.kind = HATCH_BRUSH_IMAGE, .width = image->width, .height = image->height};
    HATCH_TRY(HATCH_ALLOC(arena, &made.alpha, pixels, err));
    int alpha = varying_alpha(image, pixels);
    float darkest = 0;
    for (size_t i = 0; i < pixels; i++) {
        made.alpha[i] = ink_at(image, i, alpha);
        darkest = made.alpha[i] > darkest ? made.alpha[i] : darkest;
    }
    if (!(darkest > 0))
        return hatch_fail(err, HATCH_BAD_INPUT, "the stroke image has no ink: every pixel is white");
    HATCH_TRY(accumulate(arena, &made, err));
    *brush = made;
    return HATCH_OK;
}
