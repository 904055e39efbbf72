#include "seed/seeds_make.h"

#include <math.h>
#include <string.h>

#include "seed/spread.h"

struct choice {
    const struct hatch_seeds_options *options;
    struct hatch_seed_point *points; /* those of the chosen layers, followed by those of a candidate */
    uint32_t chosen;                 /* number of points of the chosen layers */
    struct hatch_spread_cells cells; /* points of the chosen layers; unset while there is none */
    double distance;                 /* smallest distance between points of the chosen layers */
    uint8_t *crumbs;                 /* of a candidate */
    uint64_t steps;                  /* sum over all calls of hatch_cycle_make */
};

/* Makes a candidate.
 *   left   steps that a search may take
 *   found  out: false if the search has used them up */
static enum hatch_status make_candidate(struct choice *choice, uint64_t stream, uint64_t left, bool *found,
                                        struct hatch_arena *scratch, struct hatch_err *err)
{
    struct hatch_cycle_options cycle = choice->options->cycle;
    uint64_t steps = 0;
    cycle.stream = stream;
    cycle.steps_max = left;
    enum hatch_status status = hatch_cycle_make(&cycle, scratch, choice->crumbs, &steps, err);
    choice->steps += steps;
    *found = status == HATCH_OK;
    return steps > left ? HATCH_OK : status;
}

/* Computes the goodness of a candidate, as hatch_seeds_make describes, or a value up to `best` if it is at most that. A
 * candidate that is not better is mostly recognised at its first points. */
static enum hatch_status rate(struct choice *choice, double best, struct hatch_arena *scratch, double *goodness,
                              struct hatch_err *err)
{
    const struct hatch_seed_set set = {choice->options->cycle.count, choice->crumbs};
    const struct hatch_seed_point *points = choice->points + choice->chosen;
    double distance;
    hatch_seed_points(&set, choice->points + choice->chosen);
    HATCH_TRY(hatch_spread_distance(points, set.count, scratch, &distance, err));
    double own = distance / hatch_spread_bound(set.count);
    *goodness = own;
    if (!choice->chosen)
        return HATCH_OK;
    double bound = hatch_spread_bound(choice->chosen + set.count), together = fmin(distance, choice->distance);
    *goodness = own * (own * together / bound);
    for (uint32_t i = 0; i < set.count; i++) {
        if (*goodness <= best)
            break;
        together = hatch_spread_nearest(&choice->cells, &points[i], together);
        *goodness = own * (own * together / bound);
    }
    return HATCH_OK;
}

static uint32_t count_candidates(const struct hatch_seeds_options *options)
{
    uint32_t affordable = 100000u / options->cycle.count;
    if (options->candidates)
        return options->candidates;
    return affordable > 1000 ? 1000 : affordable > 1 ? affordable : 1;
}

/* Chooses the best of the candidates for a layer. They share the steps of a search, since one that does not end soon
 * hardly ever does; it is left out. */
static enum hatch_status choose_layer(struct choice *choice, uint32_t layer, const struct hatch_seed_set *set,
                                      struct hatch_arena *scratch, struct hatch_err *err)
{
    uint32_t candidates = count_candidates(choice->options);
    uint64_t steps_max = choice->options->cycle.steps_max, before = choice->steps;
    double best = -1;
    for (uint32_t i = 0; i < candidates; i++) {
        double goodness = 0;
        uint64_t taken = choice->steps - before, left = steps_max > taken ? steps_max - taken : 0;
        bool found;
        HATCH_TRY(make_candidate(choice, (uint64_t)layer << 32 | i, left / (candidates - i), &found, scratch, err));
        hatch_progress_report(choice->options->progress, (layer + (i + 1.0) / candidates) / choice->options->layers);
        if (!found)
            continue;
        if (candidates > 1)
            HATCH_TRY(rate(choice, best, scratch, &goodness, err));
        if (goodness <= best)
            continue;
        best = goodness;
        memcpy(set->crumbs, choice->crumbs, set->count);
    }
    if (best < 0)
        return HATCH_LIMIT; /* as the last candidate has said */
    hatch_seed_points(set, choice->points + choice->chosen);
    choice->chosen += set->count;
    return HATCH_OK;
}

/* Makes a layer that is spread well among the chosen ones. */
static enum hatch_status add_layer(struct choice *choice, uint32_t layer, const struct hatch_seed_set *set,
                                   struct hatch_arena *scratch, struct hatch_err *err)
{
    struct hatch_arena_mark mark = hatch_arena_mark(scratch);
    enum hatch_status status = HATCH_OK;
    if (choice->chosen && count_candidates(choice->options) > 1) {
        status = hatch_spread_distance(choice->points, choice->chosen, scratch, &choice->distance, err);
        if (status == HATCH_OK)
            status = hatch_spread_sort(choice->points, choice->chosen, scratch, &choice->cells, err);
    }
    if (status == HATCH_OK)
        status = choose_layer(choice, layer, set, scratch, err);
    hatch_arena_rewind(scratch, mark);
    return status;
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
        choice.points = HATCH_NEW(scratch, struct hatch_seed_point, (size_t)count * options->layers, err);
    choice.crumbs = choice.points ? HATCH_NEW(scratch, uint8_t, count, err) : NULL;
    enum hatch_status status = choice.crumbs ? HATCH_OK : HATCH_LIMIT;
    for (uint32_t i = 0; status == HATCH_OK && i < options->layers; i++) {
        made.layers[i].count = count;
        made.layers[i].crumbs = HATCH_NEW(arena, uint8_t, count, err);
        status = made.layers[i].crumbs ? add_layer(&choice, i, &made.layers[i], scratch, err) : HATCH_LIMIT;
    }
    hatch_arena_rewind(scratch, mark);
    HATCH_TRY(status);
    *seeds = made;
    *steps = choice.steps;
    return HATCH_OK;
}
