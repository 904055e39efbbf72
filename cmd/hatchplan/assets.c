/* The files that candidates read, and the commands that make them. */
#include "hatchplan/hatchplan.h"

#include <assert.h>
#include <math.h>
#include <signal.h>
#include <string.h>
#include <sys/stat.h>

#define ASSETS_MAX 1024

/* Kinds of files. The parameters are, for a map, its size and tones; for a volume, size and slices; for thresholds,
 * size, and whether they are exact runs; for a solid texture, its size; for strokes, their levels. */
static const struct {
    const char *command, *ending;
} kinds[] = {
    [PLAN_MAP] = {"tamgen", "exr"},
    [PLAN_VOLUME] = {"tamvol", "ktx2"},
    [PLAN_THRESHOLDS] = {"tamthresh", "ktx2"},
    [PLAN_SOLID] = {"solidgen", "ktx2"},
    [PLAN_FIELD] = {"dirfield", "glb"},
    [PLAN_PATCHES] = {"lapped-param", "glb"},
    [PLAN_STROKES] = {"strokegen", "glb"},
};

#define FINE_TONES 64 /* columns of the map that thresholds are made of */

const char *plan_command(enum plan_kind kind)
{
    return kinds[kind].command;
}

struct plan_asset *plan_find_asset(struct plan *plan, enum plan_kind kind, double first, double second, uint32_t file)
{
    struct hatch_err err;
    if (!plan->assets) {
        plan->assets = HATCH_NEW(&plan->args->keep, struct plan_asset, ASSETS_MAX, &err);
        cmd_check(plan->assets ? HATCH_OK : HATCH_LIMIT, NULL, &err);
    }
    for (uint32_t i = 0; i < plan->asset_count; i++) {
        struct plan_asset *asset = &plan->assets[i];
        if (asset->kind == kind && asset->file == file && asset->values[0] == first && asset->values[1] == second)
            return asset;
    }
    assert(plan->asset_count < ASSETS_MAX);
    struct plan_asset *made = &plan->assets[plan->asset_count++];
    *made = (struct plan_asset){.kind = kind, .values = {first, second}, .file = file};
    made->path = cmd_child_path(plan->args, "%u.%s", plan->asset_count, kinds[kind].ending);
    return made;
}

struct plan_asset *plan_source(struct plan *plan, const struct plan_asset *asset)
{
    switch (asset->kind) {
    case PLAN_VOLUME:
        return plan_find_asset(plan, PLAN_MAP, asset->values[0], asset->values[1], 0);
    case PLAN_THRESHOLDS:
        return plan_find_asset(plan, PLAN_MAP, asset->values[0], FINE_TONES, 0);
    case PLAN_PATCHES:
    case PLAN_STROKES:
        return plan_find_asset(plan, PLAN_FIELD, 0, 0, asset->file);
    default:
        return NULL;
    }
}

void plan_add_recipe(const struct plan *plan, const struct plan_asset *asset, struct cmd_child_words *words)
{
    const struct plan_options *options = plan->options;
    switch (asset->kind) {
    case PLAN_MAP:
        cmd_child_add(words, "--style");
        cmd_child_add(words, "%s", options->style);
        cmd_child_add(words, "--set");
        cmd_child_add(words, "width %g", options->width_px);
        cmd_child_add(words, "--size");
        cmd_child_add(words, "%g", asset->values[0]);
        cmd_child_add(words, "--tones");
        cmd_child_add(words, "%g", asset->values[1]);
        break;
    case PLAN_VOLUME:
        cmd_child_add(words, "--tones");
        cmd_child_add(words, "%g", asset->values[1]);
        break;
    case PLAN_THRESHOLDS:
        if (asset->values[1] > 0)
            cmd_child_add(words, "--exact");
        break;
    case PLAN_SOLID:
        cmd_child_add(words, "--style");
        cmd_child_add(words, "strokes");
        cmd_child_add(words, "--size");
        cmd_child_add(words, "%g", asset->values[0]);
        break;
    case PLAN_STROKES:
        cmd_child_add(words, "--levels");
        cmd_child_add(words, "%g", asset->values[0]);
        break;
    default:
        break;
    }
}

void plan_add_common(const struct plan *plan, struct cmd_child_words *words)
{
    cmd_child_add(words, "-q");
    cmd_child_add(words, "-j");
    cmd_child_add(words, "%u", plan->args->threads);
    cmd_child_add(words, "--max-memory");
    cmd_child_add(words, "%llu", (unsigned long long)plan->args->max_memory);
}

bool plan_may_fail(const struct cmd_child_end *end)
{
    return end->status == HATCH_OK || end->status == HATCH_BAD_INPUT || end->status == HATCH_LIMIT ||
           (end->status < 0 && end->signal == SIGXCPU);
}

void plan_note_failure(struct plan *plan, const char *command, const struct cmd_child_end *end)
{
    struct cmd_child_words words = {.args = plan->args};
    if (end->status < 0)
        cmd_child_add(&words, "%s: signal %d ended it after %.1f s of processor time", command, end->signal,
                      end->seconds);
    else
        cmd_child_add(&words, "%s: %s", command, end->sentence);
    plan->failure = words.at[0];
    plan->failed = end->status == HATCH_LIMIT ? HATCH_LIMIT : HATCH_BAD_INPUT;
    cmd_note("%s", plan->failure);
}

static uint64_t size_of(const char *path)
{
    struct stat info;
    return stat(path, &info) == 0 ? (uint64_t)info.st_size : 0;
}

/* Makes an asset, and what it is made of. Returns false if that fails; it is not tried again, unless time was short. */
static bool make(struct plan *plan, struct plan_asset *asset)
{
    struct cmd_child_words words;
    struct cmd_child_end end;
    if (asset->made != PLAN_UNMADE)
        return asset->made == PLAN_MADE;
    struct plan_asset *source = plan_source(plan, asset);
    double most_s = plan->options->exhaustive ? INFINITY : plan->limits.setup_s;
    bool sound = !source || make(plan, source);
    double before_s = source ? source->seconds : 0;
    asset->seconds = before_s;
    if (!sound || before_s > most_s) {
        asset->made = PLAN_FAILED;
        return false;
    }
    cmd_child_begin(&words, plan->args, kinds[asset->kind].command);
    plan_add_common(plan, &words);
    plan_add_recipe(plan, asset, &words);
    cmd_child_add(&words, "-o");
    cmd_child_add(&words, "%s", asset->path);
    if (source || asset->kind == PLAN_FIELD) {
        cmd_child_add(&words, "--");
        cmd_child_add(&words, "%s", source ? source->path : plan->files[asset->file].path);
    }
    cmd_child_run(&words, most_s - before_s, &end);
    asset->made = end.status == 0 ? PLAN_MADE : PLAN_FAILED;
    if (!plan_may_fail(&end))
        cmd_child_die(words.at[0], &end);
    if (end.status != 0)
        plan_note_failure(plan, words.at[0], &end);
    asset->bytes = size_of(asset->path);
    asset->seconds = before_s + end.seconds;
    if (end.status < 0 && end.signal == SIGXCPU) /* its measured time may be a little under the limit */
        asset->seconds = fmax(asset->seconds, nextafter(most_s, INFINITY));
    return asset->made == PLAN_MADE;
}

struct plan_asset *plan_own_asset(struct plan *plan, const struct plan_candidate *candidate)
{
    const struct plan_technique *technique = candidate->technique;
    if (technique->kind == PLAN_NOTHING || technique->kind == PLAN_STROKES)
        return NULL;
    double second = technique->axes[1].name ? plan_value(plan, candidate, 1) : 0;
    return plan_find_asset(plan, technique->kind, plan_value(plan, candidate, 0), second, 0);
}

struct plan_asset *plan_scene_asset(struct plan *plan, const struct plan_candidate *candidate, uint32_t file)
{
    if (candidate->technique->kind == PLAN_STROKES)
        return plan_find_asset(plan, PLAN_STROKES, plan_value(plan, candidate, 0), 0, file);
    if (candidate->technique->needs_places && !plan->files[file].has_places)
        return plan_find_asset(plan, PLAN_PATCHES, 0, 0, file);
    return NULL;
}

bool plan_make_files(struct plan *plan, struct plan_candidate *candidate)
{
    struct hatch_plan_figures *figures = &candidate->figures;
    struct plan_asset *own = plan_own_asset(plan, candidate);
    double bytes = 0;
    bool made = !own || make(plan, own);
    figures->setup_s = own ? own->seconds : 0;
    for (uint32_t i = 0; made && i < plan->file_count; i++) {
        struct plan_asset *asset = plan_scene_asset(plan, candidate, i);
        if (!asset)
            continue;
        made = make(plan, asset);
        figures->setup_s += asset->seconds; /* of a file, too, that takes longer than all of the budget */
        if (made)
            bytes += (double)asset->bytes - (double)plan->files[i].bytes;
    }
    figures->bytes = fmax(bytes, 0) + (own ? (double)own->bytes : 0);
    const struct hatch_plan_figures known = {.bytes = figures->bytes, .setup_s = figures->setup_s};
    bool within = hatch_plan_excess(&known, &plan->limits, NULL) <= 1 || plan->options->exhaustive;
    if (!within)
        candidate->state = PLAN_OVER;
    else if (!made)
        candidate->state = PLAN_OUT;
    return made && within;
}
