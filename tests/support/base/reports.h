/* Reports of progress that a test receives: their shares rise, and are at most 1. */
#ifndef HATCH_TEST_BASE_REPORTS_H
#define HATCH_TEST_BASE_REPORTS_H

#include "run.h"

struct reports {
    uint32_t count;
    double last; /* share */
};

/* The function of a struct hatch_progress.
 *   context  struct reports, zeroed at first */
static inline void note_share(void *context, double share)
{
    struct reports *reports = context;
    ck_assert(share >= reports->last && share <= 1 + 1e-12);
    reports->last = share;
    reports->count++;
}

#endif
