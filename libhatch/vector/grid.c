#include "vector/grid.h"

#include "math/range.h"
#include "math/vector.h"

#define FACES_PER_CELL 2.0 /* mean number that the size of cells is chosen for */
#define CELLS_LEAST 1024.0
#define CELLS_MOST 1048576.0
#define ENTRIES_PER_FACE 12u   /* cells are made larger if there would be more entries on average */
#define ENTRIES_LEAST 4000000u /* number of entries that is always allowed */
#define CELL_MARGIN_PX 1e-4    /* occluders are listed in cells that they miss by less: more than rounding errors */

/* A range of cells. */
struct cells {
    uint32_t left, right, below, above; /* with right and above */
};

/* Computes the bounding box of an occluder's part before the near plane. Returns false if it is outside the picture. */
static bool box_of(const struct hatch_occluders *occluders, const struct hatch_occluder *occluder, struct cells *cells)
{
    bool flat = occluders->view.orthographic;
    double low[2] = {INFINITY, INFINITY}, high[2] = {-INFINITY, -INFINITY};
    double near = flat ? -occluders->nearest : 1 / occluders->nearest;
    for (uint32_t c = 0; c < 3; c++) {
        const uint32_t *corners = &occluders->corners[3 * (size_t)occluder->face];
        const double *a = &occluders->points[3 * (size_t)corners[c]];
        const double *b = &occluders->points[3 * (size_t)corners[(c + 1) % 3]];
        double begin = 0, end = 1;
        if (!hatch_range_keep(a[2] - near, b[2] - near, &begin, &end))
            continue;
        const double stops[2] = {begin, end};
        for (int i = 0; i < 2; i++) {
            double w = flat ? 1 : fmax(a[2] + stops[i] * (b[2] - a[2]), near);
            for (int k = 0; k < 2; k++) {
                double at = (a[k] + stops[i] * (b[k] - a[k])) / w;
                low[k] = fmin(low[k], at);
                high[k] = fmax(high[k], at);
            }
        }
    }
    const struct hatch_vector_cells *all = &occluders->cells;
    double margin = CELL_MARGIN_PX;
    if (!(low[0] <= occluders->width_px + margin && low[1] <= occluders->height_px + margin && high[0] >= -margin &&
          high[1] >= -margin))
        return false;
    *cells = (struct cells){.left = hatch_vector_cell(all, 0, low[0] - margin),
                            .right = hatch_vector_cell(all, 0, high[0] + margin),
                            .below = hatch_vector_cell(all, 1, low[1] - margin),
                            .above = hatch_vector_cell(all, 1, high[1] + margin)};
    return true;
}

/* Returns whether an occluder may reach into a cell: whether no side has the whole cell outside. */
static bool reaches(const struct hatch_occluders *occluders, const struct hatch_occluder *occluder, uint32_t column,
                    uint32_t row)
{
    double half = 0.5 * occluders->cells.side, x = (2 * column + 1) * half, y = (2 * row + 1) * half;
    for (int c = 0; c < 3; c++) {
        const double *side = occluder->sides[c];
        double most = side[0] * x + side[1] * y + side[2] + half * (fabs(side[0]) + fabs(side[1]));
        if (most < -CELL_MARGIN_PX)
            return false;
    }
    return true;
}

/* Goes through the cells of all occluders. Counts entries in first[cell + 1], or, if `listed` is made, puts occluders
 * there and moves first[cell + 1] on. Stops when the number of entries exceeds a limit, and returns it. */
static uint64_t go_through(struct hatch_occluders *occluders, uint64_t limit)
{
    uint64_t entries = 0;
    struct cells cells;
    for (uint32_t i = 0; i < occluders->count && entries <= limit; i++) {
        const struct hatch_occluder *occluder = &occluders->at[i];
        if (!box_of(occluders, occluder, &cells))
            continue;
        for (uint32_t row = cells.below; row <= cells.above; row++)
            for (uint32_t column = cells.left; column <= cells.right; column++) {
                if (!reaches(occluders, occluder, column, row))
                    continue;
                uint32_t *next = &occluders->first[(size_t)row * occluders->cells.columns + column + 1];
                if (occluders->listed)
                    occluders->listed[*next] = i;
                ++*next;
                entries++;
            }
    }
    return entries;
}

/* Turns the numbers of entries into the begins of ranges: first[cell + 1] becomes the begin of the cell's range. */
static void begin_ranges(struct hatch_occluders *occluders)
{
    uint32_t at = 0;
    for (size_t cell = 0; cell < (size_t)occluders->cells.columns * occluders->cells.rows; cell++) {
        uint32_t count = occluders->first[cell + 1];
        occluders->most = count > occluders->most ? count : occluders->most;
        occluders->first[cell + 1] = at;
        at += count;
    }
}

enum hatch_status hatch_occluders_list(struct hatch_occluders *occluders, struct hatch_arena *arena,
                                       struct hatch_arena *scratch, struct hatch_err *err)
{
    double cells = fmin(fmax(occluders->count / FACES_PER_CELL, CELLS_LEAST), CELLS_MOST);
    uint64_t limit = (uint64_t)ENTRIES_PER_FACE * occluders->count + ENTRIES_LEAST, entries;
    occluders->cells.side = sqrt(occluders->width_px * occluders->height_px / cells);
    for (;; occluders->cells.side *= 2) {
        struct hatch_arena_mark mark = hatch_arena_mark(scratch);
        occluders->cells.columns = (uint32_t)ceil(occluders->width_px / occluders->cells.side);
        occluders->cells.rows = (uint32_t)ceil(occluders->height_px / occluders->cells.side);
        size_t count = (size_t)occluders->cells.columns * occluders->cells.rows;
        HATCH_TRY(HATCH_ALLOC(scratch, &occluders->first, count + 1, err));
        entries = go_through(occluders, count > 1 ? limit : UINT32_MAX);
        hatch_arena_rewind(scratch, mark);
        if (entries <= limit || count <= 1)
            break;
    }
    size_t count = (size_t)occluders->cells.columns * occluders->cells.rows;
    HATCH_TRY(HATCH_ALLOC(arena, &occluders->first, count + 1, err));
    go_through(occluders, UINT64_MAX);
    begin_ranges(occluders);
    HATCH_TRY(HATCH_ALLOC(arena, &occluders->listed, entries, err));
    go_through(occluders, UINT64_MAX);
    return HATCH_OK;
}
