#include <math.h>
#include <string.h>

#include "lapped/work.h"

/* How often a triangle is cut in four before it counts as bare: the gap is then below 1/64 of it. */
#define CUTS_MAX 6
/* And before it counts as shown. */
#define SHOW_CUTS_MAX 4

enum hatch_status hatch_cover_make(const struct hatch_outline *outline, uint32_t face_count, struct hatch_arena *arena,
                                   struct hatch_cover *cover, struct hatch_err *err)
{
    struct hatch_cover made = {.outline = outline, .arena = arena};
    made.covered = HATCH_NEW(arena, uint8_t, face_count, err);
    made.head = made.covered ? HATCH_NEW(arena, uint32_t, face_count, err) : NULL;
    if (!made.head)
        return HATCH_LIMIT;
    memset(made.head, 0xff, face_count * sizeof *made.head);
    *cover = made;
    return HATCH_OK;
}

/* The place of barycentric coordinates in a triangle. */
static void place_in(const double mask[3][2], const double bary[3], double at[2])
{
    for (int i = 0; i < 2; i++)
        at[i] = bary[0] * mask[0][i] + bary[1] * mask[1][i] + bary[2] * mask[2][i];
}

/* The middle of a part of a triangle, and how far its corners are from there. */
static double reach_of(const double mask[3][2], const double part[3][3], double middle[2])
{
    double bary[3], reach = 0;
    for (int i = 0; i < 3; i++)
        bary[i] = (part[0][i] + part[1][i] + part[2][i]) / 3;
    place_in(mask, bary, middle);
    for (int c = 0; c < 3; c++) {
        double corner[2];
        place_in(mask, part[c], corner);
        double x = corner[0] - middle[0], y = corner[1] - middle[1], away = x * x + y * y;
        reach = away > reach ? away : reach;
    }
    return sqrt(reach);
}

/* Whether one core holds a part of a triangle whole; *touched: whether it holds the part's middle. */
static bool holds_part(const struct hatch_outline *outline, const double mask[3][2], const double part[3][3],
                       bool *touched)
{
    double middle[2], reach = reach_of(mask, part, middle);
    double depth = hatch_outline_depth(outline, middle);
    *touched = *touched || depth > 0;
    return depth > 0 && depth >= reach;
}

/* Part `which` of a part cut in four. */
static void quarter(const double part[3][3], int which, double out[3][3])
{
    for (int c = 0; c < 3; c++) {
        int a = which == 3 ? c : which, b = which == 3 ? (c + 1) % 3 : c;
        for (int i = 0; i < 3; i++)
            out[c][i] = (part[a][i] + part[b][i]) / 2;
    }
}

struct union_of {
    const struct hatch_outline *outline;
    const struct hatch_cover_entry *entries;
    uint32_t head;
};

static bool union_holds(const struct union_of *of, const double part[3][3], int cuts)
{
    bool touched = false;
    for (uint32_t e = of->head; e != UINT32_MAX; e = of->entries[e].next)
        if (holds_part(of->outline, of->entries[e].mask, part, &touched))
            return true;
    if (!touched || cuts == CUTS_MAX)
        return false;
    for (int which = 0; which < 4; which++) {
        double smaller[3][3];
        quarter(part, which, smaller);
        if (!union_holds(of, (const double(*)[3])smaller, cuts + 1))
            return false;
    }
    return true;
}

static const double WHOLE[3][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};

/* Corners first: most faces that are not covered have a bare one. */
static bool corners_held(const struct union_of *of)
{
    for (int c = 0; c < 3; c++) {
        bool held = false;
        for (uint32_t e = of->head; e != UINT32_MAX && !held; e = of->entries[e].next)
            held = hatch_outline_depth(of->outline, of->entries[e].mask[c]) > 0;
        if (!held)
            return false;
    }
    return true;
}

/* Whether opacity over 0 may be found in a part of a triangle where no earlier core lies over it. Never
 * false where it is. */
static bool may_show(const struct union_of *of, const double mask[3][2], const double part[3][3], int cuts)
{
    double middle[2], reach = reach_of(mask, part, middle);
    double gap = hatch_outline_distance(of->outline, middle);
    bool hidden = false;
    if (gap > reach)
        return false;
    for (uint32_t e = of->head; e != UINT32_MAX; e = of->entries[e].next)
        if (holds_part(of->outline, of->entries[e].mask, part, &hidden))
            return false;
    if ((gap <= 0 && !hidden) || cuts == SHOW_CUTS_MAX)
        return true;
    for (int which = 0; which < 4; which++) {
        double smaller[3][3];
        quarter(part, which, smaller);
        if (may_show(of, mask, (const double(*)[3])smaller, cuts + 1))
            return true;
    }
    return false;
}

/* Whether the circle in the core holds a triangle: most are settled by that. */
static bool circle_holds(const struct hatch_outline *outline, const double mask[3][2])
{
    double least = outline->core_min * outline->core_min;
    for (int c = 0; c < 3; c++) {
        double x = mask[c][0] - 0.5, y = mask[c][1] - 0.5;
        if (!(x * x + y * y < least))
            return false;
    }
    return true;
}

enum hatch_status hatch_cover_add(struct hatch_cover *cover, uint32_t face, const double mask[3][2], bool *shows,
                                  struct hatch_err *err)
{
    struct union_of of = {cover->outline, cover->entries, cover->head[face]};
    if (!cover->covered[face] && circle_holds(cover->outline, mask)) {
        cover->covered[face] = 1;
        *shows = true;
        return HATCH_OK;
    }
    *shows = !cover->covered[face] && may_show(&of, mask, WHOLE, 0);
    if (!*shows)
        return HATCH_OK;
    void *entries = cover->entries;
    HATCH_TRY(hatch_heap_reserve(cover->arena, &entries, &cover->entry_room, cover->entry_count + 1,
                                 sizeof *cover->entries, err));
    cover->entries = entries;
    struct hatch_cover_entry *entry = &cover->entries[cover->entry_count];
    entry->next = cover->head[face];
    memcpy(entry->mask, mask, sizeof entry->mask);
    cover->head[face] = cover->entry_count;
    of = (struct union_of){cover->outline, cover->entries, cover->entry_count};
    cover->covered[face] = corners_held(&of) && union_holds(&of, WHOLE, 0);
    /* A face that is covered needs no entries. */
    if (!cover->covered[face])
        cover->entry_count++;
    return HATCH_OK;
}
