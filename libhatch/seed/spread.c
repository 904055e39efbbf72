#include "seed/spread.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

double hatch_spread_bound(uint32_t count)
{
    return sqrt(2.0 / (sqrt(3.0) * count));
}

/* Unsigned differences wrap with the tile; read as signed numbers they are the shorter way around it. */
static double squared_distance(const struct hatch_seed_point *a, const struct hatch_seed_point *b)
{
    double u = (double)(int64_t)(a->u - b->u) * 0x1p-64;
    double v = (double)(int64_t)(a->v - b->v) * 0x1p-64;
    return u * u + v * v;
}

static uint32_t cell_of(const struct hatch_spread_cells *cells, const struct hatch_seed_point *point)
{
    if (!cells->bits)
        return 0;
    int shift = 64 - cells->bits;
    return (uint32_t)(point->v >> shift << cells->bits | point->u >> shift);
}

enum hatch_status hatch_spread_sort(const struct hatch_seed_point *points, uint32_t count, struct hatch_arena *arena,
                                    struct hatch_spread_cells *cells, struct hatch_err *err)
{
    struct hatch_spread_cells made = {.bits = 0};
    while (ldexp(hatch_spread_bound(count), made.bits + 1) <= 1.0)
        made.bits++;
    size_t cell_count = (size_t)1 << 2 * made.bits;
    HATCH_TRY(HATCH_ALLOC(arena, &made.first, cell_count + 2, err));
    HATCH_TRY(HATCH_ALLOC_UNSET(arena, &made.points, count, err));
    uint32_t *next = made.first + 1; /* next[c] is the first entry of cell c; filling points advances it to the end of
                                        that cell, which is first[c + 1] */
    for (uint32_t i = 0; i < count; i++)
        next[cell_of(&made, &points[i]) + 1]++;
    for (size_t c = 0; c < cell_count; c++)
        next[c + 1] += next[c];
    for (uint32_t i = 0; i < count; i++)
        made.points[next[cell_of(&made, &points[i])]++] = points[i];
    *cells = made;
    return HATCH_OK;
}

/* Returns the least of `least` and the squared distances from a point to those among the first `limit` of the sorted
 * points that lie in its cell and the adjacent ones. */
static double nearest_of(const struct hatch_spread_cells *cells, const struct hatch_seed_point *point, uint32_t limit,
                         double least)
{
    uint32_t cell = cell_of(cells, point), mask = ((uint32_t)1 << cells->bits) - 1;
    uint32_t u = cell & mask, v = cell >> cells->bits;
    for (uint32_t near = 0; near < 9; near++) {
        uint32_t at = ((v + near / 3 - 1) & mask) << cells->bits | ((u + near % 3 - 1) & mask);
        uint32_t end = cells->first[at + 1] < limit ? cells->first[at + 1] : limit;
        for (uint32_t i = cells->first[at]; i < end; i++)
            least = fmin(least, squared_distance(point, &cells->points[i]));
    }
    return least;
}

double hatch_spread_nearest(const struct hatch_spread_cells *cells, const struct hatch_seed_point *point,
                            double distance)
{
    double squared = distance * distance, found = nearest_of(cells, point, UINT32_MAX, squared);
    return found < squared ? sqrt(found) : distance;
}

enum hatch_status hatch_spread_distance(const struct hatch_seed_point *points, uint32_t count,
                                        struct hatch_arena *scratch, double *distance, struct hatch_err *err)
{
    struct hatch_arena_mark mark = hatch_arena_mark(scratch);
    struct hatch_spread_cells cells;
    double best = 1;
    enum hatch_status status = hatch_spread_sort(points, count, scratch, &cells, err);
    for (uint32_t i = 0; status == HATCH_OK && i < count && best > 0; i++)
        best = nearest_of(&cells, &cells.points[i], i, best);
    hatch_arena_rewind(scratch, mark);
    if (status == HATCH_OK)
        *distance = sqrt(best);
    return status;
}

static int compare_u(const void *a, const void *b)
{
    const struct hatch_seed_point *p = a, *q = b;
    if (p->u != q->u)
        return p->u < q->u ? -1 : 1;
    return p->v < q->v ? -1 : p->v > q->v;
}

/* Returns the largest difference over the boxes that end at u or next_u. The extreme over all boxes has its upper
 * corner on the grid of the points' coordinates: it is a closed box up to u, which holds too many points, or an open
 * box up to next_u, which holds too few.
 *   sorted_v  v of the points up to u, ascending
 *   filled    number of these points
 *   count     number of all points */
static double worst_box(const uint64_t *sorted_v, uint32_t filled, uint32_t count, double u, double next_u)
{
    double worst = 0;
    for (uint32_t i = 0; i <= filled; i++) {
        double below = i < filled ? (double)sorted_v[i] * 0x1p-64 : 1.0;
        double share = (double)i / count;
        worst = fmax(worst, next_u * below - share);
        if (i < filled)
            worst = fmax(worst, (double)(i + 1) / count - u * below);
    }
    return worst;
}

enum hatch_status hatch_spread_discrepancy(const struct hatch_seed_point *points, uint32_t count,
                                           struct hatch_arena *scratch, double *discrepancy, struct hatch_err *err)
{
    struct hatch_arena_mark mark = hatch_arena_mark(scratch);
    struct hatch_seed_point *sorted = HATCH_NEW(scratch, struct hatch_seed_point, count, err);
    uint64_t *sorted_v = sorted ? HATCH_NEW(scratch, uint64_t, count, err) : NULL;
    if (!sorted_v) {
        hatch_arena_rewind(scratch, mark);
        return HATCH_LIMIT;
    }
    memcpy(sorted, points, sizeof *sorted * count);
    qsort(sorted, count, sizeof *sorted, compare_u);
    double worst = (double)sorted[0].u * 0x1p-64;
    for (uint32_t i = 0; i < count; i++) {
        uint32_t at = i;
        for (; at > 0 && sorted_v[at - 1] > sorted[i].v; at--)
            sorted_v[at] = sorted_v[at - 1];
        sorted_v[at] = sorted[i].v;
        double u = (double)sorted[i].u * 0x1p-64;
        double next = i + 1 < count ? (double)sorted[i + 1].u * 0x1p-64 : 1.0;
        worst = fmax(worst, worst_box(sorted_v, i + 1, count, u, next));
    }
    hatch_arena_rewind(scratch, mark);
    *discrepancy = worst;
    return HATCH_OK;
}

enum hatch_status hatch_seeds_spread(const struct hatch_seeds *seeds, struct hatch_arena *scratch, double *within,
                                     double *together, struct hatch_err *err)
{
    struct hatch_arena_mark mark = hatch_arena_mark(scratch);
    size_t total = 0;
    for (uint32_t i = 0; i < seeds->layer_count; i++)
        total += seeds->layers[i].count;
    if (total > UINT32_MAX)
        return hatch_fail(err, HATCH_LIMIT, "%zu seed points in all layers: want fewer than 2^32", total);
    struct hatch_seed_point *points = HATCH_NEW(scratch, struct hatch_seed_point, total, err);
    enum hatch_status status = points ? HATCH_OK : HATCH_LIMIT;
    double smallest = 1, distance = 1;
    uint32_t count = 0;
    for (uint32_t i = 0; status == HATCH_OK && i < seeds->layer_count; i++) {
        const struct hatch_seed_set *set = &seeds->layers[i];
        hatch_seed_points(set, points + count);
        status = hatch_spread_distance(points + count, set->count, scratch, &distance, err);
        smallest = fmin(smallest, distance / hatch_spread_bound(set->count));
        count += set->count;
    }
    if (status == HATCH_OK)
        status = hatch_spread_distance(points, count, scratch, &distance, err);
    hatch_arena_rewind(scratch, mark);
    HATCH_TRY(status);
    *within = smallest;
    *together = distance / hatch_spread_bound(count);
    return HATCH_OK;
}
