#include "seed/life.h"

#include <math.h>

uint8_t hatch_life_tile(const struct hatch_seed_set *set, uint32_t seed)
{
    return set->crumbs[(seed + set->count - 1) % set->count];
}

/* A stroke of the four tiles, which together are the square that the 32 bits wrap around. */
struct stroke {
    uint32_t u, v;
    uint32_t index; /* 4 seed + tile */
    float square;   /* of the distance to the nearest that is ordered already */
};

static float square_between(const struct stroke *a, const struct stroke *b)
{
    float u = (float)(int32_t)(a->u - b->u), v = (float)(int32_t)(a->v - b->v);
    return u * u + v * v;
}

/* Tells the strokes from i on that there is one more in order; returns which is now the farthest from all of
 * these, the lower index where two are. */
static uint32_t farthest_beside(struct stroke *strokes, uint32_t i, uint32_t count, const struct stroke *last)
{
    uint32_t best = i;
    for (uint32_t k = i; k < count; k++) {
        float square = square_between(&strokes[k], last);
        strokes[k].square = square < strokes[k].square ? square : strokes[k].square;
        if (strokes[k].square > strokes[best].square ||
            (strokes[k].square == strokes[best].square && strokes[k].index < strokes[best].index))
            best = k;
    }
    return best;
}

/* Goes on with the one that is farthest from all before it. begin: at least 1. */
static void order(struct stroke *strokes, uint32_t begin, uint32_t count)
{
    uint32_t best = begin;
    for (uint32_t k = 0; k < begin; k++)
        best = farthest_beside(strokes, begin, count, &strokes[k]);
    for (uint32_t i = begin; i < count; i++) {
        struct stroke next = strokes[best];
        strokes[best] = strokes[i];
        strokes[i] = next;
        best = farthest_beside(strokes, i + 1, count, &next);
    }
}

enum hatch_status hatch_life_make(const struct hatch_seed_set *set, const struct hatch_seed_place *places,
                                  enum hatch_fade_law law, struct hatch_arena *scratch, uint8_t *life,
                                  struct hatch_err *err)
{
    struct hatch_arena_mark mark = hatch_arena_mark(scratch);
    uint32_t count = set->count, stay = 0, go = count;
    struct stroke *strokes = HATCH_NEW(scratch, struct stroke, 4 * (size_t)count, err);
    if (!strokes)
        return HATCH_LIMIT;
    for (uint32_t i = 0; i < 4 * count; i++) {
        const struct hatch_seed_place *place = &places[i / 4];
        bool stays = i % 4 == hatch_life_tile(set, i / 4);
        strokes[stays ? stay++ : go++] =
            (struct stroke){(uint32_t)(place->u >> 33) + (i & 1u) * 0x80000000u,
                            (uint32_t)(place->v >> 33) + (i >> 1 & 1u) * 0x80000000u, i, INFINITY};
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
