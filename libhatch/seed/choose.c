/* Draws sets and keeps those whose seeds are spread best. */
#include <string.h>

#include "seed/spread.h"

/* All layers' places so far, with room for one more. */
struct choice {
    const struct hatch_seeds_options *options;
    struct hatch_seed_place *places;
    uint32_t placed;
    uint8_t *crumbs;
    double own, together; /* of the candidate */
    uint64_t steps;
};

static enum hatch_status draw(struct choice *choice, uint64_t stream, struct hatch_arena *scratch,
                              struct hatch_err *err)
{
    struct hatch_cycle_options cycle = choice->options->cycle;
    struct hatch_seed_set set = {cycle.count, choice->crumbs};
    uint64_t steps = 0;
    cycle.stream = stream;
    HATCH_TRY(hatch_cycle_make(&cycle, scratch, choice->crumbs, &steps, err));
    choice->steps += steps;
    hatch_seed_places(&set, choice->places + choice->placed);
    HATCH_TRY(hatch_spread_distance(choice->places + choice->placed, cycle.count, scratch,
                                    &choice->own, err));
    choice->own /= hatch_spread_bound(cycle.count);
    choice->together = choice->own;
    if (!choice->placed)
        return HATCH_OK;
    uint32_t all = choice->placed + cycle.count;
    HATCH_TRY(hatch_spread_distance(choice->places, all, scratch, &choice->together, err));
    choice->together /= hatch_spread_bound(all);
    return HATCH_OK;
}

static enum hatch_status choose_layer(struct choice *choice, uint32_t layer, uint8_t *crumbs,
                                      struct hatch_arena *scratch, struct hatch_err *err)
{
    double best = -1;
    for (uint32_t i = 0; i < choice->options->candidates; i++) {
        HATCH_TRY(draw(choice, (uint64_t)layer << 32 | i, scratch, err));
        if (choice->own * choice->together <= best)
            continue;
        best = choice->own * choice->together;
        memcpy(crumbs, choice->crumbs, choice->options->cycle.count);
    }
    return HATCH_OK;
}

enum hatch_status hatch_seeds_make(const struct hatch_seeds_options *options,
                                   struct hatch_arena *arena, struct hatch_arena *scratch,
                                   struct hatch_seeds *seeds, struct hatch_seeds_result *result,
                                   struct hatch_err *err)
{
    uint32_t count = options->cycle.count;
    struct hatch_arena_mark mark = hatch_arena_mark(scratch);
    struct hatch_seeds made = {.layer_count = options->layers};
    struct hatch_seeds_result figures = {.distance = 1};
    struct choice choice = {.options = options};
    enum hatch_status status = HATCH_LIMIT;
    made.layers = HATCH_NEW(arena, struct hatch_seed_set, options->layers, err);
    if (made.layers)
        choice.places = HATCH_NEW(scratch, struct hatch_seed_place,
                                  (size_t)count * options->layers, err);
    choice.crumbs = choice.places ? HATCH_NEW(scratch, uint8_t, count, err) : NULL;
    if (choice.crumbs)
        status = HATCH_OK;
    for (uint32_t i = 0; status == HATCH_OK && i < options->layers; i++) {
        struct hatch_seed_set *set = &made.layers[i];
        set->count = count;
        set->crumbs = HATCH_NEW(arena, uint8_t, count, err);
        status = set->crumbs ? choose_layer(&choice, i, set->crumbs, scratch, err) : HATCH_LIMIT;
        if (status != HATCH_OK)
            break;
        hatch_seed_places(set, choice.places + choice.placed);
        double own;
        status = hatch_spread_distance(choice.places + choice.placed, count, scratch, &own, err);
        choice.placed += count;
        if (status == HATCH_OK && own / hatch_spread_bound(count) < figures.distance)
            figures.distance = own / hatch_spread_bound(count);
    }
    if (status == HATCH_OK)
        status = hatch_spread_distance(choice.places, choice.placed, scratch, &figures.together, err);
    hatch_arena_rewind(scratch, mark);
    HATCH_TRY(status);
    figures.together /= hatch_spread_bound(choice.placed);
    figures.steps = choice.steps;
    *seeds = made;
    *result = figures;
    return HATCH_OK;
}
