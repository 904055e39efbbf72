/* A limit of memory that several arenas keep together, also on several threads. */
#ifndef HATCH_BASE_BUDGET_H
#define HATCH_BASE_BUDGET_H

#include <stdatomic.h>
#include <stdbool.h>
#include <stddef.h>

struct hatch_budget {
    size_t limit_bytes;
    atomic_size_t used_bytes; /* 0 .. limit_bytes */
};

/* Makes a budget of which nothing is used.
 *   limit_bytes  1 .. SIZE_MAX */
static inline void hatch_budget_init(struct hatch_budget *budget, size_t limit_bytes)
{
    budget->limit_bytes = limit_bytes;
    atomic_init(&budget->used_bytes, 0);
}

/* Takes memory from a budget. Returns false, and takes none, if so much is not left. */
static inline bool hatch_budget_take(struct hatch_budget *budget, size_t bytes)
{
    size_t used = atomic_load(&budget->used_bytes);
    do {
        if (bytes > budget->limit_bytes - used)
            return false;
    } while (!atomic_compare_exchange_weak(&budget->used_bytes, &used, used + bytes));
    return true;
}

/* Gives memory back to the budget that it was taken from. */
static inline void hatch_budget_give(struct hatch_budget *budget, size_t bytes)
{
    atomic_fetch_sub(&budget->used_bytes, bytes);
}

#endif
