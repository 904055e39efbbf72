/* solidgen: makes a solid texture from a style or a picture. */
#include <math.h>
#include <stdio.h>

#include "shared/needs/needs.h"
#include "shared/style.h"
#include "shared/texels.h"
#include "exemplar.h"
#include "slices.h"
#include "solid/make.h"

#define BYTES_PER_MB 1e6
#define MORE_BYTES (1 << 20) /* for the rest: points, counts of values, headers */

static const char *style_name = "perlin", *slices_path, *needs_path;
static struct cmd_texts settings;
static int64_t size = 64;
static struct solidgen_exemplar exemplar = {.neighborhood = 8, .levels = 3, .iterations = 8};

static const struct cmd_option options[] = {
    {'S', "style", CMD_TEXT, 0, 0, "SOLID", "style of the texture: a name, or a file (default perlin)", &style_name,
     NULL, NULL},
    {'e', "set", CMD_TEXTS, 0, 0, "LINES", "style lines to add: 'scale 12; octaves 3'; repeatable", &settings, NULL,
     NULL},
    {'n', "size", CMD_INT, HATCH_SOLID_SIZE_MIN, HATCH_SOLID_SIZE_MAX, "N",
     "texels along a side, a power of two (default 64)", &size, NULL, NULL},
    {'N', "needs", CMD_TEXT, 0, 0, "FILE", "no more texels than a period covers in views (render-gl --needs)",
     &needs_path, NULL, NULL},
    {'E', "exemplar", CMD_TEXT, 0, 0, "IMAGE", "picture that all slices shall look like, in place of a style",
     &exemplar.path, NULL, NULL},
    {'m', "method", CMD_CHOICE, 0, 0, "METHOD", "exemplar: kopf or pyramid, fast and without lines (default kopf)",
     &exemplar.method, solidgen_methods, NULL},
    {0, "axes", CMD_CHOICE, 0, 0, "AXES", "kopf: slices across these look like it: xyz, xy, xz or yz (default xyz)",
     &exemplar.axes, solidgen_axes, NULL},
    {0, "neighborhood", CMD_INT, HATCH_SYNTHESIS_SIDE_MIN, HATCH_SYNTHESIS_SIDE_MAX, "PX",
     "kopf: side of the neighbourhoods that are compared, 3 .. 12 (default 8)", &exemplar.neighborhood, NULL, NULL},
    {0, "levels", CMD_INT, 1, HATCH_SYNTHESIS_LEVELS_MAX, "N",
     "kopf: levels of detail at most, coarse to fine, 1 .. 4 (default 3)", &exemplar.levels, NULL, NULL},
    {0, "iterations", CMD_INT, 1, 1000, "N", "exemplar: iterations at the finest level, 1 .. 1000 (default 8)",
     &exemplar.iterations, NULL, NULL},
    {0, "exhaustive", CMD_FLAG, 0, 0, NULL, "kopf: search all neighbourhoods, as a reference; slow",
     &exemplar.exhaustive, NULL, NULL},
    {'x', "slices", CMD_TEXT, 0, 0, "PNG", "draw the middle slices across z, y and x", &slices_path, NULL, NULL},
    {0},
};

static const struct cmd_rule rules[] = {
    {"style set", "!exemplar", "which takes the place of a style"},
    {"method iterations", "exemplar", NULL},
    {"axes neighborhood levels exhaustive", "exemplar method=kopf", NULL},
    {NULL, NULL, NULL},
};

static const char *const examples[] = {
    "solidgen --style wood --size 128 --slices slices.png -o wood.ktx2",
    "solidgen --style stipple --set 'dots 20' -o dots.ktx2",
    "solidgen --exemplar bark.png --slices slices.png -o bark.ktx2",
    NULL,
};

static const struct cmd_program program = {
    .name = "solidgen",
    .operands = "",
    .summary = "make a solid texture: a cube of texels in which objects are carved",
    .examples = examples,
    .options = options,
    .rules = rules,
    .seeded = true,
    .binary = true,
};

/* A solid texture, and what made it. */
struct job {
    struct cmd_args args;
    struct hatch_solid_style style;
    struct hatch_solid solid;
    const char *maker; /* style or method */
};

/* Makes the texture no larger than its period in the pictures asks for.
 *   size_min  texels along a side at least */
static void fit(struct cmd_args *args, uint32_t size_min)
{
    struct hatch_needs needs;
    cmd_read_needs(args, needs_path, &needs);
    uint32_t needed = hatch_needs_solid(&needs, (uint32_t)size, size_min);
    if (needed < size)
        cmd_note("%u texels along a side, not %d: a period covers %g pixels; %.3g %% of the texels are made", needed,
                 (int)size, needs.solid_px, 100 * pow((double)needed / (double)size, 3));
    size = needed;
}

/* Returns the texels along a side, at most size, that show all features of a style. */
static uint32_t size_of_features(const struct hatch_solid_style *style)
{
    uint32_t least = HATCH_SOLID_SIZE_MIN;
    struct hatch_solid_style fitted = *style;
    while (least < size && hatch_solid_style_fit(&fitted, least)) {
        fitted = *style;
        least *= 2;
    }
    return least;
}

static void read_style(struct job *job)
{
    struct hatch_err err;
    const char *path = cmd_find_style(&job->args, style_name, "solid");
    cmd_check(hatch_solid_style_parse(cmd_read(&job->args, path), &job->style, &err), cmd_input_name(path), &err);
    if (settings.count &&
        hatch_solid_style_parse(cmd_split_settings(&job->args, &settings), &job->style, &err) != HATCH_OK)
        cmd_usage("--set: %s", err.text);
    cmd_name_style(path, job->style.name);
    if (needs_path)
        fit(&job->args, size_of_features(&job->style));
    struct hatch_solid_style fitted = job->style;
    const char *lowered = hatch_solid_style_fit(&fitted, (uint32_t)size);
    if (lowered)
        cmd_note("%s: lowered to the most that %d texels along a side can show", lowered, (int)size);
}

/* Refuses a texture that memory cannot hold, before it is made: its texels, mip levels and file in one arena, values of
 * all texels in the other, and strokes or points.
 *   value_bytes  bytes for each texel in the other
 *   more_bytes   of the strokes or points */
static void check_memory(const struct job *job, uint32_t channels, uint32_t value_bytes, uint64_t more_bytes)
{
    uint64_t texels = (uint64_t)size * (uint64_t)size * (uint64_t)size, values = value_bytes * texels + more_bytes;
    uint64_t file = channels * texels * (cmd_is_exr_path(job->args.output) ? 3 : 1), kept = channels * texels + file;
    kept += channels * texels < HATCH_ARENA_STEP ? channels * texels : HATCH_ARENA_STEP; /* the levels' block */
    uint64_t most = kept > values ? kept : values;
    most += most / 7 + MORE_BYTES; /* with the coarser levels */
    struct hatch_err err;
    if (most <= job->args.max_memory)
        return;
    bool many = more_bytes > most / 2;
    cmd_die(NULL, (hatch_fail(&err, HATCH_LIMIT, "%s--size %d %s %.0f MB of memory, --max-memory allows %.0f MB",
                              many ? "the strokes or points of the style and " : "", (int)size, many ? "need" : "needs",
                              (double)most / BYTES_PER_MB, (double)job->args.max_memory / BYTES_PER_MB),
                   &err));
}

/* Makes the texture of the style. */
static void make_from_style(struct job *job)
{
    struct hatch_err err;
    read_style(job);
    const struct hatch_progress progress = cmd_progress_of("texels");
    const struct hatch_solid_options how = {.style = &job->style,
                                            .size = (uint32_t)size,
                                            .seed = job->args.seed,
                                            .pool = cmd_pool(&job->args),
                                            .progress = &progress};
    /* A value of each texel and, to equalize them, its rank. */
    check_memory(job, job->style.color_count ? 3 : 1, sizeof(float) + hatch_solid_equalizes(&job->style),
                 hatch_solid_style_bytes(&job->style, (uint32_t)size));
    cmd_check(hatch_solid_from_style(&how, &job->args.keep, &job->args.scratch, &job->solid, &err), NULL, &err);
    job->maker = job->style.name;
}

/* Makes the texture of the exemplar. */
static void make_from_exemplar(struct job *job)
{
    struct hatch_image image;
    const uint32_t whole = (uint32_t)size;
    if (needs_path)
        fit(&job->args, HATCH_SOLID_SIZE_MIN);
    solidgen_read_exemplar(&job->args, &exemplar, whole, (uint32_t)size, &image);
    check_memory(job, image.channel_count, 0, 0); /* hatch_synthesis_make tries what it needs */
    solidgen_synthesize(&job->args, &exemplar, (uint32_t)size, &image, &job->solid);
    job->maker = solidgen_methods[exemplar.method];
}

static void encode(struct job *job, struct hatch_buffer *file)
{
    struct hatch_err err;
    struct hatch_texels texels;
    char seed[24];
    snprintf(seed, sizeof seed, "%llu", (unsigned long long)job->args.seed);
    const char *const keys[] = {HATCH_SOLID_KEY,
                                job->maker,
                                HATCH_SOLID_KEY_SEED,
                                seed,
                                job->solid.isotropic ? HATCH_SOLID_KEY_ISOTROPIC : NULL,
                                "yes",
                                NULL};
    const struct cmd_texture texture = {&texels, keys, NULL};
    cmd_check(hatch_solid_mips(&job->solid, &job->args.keep, &texels, &err), NULL, &err);
    cmd_encode_texture(&job->args, &texture, job->args.output, file);
}

int main(int argc, char **argv)
{
    static struct job job;
    cmd_begin(&program, argc, argv, &job.args);
    if (size & (size - 1))
        cmd_usage("--size %d: want a power of two", (int)size);
    struct cmd_file files[2] = {{.output = cmd_open_output(job.args.output, "ktx2 exr", true)}};
    if (slices_path)
        files[1].output = cmd_open_output(slices_path, "png", true);

    if (exemplar.path)
        make_from_exemplar(&job);
    else
        make_from_style(&job);

    struct hatch_buffer file = {.arena = &job.args.keep}, picture = file;
    encode(&job, &file);
    files[0].data = file.data;
    files[0].size = file.size;
    if (slices_path) {
        solidgen_draw_slices(&job.args, &job.solid, slices_path, &picture);
        files[1].data = picture.data;
        files[1].size = picture.size;
    }
    cmd_note("%u texels along a side, %u %s; %zu bytes", job.solid.size, job.solid.channels,
             cmd_plural(job.solid.channels, "channel", "channels"), file.size);
    cmd_write_all(files, slices_path ? 2 : 1);
    return cmd_end(&job.args, HATCH_OK);
}
