/* Draws sets and keeps those whose seeds are spread best. */
#include <math.h>
#include <string.h>

#include "seed/spread.h"

/* All layers' places so far, with room for one more. */
struct choice {
    const struct hatch_seeds_options *options;
    struct hatch_seed_place *places;
    uint32_t placed;
    uint8_t *crumbs;
    uint64_t steps;
};

static enum hatch_status draw(struct choice *choice, uint64_t stream, struct hatch_arena *scratch,
                              struct hatch_err *err)
{
    struct hatch_cycle_options cycle = choice->options->cycle;
    uint64_t steps = 0;
    cycle.stream = stream;
    HATCH_TRY(hatch_cycle_make(&cycle, scratch, choice->crumbs, &steps, err));
    choice->steps += steps;
    return HATCH_OK;
}

/* The candidate's own spread and, from the second layer on, that of all layers with it. */
static enum hatch_status weigh(struct choice *choice, struct hatch_arena *scratch, double *goodness,
                               struct hatch_err *err)
{
    const struct hatch_seed_set set = {choice->options->cycle.count, choice->crumbs};
    uint32_t all = choice->placed + set.count;
    double own, together;
    hatch_seed_places(&set, choice->places + choice->placed);
    HATCH_TRY(hatch_spread_distance(choice->places + choice->placed, set.count, scratch, &own, err));
    own /= hatch_spread_bound(set.count);
    if (choice->placed) {
        HATCH_TRY(hatch_spread_distance(choice->places, all, scratch, &together, err));
        own *= own * together / hatch_spread_bound(all);
    }
    *goodness = own;
    return HATCH_OK;
}

static uint32_t candidates_of(const struct hatch_seeds_options *options)
{
    uint32_t fitting = 100000u / options->cycle.count;
    if (options->candidates)
        return options->candidates;
    return fitting > 1000 ? 1000 : fitting > 1 ? fitting : 1;
}

static enum hatch_status choose_layer(struct choice *choice, uint32_t layer, const struct hatch_seed_set *set,
                                      struct hatch_arena *scratch, struct hatch_err *err)
{
    uint32_t candidates = candidates_of(choice->options);
    double best = -1;
    for (uint32_t i = 0; i < candidates; i++) {
        double goodness = 0;
        HATCH_TRY(draw(choice, (uint64_t)layer << 32 | i, scratch, err));
        if (candidates > 1)
            HATCH_TRY(weigh(choice, scratch, &goodness, err));
        if (goodness <= best)
            continue;
        best = goodness;
        memcpy(set->crumbs, choice->crumbs, set->count);
    }
    hatch_seed_places(set, choice->places + choice->placed);
    choice->placed += set->count;
    return HATCH_OK;
}

enum hatch_status hatch_seeds_make(const struct hatch_seeds_options *options, struct hatch_arena *arena,
                                   struct hatch_arena *scratch, struct hatch_seeds *seeds, uint64_t *steps,
                                   struct hatch_err *err)
{
    uint32_t count = options->cycle.count;
    struct hatch_arena_mark mark = hatch_arena_mark(scratch);
    struct hatch_seeds made = {.layer_count = options->layers};
    struct choice choice = {.options = options};
    made.layers = HATCH_NEW(arena, struct hatch_seed_set, options->layers, err);
    if (made.layers)
        choice.places = HATCH_NEW(scratch, struct hatch_seed_place, (size_t)count * options->layers, err);
    choice.crumbs = choice.places ? HATCH_NEW(scratch, uint8_t, count, err) : NULL;
    enum hatch_status status = choice.crumbs ? HATCH_OK : HATCH_LIMIT;
    for (uint32_t i = 0; status == HATCH_OK && i < options->layers; i++) {
        made.layers[i].count = count;
        made.layers[i].crumbs = HATCH_NEW(arena, uint8_t, count, err);
        status = made.layers[i].crumbs ? choose_layer(&choice, i, &made.layers[i], scratch, err) : HATCH_LIMIT;
    }
    hatch_arena_rewind(scratch, mark);
    HATCH_TRY(status);
    *seeds = made;
    *steps = choice.steps;
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
        return hatch_fail(err, HATCH_LIMIT, "%zu seeds in all layers", total);
    struct hatch_seed_place *places = HATCH_NEW(scratch, struct hatch_seed_place, total, err);
    enum hatch_status status = places ? HATCH_OK : HATCH_LIMIT;
    double smallest = 1, distance = 1;
    uint32_t placed = 0;
    for (uint32_t i = 0; status == HATCH_OK && i < seeds->layer_count; i++) {
        const struct hatch_seed_set *set = &seeds->layers[i];
        hatch_seed_places(set, places + placed);
        status = hatch_spread_distance(places + placed, set->count, scratch, &distance, err);
        smallest = fmin(smallest, distance / hatch_spread_bound(set->count));
        placed += set->count;
    }
    if (status == HATCH_OK)
        status = hatch_spread_distance(places, placed, scratch, &distance, err);
    hatch_arena_rewind(scratch, mark);
    HATCH_TRY(status);
    *within = smallest;
    *together = distance / hatch_spread_bound(placed);
    return HATCH_OK;
}
