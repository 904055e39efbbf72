#include "seed/coverage.h"

#include <math.h>
#include <string.h>

/* Whether a place is within `reach` of a stroke's rectangle around the origin. */
static bool is_near(const struct hatch_coverage_stroke *stroke, double u, double v, double reach)
{
    double along = fabs(stroke->cosine * u + stroke->sine * v) - stroke->length / 2;
    double across = fabs(stroke->cosine * v - stroke->sine * u) - stroke->width / 2;
    along = along > 0 ? along : 0;
    across = across > 0 ? across : 0;
    return along * along + across * across <= reach * reach;
}

/* Keeps what of span has |slope u + base| <= most. */
static void narrow(double slope, double base, double most, double span[2])
{
    if (slope == 0) {
        if (fabs(base) > most)
            span[1] = -INFINITY;
        return;
    }
    double a = (-most - base) / slope, b = (most - base) / slope;
    span[0] = fmax(span[0], fmin(a, b));
    span[1] = fmin(span[1], fmax(a, b));
}

bool hatch_coverage_span(const struct hatch_coverage_stroke *stroke, double v, double reach, double limit,
                         double span[2])
{
    span[0] = -limit;
    span[1] = limit;
    narrow(stroke->cosine, stroke->sine * v, stroke->length / 2 + reach, span);
    narrow(-stroke->sine, stroke->cosine * v, stroke->width / 2 + reach, span);
    return span[0] <= span[1];
}

/* A walk over the texels that strokes may cover. */
struct walk {
    const struct hatch_coverage_stroke *stroke;
    uint32_t side;
    uint32_t *count; /* per texel: how many strokes so far */
    uint32_t *seen;  /* per texel: the last of them, plus one */
    uint32_t *ids;   /* NULL: they are only counted */
    const uint32_t *first;
};

static uint32_t wrap(int64_t texel, uint32_t side)
{
    return (uint32_t)((texel % side + side) % side);
}

static void put(struct walk *walk, size_t texel, uint32_t seed)
{
    if (walk->seen[texel] == seed + 1)
        return;
    walk->seen[texel] = seed + 1;
    if (walk->ids)
        walk->ids[walk->first[texel] + walk->count[texel]] = seed;
    walk->count[texel]++;
}

/* Texels that lie at the edge of the seed's window of half a tile each way are met from both sides. */
static void put_stroke(struct walk *walk, const struct hatch_seed_place *place, uint32_t seed)
{
    uint32_t side = walk->side;
    double texel = 1.0 / side, reach = texel * 0.70710678118654757 + 1e-9, limit = 0.5 + texel;
    double at_u = (double)place->u * 0x1p-64, at_v = (double)place->v * 0x1p-64;
    int64_t last_row = (int64_t)floor((at_v + limit) * side - 0.5);
    for (int64_t row = (int64_t)ceil((at_v - limit) * side - 0.5); row <= last_row; row++) {
        double v = ((double)row + 0.5) / side - at_v, span[2];
        if (!hatch_coverage_span(walk->stroke, v, reach, limit, span))
            continue;
        int64_t last = (int64_t)floor((at_u + span[1]) * side - 0.5);
        for (int64_t column = (int64_t)ceil((at_u + span[0]) * side - 0.5); column <= last; column++)
            if (is_near(walk->stroke, ((double)column + 0.5) / side - at_u, v, reach))
                put(walk, (size_t)wrap(row, side) * side + wrap(column, side), seed);
    }
}

static void walk_all(struct walk *walk, const struct hatch_seed_place *places, uint32_t count)
{
    size_t texels = (size_t)walk->side * walk->side;
    memset(walk->count, 0, sizeof *walk->count * texels);
    memset(walk->seen, 0, sizeof *walk->seen * texels);
    for (uint32_t i = 0; i < count; i++)
        put_stroke(walk, &places[i], i);
}

enum hatch_status hatch_coverage_make(const struct hatch_seed_place *places, uint32_t count,
                                      const struct hatch_coverage_stroke *stroke, uint32_t side,
                                      struct hatch_arena *arena, struct hatch_arena *scratch,
                                      struct hatch_coverage *coverage, struct hatch_err *err)
{
    struct hatch_arena_mark mark = hatch_arena_mark(scratch);
    size_t texels = (size_t)side * side;
    uint64_t total = 0;
    struct hatch_coverage made = {.side = side};
    made.first = HATCH_NEW(arena, uint32_t, texels + 1, err);
    uint32_t *counts = made.first ? HATCH_NEW(scratch, uint32_t, 2 * texels, err) : NULL;
    if (!counts)
        return HATCH_LIMIT;
    struct walk walk = {.stroke = stroke, .side = side, .count = counts, .seen = counts + texels};
    walk_all(&walk, places, count);
    for (size_t t = 0; t < texels; t++) {
        made.first[t] = (uint32_t)total;
        total += walk.count[t];
    }
    made.first[texels] = (uint32_t)total;
    enum hatch_status status = HATCH_LIMIT;
    if (total > UINT32_MAX)
        hatch_fail(err, HATCH_LIMIT, "too many strokes cover one place");
    else if ((made.ids = HATCH_NEW(arena, uint32_t, total, err)))
        status = HATCH_OK;
    if (status == HATCH_OK) {
        walk.ids = made.ids;
        walk.first = made.first;
        walk_all(&walk, places, count);
    }
    hatch_arena_rewind(scratch, mark);
    HATCH_TRY(status);
    *coverage = made;
    return HATCH_OK;
}
