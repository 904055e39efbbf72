#include "vector/sight.h"

#include <stdlib.h>
#include <string.h>

#include "math/range.h"
#include "math/vector.h"

#define SIDE_PX 1e-7 /* occluders reach beyond their sides by this much, so that there is no gap between neighbours */
#define GAP_PX 1e-3  /* shorter visible parts between hidden ones are due to rounding */

enum hatch_status hatch_sight_make(const struct hatch_occluders *occluders, struct hatch_arena *arena,
                                   struct hatch_sight *sight, struct hatch_err *err)
{
    struct hatch_sight made = {.occluders = occluders, .arena = arena, .room = 64};
    HATCH_TRY(HATCH_ALLOC(arena, &made.parts, made.room, err));
    HATCH_TRY(HATCH_ALLOC(arena, &made.open, (size_t)occluders->most + 1, err));
    *sight = made;
    return HATCH_OK;
}

/* Narrows begin .. end to what an occluder hides. Returns false if it hides nothing of it. */
static bool hides(const struct hatch_occluders *occluders, const struct hatch_occluder *occluder,
                  const struct hatch_sight_line *line, double *begin, double *end)
{
    double near[2];
    for (int c = 0; c < 3; c++) {
        const double *side = occluder->sides[c];
        if (!hatch_range_keep(hatch_occluder_value(side, line->at[0]) + SIDE_PX,
                              hatch_occluder_value(side, line->at[1]) + SIDE_PX, begin, end))
            return false;
    }
    for (int i = 0; i < 2; i++)
        near[i] = hatch_occluder_value(occluder->nearness, line->at[i]);
    return hatch_range_keep(near[0] - line->limit[0], near[1] - line->limit[1], begin, end) &&
           hatch_range_keep(occluders->nearest - near[0], occluders->nearest - near[1], begin, end) && *begin < *end;
}

/* Returns whether a face is one that an end of the segment lies on, or is beside it. */
static bool is_own(const struct hatch_occluders *occluders, uint32_t face, const struct hatch_sight_line *line)
{
    for (int i = 0; i < 2; i++) {
        uint32_t own = line->faces[i];
        if (own == face)
            return true;
        if (own != HATCH_NONE && occluders->facing[own] == occluders->facing[face] &&
            hatch_occluders_touch(occluders, own, face))
            return true;
    }
    return false;
}

/* Removes begin .. end from the open parts of a cell. Returns their new number. */
static uint32_t remove_part(double (*open)[2], uint32_t count, double begin, double end)
{
    uint32_t from = 0, to;
    while (from < count && open[from][1] <= begin)
        from++;
    to = from;
    while (to < count && open[to][0] < end)
        to++;
    if (from == to)
        return count;
    const double left[2] = {open[from][0], begin}, right[2] = {end, open[to - 1][1]};
    uint32_t kept = (left[0] < left[1] ? 1u : 0u) + (right[0] < right[1] ? 1u : 0u);
    memmove(&open[from + kept], &open[to], (count - to) * sizeof *open);
    if (left[0] < left[1])
        memcpy(open[from], left, sizeof left);
    if (right[0] < right[1])
        memcpy(open[from + kept - 1], right, sizeof right);
    return count + kept - (to - from);
}

/* Finds what is visible of begin .. end, the segment's part in a cell. Returns the number of open parts. */
static uint32_t look(const struct hatch_sight *sight, const struct hatch_sight_line *line, uint32_t cell, double begin,
                     double end)
{
    const struct hatch_occluders *occluders = sight->occluders;
    double change = line->limit[1] - line->limit[0];
    double least = line->limit[0] + fmin(begin * change, end * change);
    uint32_t count = 1;
    sight->open[0][0] = begin;
    sight->open[0][1] = end;
    for (uint32_t i = occluders->first[cell]; i < occluders->first[cell + 1] && count; i++) {
        const struct hatch_occluder *occluder = &occluders->at[occluders->listed[i]];
        double from = begin, to = end;
        if (occluder->nearest <= least)
            break;
        if (hides(occluders, occluder, line, &from, &to) && !is_own(occluders, occluder->face, line))
            count = remove_part(sight->open, count, from, to);
    }
    return count;
}

/* Appends the open parts of a cell to the visible parts of the segment. */
static enum hatch_status append(struct hatch_sight *sight, uint32_t count, struct hatch_err *err)
{
    if (sight->count + count > sight->room) {
        uint32_t room = 2 * (sight->count + count);
        double(*parts)[2];
        HATCH_TRY(HATCH_ALLOC(sight->arena, &parts, room, err));
        memcpy(parts, sight->parts, sight->count * sizeof *parts);
        sight->parts = parts;
        sight->room = room;
    }
    for (uint32_t i = 0; i < count; i++) {
        double *last = sight->count ? sight->parts[sight->count - 1] : NULL;
        if (last && sight->open[i][0] >= last[1] && sight->open[i][0] <= last[1])
            last[1] = sight->open[i][1];
        else
            memcpy(sight->parts[sight->count++], sight->open[i], sizeof *sight->parts);
    }
    return HATCH_OK;
}

/* Drops parts that are due to rounding, on a segment of a length in pixels. */
static void drop_gaps(struct hatch_sight *sight, double length_px)
{
    uint32_t kept = 0;
    for (uint32_t i = 0; i < sight->count; i++) {
        const double *part = sight->parts[i];
        bool touches_end = part[0] <= 0 || part[1] >= 1;
        if (touches_end || (part[1] - part[0]) * length_px > GAP_PX)
            memcpy(sight->parts[kept++], part, sizeof *sight->parts);
    }
    sight->count = kept;
}

/* Appends the visible parts of a segment, which does not move sideways. */
static enum hatch_status find(struct hatch_sight *sight, const struct hatch_sight_line *line, struct hatch_err *err)
{
    const struct hatch_occluders *occluders = sight->occluders;
    const struct hatch_vector_cells *cells = &occluders->cells;
    uint32_t cell[2], last[2];
    double next[2], step[2], at = 0; /* next: where the segment leaves its column, its row */
    int turn[2];
    for (int k = 0; k < 2; k++) {
        double along = line->at[1][k] - line->at[0][k];
        cell[k] = hatch_vector_cell(cells, k, line->at[0][k]);
        last[k] = hatch_vector_cell(cells, k, line->at[1][k]);
        turn[k] = along < 0 ? -1 : 1;
        step[k] = cells->side / fabs(along);
        next[k] =
            last[k] == cell[k] ? INFINITY : ((cell[k] + (along > 0 ? 1 : 0)) * cells->side - line->at[0][k]) / along;
    }
    for (;;) {
        int k = next[0] < next[1] ? 0 : 1;
        double end = fmax(fmin(next[k], 1), at);
        HATCH_TRY(append(sight, look(sight, line, cell[1] * cells->columns + cell[0], at, end), err));
        if (isinf(next[k]))
            return HATCH_OK;
        at = end;
        cell[k] += (uint32_t)turn[k];
        next[k] = cell[k] == last[k] ? INFINITY : next[k] + step[k];
    }
}

static int compare(const void *a, const void *b)
{
    const double *x = a, *y = b;
    return (*x > *y) - (*x < *y);
}

/* Unites parts that overlap, in ascending order. */
static void unite(struct hatch_sight *sight)
{
    uint32_t kept = 0;
    qsort(sight->parts, sight->count, sizeof *sight->parts, compare);
    for (uint32_t i = 0; i < sight->count; i++) {
        double *part = sight->parts[i], *last = kept ? sight->parts[kept - 1] : NULL;
        if (last && part[0] <= last[1])
            last[1] = fmax(last[1], part[1]);
        else
            memmove(sight->parts[kept++], part, sizeof *sight->parts);
    }
    sight->count = kept;
}

enum hatch_status hatch_sight_find(struct hatch_sight *sight, const struct hatch_sight_line *line,
                                   struct hatch_err *err)
{
    double x = line->at[1][0] - line->at[0][0], y = line->at[1][1] - line->at[0][1], length_px = hypot(x, y);
    sight->count = 0;
    HATCH_TRY(find(sight, line, err));
    bool whole = sight->count == 1 && sight->parts[0][0] <= 0 && sight->parts[0][1] >= 1;
    for (int turn = -1; turn <= 1 && !whole && line->reach_px > 0 && length_px > 0; turn += 2) {
        double across[2] = {-turn * line->reach_px * y / length_px, turn * line->reach_px * x / length_px};
        struct hatch_sight_line beside = *line;
        for (int i = 0; i < 2; i++)
            for (int k = 0; k < 2; k++)
                beside.at[i][k] += across[k];
        HATCH_TRY(find(sight, &beside, err));
    }
    unite(sight);
    drop_gaps(sight, length_px);
    return HATCH_OK;
}
