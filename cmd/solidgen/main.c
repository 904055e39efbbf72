/* solidgen: makes a solid texture from a style. */
#include <stdio.h>

#include "shared/style.h"
#include "shared/texels.h"
#include "slices.h"
#include "solid/make.h"

#define BYTES_PER_MB 1000000

static const char *style_name = "perlin", *settings, *slices_path;
static int64_t size = 64;

static const struct cmd_option options[] = {
    {'S', "style", CMD_TEXT, 0, 0, "SOLID", "style of the texture: a name, or a file (default perlin)", &style_name,
     NULL, NULL},
    {'e', "set", CMD_TEXT, 0, 0, "LINES", "style lines to add: 'scale 12; octaves 3'", &settings, NULL, NULL},
    {'n', "size", CMD_INT, HATCH_SOLID_SIZE_MIN, HATCH_SOLID_SIZE_MAX, "N",
     "texels along a side, a power of two (default 64)", &size, NULL, NULL},
    {'x', "slices", CMD_TEXT, 0, 0, "PNG", "draw the middle slices across z, y and x", &slices_path, NULL, NULL},
    {0},
};

static const char *const examples[] = {
    "solidgen --style wood --size 128 --slices slices.png -o wood.ktx2",
    "solidgen --style stipple --set 'dots 20' -o dots.ktx2",
    NULL,
};

static const struct cmd_program program = {
    .name = "solidgen",
    .operands = "",
    .summary = "make a solid texture: a cube of texels in which objects are carved",
    .examples = examples,
    .options = options,
    .seeded = true,
    .binary = true,
};

/* A solid texture, and what made it. */
struct job {
    struct cmd_args args;
    struct hatch_solid_style style;
    struct hatch_solid solid;
};

static void read_style(struct job *job)
{
    struct hatch_err err;
    const char *path = cmd_find_style(&job->args, style_name, "solid");
    cmd_check(hatch_solid_style_parse(cmd_read(&job->args, path), &job->style, &err), cmd_input_name(path), &err);
    if (settings && hatch_solid_style_parse(cmd_split_settings(&job->args, settings), &job->style, &err) != HATCH_OK)
        cmd_usage("--set: %s", err.text);
    cmd_name_style(path, job->style.name);
}

/* Refuses a texture that memory cannot hold, before it is made: its texels, mip levels and file in one arena, the
 * values of all texels and their ranks in the other. */
static void check_memory(const struct job *job)
{
    uint64_t texels = (uint64_t)size * (uint64_t)size * (uint64_t)size, channels = job->style.color_count ? 3 : 1;
    uint64_t file = channels * texels * (cmd_is_exr_path(job->args.output) ? 3 : 1), kept = channels * texels + file;
    uint64_t values = (sizeof(float) + hatch_solid_equalizes(&job->style)) * texels,
             most = kept > values ? kept : values;
    most += most / 7; /* the coarser levels */
    struct hatch_err err;
    if (most <= job->args.max_memory)
        return;
    cmd_die(NULL, (hatch_fail(&err, HATCH_LIMIT, "--size %d needs %.0f MB of memory, --max-memory allows %.0f MB",
                              (int)size, (double)most / BYTES_PER_MB, (double)job->args.max_memory / BYTES_PER_MB),
                   &err));
}

/* Makes the texture of the style. */
static void make(struct job *job)
{
    struct hatch_err err;
    const struct hatch_progress progress = cmd_progress_of("texels");
    const struct hatch_solid_options how = {.style = &job->style,
                                            .size = (uint32_t)size,
                                            .seed = job->args.seed,
                                            .pool = cmd_pool(&job->args),
                                            .progress = &progress};
    cmd_check(hatch_solid_from_style(&how, &job->args.keep, &job->args.scratch, &job->solid, &err), NULL, &err);
}

static void encode(struct job *job, struct hatch_buffer *file)
{
    struct hatch_err err;
    struct hatch_texels texels;
    char seed[24];
    snprintf(seed, sizeof seed, "%llu", (unsigned long long)job->args.seed);
    const char *const keys[] = {HATCH_SOLID_KEY, job->style.name, HATCH_SOLID_KEY_SEED, seed, NULL};
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

    read_style(&job);
    check_memory(&job);
    make(&job);

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
