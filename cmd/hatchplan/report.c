/* The results: the table, the choice, and variables of make. */
#include "hatchplan/hatchplan.h"

#include <stdlib.h>

#include "shared/report.h"

/* The candidates of a state or a later one, with their figures side by side, in args->scratch. */
struct group {
    struct hatch_plan_figures *figures;
    uint32_t *which; /* indices of the candidates */
    size_t count;
};

static struct group collect(const struct plan *plan, enum plan_state state)
{
    struct hatch_err err;
    struct hatch_arena *scratch = &plan->args->scratch;
    struct group group = {.figures = HATCH_NEW(scratch, struct hatch_plan_figures, plan->candidate_count, &err),
                          .which = HATCH_NEW(scratch, uint32_t, plan->candidate_count, &err)};
    cmd_check(group.figures && group.which ? HATCH_OK : HATCH_LIMIT, NULL, &err);
    for (uint32_t i = 0; i < plan->candidate_count; i++)
        if (plan->candidates[i].state >= state) {
            group.figures[group.count] = plan->candidates[i].figures;
            group.which[group.count++] = i;
        }
    return group;
}

bool *plan_mark_useful(const struct plan *plan, enum plan_state state)
{
    struct hatch_err err;
    struct hatch_arena *scratch = &plan->args->scratch;
    const struct group group = collect(plan, state);
    bool *front = HATCH_NEW(scratch, bool, plan->candidate_count, &err);
    bool *useful = HATCH_NEW(scratch, bool, plan->candidate_count, &err);
    cmd_check(front && useful ? HATCH_OK : HATCH_LIMIT, NULL, &err);
    hatch_plan_front(group.figures, group.count, front);
    for (size_t i = 0; i < group.count; i++)
        useful[group.which[i]] = front[i];
    return useful;
}

struct plan_candidate *plan_choice(const struct plan *plan)
{
    const struct group group = collect(plan, PLAN_MEASURED);
    size_t best = hatch_plan_choose(group.figures, group.count, &plan->limits);
    return best < group.count ? &plan->candidates[group.which[best]] : NULL;
}

struct plan_candidate *plan_nearest(const struct plan *plan)
{
    static const enum plan_state states[] = {PLAN_MEASURED, PLAN_LOOKED, PLAN_OVER};
    for (size_t i = 0; i < 3; i++) {
        const struct group group = collect(plan, states[i]);
        if (group.count)
            return &plan->candidates[group.which[hatch_plan_nearest(group.figures, group.count, &plan->limits)]];
    }
    return NULL;
}

static int compare_times(const void *a, const void *b)
{
    const struct plan_candidate *const *x = a, *const *y = b;
    double p = (*x)->figures.ms, q = (*y)->figures.ms;
    return p != q ? (p > q) - (p < q) : (*x > *y) - (*x < *y);
}

void plan_report(const struct plan *plan, const struct plan_candidate *chosen, bool all, struct cmd_output *output)
{
    static const char *const columns[] = {"technique", "parameters",   "ms",     "bytes", "setup_s",
                                          "tone_rms",  "grey_strokes", "chosen", NULL};
    const bool *useful = plan_mark_useful(plan, PLAN_MEASURED);
    struct cmd_report report;
    struct hatch_err err;
    const struct plan_candidate **rows =
        HATCH_NEW(&plan->args->scratch, const struct plan_candidate *, plan->candidate_count, &err);
    cmd_check(rows ? HATCH_OK : HATCH_LIMIT, NULL, &err);
    size_t count = 0;
    for (uint32_t i = 0; i < plan->candidate_count; i++) {
        const struct plan_candidate *candidate = &plan->candidates[i];
        if (candidate->state == PLAN_MEASURED && (all || useful[i] || candidate == chosen))
            rows[count++] = candidate;
    }
    qsort(rows, count, sizeof *rows, compare_times);
    cmd_report_begin(&report, plan->args, columns);
    for (size_t i = 0; i < count; i++) {
        const struct plan_candidate *row = rows[i];
        char text[128];
        plan_describe(plan, row, text, sizeof text);
        cmd_report_text(&report, row->technique->name);
        cmd_report_text(&report, text);
        cmd_report_number(&report, row->figures.ms);
        cmd_report_integer(&report, (uint64_t)row->figures.bytes);
        cmd_report_number(&report, row->figures.setup_s);
        cmd_report_number(&report, row->figures.error);
        cmd_report_number(&report, row->grey);
        cmd_report_text(&report, row == chosen ? "yes" : "no");
    }
    cmd_report_write(&report, output);
}

/* Adds a line that sets a variable.
 *   first  index of the first word */
static void add_variable(struct hatch_buffer *text, const char *name, const struct cmd_child_words *words,
                         uint32_t first)
{
    struct hatch_err err;
    cmd_check(hatch_buffer_print(text, &err, "%s :=", name), NULL, &err);
    for (uint32_t i = first; i < words->count; i++)
        plan_add_word(text, words->at[i]);
    cmd_check(hatch_buffer_print(text, &err, "\n"), NULL, &err);
}

/* Adds a line that sets a variable to words that are a text already. */
static void add_text(struct hatch_buffer *text, const char *name, const struct hatch_buffer *words)
{
    struct hatch_err err;
    cmd_check(hatch_buffer_print(text, &err, "%s :=%.*s\n", name, (int)words->size, (const char *)words->data), NULL,
              &err);
}

/* Adds the options of the command that makes an asset, as the variable of the command's name in capitals. */
static void add_recipe(struct plan *plan, struct hatch_buffer *text, const struct plan_asset *asset)
{
    struct cmd_child_words words;
    char name[32] = "";
    cmd_child_begin(&words, plan->args, plan_command(asset->kind));
    plan_add_recipe(plan, asset, &words);
    for (size_t i = 0; words.at[0][i]; i++)
        name[i] = (char)(words.at[0][i] - 'a' + 'A');
    add_variable(text, name, &words, 1);
}

void plan_write_make(struct plan *plan, const struct plan_candidate *chosen, struct cmd_output *output)
{
    static const char *const reads[] = {
        [PLAN_NOTHING] = "nothing",       [PLAN_MAP] = "map",     [PLAN_VOLUME] = "volume",
        [PLAN_THRESHOLDS] = "thresholds", [PLAN_SOLID] = "solid", [PLAN_STROKES] = "strokes"};
    struct hatch_buffer text = {.arena = &plan->args->keep};
    struct cmd_child_words words;
    cmd_child_begin(&words, plan->args, reads[chosen->technique->kind]);
    add_variable(&text, "READS", &words, 0);
    words.count = 0;
    if (plan_needs_patches(plan, chosen))
        cmd_child_add(&words, "1");
    add_variable(&text, "PATCHES", &words, 0);
    const struct plan_asset *asset = plan_own_asset(plan, chosen);
    if (chosen->technique->kind == PLAN_STROKES)
        asset = plan_scene_asset(plan, chosen, 0);
    for (; asset; asset = plan_source(plan, asset))
        if (asset->kind != PLAN_FIELD)
            add_recipe(plan, &text, asset);
    words.count = 0;
    plan_add_technique(plan, chosen, &words);
    plan_add_view(plan, (uint32_t)plan->options->frames, 1, &words);
    add_variable(&text, "DRAW", &words, 0);
    add_text(&text, "INPUTS", &plan->inputs);
    add_text(&text, "STAMPS", &plan->stamps);
    cmd_write(output, text.data, text.size);
}
