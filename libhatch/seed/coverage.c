#include "seed/coverage.h"

#include <math.h>

#define MARGIN 1e-9 /* of a tile, against rounding */

/* A stroke's rectangle, and how much it gains where texels are asked that it touches. */
struct reach {
    double cosine, sine, per_cosine, per_sine; /* 1 over them; 0: they are nearly 0 */
    double along, across;                      /* half of the rectangle and of a texel's extent in its directions */
    double u, v;                               /* half of the box around the rectangle */
    uint32_t side;
};

static double turned_round(double x)
{
    return fabs(x) < 1e-12 ? 0 : 1 / x;
}

static struct reach reach_of(const struct hatch_coverage_stroke *stroke, uint32_t side)
{
    double c = fabs(stroke->cosine), s = fabs(stroke->sine), texel = (c + s) / (2 * side) + MARGIN;
    return (struct reach){.cosine = stroke->cosine,
                          .sine = stroke->sine,
                          .per_cosine = turned_round(stroke->cosine),
                          .per_sine = turned_round(stroke->sine),
                          .along = stroke->length / 2 + texel,
                          .across = stroke->width / 2 + texel,
                          .u = (c * stroke->length + s * stroke->width) / 2 + MARGIN,
                          .v = (s * stroke->length + c * stroke->width) / 2 + MARGIN,
                          .side = side};
}

/* Cuts [*low, *high] down to the x where |x / per_a + b| <= most. */
static void cut(double per_a, double b, double most, double *low, double *high)
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

/* The texels of a row that a stroke at (u, v) reaches: *begin up to, without it, *end. */
static void span(const struct reach *reach, double u, double v, uint32_t row, uint32_t *begin, uint32_t *end)
{
    double side = reach->side, away_v = (row + 0.5) / side - v;
    double low = -reach->u - 0.5 / side, high = reach->u + 0.5 / side; /* of texels' middles, from u */
    cut(reach->per_cosine, reach->sine * away_v, reach->along, &low, &high);
    cut(-reach->per_sine, reach->cosine * away_v, reach->across, &low, &high);
    double first = ceil((low + u) * side - 0.5), last = floor((high + u) * side - 0.5);
    first = first > 0 ? first : 0;
    last = last < side - 1 ? last : side - 1;
    *begin = last >= first ? (uint32_t)first : 0;
    *end = last >= first ? (uint32_t)last + 1 : 0;
}

/* Counts one stroke in counts[texel + 1], or lists it at next[texel]. */
static void put(const struct reach *reach, const struct hatch_seed_place *place, const struct hatch_coverage_copy *copy,
                uint32_t *counts, uint32_t *next, struct hatch_coverage_copy *copies)
{
    double u = (double)place->u * 0x1p-64 + copy->tile_u, v = (double)place->v * 0x1p-64 + copy->tile_v;
    double side = reach->side, top = fmax(floor((v - reach->v) * side), 0);
    double bottom = fmin(floor((v + reach->v) * side), side - 1);
    for (double row = top; row <= bottom; row++) {
        uint32_t begin, end;
        span(reach, u, v, (uint32_t)row, &begin, &end);
        size_t texel = (size_t)row * reach->side;
        for (uint32_t x = begin; x < end; x++) {
            if (counts)
                counts[texel + x + 1]++;
            else
                copies[next[texel + x]++] = *copy;
        }
    }
}

static void put_all(const struct hatch_seed_place *places, uint32_t count, const struct reach *reach, uint32_t *counts,
                    uint32_t *next, struct hatch_coverage_copy *copies)
{
    for (uint32_t i = 0; i < count; i++) {
        double u = (double)places[i].u * 0x1p-64, v = (double)places[i].v * 0x1p-64;
        int32_t right = (int32_t)floor(1 + reach->u - u), low = (int32_t)floor(1 + reach->v - v);
        for (int32_t tile_v = (int32_t)ceil(-reach->v - v); tile_v <= low; tile_v++)
            for (int32_t tile_u = (int32_t)ceil(-reach->u - u); tile_u <= right; tile_u++) {
                const struct hatch_coverage_copy copy = {i, tile_u, tile_v};
                put(reach, &places[i], &copy, counts, next, copies);
            }
    }
}

enum hatch_status hatch_coverage_make(const struct hatch_seed_place *places, uint32_t count,
                                      const struct hatch_coverage_stroke *stroke, uint32_t side,
                                      struct hatch_arena *arena, struct hatch_coverage *coverage, struct hatch_err *err)
{
    size_t texels = (size_t)side * side;
    struct hatch_coverage made = {.side = side};
    struct reach reach = reach_of(stroke, side);
    made.first = HATCH_NEW(arena, uint32_t, texels + 2, err); /* one more, for filling */
    if (!made.first)
        return HATCH_LIMIT;
    put_all(places, count, &reach, made.first + 1, NULL, NULL);
    uint64_t total = 0;
    for (size_t t = 0; t <= texels + 1; t++)
        made.first[t] = (uint32_t)(total += made.first[t]);
    if (total > UINT32_MAX)
        return hatch_fail(err, HATCH_LIMIT, "too many strokes cover one place");
    made.copies = HATCH_NEW_UNSET(arena, struct hatch_coverage_copy, total, err);
    if (!made.copies)
        return HATCH_LIMIT;
    put_all(places, count, &reach, NULL, made.first + 1, made.copies);
    *coverage = made;
    return HATCH_OK;
}
