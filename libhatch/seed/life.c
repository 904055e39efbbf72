#include "seed/life.h"

#include <math.h>

uint8_t hatch_life_tile(const struct hatch_seed_set *set, uint32_t seed)
{
    return set->crumbs[(seed + set->count - 1) % set->count];
}

/* A stroke in one of four merging tiles. Together the tiles are a torus with sides of 2^32 units. */
struct stroke {
    uint32_t u, v;
    uint32_t index; /* 4 seed + tile */
    float square;   /* squared distance to the nearest stroke that is already ordered */
};

static float squared_distance(const struct stroke *a, const struct stroke *b)
{
    float u = (float)(int32_t)(a->u - b->u), v = (float)(int32_t)(a->v - b->v);
    return u * u + v * v;
}

/* Updates the squared distances of strokes i .. count - 1 for `last`, which was just ordered. Returns the position of
 * the one farthest from all ordered strokes, ties going to the lowest index. */
static uint32_t update_farthest(struct stroke *strokes, uint32_t i, uint32_t count, const struct stroke *last)
{
    uint32_t best = i;
    for (uint32_t k = i; k < count; k++) {
        float square = squared_distance(&strokes[k], last);
        strokes[k].square = square < strokes[k].square ? square : strokes[k].square;
        if (strokes[k].square > strokes[best].square ||
            (strokes[k].square == strokes[best].square && strokes[k].index < strokes[best].index))
            best = k;
    }
    return best;
}

/* Orders strokes begin .. count - 1 by farthest-point sampling.
 *   begin  number of strokes that are already ordered, 1 upwards */
static void order(struct stroke *strokes, uint32_t begin, uint32_t count)
{
    uint32_t best = begin;
    for (uint32_t k = 0; k < begin; k++)
        best = update_farthest(strokes, begin, count, &strokes[k]);
    for (uint32_t i = begin; i < count; i++) {
        struct stroke next = strokes[best];
        strokes[best] = strokes[i];
        strokes[i] = next;
        best = update_farthest(strokes, i + 1, count, &next);
    }
}

enum hatch_status hatch_life_make(const struct hatch_seed_set *set, const struct hatch_seed_point *points,
                                  enum hatch_fade_law law, struct hatch_arena *scratch, uint8_t *life,
                                  struct hatch_err *err)
{
    struct hatch_arena_mark mark = hatch_arena_mark(scratch);
    uint32_t count = set->count, staying = 0, fading = count;
    struct stroke *strokes;
    HATCH_TRY(HATCH_ALLOC(scratch, &strokes, 4 * (size_t)count, err));
    for (uint32_t i = 0; i < 4 * count; i++) {
        const struct hatch_seed_point *point = &points[i / 4];
        bool stays = i % 4 == hatch_life_tile(set, i / 4);
        strokes[stays ? staying++ : fading++] =
            (struct stroke){(uint32_t)(point->u >> 33) + (i & 1u) * 0x80000000u,
                            (uint32_t)(point->v >> 33) + (i >> 1 & 1u) * 0x80000000u, i, INFINITY};
    }
    order(strokes, count, 4 * count);
    for (uint32_t k = 0; k < count; k++)
        life[strokes[k].index] = HATCH_LIFE_STAYS;
    for (uint32_t k = 0; k < 3 * count; k++) {
        double rank = (k + 0.5) / (3.0 * count);
        double share = law == HATCH_FADE_WEIGHTED ? hatch_fade_death(rank) : 1 - rank;
        life[strokes[count + k].index] = (uint8_t)(share * HATCH_LIFE_STAYS);
    }
    hatch_arena_rewind(scratch, mark);
    return HATCH_OK;
}
