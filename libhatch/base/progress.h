/* How a long computation tells its caller how far it is. */
#ifndef HATCH_BASE_PROGRESS_H
#define HATCH_BASE_PROGRESS_H

struct hatch_progress {
    void (*report)(void *context, double share); /* called often, on one thread; share: 0 .. 1, never falls */
    void *context;
};

/* Reports a share of the work.
 *   progress  NULL: nobody is told */
static inline void hatch_progress_report(const struct hatch_progress *progress, double share)
{
    if (progress)
        progress->report(progress->context, share);
}

#endif
