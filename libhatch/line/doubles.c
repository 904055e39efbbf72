/* Hides short parts of lines that run along longer ones. */
#include "base/random.h"
#include "line/strip.h"

#define BESIDE_PX 2.0 /* distance between the middles of pieces that run along one another; side of a cell */
/* Length of parts that may be hidden. With the length of a fold it is less than HATCH_LINES_REACH_PX, so that all tiles
 * agree. */
#define SHORT_PX 20.0
#define ALONGSIDE 0.9 /* share of a part that must run along longer ones */

/* Parts are runs of visible and bridged pieces. */
struct work {
    const struct hatch_line_strips *strips;
    uint32_t *part; /* per piece: its part + 1; 0: none */
    double *length; /* per part */
    uint32_t part_count;
    uint32_t mask;         /* cells are numbered by a hash value of these bits, so that several may share a number */
    uint32_t *head, *next; /* per number: its first piece + 1; per piece: the next one + 1; 0: none */
};

static double length_of(const struct hatch_line_piece *piece)
{
    double x = (double)(piece->b[0] - piece->a[0]), y = (double)(piece->b[1] - piece->a[1]);
    return sqrt(x * x + y * y);
}

/* Numbers the parts and measures them. The two at the ends of a closed strip are one if they meet. */
static void find_parts(struct work *w, const uint8_t *visible)
{
    for (uint32_t s = 0; s < w->strips->strip_count; s++) {
        const struct hatch_line_strip *strip = &w->strips->strips[s];
        uint32_t first = strip->first, end = first + strip->count, last_part = 0;
        for (uint32_t i = first; i < end; i++) {
            if (visible[i] && (i == first || !visible[i - 1]))
                last_part = ++w->part_count;
            w->part[i] = visible[i] ? last_part : 0;
        }
        for (uint32_t i = end; strip->closed && w->part[first] && i > first && visible[i - 1]; i--)
            w->part[i - 1] = w->part[first];
        for (uint32_t i = first; i < end; i++)
            if (visible[i] == HATCH_LINE_VISIBLE)
                w->length[w->part[i] - 1] += length_of(&w->strips->pieces[i]);
    }
}

static uint32_t cell_at(const struct work *w, double x, double y)
{
    uint64_t column = (uint64_t)(int64_t)floor(x / BESIDE_PX), row = (uint64_t)(int64_t)floor(y / BESIDE_PX);
    return (uint32_t)hatch_random_mix(column << 32 ^ row) & w->mask;
}

static void fill_cells(struct work *w, const uint8_t *visible)
{
    for (uint32_t i = 0; i < w->strips->piece_count; i++) {
        const float *at = w->strips->samples[i].at;
        if (visible[i] != HATCH_LINE_VISIBLE)
            continue;
        uint32_t cell = cell_at(w, (double)at[0], (double)at[1]);
        w->next[i] = w->head[cell];
        w->head[cell] = i + 1;
    }
}

/* Returns whether a longer part runs beside a piece; of two equally long ones the first counts as longer. */
static bool is_doubled(const struct work *w, uint32_t piece)
{
    const float *at = w->strips->samples[piece].at;
    uint32_t part = w->part[piece] - 1;
    for (int k = 0; k < 9; k++) {
        uint32_t cell = cell_at(w, (double)at[0] + BESIDE_PX * (k % 3 - 1), (double)at[1] + BESIDE_PX * (k / 3 - 1));
        for (uint32_t i = w->head[cell]; i; i = w->next[i - 1]) {
            const float *other = w->strips->samples[i - 1].at;
            uint32_t that = w->part[i - 1] - 1;
            double x = (double)(other[0] - at[0]), y = (double)(other[1] - at[1]);
            bool longer = w->length[that] > w->length[part] || (w->length[that] == w->length[part] && that < part);
            if (longer && x * x + y * y < BESIDE_PX * BESIDE_PX)
                return true;
        }
    }
    return false;
}

static enum hatch_status drop(struct work *w, uint8_t *visible, struct hatch_arena *arena, struct hatch_err *err)
{
    uint32_t count = w->strips->piece_count;
    double *doubled; /* per part: length that runs along longer ones */
    HATCH_TRY(HATCH_ALLOC(arena, &w->part, count, err));
    HATCH_TRY(HATCH_ALLOC(arena, &w->length, count, err));
    HATCH_TRY(HATCH_ALLOC(arena, &doubled, count, err));
    for (w->mask = 1; w->mask < count; w->mask = 2 * w->mask + 1)
        ;
    HATCH_TRY(HATCH_ALLOC(arena, &w->head, (size_t)w->mask + 1, err));
    HATCH_TRY(HATCH_ALLOC(arena, &w->next, count, err));
    find_parts(w, visible);
    fill_cells(w, visible);
    for (uint32_t i = 0; i < count; i++)
        if (visible[i] == HATCH_LINE_VISIBLE && w->length[w->part[i] - 1] < SHORT_PX && is_doubled(w, i))
            doubled[w->part[i] - 1] += length_of(&w->strips->pieces[i]);
    for (uint32_t i = 0; i < count; i++)
        if (w->part[i] && doubled[w->part[i] - 1] > ALONGSIDE * w->length[w->part[i] - 1])
            visible[i] = 0;
    return HATCH_OK;
}

enum hatch_status hatch_line_strips_drop_doubles(const struct hatch_line_strips *strips, uint8_t *visible,
                                                 struct hatch_arena *arena, struct hatch_err *err)
{
    struct hatch_arena_mark mark = hatch_arena_mark(arena);
    struct work work = {.strips = strips};
    enum hatch_status status = drop(&work, visible, arena, err);
    hatch_arena_rewind(arena, mark);
    return status;
}
