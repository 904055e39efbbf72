#include <assert.h>

#include "seed/cycle/parts.h"

int hatch_cycle_order(uint32_t count)
{
    int order = 0;
    while (count > 1 && count % 4 == 0) {
        count /= 4;
        order++;
    }
    return count == 1 ? order : -1;
}

/* Chooses edges of the de Bruijn graph and makes a circuit through them. */
static enum hatch_status make_circuit(const struct hatch_cycle_options *options, struct hatch_cycle_rng *rng,
                                      struct hatch_arena *scratch, uint8_t *crumbs, struct hatch_err *err)
{
    bool all = hatch_cycle_order(options->count) > 0; /* every pattern of K crumbs appears once */
    int order = 0;
    while (options->count >> 2 * (order + 1))
        order++;
    order -= all ? 1 : 0;
    size_t edge_count = (size_t)4 << 2 * order;
    uint8_t *edges;
    HATCH_TRY(HATCH_ALLOC(scratch, &edges, edge_count, err));
    for (size_t edge = 0; edge < edge_count && all; edge++)
        edges[edge] = 1;
    if (!all)
        HATCH_TRY(hatch_cycle_balance(options->count, order, rng, scratch, edges, err));
    return hatch_cycle_circuit(edges, order, rng, scratch, crumbs, err);
}

enum hatch_status hatch_cycle_make(const struct hatch_cycle_options *options, struct hatch_arena *scratch,
                                   uint8_t *crumbs, uint64_t *steps, struct hatch_err *err)
{
    struct hatch_cycle_rng rng = {.seed = options->seed, .stream = options->stream};
    uint64_t tried = 0;
    assert(options->count >= HATCH_CYCLE_MIN && options->count <= HATCH_CYCLE_MAX);
    if (options->method != HATCH_CYCLE_ANY && hatch_cycle_order(options->count) < 1)
        return hatch_fail(err, HATCH_USAGE, "%u seed points: this method is for powers of four (4, 16, 64 ...)",
                          options->count);
    struct hatch_arena_mark mark = hatch_arena_mark(scratch);
    enum hatch_status status =
        options->method == HATCH_CYCLE_BACKTRACK
            ? hatch_cycle_backtrack(options->count, options->steps_max, &rng, scratch, crumbs, &tried, err)
            : make_circuit(options, &rng, scratch, crumbs, err);
    hatch_arena_rewind(scratch, mark);
    if (steps)
        *steps = tried;
    return status;
}
