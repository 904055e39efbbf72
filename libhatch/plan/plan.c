#include "plan/plan.h"

#include <assert.h>
#include <math.h>

#include "base/text.h"

struct hatch_plan_figures hatch_plan_no_limits(void)
{
    return (struct hatch_plan_figures){INFINITY, INFINITY, INFINITY, INFINITY};
}

/* Reads one word of a budget.
 *   given  per figure: whether a word has set it */
static enum hatch_status parse_word(struct hatch_text word, struct hatch_plan_figures *limits, bool given[3],
                                    struct hatch_err *err)
{
    static const char *const names[] = {"ms", "mb", "s"};
    double *const values[] = {&limits->ms, &limits->bytes, &limits->setup_s};
    size_t length = 0;
    while (length < word.length && word.at[length] != '=')
        length++;
    for (size_t i = 0; i < 3; i++) {
        if (!hatch_text_is((struct hatch_text){word.at, length}, names[i]) || length == word.length)
            continue;
        const struct hatch_text number = {word.at + length + 1, word.length - length - 1};
        double value;
        if (!hatch_text_number(number, &value) || !(value >= 0))
            return hatch_fail(err, HATCH_USAGE, "%s: '%.*s' is not a number from 0", names[i], (int)number.length,
                              number.at);
        if (given[i])
            return hatch_fail(err, HATCH_USAGE, "%s is given twice", names[i]);
        given[i] = true;
        *values[i] = i == 1 ? 1e6 * value : value;
        return HATCH_OK;
    }
    return hatch_fail(err, HATCH_USAGE, "'%.*s': want words like ms=10, mb=4 or s=5", (int)word.length, word.at);
}

enum hatch_status hatch_plan_parse_budget(const char *text, struct hatch_plan_figures *limits, struct hatch_err *err)
{
    struct hatch_plan_figures read = *limits;
    bool given[3] = {false, false, false};
    for (const char *at = text; *at;) {
        struct hatch_text word = {at, 0};
        while (at[word.length] && at[word.length] != ' ' && at[word.length] != ',')
            word.length++;
        if (word.length)
            HATCH_TRY(parse_word(word, &read, given, err));
        at += word.length + (at[word.length] != '\0');
    }
    if (!given[0] && !given[1] && !given[2])
        return hatch_fail(err, HATCH_USAGE, "nothing is limited: want words like ms=10, mb=4 or s=5");
    *limits = read;
    return HATCH_OK;
}

static double ratio(double value, double limit)
{
    return isinf(limit) || value <= 0 ? 0 : value / limit;
}

double hatch_plan_excess(const struct hatch_plan_figures *figures, const struct hatch_plan_figures *limits,
                         struct hatch_plan_worst *worst)
{
    const struct hatch_plan_worst all[] = {
        {"ms", figures->ms}, {"mb", 1e-6 * figures->bytes}, {"s", figures->setup_s}, {"of tone error", figures->error}};
    const double ratios[] = {ratio(figures->ms, limits->ms), ratio(figures->bytes, limits->bytes),
                             ratio(figures->setup_s, limits->setup_s), ratio(figures->error, limits->error)};
    size_t first = 0;
    for (size_t i = 1; i < 4; i++)
        first = ratios[i] > ratios[first] ? i : first;
    if (worst)
        *worst = all[first];
    return ratios[first];
}

bool hatch_plan_is_nearer(const struct hatch_plan_figures *a, const struct hatch_plan_figures *b,
                          const struct hatch_plan_figures *limits)
{
    const double before[] = {a->ms, a->bytes, a->setup_s, a->error};
    const double after[] = {b->ms, b->bytes, b->setup_s, b->error};
    const double most[] = {limits->ms, limits->bytes, limits->setup_s, limits->error};
    double p = hatch_plan_excess(a, limits, NULL), q = hatch_plan_excess(b, limits, NULL);
    for (size_t i = 0; i < 4 && isinf(p) && isinf(q); i++)
        if (most[i] <= 0 && (before[i] < after[i] || before[i] > after[i]))
            return before[i] < after[i];
    return p < q;
}

double hatch_plan_objective(const struct hatch_plan_figures *figures, const struct hatch_plan_figures *limits)
{
    return isinf(limits->error) ? figures->error : figures->ms;
}

/* Whether a is equal to b or better in all figures. */
static bool covers(const struct hatch_plan_figures *a, const struct hatch_plan_figures *b)
{
    return a->ms <= b->ms && a->bytes <= b->bytes && a->setup_s <= b->setup_s && a->error <= b->error;
}

void hatch_plan_front(const struct hatch_plan_figures *figures, size_t count, bool *useful)
{
    for (size_t i = 0; i < count; i++) {
        useful[i] = true;
        for (size_t j = 0; j < count && useful[i]; j++)
            if (j != i && covers(&figures[j], &figures[i]))
                useful[i] = covers(&figures[i], &figures[j]) && i < j;
    }
}

size_t hatch_plan_choose(const struct hatch_plan_figures *figures, size_t count,
                         const struct hatch_plan_figures *limits)
{
    double least = INFINITY;
    size_t best = count;
    for (size_t i = 0; i < count; i++)
        if (hatch_plan_excess(&figures[i], limits, NULL) <= 1)
            least = fmin(least, hatch_plan_objective(&figures[i], limits));
    for (size_t i = 0; i < count; i++) {
        if (!(hatch_plan_excess(&figures[i], limits, NULL) <= 1) ||
            hatch_plan_objective(&figures[i], limits) > least * (1 + HATCH_PLAN_TIE))
            continue;
        if (best == count || figures[i].bytes < figures[best].bytes ||
            (figures[i].bytes <= figures[best].bytes && figures[i].setup_s < figures[best].setup_s))
            best = i;
    }
    return best;
}

size_t hatch_plan_nearest(const struct hatch_plan_figures *figures, size_t count,
                          const struct hatch_plan_figures *limits)
{
    size_t nearest = 0;
    assert(count > 0);
    for (size_t i = 1; i < count; i++)
        if (hatch_plan_is_nearer(&figures[i], &figures[nearest], limits))
            nearest = i;
    return nearest;
}
