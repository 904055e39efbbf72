/* Algorithm 1 of the paper: crumbs are appended as long as the pattern that they end is still
 * available; at a dead end the last one is taken back. Its line 14 runs one step too far as printed (the
 * last of those patterns is the first snippet, which was spent at the start): the wrapped patterns
 * are K - 1. */
#include "seed/cycle_parts.h"

#include <string.h>

struct search {
    uint8_t *crumbs;
    uint8_t *spent; /* per pattern of K crumbs */
    uint8_t *begin; /* per crumb: the value tried first */
    uint8_t *tried; /* per crumb: how many values have been tried */
    uint32_t count;
    int order; /* K */
};

/* The pattern of K crumbs that ends with crumb number `end`, going round. */
static uint32_t pattern_at(const struct search *search, uint32_t end)
{
    uint32_t pattern = 0;
    for (uint32_t k = (uint32_t)search->order; k-- > 0;)
        pattern = 4 * pattern + search->crumbs[(end + search->count - k) % search->count];
    return pattern;
}

/* Whether the patterns that wrap around are those that are left. */
static bool closes(struct search *search)
{
    uint32_t wrapped = (uint32_t)search->order - 1, taken = 0;
    while (taken < wrapped && !search->spent[pattern_at(search, taken)])
        search->spent[pattern_at(search, taken++)] = 1;
    bool closed = taken == wrapped;
    while (!closed && taken-- > 0)
        search->spent[pattern_at(search, taken)] = 0;
    return closed;
}

/* Tries the values left for crumb number at; whether one could be appended. */
static bool append(struct search *search, uint32_t at, uint64_t *steps)
{
    for (; search->tried[at] < 4; search->tried[at]++) {
        search->crumbs[at] = (uint8_t)((search->begin[at] + search->tried[at]) % 4);
        uint32_t pattern = pattern_at(search, at);
        if (search->spent[pattern])
            continue;
        search->spent[pattern] = 1;
        search->tried[at]++;
        ++*steps;
        return true;
    }
    return false;
}

static enum hatch_status run(struct search *search, uint64_t steps_max, struct cycle_dice *dice, uint64_t *steps,
                             struct hatch_err *err)
{
    uint32_t first = (uint32_t)search->order, at = first;
    search->spent[pattern_at(search, first - 1)] = 1;
    bool forward = true;
    while (at < search->count || !closes(search)) {
        if (at < search->count && forward) {
            search->begin[at] = (uint8_t)cycle_roll(dice, 4);
            search->tried[at] = 0;
        }
        forward = at < search->count && append(search, at, steps);
        if (forward) {
            at++;
        } else {
            if (at-- == first)
                return hatch_fail(err, HATCH_LIMIT, "there is no such cycle");
            search->spent[pattern_at(search, at)] = 0;
        }
        if (*steps > steps_max)
            return hatch_fail(err, HATCH_LIMIT,
                              "backtracking tried %llu crumbs and found no cycle of %u: raise its "
                              "limit or take another method",
                              (unsigned long long)steps_max, search->count);
    }
    return HATCH_OK;
}

enum hatch_status hatch_cycle_backtrack(uint32_t count, uint64_t steps_max, struct cycle_dice *dice,
                                        struct hatch_arena *scratch, uint8_t *crumbs, uint64_t *steps,
                                        struct hatch_err *err)
{
    struct hatch_arena_mark mark = hatch_arena_mark(scratch);
    struct search search = {.count = count, .order = hatch_cycle_order(count)};
    search.crumbs = HATCH_NEW(scratch, uint8_t, count, err);
    search.spent = search.crumbs ? HATCH_NEW(scratch, uint8_t, count, err) : NULL;
    search.begin = search.spent ? HATCH_NEW(scratch, uint8_t, count, err) : NULL;
    search.tried = search.begin ? HATCH_NEW(scratch, uint8_t, count, err) : NULL;
    enum hatch_status status = HATCH_LIMIT;
    if (search.tried) {
        for (int k = 0; k < search.order; k++)
            search.crumbs[k] = (uint8_t)cycle_roll(dice, 4);
        status = run(&search, steps_max, dice, steps, err);
    }
    if (status == HATCH_OK)
        memcpy(crumbs, search.crumbs, count);
    hatch_arena_rewind(scratch, mark);
    return status;
}
