/* The search for the best candidate, which measures as few as it can. It looks at one candidate of each technique in
 * small pictures, goes on to the neighbours of those that may lead to the best one, measures those that may be the best
 * in full, and times the best of these again in turns. */
#include "hatchplan/hatchplan.h"

#include <math.h>
#include <string.h>

/* How often pictures are drawn: at least `draws` times, and as often as plain frames take `plain_ms`, since short times
 * are less certain on a busy machine. */
struct effort {
    double draws, plain_ms;
};
static const struct effort first_look = {2, 15}, first_full = {3, 40}, each_round = {4, 60}, exhaustive = {5, 60};

#define DRAWS_MAX 20
#define ROUNDS 2

/* Factors by which figures may be better than a look or a first time tells. */
#define LOOK_MS 1.25
#define LOOK_ERROR 1.3
#define FULL_MS 1.05

#define NEAR 1.3  /* candidates with at most this many times the best one's objective may lead to a better one */
#define GAIN 0.05 /* least relative gain of a step that is worth another one */
#define FULL_MAX 5
#define FINALISTS_MAX 3

static bool is_open(const struct plan *plan)
{
    const struct hatch_plan_figures *limits = &plan->limits;
    return isinf(limits->ms) && isinf(limits->bytes) && isinf(limits->setup_s) && isinf(limits->error);
}

static double objective(const struct plan *plan, const struct plan_candidate *candidate)
{
    return hatch_plan_objective(&candidate->figures, &plan->limits);
}

static double excess(const struct plan *plan, const struct plan_candidate *candidate)
{
    return hatch_plan_excess(&candidate->figures, &plan->limits, NULL);
}

static bool is_nearer(const struct plan *plan, const struct plan_candidate *a, const struct plan_candidate *b)
{
    return hatch_plan_is_nearer(&a->figures, &b->figures, &plan->limits);
}

/* The best so far of the candidates of a state or a later one. */
struct lead {
    double objective; /* the least one within the limits; INFINITY: none is within them */
    double excess;    /* the least one */
};

static struct lead lead_of(const struct plan *plan, enum plan_state state)
{
    struct lead lead = {INFINITY, INFINITY};
    for (uint32_t i = 0; i < plan->candidate_count; i++) {
        const struct plan_candidate *candidate = &plan->candidates[i];
        if (candidate->state < state)
            continue;
        lead.excess = fmin(lead.excess, excess(plan, candidate));
        if (excess(plan, candidate) <= 1)
            lead.objective = fmin(lead.objective, objective(plan, candidate));
    }
    return lead;
}

static void measure(struct plan *plan, struct plan_candidate *candidate, bool small, const struct effort *effort)
{
    double plain_ms = plan->plain_ms * (small ? PLAN_SMALL * PLAN_SMALL : 1);
    plan_measure(plan, candidate, small, (uint32_t)fmax(effort->draws, fmin(effort->plain_ms / plain_ms, DRAWS_MAX)));
}

/* Makes the files of a candidate and draws it for the first time. */
static void look(struct plan *plan, struct plan_candidate *candidate)
{
    if (plan_make_files(plan, candidate))
        measure(plan, candidate, plan->has_small, &first_look);
}

/* Whether a candidate is better than the one that suggested it. */
static bool has_gained(const struct plan *plan, const struct plan_candidate *candidate)
{
    const struct plan_candidate *parent = candidate->parent;
    if (!parent || is_open(plan) || parent->state < PLAN_LOOKED)
        return true;
    double before = excess(plan, parent), after = excess(plan, candidate);
    if (before <= 1 && after <= 1)
        return objective(plan, candidate) < (1 - GAIN) * objective(plan, parent);
    return after < (1 - GAIN) * before;
}

/* Whether a candidate may lead to the best one.
 *   useful  it is on the front */
static bool is_promising(const struct plan *plan, const struct plan_candidate *candidate, const struct lead *lead,
                         bool useful)
{
    if (candidate->state < PLAN_LOOKED || !has_gained(plan, candidate))
        return false;
    if (is_open(plan))
        return useful;
    double over = excess(plan, candidate);
    if (isinf(lead->objective))
        return over <= NEAR * lead->excess;
    return over <= NEAR && objective(plan, candidate) <= NEAR * lead->objective;
}

/* Whether a neighbour that takes more work may be of use: a candidate that is exact enough need not become more so. */
static bool needs_more(const struct plan *plan, const struct plan_candidate *candidate)
{
    return isinf(plan->limits.error) || candidate->figures.error > plan->limits.error;
}

/* A candidate to look at, and the promising one that suggests it. */
struct suggestion {
    struct plan_candidate *next, *from;
};

static void suggest(const struct plan *plan, struct plan_candidate *next, struct plan_candidate *from,
                    struct suggestion *best)
{
    if (next && next->state == PLAN_UNTRIED && (!best->next || objective(plan, from) < objective(plan, best->from)))
        *best = (struct suggestion){next, from};
}

/* Returns the candidate to look at next, suggested by the best one that suggests any; NULL: there is none. */
static struct plan_candidate *next_look(const struct plan *plan)
{
    struct suggestion best = {NULL, NULL};
    const struct hatch_arena_mark mark = hatch_arena_mark(&plan->args->scratch);
    const bool *useful = plan_mark_useful(plan, PLAN_LOOKED);
    const struct lead lead = lead_of(plan, PLAN_LOOKED);
    for (uint32_t i = 0; i < plan->candidate_count; i++) {
        struct plan_candidate *candidate = &plan->candidates[i];
        bool promising = is_promising(plan, candidate, &lead, useful[i]);
        for (uint32_t axis = 0; axis < PLAN_AXES; axis++) {
            if (promising && needs_more(plan, candidate))
                suggest(plan, plan_neighbour(plan, candidate, axis, 1), candidate, &best);
            if (promising || candidate->state == PLAN_OVER)
                suggest(plan, plan_neighbour(plan, candidate, axis, -1), candidate, &best);
        }
        for (uint32_t j = 0; promising && j < plan->candidate_count; j++) {
            const char *after = plan->candidates[j].technique->after;
            if (after && plan_is_first(&plan->candidates[j]) && strcmp(after, candidate->technique->name) == 0)
                suggest(plan, &plan->candidates[j], candidate, &best);
        }
    }
    hatch_arena_rewind(&plan->args->scratch, mark);
    if (best.next)
        best.next->parent = best.from;
    return best.next;
}

/* Returns what the figures of a candidate may become when it is measured better. */
static struct hatch_plan_figures hope_of(const struct plan_candidate *candidate)
{
    struct hatch_plan_figures hope = candidate->figures;
    hope.ms /= candidate->state == PLAN_LOOKED ? LOOK_MS : FULL_MS;
    hope.error /= candidate->state == PLAN_LOOKED ? LOOK_ERROR : 1;
    return hope;
}

/* Returns the candidate to measure in full next: of those that may become the best, the one that now seems to be; NULL:
 * there is none. */
static struct plan_candidate *next_full(const struct plan *plan, const bool *useful)
{
    const struct lead lead = lead_of(plan, PLAN_MEASURED);
    struct plan_candidate *best = NULL;
    double best_over = 0, best_objective = 0;
    for (uint32_t i = 0; i < plan->candidate_count; i++) {
        struct plan_candidate *candidate = &plan->candidates[i];
        const struct hatch_plan_figures hope = hope_of(candidate);
        double over = fmax(excess(plan, candidate), 1);
        if (candidate->state != PLAN_LOOKED || (is_open(plan) && !useful[i]) ||
            (!is_open(plan) && hatch_plan_objective(&hope, &plan->limits) >= (1 - HATCH_PLAN_TIE) * lead.objective) ||
            (!isinf(lead.excess) && hatch_plan_excess(&hope, &plan->limits, NULL) > 1))
            continue;
        bool equal = best && over <= best_over && over >= best_over;
        if (!best || over < best_over || (equal && isinf(over) && is_nearer(plan, candidate, best)) ||
            (equal && !isinf(over) && objective(plan, candidate) < best_objective)) {
            best = candidate;
            best_over = over;
            best_objective = objective(plan, candidate);
        }
    }
    return best;
}

/* Whether the choice may depend on knowing the time of a candidate better. */
static bool is_finalist(const struct plan *plan, const struct plan_candidate *candidate, const struct lead *lead)
{
    const struct hatch_plan_figures hope = hope_of(candidate);
    if (candidate->state != PLAN_MEASURED || hatch_plan_excess(&hope, &plan->limits, NULL) > 1)
        return false;
    if (isinf(plan->limits.error)) /* the time is a limit */
        return candidate->figures.ms * FULL_MS > plan->limits.ms && objective(plan, candidate) <= lead->objective;
    return hatch_plan_objective(&hope, &plan->limits) <= lead->objective;
}

/* Times the candidates near the best one again, in turns, so that the load of the machine affects all alike. Ends early
 * when the choice no longer depends on it. */
static void compare_finalists(struct plan *plan)
{
    for (int round = 0; round < ROUNDS; round++) {
        struct plan_candidate *finalists[FINALISTS_MAX];
        uint32_t count = 0;
        double most = 0;
        const struct lead lead = lead_of(plan, PLAN_MEASURED);
        for (uint32_t i = 0; i < plan->candidate_count && count < FINALISTS_MAX; i++)
            if (is_finalist(plan, &plan->candidates[i], &lead)) {
                finalists[count++] = &plan->candidates[i];
                most = fmax(most, objective(plan, &plan->candidates[i]));
            }
        if (isinf(plan->limits.ms) && most <= (1 + HATCH_PLAN_TIE) * lead.objective)
            return;
        for (uint32_t i = 0; i < count; i++)
            measure(plan, finalists[i], false, &each_round);
    }
}

void plan_search(struct plan *plan)
{
    for (uint32_t i = 0; i < plan->candidate_count; i++) {
        struct plan_candidate *candidate = &plan->candidates[i];
        cmd_progress("techniques tried", (double)i / plan->candidate_count);
        if (plan_is_first(candidate) && !plan_is_suggested(plan, candidate))
            look(plan, candidate);
    }
    for (struct plan_candidate *next = next_look(plan); next; next = next_look(plan))
        look(plan, next);
    const bool *useful = plan_mark_useful(plan, PLAN_LOOKED);
    struct plan_candidate *next = next_full(plan, useful);
    for (uint32_t count = 0; next && (count < FULL_MAX || is_open(plan)); next = next_full(plan, useful), count++)
        measure(plan, next, false, &first_full);
    if (!is_open(plan))
        compare_finalists(plan);
}

void plan_search_all(struct plan *plan)
{
    const double rounds = (double)plan->options->rounds;
    for (int round = 0; round < rounds; round++)
        for (uint32_t i = 0; i < plan->candidate_count; i++) {
            struct plan_candidate *candidate = &plan->candidates[i];
            cmd_progress("candidates measured", (round + (double)i / plan->candidate_count) / rounds);
            if (round > 0 ? candidate->state == PLAN_MEASURED : plan_make_files(plan, candidate))
                measure(plan, candidate, false, &exhaustive);
        }
}
