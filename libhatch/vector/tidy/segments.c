#include "vector/tidy/segments.h"

#include <math.h>

#define NONE UINT32_MAX
#define PARTS_MOST 1e6

/* A segment in a cell that it passes. */
struct entry {
    uint32_t segment;
    uint32_t next; /* entry of the same cell, or NONE */
};

enum hatch_status hatch_segments_make(const struct hatch_vector_paths *paths, double reach, struct hatch_arena *arena,
                                      struct hatch_segments *near, struct hatch_err *err)
{
    size_t points = hatch_vector_point_count(paths);
    struct hatch_segments made = {.entries = {.arena = arena}, .looked = {.arena = arena}};
    made.cells = hatch_vector_cells_over(paths->points, points, (double)points + 1, 2 * reach);
    size_t cells = (size_t)made.cells.columns * made.cells.rows;
    HATCH_TRY(HATCH_ALLOC(arena, &made.head, cells, err));
    for (size_t i = 0; i < cells; i++)
        made.head[i] = NONE;
    *near = made;
    return HATCH_OK;
}

/* A range of cells, with its ends. */
struct window {
    uint32_t low[2], high[2];
};

/* Returns how many parts a segment is divided into, so that the cells around each part are few. */
static uint32_t parts_of(const struct hatch_segments *near, const double a[2], const double b[2])
{
    return (uint32_t)fmin(ceil(hatch_vector_distance(a, b) / near->cells.side), PARTS_MOST) + 1;
}

/* Returns the cells around a part of a segment. */
static struct window window_of(const struct hatch_segments *near, const double a[2], const double b[2], uint32_t part,
                               uint32_t parts, double margin)
{
    struct window window;
    for (int k = 0; k < 2; k++) {
        double from = a[k] + (b[k] - a[k]) * part / parts, to = a[k] + (b[k] - a[k]) * (part + 1) / parts;
        window.low[k] = hatch_vector_cell(&near->cells, k, fmin(from, to) - margin);
        window.high[k] = hatch_vector_cell(&near->cells, k, fmax(from, to) + margin);
    }
    return window;
}

static uint32_t *head_at(const struct hatch_segments *near, uint32_t column, uint32_t row)
{
    return &near->head[(size_t)row * near->cells.columns + column];
}

/* Adds a segment to a cell, unless it was the last one to be added there. */
static enum hatch_status add_entry(struct hatch_segments *near, uint32_t segment, uint32_t *head, struct hatch_err *err)
{
    const struct entry *entries = (const void *)near->entries.data, entry = {segment, *head};
    if (*head != NONE && entries[*head].segment == segment)
        return HATCH_OK;
    HATCH_TRY(hatch_buffer_add(&near->entries, &entry, sizeof entry, err));
    *head = near->entry_count++;
    return HATCH_OK;
}

enum hatch_status hatch_segments_insert(struct hatch_segments *near, uint32_t segment, const double a[2],
                                        const double b[2], struct hatch_err *err)
{
    uint32_t parts = parts_of(near, a, b);
    size_t marks = ((size_t)segment + 1) * sizeof(uint32_t);
    if (near->looked.size < marks)
        HATCH_TRY(hatch_buffer_add(&near->looked, NULL, marks - near->looked.size, err));
    for (uint32_t part = 0; part < parts; part++) {
        const struct window window = window_of(near, a, b, part, parts, 0);
        for (uint32_t row = window.low[1]; row <= window.high[1]; row++)
            for (uint32_t column = window.low[0]; column <= window.high[0]; column++)
                HATCH_TRY(add_entry(near, segment, head_at(near, column, row), err));
    }
    return HATCH_OK;
}

/* Visits the segments of a cell that this search has not found yet. */
static enum hatch_status look(struct hatch_segments *near, uint32_t at, hatch_segments_visit visit, void *context,
                              struct hatch_err *err)
{
    const struct entry *entries = (const void *)near->entries.data;
    uint32_t *looked = (void *)near->looked.data;
    for (; at != NONE; at = entries[at].next) {
        uint32_t segment = entries[at].segment;
        if (looked[segment] == near->search)
            continue;
        looked[segment] = near->search;
        HATCH_TRY(visit(context, segment, err));
    }
    return HATCH_OK;
}

enum hatch_status hatch_segments_find(struct hatch_segments *near, const double a[2], const double b[2], double reach,
                                      hatch_segments_visit visit, void *context, struct hatch_err *err)
{
    uint32_t parts = parts_of(near, a, b);
    near->search++;
    for (uint32_t part = 0; part < parts; part++) {
        const struct window window = window_of(near, a, b, part, parts, reach);
        for (uint32_t row = window.low[1]; row <= window.high[1]; row++)
            for (uint32_t column = window.low[0]; column <= window.high[0]; column++)
                HATCH_TRY(look(near, *head_at(near, column, row), visit, context, err));
    }
    return HATCH_OK;
}
