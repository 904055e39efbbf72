/* tampack: packs a tonal art map into the textures that engines load. */
#include <assert.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>

#include "shared/map.h"
#include "layout.h"

static int layout;
static int64_t ink;

static const char *const layout_choices[] = {"rgb", "array", "dds", "png", "exr", NULL};

static const struct cmd_option options[] = {
    {'l', "layout", CMD_CHOICE, 0, 0, "LAYOUT", "rgb (default), array (KTX2), dds, png or exr: see the manual", &layout,
     layout_choices, NULL},
    {'i', "ink", CMD_INT, 0, 1, "N", "value of ink, 0 or 1; paper has the other (default 0)", &ink, NULL, NULL},
    {0},
};

static const struct cmd_rule rules[] = {
    {"ink", "layout=rgb,array,dds,png", "in OpenEXR ink is always 0"},
    {NULL, NULL, NULL},
};

static const char *const examples[] = {
    "tamgen -o tam.exr && tampack tam.exr -o tam.ktx2   # tam.0.ktx2 tam.1.ktx2",
    "tampack --layout png tam.exr -o folder",
    NULL,
};

static const struct cmd_program program = {
    .name = "tampack",
    .operands = "[FILE]",
    .summary = "pack a tonal art map into the textures that engines load",
    .examples = examples,
    .options = options,
    .rules = rules,
    .operands_min = 0,
    .operands_max = 1,
    .binary = true,
};

static void warn(const struct pack_layout *how, const struct hatch_tam *tam, const char *input)
{
    if (how->warning)
        cmd_warn(cmd_input_name(input), "%s", how->warning);
    if (tam->ids && !how->keeps_ids)
        cmd_warn(cmd_input_name(input), "stroke ids are left out: only --layout exr holds them");
}

static bool is_folder(const char *path)
{
    struct stat info;
    size_t length = strlen(path);
    return (length && path[length - 1] == '/') || (stat(path, &info) == 0 && S_ISDIR(info.st_mode));
}

static const char *after_last_slash(const char *path)
{
    const char *slash = strrchr(path, '/');
    return slash ? slash + 1 : path;
}

/* Returns the length of a name without its ending; a leading dot does not begin an ending. */
static size_t stem_length(const char *name)
{
    const char *dot = strrchr(name, '.');
    return dot && dot != name ? (size_t)(dot - name) : strlen(name);
}

static const char *input_stem(const char *input)
{
    bool is_standard = !input || strcmp(input, "-") == 0;
    return is_standard ? "tam" : after_last_slash(input);
}

/* Makes the name of an output file, in args->keep.
 *   path    value of --output: a name or an existing folder
 *   input   path of the map, after which files in a folder are named; NULL or "-": standard input
 *   ending  with the dot */
static const char *file_name(struct cmd_args *args, const char *path, const char *input, const char *suffix,
                             const char *ending)
{
    struct hatch_buffer name = {.arena = &args->keep};
    struct hatch_err err;
    const char *file = after_last_slash(path);
    bool folder = is_folder(path);
    const char *stem = folder ? input_stem(input) : file;
    size_t stem_size = stem_length(stem);
    bool has_ending = !folder && stem[stem_size];
    int before = folder ? (int)strlen(path) : (int)(file - path);
    bool needs_slash = folder && path[strlen(path) - 1] != '/';
    cmd_check(hatch_buffer_print(&name, &err, "%.*s%s%.*s%s%s", before, path, needs_slash ? "/" : "", (int)stem_size,
                                 stem, suffix, has_ending ? stem + stem_size : ending),
              NULL, &err);
    return (const char *)name.data;
}

/* One output file. */
struct file {
    const struct pack_job *job;
    const struct pack_layout *how;
    struct cmd_output *output;
    struct hatch_arena arena; /* arena of bytes */
    struct hatch_buffer bytes;
    enum hatch_status status;
    struct hatch_err err;
};

static void encode(void *context, uint32_t index)
{
    struct file *file = (struct file *)context + index;
    struct hatch_arena scratch;
    hatch_arena_init(&file->arena, file->job->args->max_memory);
    hatch_arena_init(&scratch, file->job->args->max_memory);
    file->bytes.arena = &file->arena;
    file->status = file->how->encode(file->job, index, &scratch, &file->bytes, &file->err);
    hatch_arena_free(&scratch);
}

static struct cmd_output *open_file(const struct pack_job *job, const struct pack_layout *how, const char *input,
                                    uint32_t index)
{
    char suffix[64];
    how->suffix(&job->tam, index, suffix, sizeof suffix);
    return cmd_open_output(file_name(job->args, job->args->output, input, suffix, how->ending), how->ending + 1, true);
}

static uint32_t count_files(const struct pack_job *job, const struct pack_layout *how)
{
    uint32_t count = how->count(&job->tam);
    assert(count <= CMD_OUTPUTS_MAX); /* a map has at most 256 columns of 13 levels */
    if (count > 1 && (!job->args->output || strcmp(job->args->output, "-") == 0))
        cmd_usage("--layout %s makes %u files: give a name or a folder with -o", how->name, count);
    return count;
}

/* Opens the only file of a layout: where the path ends with /, it is named after the map. */
static struct cmd_output *open_single(struct cmd_args *args, const struct pack_layout *how, const char *input)
{
    const char *path = args->output;
    if (path && *path && path[strlen(path) - 1] == '/')
        path = file_name(args, path, input, "", how->ending);
    return cmd_open_output(path, how->ending + 1, true);
}

/* Opens all files, encodes them, then writes them. */
static void pack(const struct pack_job *job, const struct pack_layout *how, const char *input,
                 struct cmd_output *single)
{
    struct hatch_err err;
    uint32_t count = count_files(job, how);
    struct file *files;
    cmd_check(HATCH_ALLOC(&job->args->keep, &files, count, &err), NULL, &err);
    for (uint32_t i = 0; i < count; i++) {
        files[i].job = job;
        files[i].how = how;
        files[i].output = single       ? single
                          : count == 1 ? open_single(job->args, how, input)
                                       : open_file(job, how, input, i);
    }
    hatch_parallel_for(cmd_pool(job->args), count, encode, files);
    for (uint32_t i = 0; i < count; i++)
        cmd_check(files[i].status, cmd_input_name(input), &files[i].err);
    struct cmd_file *written;
    cmd_check(HATCH_ALLOC(&job->args->keep, &written, count, &err), NULL, &err);
    for (uint32_t i = 0; i < count; i++)
        written[i] =
            (struct cmd_file){.output = files[i].output, .data = files[i].bytes.data, .size = files[i].bytes.size};
    cmd_write_all(written, count);
    for (uint32_t i = 0; i < count; i++)
        hatch_arena_free(&files[i].arena);
    cmd_note("%u %s, %u %s; %u %s", job->tam.tones, cmd_plural(job->tam.tones, "tone", "tones"),
             job->tam.columns[0].level_count, cmd_plural(job->tam.columns[0].level_count, "level", "levels"), count,
             cmd_plural(count, "file", "files"));
}

int main(int argc, char **argv)
{
    struct cmd_args args;
    cmd_begin(&program, argc, argv, &args);
    const struct pack_layout *how = &pack_layouts[layout];
    const char *input = args.operand_count ? args.operands[0] : NULL;
    cmd_check_ending(args.output, how->ending + 1);
    struct cmd_output *single = how->is_single ? open_single(&args, how, input) : NULL;

    struct pack_job job = {.args = &args, .ink_is_one = ink == 1};
    cmd_read_map(job.args, input, &job.tam);
    cmd_warn_nesting(job.args, cmd_input_name(input), &job.tam);
    const char *seed = cmd_map_seed(&job.tam);
    char comment[64] = "";
    if (seed)
        snprintf(comment, sizeof comment, "seed %s", seed);
    job.comment = *comment ? comment : NULL;
    pack(&job, how, input, single);
    warn(how, &job.tam, input);
    return cmd_end(&args, HATCH_OK);
}
