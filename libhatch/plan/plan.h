/* The choice among candidates by four figures: which are useful, and which is the best within limits. */
#ifndef HATCH_PLAN_H
#define HATCH_PLAN_H

#include <stdbool.h>
#include <stddef.h>

#include "base/status.h"

/* Figures of a candidate, or limits of them. All are at least 0, and less is better. Those of a candidate are finite; a
 * limit of INFINITY is none. */
struct hatch_plan_figures {
    double ms;      /* time of a frame */
    double bytes;   /* of all files that it reads */
    double setup_s; /* processor time to make these */
    double error;   /* of tone */
};

/* Returns limits that every candidate keeps. */
struct hatch_plan_figures hatch_plan_no_limits(void);

/* Reads a budget: words "ms=10", "mb=4" (millions of bytes) or "s=5", each at most once, separated by spaces or commas.
 *   limits  in, out: ms, bytes and setup_s change for the words that are there
 * HATCH_USAGE for anything else, and for a text without a word. */
enum hatch_status hatch_plan_parse_budget(const char *text, struct hatch_plan_figures *limits,
                                          struct hatch_err *err) HATCH_MUST_USE;

/* The figure that exceeds its limit most. */
struct hatch_plan_worst {
    const char *name; /* as in a sentence on its limit: "ms", "mb", "s" or "of tone error" */
    double value;     /* in that unit */
};

/* Returns how many times its limit the worst figure is: at most 1 if the candidate is within the limits. A figure over
 * a limit of 0 counts as INFINITY.
 *   worst  out: that figure, the first one of equal ones; may be NULL */
double hatch_plan_excess(const struct hatch_plan_figures *figures, const struct hatch_plan_figures *limits,
                         struct hatch_plan_worst *worst);

/* Returns whether a comes nearer to the limits than b: its excess is less. Where both exceed limits of 0, the first of
 * the figures with such a limit that differs decides. */
bool hatch_plan_is_nearer(const struct hatch_plan_figures *a, const struct hatch_plan_figures *b,
                          const struct hatch_plan_figures *limits);

/* Returns the figure that the choice makes small: with a limit of the error the time of a frame, else the error. */
double hatch_plan_objective(const struct hatch_plan_figures *figures, const struct hatch_plan_figures *limits);

/* Marks the useful candidates: those to which no other one is equal or better in all four figures. Of equal ones, the
 * first is useful. Takes count² steps.
 *   useful  out: per candidate */
void hatch_plan_front(const struct hatch_plan_figures *figures, size_t count, bool *useful);

/* Objectives that differ by less than this share are taken as equal. */
#define HATCH_PLAN_TIE 0.03

/* Returns the index of the best candidate within the limits; `count` if there is none. Of those whose objectives are
 * within HATCH_PLAN_TIE of the least one, it is the one with the fewest bytes, then with the shortest set-up, then the
 * first. */
size_t hatch_plan_choose(const struct hatch_plan_figures *figures, size_t count,
                         const struct hatch_plan_figures *limits);

/* Returns the index of the candidate to which no other one comes nearer, the first of equal ones.
 *   count  at least 1 */
size_t hatch_plan_nearest(const struct hatch_plan_figures *figures, size_t count,
                          const struct hatch_plan_figures *limits);

#endif
