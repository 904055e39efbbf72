#include "seed/coverage.h"

#include <math.h>

#define MARGIN 1e-9 /* in tiles, against rounding errors */

/* A stroke's rectangle, grown by half the extent of a texel on every side, so that it contains the centre of every
 * texel that the stroke intersects. */
struct reach {
    double cosine, sine;
    double per_cosine, per_sine; /* 1 / cosine, 1 / sine; 0 where that would be nearly infinite */
    double along, across;        /* half of the grown rectangle's length and width */
    double u, v;                 /* half of the bounding box of the rectangle before it is grown */
    uint32_t side;
};

static double reciprocal(double x)
{
    return fabs(x) < 1e-12 ? 0 : 1 / x;
}

static struct reach reach_of(const struct hatch_coverage_stroke *stroke, uint32_t side)
{
    double c = fabs(stroke->cosine), s = fabs(stroke->sine), texel = (c + s) / (2 * side) + MARGIN;
    return (struct reach){.cosine = stroke->cosine,
                          .sine = stroke->sine,
                          .per_cosine = reciprocal(stroke->cosine),
                          .per_sine = reciprocal(stroke->sine),
                          .along = stroke->length / 2 + texel,
                          .across = stroke->width / 2 + texel,
                          .u = (c * stroke->length + s * stroke->width) / 2 + MARGIN,
                          .v = (s * stroke->length + c * stroke->width) / 2 + MARGIN,
                          .side = side};
}

/* Narrows *low .. *high to the x for which |a x + b| <= most.
 *   per_a  1 / a, or 0 for a near 0 */
static void clip(double per_a, double b, double most, double *low, double *high)
{
    if (!(per_a > 0) && !(per_a < 0)) {
        if (fabs(b) > most)
            *high = *low - 1;
        return;
    }
    double middle = -b * per_a, half = most * fabs(per_a), begin = middle - half, end = middle + half;
    *low = begin > *low ? begin : *low;
    *high = end < *high ? end : *high;
}

/* Finds the texels *begin .. *end - 1 of a row that a stroke at (u, v) intersects. */
static void find_span(const struct reach *reach, double u, double v, uint32_t row, uint32_t *begin, uint32_t *end)
{
    double side = reach->side, away_v = (row + 0.5) / side - v;
    double low = -reach->u - 0.5 / side, high = reach->u + 0.5 / side; /* of texel centres, relative to u */
    clip(reach->per_cosine, reach->sine * away_v, reach->along, &low, &high);
    clip(-reach->per_sine, reach->cosine * away_v, reach->across, &low, &high);
    double first = ceil((low + u) * side - 0.5), last = floor((high + u) * side - 0.5);
    first = first > 0 ? first : 0;
    last = last < side - 1 ? last : side - 1;
    *begin = last >= first ? (uint32_t)first : 0;
    *end = last >= first ? (uint32_t)last + 1 : 0;
}

/* Adds one stroke to the lists of all texels that it intersects: counts it in counts[texel + 1] or, if counts is NULL,
 * stores it at copies[next[texel]]. */
static void add_copy(const struct reach *reach, const struct hatch_seed_point *point,
                     const struct hatch_coverage_copy *copy, uint32_t *counts, uint32_t *next,
                     struct hatch_coverage_copy *copies)
{
    double u = (double)point->u * 0x1p-64 + copy->tile_u, v = (double)point->v * 0x1p-64 + copy->tile_v;
    double side = reach->side, top = fmax(floor((v - reach->v) * side), 0);
    double bottom = fmin(floor((v + reach->v) * side), side - 1);
    for (double row = top; row <= bottom; row++) {
        uint32_t begin, end;
        find_span(reach, u, v, (uint32_t)row, &begin, &end);
        size_t texel = (size_t)row * reach->side;
        for (uint32_t x = begin; x < end; x++) {
            if (counts)
                counts[texel + x + 1]++;
            else
                copies[next[texel + x]++] = *copy;
        }
    }
}

static void add_all(const struct hatch_seed_point *points, uint32_t count, const struct reach *reach, uint32_t *counts,
                    uint32_t *next, struct hatch_coverage_copy *copies)
{
    for (uint32_t i = 0; i < count; i++) {
        double u = (double)points[i].u * 0x1p-64, v = (double)points[i].v * 0x1p-64;
        int32_t right = (int32_t)floor(1 + reach->u - u), low = (int32_t)floor(1 + reach->v - v);
        for (int32_t tile_v = (int32_t)ceil(-reach->v - v); tile_v <= low; tile_v++)
            for (int32_t tile_u = (int32_t)ceil(-reach->u - u); tile_u <= right; tile_u++) {
                const struct hatch_coverage_copy copy = {i, tile_u, tile_v};
                add_copy(reach, &points[i], &copy, counts, next, copies);
            }
    }
}

enum hatch_status hatch_coverage_make(const struct hatch_seed_point *points, uint32_t count,
                                      const struct hatch_coverage_stroke *stroke, uint32_t side,
                                      struct hatch_arena *arena, struct hatch_coverage *coverage, struct hatch_err *err)
{
    size_t texels = (size_t)side * side;
    struct hatch_coverage made = {.side = side};
    struct reach reach = reach_of(stroke, side);
    /* One entry more than the lists need, used while they are filled. */
    HATCH_TRY(HATCH_ALLOC(arena, &made.first, texels + 2, err));
    add_all(points, count, &reach, made.first + 1, NULL, NULL);
    uint64_t total = 0;
    for (size_t t = 0; t <= texels + 1; t++)
        made.first[t] = (uint32_t)(total += made.first[t]);
    if (total > UINT32_MAX)
        return hatch_fail(err, HATCH_LIMIT, "too many strokes overlap: the coverage lists would pass 2^32 entries");
    HATCH_TRY(HATCH_ALLOC_UNSET(arena, &made.copies, total, err));
    add_all(points, count, &reach, NULL, made.first + 1, made.copies);
    *coverage = made;
    return HATCH_OK;
}
