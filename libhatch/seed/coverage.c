#include "seed/coverage.h"

#include <math.h>
#include <string.h>

/* How far a place is from a stroke's rectangle around the origin. */
static double distance_to(const struct hatch_coverage_stroke *stroke, double u, double v)
{
    double along = fabs(stroke->cosine * u + stroke->sine * v) - stroke->length / 2;
    double across = fabs(stroke->cosine * v - stroke->sine * u) - stroke->width / 2;
    return hypot(fmax(along, 0), fmax(across, 0));
}

/* Whether a stroke may cover the texel whose middle lies at (u, v) from its seed, each -1/2 .. 1/2, in any
 * of the copies of the seed that are nearest to some place of the texel. */
static bool may_cover(const struct hatch_coverage_stroke *stroke, double u, double v, double texel)
{
    double reach = texel * 0.70710678118654757 + 1e-9;
    for (int i = -1; i <= 1; i++)
        for (int k = -1; k <= 1; k++) {
            double from_u = u + i, from_v = v + k;
            if (fabs(from_u) > 0.5 + texel || fabs(from_v) > 0.5 + texel)
                continue;
            if (distance_to(stroke, from_u, from_v) <= reach)
                return true;
        }
    return false;
}

static double offset(uint32_t texel, uint32_t side, uint64_t place)
{
    double away = (texel + 0.5) / side - (double)place * 0x1p-64;
    return away - floor(away + 0.5);
}

enum hatch_status hatch_coverage_make(const struct hatch_seed_place *places, uint32_t count,
                                      const struct hatch_coverage_stroke *stroke, uint32_t side,
                                      struct hatch_arena *arena, struct hatch_arena *scratch,
                                      struct hatch_coverage *coverage, struct hatch_err *err)
{
    struct hatch_arena_mark mark = hatch_arena_mark(scratch);
    size_t texels = (size_t)side * side, total = 0;
    struct hatch_coverage made = {.side = side};
    made.first = HATCH_NEW(arena, uint32_t, texels + 1, err);
    uint8_t *hit = made.first ? HATCH_NEW(scratch, uint8_t, texels * count, err) : NULL;
    for (size_t t = 0; hit && t < texels; t++) {
        made.first[t] = (uint32_t)total;
        for (uint32_t i = 0; i < count; i++) {
            double u = offset((uint32_t)(t % side), side, places[i].u);
            double v = offset((uint32_t)(t / side), side, places[i].v);
            hit[t * count + i] = may_cover(stroke, u, v, 1.0 / side);
            total += hit[t * count + i];
        }
    }
    enum hatch_status status = HATCH_LIMIT;
    if (hit && total > UINT32_MAX)
        hatch_fail(err, HATCH_LIMIT, "too many strokes cover one place");
    else if (hit && (made.ids = HATCH_NEW(arena, uint32_t, total, err)))
        status = HATCH_OK;
    size_t next = 0;
    for (size_t k = 0; status == HATCH_OK && k < texels * count; k++)
        if (hit[k])
            made.ids[next++] = (uint32_t)(k % count);
    hatch_arena_rewind(scratch, mark);
    HATCH_TRY(status);
    made.first[texels] = (uint32_t)total;
    *coverage = made;
    return HATCH_OK;
}
