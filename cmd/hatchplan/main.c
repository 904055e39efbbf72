/* hatchplan: measures on a scene which technique draws it best within bounds. */
#include <math.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>

#include "base/text.h"
#include "hatchplan/hatchplan.h"
#include "shared/report.h"
#include "shared/scene.h"

#define VIEWS_MAX 3 /* pictures of a film that are measured */

static struct plan_options chosen = {
    .size_px = {1280, 720},
    .from_deg = {30, 20},
    .zoom = 1,
    .tone_range = {0, 0.65},
    .width_px = 2,
    .frames = 1,
    .rate = 24,
    .rounds = 5,
    .lines = "none",
    .style = "ink",
};
static const char *budget, *samples = "4";
static double tolerance = INFINITY;
static bool tolerance_given, make, all;

static const struct cmd_option options[] = {
    {'b', "budget", CMD_TEXT, 0, 0, "LIMITS", "limits of a frame, of files and of their making: 'ms=10 mb=4 s=5'",
     &budget, NULL, NULL},
    {'t', "tolerance", CMD_REAL, 0, 1, "TONE", "limit of the tone error; the fastest within it is chosen", &tolerance,
     NULL, &tolerance_given},
    {0, "techniques", CMD_TEXT, 0, 0, "LIST", "techniques to choose from, with commas (default: all)",
     &chosen.techniques, NULL, NULL},
    {0, "samples", CMD_TEXT, 0, 0, "LIST", "samples per pixel to choose from, with commas (default 4)", &samples, NULL,
     NULL},
    {0, "style", CMD_TEXT, 0, 0, "STYLE", "drawing style of maps and strokes (default ink)", &chosen.style, NULL, NULL},
    {0, "stroke-width", CMD_REAL, 0.5, 16, "PX", "width of strokes in pixels (default 2)", &chosen.width_px, NULL,
     NULL},
    {0, "size", CMD_WHOLES, 1, 4096, "WxH", "width and height of the pictures in pixels (default 1280x720)",
     chosen.size_px, NULL, NULL},
    {0, "from", CMD_PAIR, -360, 360, "AZ:EL", "frame the scene from this azimuth and elevation (default 30:20)",
     chosen.from_deg, NULL, &chosen.from_given},
    {0, "zoom", CMD_REAL, 1e-3, 0x1p40, "X", "move X times nearer to the middle of the picture (default 1)",
     &chosen.zoom, NULL, NULL},
    {'n', "frames", CMD_INT, 1, 4096, "N", "pictures of the film that is drawn (default 1)", &chosen.frames, NULL,
     &chosen.frames_given},
    {0, "turntable", CMD_FLAG, 0, 0, NULL, "the film goes once around the scene", &chosen.turntable, NULL, NULL},
    {0, "rate", CMD_REAL, 0.001, 1000, "FPS", "frames per second of the scene's animation (default 24)", &chosen.rate,
     NULL, NULL},
    {0, "ground", CMD_REAL, 0.1, 100, "R", "add a ground plane; half its side in scene radii (default: none)",
     &chosen.ground, NULL, NULL},
    {0, "tone-range", CMD_PAIR, 0, 1, "LO:HI", "tones of lit and unlit parts (default 0:0.65)", chosen.tone_range, NULL,
     NULL},
    {0, "lines", CMD_TEXT, 0, 0, "WHAT", "feature lines, as in render-gl (default none)", &chosen.lines, NULL, NULL},
    {0, "draw", CMD_TEXT, 0, 0, "OPTIONS", "other options for render-gl: '--up z --shadows .03'", &chosen.draw, NULL,
     NULL},
    {'m', "make", CMD_FLAG, 0, 0, NULL, "write the choice as variables of make, for plan.mk", &make, NULL, NULL},
    {'a', "all", CMD_FLAG, 0, 0, NULL, "list all candidates that were measured, not the useful ones alone", &all, NULL,
     NULL},
    {0, "exhaustive", CMD_FLAG, 0, 0, NULL, "measure all candidates in all pictures, many times; slow",
     &chosen.exhaustive, NULL, NULL},
    {0, "rounds", CMD_INT, 1, PLAN_ROUNDS_MAX, "N", "+how often --exhaustive measures each of them (default 5)",
     &chosen.rounds, NULL, NULL},
    {0},
};

static const struct cmd_rule rules[] = {
    {"turntable rate", "frames", NULL},
    {"rate", "!turntable", "which moves the camera alone"},
    {"rounds", "exhaustive", NULL},
    {"make", "budget|tolerance", "which determine the choice"},
    {"make", "!json !all", "which shape a table"},
    {NULL, NULL, NULL},
};

static const char *const examples[] = {
    "meshgen teapot -o teapot.glb && hatchplan teapot.glb --size 320x240",
    "hatchplan teapot.glb --budget mb=1 --tolerance .04 --make -o plan.mk",
    NULL,
};

static const struct cmd_program program = {
    .name = "hatchplan",
    .operands = "[SCENE ...]",
    .summary = "measure on a scene which technique draws it best within bounds",
    .examples = examples,
    .options = options,
    .rules = rules,
    .operands_max = -1,
    .reports = true,
};

static void read_limits(struct plan *plan)
{
    struct hatch_err err;
    plan->limits = hatch_plan_no_limits();
    if (budget && hatch_plan_parse_budget(budget, &plan->limits, &err) != HATCH_OK)
        cmd_usage("--budget %s: %s", budget, err.text);
    plan->limits.error = tolerance;
}

/* Adds a number of samples to the list, which rises: the search takes later ones for more work. */
static void add_samples(uint32_t count)
{
    uint32_t at = chosen.sample_count;
    while (at > 0 && chosen.samples[at - 1] > count)
        at--;
    if (at > 0 && chosen.samples[at - 1] == count)
        return;
    memmove(&chosen.samples[at + 1], &chosen.samples[at], (chosen.sample_count++ - at) * sizeof *chosen.samples);
    chosen.samples[at] = count;
}

static void read_samples(void)
{
    struct hatch_text rest = {samples, strlen(samples)};
    for (const char *at = samples; at; at = strchr(at, ',')) {
        at += *at == ',' && at != samples;
        double value;
        rest = (struct hatch_text){at, strcspn(at, ",")};
        if (!hatch_text_number(rest, &value) || !(value >= 1 && value <= 64) || sqrt(value) != floor(sqrt(value)))
            cmd_usage("--samples %s: want numbers out of 1, 4, 9, 16, 25, 36, 49 and 64, with commas", samples);
        if (chosen.sample_count == PLAN_SAMPLES_MAX)
            cmd_usage("--samples %s: more than %d numbers", samples, PLAN_SAMPLES_MAX);
        add_samples((uint32_t)value);
    }
}

/* Makes standard input a file, since commands read it several times. A pipe that is named is read like standard
 * input. */
static void keep_input(struct cmd_args *args, const char *operand, struct plan_file *file)
{
    static bool taken;
    struct hatch_bytes bytes = {0};
    struct hatch_err err;
    if (taken)
        cmd_usage("two inputs come from standard input or a pipe");
    taken = true;
    cmd_check(cmd_try_read(&args->scratch, operand, &bytes, &err), cmd_input_name(operand), &err);
    file->path = cmd_child_keep_input(args, bytes);
}

static bool is_file(const char *path)
{
    struct stat info;
    return path && strcmp(path, "-") != 0 && (stat(path, &info) != 0 || S_ISREG(info.st_mode) || S_ISDIR(info.st_mode));
}

/* Reads a scene, to see whether it is sound, and whether its meshes have texture coordinates. */
static void read_scene(struct plan *plan, const char *operand, struct plan_file *file)
{
    struct cmd_args *args = plan->args;
    struct cmd_companions companions = {.arena = &plan->kept};
    struct hatch_scene scene;
    struct hatch_mesh_notes notes = {0};
    struct stat info = {.st_size = 0};
    struct hatch_arena_mark keep = hatch_arena_mark(&args->keep), scratch = hatch_arena_mark(&args->scratch);
    *file = (struct plan_file){.path = operand, .has_places = true};
    if (!is_file(operand)) {
        keep_input(args, operand, file);
        keep = hatch_arena_mark(&args->keep);
        operand = NULL;
    }
    if (operand)
        plan_note_input(plan, operand);
    cmd_read_scene_silently(args, operand, CMD_SCENE_AS_IS, &scene, &notes, &companions);
    for (uint32_t i = 0; i < scene.mesh_count; i++)
        if (scene.meshes[i].mesh.face_count && !hatch_mesh_find(&scene.meshes[i].mesh, "TEXCOORD_0", 2))
            file->has_places = false;
    if (stat(file->path, &info) == 0)
        file->bytes = (uint64_t)info.st_size;
    for (const struct cmd_companion *companion = companions.first; companion; companion = companion->next) {
        file->bytes += companion->bytes;
        plan_note_input(plan, companion->path);
    }
    hatch_arena_rewind(&args->keep, keep);
    hatch_arena_rewind(&args->scratch, scratch);
}

/* Writes the table, or the variables of make; tells what comes nearest where nothing fits. Returns the status of the
 * command. */
static enum hatch_status write_results(struct plan *plan, struct cmd_output *output)
{
    bool bounded = budget || tolerance_given;
    const struct plan_candidate *best = bounded ? plan_choice(plan) : NULL, *nearest = plan_nearest(plan);
    struct hatch_err err;
    if (!nearest)
        cmd_check(hatch_fail(&err, plan->failure ? plan->failed : HATCH_BAD_INPUT,
                             "no technique can draw the scene: %s", plan->failure ? plan->failure : "there is none"),
                  cmd_input_name(plan->files[0].path), &err);
    if (bounded && !best) {
        char text[128], how[64];
        struct hatch_plan_worst worst;
        double times = hatch_plan_excess(&nearest->figures, &plan->limits, &worst);
        plan_describe(plan, nearest, text, sizeof text);
        if (isinf(times))
            snprintf(how, sizeof how, "%.3g where the limit %s is 0", worst.value, worst.name);
        else
            snprintf(how, sizeof how, "%.3g times the limit %s", times, worst.name);
        hatch_fail(&err, HATCH_DIFFERS, "nothing is within the limits; nearest is %s with %s, at %s",
                   nearest->technique->name, text, how);
        if (make)
            cmd_die(NULL, &err);
        cmd_say("%s", err.text);
    }
    if (make)
        plan_write_make(plan, best, output);
    else
        plan_report(plan, best, all, output);
    return bounded && !best ? HATCH_DIFFERS : HATCH_OK;
}

int main(int argc, char **argv)
{
    struct cmd_args args;
    struct plan plan = {.args = &args, .options = &chosen};
    struct hatch_err err;
    cmd_begin(&program, argc, argv, &args);
    read_limits(&plan);
    read_samples();
    struct cmd_output *output =
        make ? cmd_open_output(args.output, "mk make txt", false) : cmd_open_report(&args, args.output);
    cmd_child_make_folder();
    hatch_arena_init(&plan.kept, (size_t)args.max_memory);
    plan.inputs.arena = plan.stamps.arena = &plan.kept;

    plan.file_count = args.operand_count ? (uint32_t)args.operand_count : 1;
    plan.files = HATCH_NEW(&args.keep, struct plan_file, plan.file_count, &err);
    cmd_check(plan.files ? HATCH_OK : HATCH_LIMIT, NULL, &err);
    for (uint32_t i = 0; i < plan.file_count; i++)
        read_scene(&plan, args.operand_count ? args.operands[i] : NULL, &plan.files[i]);
    plan_note_options(&plan);
    plan.views = (uint32_t)chosen.frames;
    if (plan.views > VIEWS_MAX && !chosen.exhaustive)
        plan.views = VIEWS_MAX;

    plan_list_candidates(&plan);
    if (chosen.draw)
        plan_check_draw(&plan);
    plan_measure_plain(&plan);
    if (chosen.exhaustive)
        plan_search_all(&plan);
    else
        plan_search(&plan);
    cmd_note("a plain frame takes %.4g ms", plan.plain_ms);
    cmd_note("%.2f s of processor time", cmd_child_processor_s());
    enum hatch_status status = write_results(&plan, output);
    hatch_arena_free(&plan.kept);
    return cmd_end(&args, status);
}
