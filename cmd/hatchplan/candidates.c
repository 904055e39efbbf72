/* The candidates: techniques with their parameters. */
#include "hatchplan/hatchplan.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

/* Parameters of techniques; assets.c and plan_add_technique tell what they do. */
#define SIZE(count, first, ...)                                                                                        \
    {                                                                                                                  \
        "size", count, first,                                                                                          \
        {                                                                                                              \
            __VA_ARGS__                                                                                                \
        }                                                                                                              \
    }
#define MAP_SIZES SIZE(4, 1, 128, 256, 512, 1024)
#define FEW_SIZES SIZE(2, 0, 128, 512)
#define SIX_TONES                                                                                                      \
    {                                                                                                                  \
        "tones", 1, 0,                                                                                                 \
        {                                                                                                              \
            6                                                                                                          \
        }                                                                                                              \
    }

static const struct plan_technique techniques[] = {
    {"solid", NULL, PLAN_SOLID, false, {SIZE(3, 1, 32, 64, 128)}},
    {"tam", NULL, PLAN_MAP, true, {MAP_SIZES, {"tones", 3, 0, {6, 12, 24}}}},
    {"tam-face", "tam", PLAN_MAP, true, {FEW_SIZES, SIX_TONES}},
    {"tam-flat", "tam-face", PLAN_MAP, true, {FEW_SIZES, SIX_TONES}},
    {"tam-gouraud", "tam-flat", PLAN_MAP, true, {FEW_SIZES, SIX_TONES}},
    {"tam-triple", "tam-face", PLAN_MAP, true, {FEW_SIZES, SIX_TONES}},
    {"tam-threshold", "tam", PLAN_MAP, true, {FEW_SIZES, SIX_TONES}},
    {"volume", NULL, PLAN_VOLUME, true, {SIZE(3, 1, 128, 256, 512), {"tones", 2, 0, {16, 64}}}},
    {"threshold", NULL, PLAN_THRESHOLDS, true, {SIZE(3, 1, 128, 256, 512), {"exact", 2, 0, {0, 1}}}},
    {"threshold-soft", "threshold", PLAN_THRESHOLDS, true, {FEW_SIZES, {"exact", 1, 0, {0}}}},
    {"rptam", NULL, PLAN_NOTHING, true, {{"length", 3, 1, {40, 20, 10}}}},
    {"strokes", "rptam", PLAN_NOTHING, true, {{"length", 3, 1, {40, 20, 10}}, {"blend", 2, 0, {0, 1}}}},
    {"traced", NULL, PLAN_STROKES, false, {{"levels", 3, 0, {5, 6, 7}}}},
};
#define TECHNIQUES (sizeof techniques / sizeof *techniques)

/* Refuses a name in --techniques that is none of a technique. */
static void check_names(const char *list)
{
    const char *names[TECHNIQUES + 1] = {NULL};
    for (size_t i = 0; i < TECHNIQUES; i++)
        names[i] = techniques[i].name;
    for (const char *at = list; at; at = strchr(at, ',')) {
        char word[64];
        at += *at == ',' && at != list;
        snprintf(word, sizeof word, "%.*s", (int)strcspn(at, ","), at);
        if (cmd_find_name(names, word) < 0)
            cmd_refuse_name("--techniques", word, names, NULL);
    }
}

static bool is_listed(const char *list, const char *name)
{
    size_t length = strlen(name);
    for (const char *at = list; at; at = strchr(at, ',')) {
        at += *at == ',';
        if (strncmp(at, name, length) == 0 && (at[length] == ',' || !at[length]))
            return true;
    }
    return false;
}

/* Number of values of a parameter; 1 if the technique has no such parameter. */
static uint32_t axis_count(const struct plan *plan, const struct plan_technique *technique, uint32_t axis)
{
    if (axis == PLAN_AXES - 1)
        return plan->options->sample_count;
    return technique->axes[axis].name ? technique->axes[axis].count : 1;
}

void plan_list_candidates(struct plan *plan)
{
    struct hatch_err err;
    uint32_t count = 0;
    const char *list = plan->options->techniques;
    if (list)
        check_names(list);
    for (size_t i = 0; i < TECHNIQUES; i++) {
        const struct plan_technique *technique = &techniques[i];
        count += axis_count(plan, technique, 0) * axis_count(plan, technique, 1) * axis_count(plan, technique, 2);
    }
    plan->candidates = HATCH_NEW(&plan->args->keep, struct plan_candidate, count, &err);
    cmd_check(plan->candidates ? HATCH_OK : HATCH_LIMIT, NULL, &err);
    for (size_t i = 0; i < TECHNIQUES; i++) {
        const struct plan_technique *technique = &techniques[i];
        if (list && !is_listed(list, technique->name))
            continue;
        for (uint32_t a = 0; a < axis_count(plan, technique, 0); a++)
            for (uint32_t b = 0; b < axis_count(plan, technique, 1); b++)
                for (uint32_t c = 0; c < axis_count(plan, technique, 2); c++)
                    plan->candidates[plan->candidate_count++] =
                        (struct plan_candidate){.technique = technique, .at = {a, b, c}};
    }
}

bool plan_is_first(const struct plan_candidate *candidate)
{
    const struct plan_axis *axes = candidate->technique->axes;
    return candidate->at[0] == axes[0].first && candidate->at[1] == axes[1].first && candidate->at[2] == 0;
}

bool plan_is_suggested(const struct plan *plan, const struct plan_candidate *candidate)
{
    const char *list = plan->options->techniques, *after = candidate->technique->after;
    return after && (!list || is_listed(list, after));
}

double plan_value(const struct plan *plan, const struct plan_candidate *candidate, uint32_t axis)
{
    if (axis == PLAN_AXES - 1)
        return plan->options->samples[candidate->at[axis]];
    return candidate->technique->axes[axis].values[candidate->at[axis]];
}

struct plan_candidate *plan_neighbour(const struct plan *plan, const struct plan_candidate *candidate, uint32_t axis,
                                      int step)
{
    const struct plan_technique *technique = candidate->technique;
    uint32_t next = candidate->at[axis] + (uint32_t)step, stride = 1; /* wraps below 0 */
    if (next >= axis_count(plan, technique, axis))
        return NULL;
    for (uint32_t after = axis + 1; after < PLAN_AXES; after++)
        stride *= axis_count(plan, technique, after);
    return &plan->candidates[candidate - plan->candidates + step * (int)stride];
}

void plan_describe(const struct plan *plan, const struct plan_candidate *candidate, char *text, size_t bytes)
{
    size_t used = 0;
    for (uint32_t axis = 0; axis < 2 && used < bytes; axis++) {
        const struct plan_axis *parameter = &candidate->technique->axes[axis];
        if (parameter->name)
            used += (size_t)snprintf(text + used, bytes - used, "%s=%g ", parameter->name,
                                     plan_value(plan, candidate, axis));
    }
    if (used < bytes)
        snprintf(text + used, bytes - used, "samples=%g%s", plan_value(plan, candidate, PLAN_AXES - 1),
                 plan_needs_patches(plan, candidate) ? " patches=1" : "");
}

bool plan_needs_patches(const struct plan *plan, const struct plan_candidate *candidate)
{
    bool any = false;
    for (uint32_t i = 0; i < plan->file_count; i++)
        any = any || !plan->files[i].has_places;
    return candidate->technique->needs_places && any;
}

void plan_add_technique(const struct plan *plan, const struct plan_candidate *candidate, struct cmd_child_words *words)
{
    const struct plan_options *options = plan->options;
    const char *name = candidate->technique->name;
    double width_px = options->width_px;
    cmd_child_add(words, "--technique");
    cmd_child_add(words, "%s", name);
    cmd_child_add(words, "--samples");
    cmd_child_add(words, "%g", plan_value(plan, candidate, PLAN_AXES - 1));
    if (strcmp(name, "rptam") == 0 || strcmp(name, "strokes") == 0) {
        cmd_child_add(words, "--style");
        cmd_child_add(words, "%s", options->style);
        cmd_child_add(words, "--stroke");
        cmd_child_add(words, "%gx%g", plan_value(plan, candidate, 0) * width_px, width_px);
    }
    if (strcmp(name, "strokes") == 0 && plan_value(plan, candidate, 1) > 0) {
        cmd_child_add(words, "--aggregate");
        cmd_child_add(words, "blend");
    }
    if (candidate->technique->kind == PLAN_SOLID) {
        cmd_child_add(words, "--look");
        cmd_child_add(words, "binary");
        cmd_child_add(words, "--solid-size");
        cmd_child_add(words, "%g", 33.5 * width_px); /* the strokes of the style are then as wide */
    }
    if (candidate->technique->kind == PLAN_STROKES) {
        cmd_child_add(words, "--stroke-width");
        cmd_child_add(words, "%g", width_px);
        cmd_child_add(words, "--finer"); /* the levels are a parameter */
        cmd_child_add(words, "0");
    }
}

void plan_add_view(const struct plan *plan, uint32_t views, double scale, struct cmd_child_words *words)
{
    const struct plan_options *options = plan->options;
    cmd_child_add(words, "--size");
    cmd_child_add(words, "%gx%g", ceil(scale * options->size_px[0]), ceil(scale * options->size_px[1]));
    if (options->from_given) {
        cmd_child_add(words, "--from");
        cmd_child_add(words, "%.17g:%.17g", options->from_deg[0], options->from_deg[1]);
    }
    cmd_child_add(words, "--zoom");
    cmd_child_add(words, "%.17g", options->zoom);
    if (options->ground > 0) {
        cmd_child_add(words, "--ground");
        cmd_child_add(words, "%.17g", options->ground);
    }
    cmd_child_add(words, "--tone-range");
    cmd_child_add(words, "%g:%g", options->tone_range[0], options->tone_range[1]);
    cmd_child_add(words, "--lines");
    cmd_child_add(words, "%s", options->lines);
    if (options->turntable)
        cmd_child_add(words, "--turntable");
    if (options->draw)
        cmd_child_add_all(words, "draw", options->draw);
    if (options->frames_given) {
        cmd_child_add(words, "--frames");
        cmd_child_add(words, "%u", views);
        if (!options->turntable) { /* an animation takes as long with fewer pictures, as far as --rate goes */
            cmd_child_add(words, "--rate");
            cmd_child_add(words, "%.17g", fmax(options->rate * views / (double)options->frames, 0.001));
        }
    }
}
