#include "placement/potential.h"

#include <math.h>
#include <string.h>

#include "stroke/path.h"

static float *ink_shares(float *share, uint32_t parts)
{
    return share + (size_t)parts * (parts - 1) / 2;
}

/* Computes the distribution of the brush's ink over equal parts of its length. */
static void fill_ink_shares(const struct hatch_brush *brush, uint32_t parts, float *share)
{
    double ink[HATCH_POTENTIAL_PARTS] = {0}, total = 0;
    for (uint64_t x = 0; x < brush->width; x++) {
        double alpha = (double)brush->cumulative[(x + 1) * (brush->height + 1) - 1];
        uint64_t from = x * parts, to = from + parts; /* of the brush column, in units of 1 / (width * parts) */
        for (uint64_t i = from / brush->width; i * brush->width < to; i++) {
            uint64_t begin = i * brush->width, end = begin + brush->width;
            uint64_t covered = (end < to ? end : to) - (begin > from ? begin : from);
            ink[i] += alpha * (double)covered;
            total += alpha * (double)covered;
        }
    }
    for (uint32_t i = 0; i < parts; i++)
        share[i] = (float)(ink[i] / total);
}

enum hatch_status hatch_potential_make(struct hatch_arena *arena, uint32_t canvas_size_px, uint32_t levels,
                                       const struct hatch_brush *brush, struct hatch_potential *field,
                                       struct hatch_err *err)
{
    struct hatch_potential made = {.canvas_size_px = canvas_size_px, .levels = levels, .reach = levels};
    /* Measured: cells of 2 pixels at 256, 4 at 1024 and 8 at 4096 pixels give strokes as even as finer ones, in a
     * fraction of the time. */
    made.size = canvas_size_px / 4;
    if (made.size < 128)
        made.size = canvas_size_px < 128 ? canvas_size_px : 128;
    if (made.size > 512)
        made.size = 512;
    size_t cells = (size_t)made.size * made.size;
    HATCH_TRY(HATCH_ALLOC(arena, &made.potential, cells, err));
    HATCH_TRY(HATCH_ALLOC(arena, &made.row, made.size + 2, err));
    HATCH_TRY(HATCH_ALLOC(arena, &made.used, made.size, err));
    HATCH_TRY(HATCH_ALLOC(arena, &made.share, HATCH_POTENTIAL_PARTS * (HATCH_POTENTIAL_PARTS + 1) / 2, err));
    for (uint32_t parts = 1; parts <= HATCH_POTENTIAL_PARTS; parts++)
        fill_ink_shares(brush, parts, ink_shares(made.share, parts));
    for (uint32_t size = made.size; size >= 2; size /= 2) {
        float *octave;
        HATCH_TRY(HATCH_ALLOC(arena, &octave, (size_t)size * size, err));
        made.octave[made.octaves++] = octave;
    }
    for (uint32_t level = 0; level < levels; level++) {
        uint32_t size = canvas_size_px >> level, grid = size < made.size ? size : made.size;
        made.grid[level] = grid;
        HATCH_TRY(HATCH_ALLOC(arena, &made.darkness[level], (size_t)grid * grid, err));
    }
    *field = made;
    return HATCH_OK;
}

/* Returns the weight of a level. A stroke of width_px covers width_px / size of the tile, so a coarser level weighs
 * more, as in the sum of the paper. */
static float level_weight(uint32_t size_px)
{
    return 1.0f / (float)size_px;
}

/* Adds amount to the cells of the field under one cell of a level's grid. */
static void deposit(struct hatch_potential *field, uint32_t grid, uint32_t x, uint32_t y, float amount)
{
    uint32_t cells = field->size / grid;
    for (uint32_t j = 0; j < cells; j++) {
        float *row = field->octave[0] + (size_t)(y * cells + j) * field->size + (size_t)x * cells;
        field->used[y * cells + j] = true;
        for (uint32_t i = 0; i < cells; i++)
            row[i] += amount;
    }
}

void hatch_potential_deposit(struct hatch_potential *field, const struct hatch_canvas *canvas, uint32_t level)
{
    uint32_t size_px = hatch_canvas_size(canvas, level), grid = field->grid[level];
    uint32_t px_per_cell = size_px / grid;
    float share = 1.0f / (float)(px_per_cell * px_per_cell), weight = level_weight(size_px);
    const struct hatch_footprint *f = &canvas->footprint;
    for (uint32_t i = 0; i < f->count; i++) {
        uint32_t x = f->at[i] % size_px / px_per_cell, y = f->at[i] / size_px / px_per_cell;
        float amount = canvas->change[i] * share;
        field->darkness[level][y * grid + x] += amount;
        if (level < field->reach)
            deposit(field, grid, x, y, amount * weight);
    }
}

/* Adds the darkness of a level to the field. Each cell of the level's grid is repeated over the cells of the field that
 * it covers. */
static void deposit_level(struct hatch_potential *field, uint32_t level)
{
    uint32_t size = field->size, grid = field->grid[level], cells = size / grid;
    float weight = level_weight(field->canvas_size_px >> level), *repeated = field->row;
    for (uint32_t y = 0; y < size; y++) {
        const float *from = field->darkness[level] + (size_t)(y / cells) * grid;
        float *row = field->octave[0] + (size_t)y * size;
        field->used[y] = true;
        for (uint32_t x = 0; cells == 1 && x < size; x++)
            repeated[x] = from[x] * weight;
        for (uint32_t x = 0; cells > 1 && y % cells == 0 && x < grid; x++)
            for (uint32_t i = 0; i < cells; i++)
                repeated[x * cells + i] = from[x] * weight;
        for (uint32_t x = 0; x < size; x++)
            row[x] += repeated[x];
    }
}

void hatch_potential_select(struct hatch_potential *field, uint32_t level)
{
    if (field->reach == level + 1)
        return;
    field->reach = level + 1;
    size_t cells = (size_t)field->size * field->size;
    memset(field->potential, 0, cells * sizeof *field->potential);
    for (uint32_t l = 0; l <= level; l++)
        deposit_level(field, l);
    hatch_potential_update(field);
}

/* Filters fine by (1 3 3 1) / 8 along both axes, on the torus, and halves its size. The filter is close to a Gaussian,
 * so the pyramid hardly depends on the position of its cells.
 *   used    rows of fine that are not all zero; NULL: all rows
 *   padded  scratch: size + 2 floats */
static void reduce(const float *fine, uint32_t size, const bool *used, float *padded, float *coarse)
{
    uint32_t half = size / 2, mask = size - 1;
    float *row = padded + 1;
    for (uint32_t y = 0; y < half; y++) {
        uint32_t above = (2 * y + mask) & mask, below = (2 * y + 2) & mask;
        float *out = coarse + (size_t)y * half;
        if (used && !used[above] && !used[2 * y] && !used[2 * y + 1] && !used[below]) {
            memset(out, 0, half * sizeof *out);
            continue;
        }
        const float *a = fine + (size_t)above * size, *b = fine + (size_t)(2 * y) * size;
        const float *c = b + size, *d = fine + (size_t)below * size;
        for (uint32_t x = 0; x < size; x++)
            row[x] = ((a[x] + d[x]) + 3 * (b[x] + c[x])) * 0.125f;
        row[-1] = row[mask];
        row[size] = row[0];
        for (uint32_t x = 0; x < half; x++)
            out[x] = ((padded[2 * x] + padded[2 * x + 3]) + 3 * (padded[2 * x + 1] + padded[2 * x + 2])) * 0.125f;
    }
}

/* Adds coarse to fine, interpolated linearly between the centres of the coarse cells. */
static void expand(const float *coarse, uint32_t half, float *padded, float *fine)
{
    uint32_t size = 2 * half, mask = half - 1;
    float *row = padded + 1;
    for (uint32_t y = 0; y < size; y++) {
        const float *near = coarse + (size_t)(y / 2) * half;
        const float *far = coarse + (size_t)(((y & 1) ? y / 2 + 1 : y / 2 + mask) & mask) * half;
        for (uint32_t x = 0; x < half; x++)
            row[x] = 0.75f * near[x] + 0.25f * far[x];
        row[-1] = row[mask];
        row[half] = row[0];
        float *out = fine + (size_t)y * size;
        for (uint32_t x = 0; x < half; x++) {
            out[2 * x] += 0.75f * padded[x + 1] + 0.25f * padded[x];
            out[2 * x + 1] += 0.75f * padded[x + 1] + 0.25f * padded[x + 2];
        }
    }
}

/* Moves the deposits at the finest scale to the potential. */
static void move_deposits(struct hatch_potential *field)
{
    for (uint32_t y = 0; y < field->size; y++) {
        float *from = field->octave[0] + (size_t)y * field->size;
        float *to = field->potential + (size_t)y * field->size;
        for (uint32_t x = 0; field->used[y] && x < field->size; x++)
            to[x] += from[x];
        if (field->used[y])
            memset(from, 0, field->size * sizeof *from);
        field->used[y] = false;
    }
}

void hatch_potential_update(struct hatch_potential *field)
{
    uint32_t last = field->octaves - 1;
    for (uint32_t o = 0; o < last; o++)
        reduce(field->octave[o], field->size >> o, o ? NULL : field->used, field->row, field->octave[o + 1]);
    for (uint32_t o = last; o-- > 1;)
        expand(field->octave[o + 1], field->size >> (o + 1), field->row, field->octave[o]);
    move_deposits(field);
    expand(field->octave[1], field->size / 2, field->row, field->potential);
}

/* Position of a sample on a stroke and the step to the next, in cells, 16.16 fixed point; the caller's mask wraps them
 * around the torus. */
struct walk {
    uint32_t x, y, step_x, step_y;
    float dx, dy, cosine, sine; /* of an arc: the next step, and the rotation from one step to the next */
};

static void set_step(struct walk *walk)
{
    walk->step_x = (uint32_t)(int32_t)(walk->dx * 65536.0f);
    walk->step_y = (uint32_t)(int32_t)(walk->dy * 65536.0f);
}

static void turn(struct walk *walk)
{
    float dx = walk->dx * walk->cosine - walk->dy * walk->sine;
    walk->dy = walk->dx * walk->sine + walk->dy * walk->cosine;
    walk->dx = dx;
    set_step(walk);
}

/* The steps of an arc are chords between its samples, which lie in the middles of equal parts. */
static void begin_arc(const struct hatch_stroke *stroke, float size, float cells, uint32_t samples, struct walk *walk)
{
    double angle = (double)stroke->bend_rad / samples, back = angle * (samples - 1) / 2;
    double radius = (double)cells / (double)stroke->bend_rad;
    double first = (double)stroke->angle_rad - back + angle / 2, chord = 2 * radius * sin(angle / 2);
    double aside = radius * (1 - cos(back)), before = -radius * sin(back);
    double cosine = cos((double)stroke->angle_rad), sine = sin((double)stroke->angle_rad);
    walk->dx = (float)(chord * cos(first));
    walk->dy = (float)(chord * sin(first));
    walk->cosine = (float)cos(angle);
    walk->sine = (float)sin(angle);
    walk->x = (uint32_t)(int32_t)((stroke->x * size + (float)(before * cosine - aside * sine)) * 65536.0f);
    walk->y = (uint32_t)(int32_t)((stroke->y * size + (float)(before * sine + aside * cosine)) * 65536.0f);
    set_step(walk);
}

static struct walk begin_walk(const struct hatch_stroke *stroke, float size, float cells, uint32_t samples)
{
    struct walk walk = {.dx = 0};
    if (stroke->bend_rad != 0) {
        begin_arc(stroke, size, cells, samples, &walk);
        return walk;
    }
    walk.dx = (float)cos((double)stroke->angle_rad) * cells / (float)samples;
    walk.dy = (float)sin((double)stroke->angle_rad) * cells / (float)samples;
    float back = ((float)samples - 1) / 2;
    walk.x = (uint32_t)(int32_t)((stroke->x * size - back * walk.dx) * 65536.0f);
    walk.y = (uint32_t)(int32_t)((stroke->y * size - back * walk.dy) * 65536.0f);
    set_step(&walk);
    return walk;
}

float hatch_potential_score(const struct hatch_potential *field, const struct hatch_stroke *stroke,
                            uint32_t samples_max)
{
    float size = (float)field->size;
    float cells = fminf(stroke->length, (float)HATCH_LINE_LENGTH_MAX) * size; /* paths may be longer */
    uint32_t samples = cells < 1 ? 1 : cells > (float)samples_max ? samples_max : (uint32_t)cells;
    struct walk walk = begin_walk(stroke, size, cells, samples);
    uint32_t mask = field->size - 1, parts = samples < HATCH_POTENTIAL_PARTS ? samples : HATCH_POTENTIAL_PARTS;
    const float *share = ink_shares(field->share, parts);
    float sum = 0, weight = 0;
    for (uint32_t i = 0; i < samples; i++) {
        float ink = share[parts == samples ? i : (uint64_t)i * parts / samples];
        sum += ink * field->potential[(walk.y >> 16 & mask) * field->size + (walk.x >> 16 & mask)];
        weight += ink;
        walk.x += walk.step_x;
        walk.y += walk.step_y;
        if (stroke->bend_rad != 0)
            turn(&walk);
    }
    return sum / weight;
}
