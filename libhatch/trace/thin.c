/* Thinning of seeds that are too near to one another, by their ids: the result does not depend on their order. */
#include <math.h>

#include "trace/grid.h"
#include "trace/work.h"

#define ALONG_CLEAR 6.0  /* of the gap: least distance of two new seeds on one line, */
#define ACROSS_CLEAR 0.9 /* and beside one another */
#define ROUNDS 3u

/* Seeds in a grid. */
struct thinning {
    struct hatch_trace_seed *seeds;
    bool *chosen; /* per seed */
    double gap;
    struct hatch_trace_grid grid;
};

/* Returns whether one of two seeds must go. */
static bool in_conflict(const struct hatch_trace_seed *a, const struct hatch_trace_seed *b, double gap)
{
    double along = 0, square = 0, agree = 0;
    for (int k = 0; k < 3; k++) {
        double way = (double)b->at[k] - (double)a->at[k];
        along += way * (double)a->heading[k];
        agree += (double)a->normal[k] * (double)b->normal[k];
        square += way * way;
    }
    return agree > 0 && fabs(along) < ALONG_CLEAR * gap &&
           square - along * along < ACROSS_CLEAR * gap * (ACROSS_CLEAR * gap);
}

/* Chooses a seed that has the highest id among those in conflict with it, or drops one that is in conflict with a
 * chosen one. */
static void judge(struct thinning *thinning, uint32_t i, bool choosing)
{
    struct hatch_trace_seed *seed = &thinning->seeds[i];
    uint32_t heads[27], count = hatch_trace_grid_near(&thinning->grid, seed->at, thinning->grid.cell, heads);
    bool best = true, beaten = false;
    for (uint32_t h = 0; h < count; h++)
        for (uint32_t j = heads[h]; j != HATCH_TRACE_NONE; j = thinning->grid.next[j]) {
            const struct hatch_trace_seed *other = &thinning->seeds[j];
            if (j == i || !other->valid || !(choosing ? other->id > seed->id : thinning->chosen[j]))
                continue;
            bool conflict = in_conflict(seed, other, thinning->gap) || in_conflict(other, seed, thinning->gap);
            best = best && !conflict;
            beaten = beaten || conflict;
        }
    if (choosing)
        thinning->chosen[i] = best;
    else if (beaten)
        seed->valid = false;
}

enum hatch_status hatch_trace_thin(const struct hatch_tracer *tracer, struct hatch_trace_seed *seeds, uint32_t count,
                                   struct hatch_err *err)
{
    struct thinning thinning = {.seeds = seeds, .gap = tracer->gap};
    hatch_trace_grid_begin(ALONG_CLEAR * tracer->gap, tracer->scratch, &thinning.grid);
    HATCH_TRY(HATCH_ALLOC(tracer->scratch, &thinning.chosen, count, err));
    for (uint32_t i = 0; i < count; i++)
        if (seeds[i].valid)
            HATCH_TRY(hatch_trace_grid_add(&thinning.grid, i, seeds[i].at, err));
    for (uint32_t round = 0; round < ROUNDS; round++)
        for (int choosing = 1; choosing >= 0; choosing--)
            for (uint32_t i = 0; i < count; i++)
                if (seeds[i].valid && !thinning.chosen[i])
                    judge(&thinning, i, choosing);
    for (uint32_t i = 0; i < count; i++)
        seeds[i].valid = thinning.chosen[i];
    return HATCH_OK;
}
