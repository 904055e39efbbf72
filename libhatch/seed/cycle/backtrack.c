/* Algorithm 1 of the paper: appends crumbs as long as each completes an unused pattern of K crumbs, and removes the
 * last one at a dead end. At the wrap-around, line 14 as printed tests one pattern too many: K - 1 patterns wrap
 * around, and the next one is the first snippet, which is used from the start. */
#include "seed/cycle/parts.h"

#include <string.h>

struct search {
    uint8_t *crumbs;
    uint8_t *used;  /* per pattern of K crumbs: 1 if it is used */
    uint8_t *begin; /* per crumb: the value tried first */
    uint8_t *tried; /* per crumb: number of values tried */
    uint32_t count;
    int order; /* K */
};

/* Returns the pattern of K crumbs that ends with crumb `end`, cyclically. */
static uint32_t pattern_at(const struct search *search, uint32_t end)
{
    uint32_t pattern = 0;
    for (uint32_t k = (uint32_t)search->order; k-- > 0;)
        pattern = 4 * pattern + search->crumbs[(end + search->count - k) % search->count];
    return pattern;
}

/* Returns whether the patterns that wrap around are unused; if so, marks them as used. */
static bool closes(struct search *search)
{
    uint32_t wrapped = (uint32_t)search->order - 1, end = 0;
    while (end < wrapped && !search->used[pattern_at(search, end)])
        search->used[pattern_at(search, end++)] = 1;
    bool closed = end == wrapped;
    while (!closed && end-- > 0)
        search->used[pattern_at(search, end)] = 0;
    return closed;
}

/* Puts the next possible value at crumb `at`; returns false if there is none. */
static bool append(struct search *search, uint32_t at, uint64_t *steps)
{
    for (; search->tried[at] < 4; search->tried[at]++) {
        search->crumbs[at] = (uint8_t)((search->begin[at] + search->tried[at]) % 4);
        uint32_t pattern = pattern_at(search, at);
        if (search->used[pattern])
            continue;
        search->used[pattern] = 1;
        search->tried[at]++;
        ++*steps;
        return true;
    }
    return false;
}

static enum hatch_status run(struct search *search, uint64_t steps_max, struct hatch_cycle_rng *rng, uint64_t *steps,
                             struct hatch_err *err)
{
    uint32_t first = (uint32_t)search->order, at = first;
    search->used[pattern_at(search, first - 1)] = 1;
    bool forward = true;
    while (at < search->count || !closes(search)) {
        if (at < search->count && forward) {
            search->begin[at] = (uint8_t)hatch_cycle_random(rng, 4);
            search->tried[at] = 0;
        }
        forward = at < search->count && append(search, at, steps);
        if (forward) {
            at++;
        } else {
            if (at-- == first)
                return hatch_fail(err, HATCH_LIMIT, "no seed set of %u points found", search->count);
            search->used[pattern_at(search, at)] = 0;
        }
        if (*steps > steps_max)
            return hatch_fail(err, HATCH_LIMIT,
                              "backtracking found no seed set of %u points: allow more steps or use another method",
                              search->count);
    }
    return HATCH_OK;
}

enum hatch_status hatch_cycle_backtrack(uint32_t count, uint64_t steps_max, struct hatch_cycle_rng *rng,
                                        struct hatch_arena *scratch, uint8_t *crumbs, uint64_t *steps,
                                        struct hatch_err *err)
{
    struct hatch_arena_mark mark = hatch_arena_mark(scratch);
    struct search search = {.count = count, .order = hatch_cycle_order(count)};
    search.crumbs = HATCH_NEW(scratch, uint8_t, count, err);
    search.used = search.crumbs ? HATCH_NEW(scratch, uint8_t, count, err) : NULL;
    search.begin = search.used ? HATCH_NEW(scratch, uint8_t, count, err) : NULL;
    search.tried = search.begin ? HATCH_NEW(scratch, uint8_t, count, err) : NULL;
    enum hatch_status status = HATCH_LIMIT;
    if (search.tried) {
        for (int k = 0; k < search.order; k++)
            search.crumbs[k] = (uint8_t)hatch_cycle_random(rng, 4);
        status = run(&search, steps_max, rng, steps, err);
    }
    if (status == HATCH_OK)
        memcpy(crumbs, search.crumbs, count);
    hatch_arena_rewind(scratch, mark);
    return status;
}
