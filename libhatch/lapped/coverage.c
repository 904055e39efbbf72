#include <math.h>
#include <string.h>

#include "lapped/work.h"

/* Depth of subdivision into four parts at which a part counts as uncovered; it is then 1/64 as wide as the triangle. */
#define SUBDIVISIONS_MAX 6
/* Depth of subdivision at which a part counts as possibly visible. */
#define SHOW_SUBDIVISIONS_MAX 4
/* The same where the part decides whether a whole patch is left out. */
#define HIDE_SUBDIVISIONS_MAX 10

enum hatch_status hatch_core_coverage_make(const struct hatch_outline *outline, uint32_t face_count,
                                           struct hatch_arena *arena, struct hatch_core_coverage *coverage,
                                           struct hatch_err *err)
{
    struct hatch_core_coverage made = {.outline = outline, .arena = arena};
    HATCH_TRY(HATCH_ALLOC(arena, &made.covered, face_count, err));
    HATCH_TRY(HATCH_ALLOC(arena, &made.head, face_count, err));
    memset(made.head, 0xff, face_count * sizeof *made.head);
    *coverage = made;
    return HATCH_OK;
}

/* Computes the mask coordinates of a point given in barycentric coordinates. */
static void barycentric_point(const double mask[3][2], const double bary[3], double point[2])
{
    for (int i = 0; i < 2; i++)
        point[i] = bary[0] * mask[0][i] + bary[1] * mask[1][i] + bary[2] * mask[2][i];
}

/* Finds the centroid of a part of a triangle, whose corners are in barycentric coordinates. Returns the largest
 * distance of a corner from it. */
static double part_radius(const double mask[3][2], const double part[3][3], double middle[2])
{
    double bary[3], radius = 0;
    for (int i = 0; i < 3; i++)
        bary[i] = (part[0][i] + part[1][i] + part[2][i]) / 3;
    barycentric_point(mask, bary, middle);
    for (int c = 0; c < 3; c++) {
        double corner[2];
        barycentric_point(mask, part[c], corner);
        double x = corner[0] - middle[0], y = corner[1] - middle[1], away = x * x + y * y;
        radius = away > radius ? away : radius;
    }
    return sqrt(radius);
}

/* Returns whether a core certainly contains the whole of a part. Sets *touched when it contains the part's middle. */
static bool core_contains_part(const struct hatch_outline *outline, const double mask[3][2], const double part[3][3],
                               bool *touched)
{
    double middle[2], radius = part_radius(mask, part, middle);
    double core_depth = hatch_outline_depth(outline, middle);
    *touched = *touched || core_depth > 0;
    return core_depth > 0 && core_depth >= radius;
}

/* Computes one of the four parts of a subdivision. */
static void quarter(const double part[3][3], int which, double out[3][3])
{
    for (int c = 0; c < 3; c++) {
        int a = which == 3 ? c : which, b = which == 3 ? (c + 1) % 3 : c;
        for (int i = 0; i < 3; i++)
            out[c][i] = (part[a][i] + part[b][i]) / 2;
    }
}

/* The cores over one face: a list of entries. */
struct core_union {
    const struct hatch_outline *outline;
    const struct hatch_core_coverage_entry *entries;
    uint32_t head;
};

static bool cores_contain(const struct core_union *cores, const double part[3][3], int depth)
{
    bool touched = false;
    for (uint32_t e = cores->head; e != UINT32_MAX; e = cores->entries[e].next)
        if (core_contains_part(cores->outline, cores->entries[e].mask, part, &touched))
            return true;
    if (!touched || depth == SUBDIVISIONS_MAX)
        return false;
    for (int which = 0; which < 4; which++) {
        double smaller[3][3];
        quarter(part, which, smaller);
        if (!cores_contain(cores, (const double(*)[3])smaller, depth + 1))
            return false;
    }
    return true;
}

static const double WHOLE[3][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};

/* Returns whether every corner lies in a core. Tested first, because most uncovered faces have an uncovered corner. */
static bool cores_contain_corners(const struct core_union *cores)
{
    for (int c = 0; c < 3; c++) {
        bool contained = false;
        for (uint32_t e = cores->head; e != UINT32_MAX && !contained; e = cores->entries[e].next)
            contained = hatch_outline_depth(cores->outline, cores->entries[e].mask[c]) > 0;
        if (!contained)
            return false;
    }
    return true;
}

/* Returns whether a patch is visible in a part, with opacity greater than 0 and not under the core of an earlier patch.
 * The result is HATCH_LAPPED_UNDECIDED when the first smaller part that is not certainly hidden has the depth depth_max
 * and no certain result. */
static enum hatch_visibility visibility(const struct core_union *cores, const double mask[3][2],
                                        const double part[3][3], int depth, int depth_max)
{
    double middle[2], radius = part_radius(mask, part, middle);
    double gap = hatch_outline_distance(cores->outline, middle);
    bool hidden = false;
    if (gap > radius)
        return HATCH_LAPPED_HIDDEN;
    for (uint32_t e = cores->head; e != UINT32_MAX; e = cores->entries[e].next)
        if (core_contains_part(cores->outline, cores->entries[e].mask, part, &hidden))
            return HATCH_LAPPED_HIDDEN;
    if (gap <= 0 && !hidden)
        return HATCH_LAPPED_VISIBLE;
    if (depth == depth_max)
        return HATCH_LAPPED_UNDECIDED;
    for (int which = 0; which < 4; which++) {
        double smaller[3][3];
        quarter(part, which, smaller);
        enum hatch_visibility found = visibility(cores, mask, (const double(*)[3])smaller, depth + 1, depth_max);
        if (found != HATCH_LAPPED_HIDDEN)
            return found;
    }
    return HATCH_LAPPED_HIDDEN;
}

/* Returns whether the circle of radius core_min contains a triangle, which decides most cases. */
static bool circle_contains(const struct hatch_outline *outline, const double mask[3][2])
{
    double least = outline->core_min * outline->core_min;
    for (int c = 0; c < 3; c++) {
        double x = mask[c][0] - 0.5, y = mask[c][1] - 0.5;
        if (!(x * x + y * y < least))
            return false;
    }
    return true;
}

enum hatch_status hatch_core_coverage_add(struct hatch_core_coverage *coverage, uint32_t face, const double mask[3][2],
                                          enum hatch_visibility *visible, struct hatch_err *err)
{
    struct core_union cores = {coverage->outline, coverage->entries, coverage->head[face]};
    if (coverage->covered[face]) {
        *visible = HATCH_LAPPED_HIDDEN;
        return HATCH_OK;
    }
    if (circle_contains(coverage->outline, mask)) {
        coverage->covered[face] = 1;
        *visible = cores.head == UINT32_MAX ? HATCH_LAPPED_VISIBLE : HATCH_LAPPED_UNDECIDED;
        return HATCH_OK;
    }
    *visible = visibility(&cores, mask, WHOLE, 0, SHOW_SUBDIVISIONS_MAX);
    if (*visible == HATCH_LAPPED_HIDDEN)
        return HATCH_OK;
    void *entries = coverage->entries;
    HATCH_TRY(hatch_lapped_reserve(coverage->arena, &entries, &coverage->entry_capacity, coverage->entry_count + 1,
                                   sizeof *coverage->entries, err));
    coverage->entries = entries;
    struct hatch_core_coverage_entry *entry = &coverage->entries[coverage->entry_count];
    entry->next = coverage->head[face];
    memcpy(entry->mask, mask, sizeof entry->mask);
    cores = (struct core_union){coverage->outline, coverage->entries, coverage->entry_count};
    coverage->covered[face] = cores_contain_corners(&cores) && cores_contain(&cores, WHOLE, 0);
    /* A covered face needs no entry. */
    if (!coverage->covered[face])
        coverage->head[face] = coverage->entry_count++;
    return HATCH_OK;
}

bool hatch_core_coverage_hides(const struct hatch_core_coverage *coverage, uint32_t entry_count, uint32_t face,
                               const double mask[3][2])
{
    struct core_union cores = {coverage->outline, coverage->entries, coverage->head[face]};
    while (cores.head != UINT32_MAX && cores.head >= entry_count)
        cores.head = coverage->entries[cores.head].next;
    return visibility(&cores, mask, WHOLE, 0, HIDE_SUBDIVISIONS_MAX) == HATCH_LAPPED_HIDDEN;
}
