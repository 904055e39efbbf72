/* Makes a map whose levels do not nest: level k has the strokes of level k of the k-th map.
 *     limits_levels MAP MAP ... -o OUT.exr */
#include "io/exr/exr.h"
#include "shared/cmd.h"

#define MAPS_MAX 8

static struct cmd_args args;
static struct hatch_err err;

int main(int argc, char **argv)
{
    static const struct cmd_option options[] = {{0}};
    static const char *const examples[] = {"limits_levels fine.exr coarse.exr -o mixed.exr", NULL};
    static const struct cmd_program program = {.name = "limits_levels",
                                               .operands = "MAP MAP ...",
                                               .summary = "make a map whose levels do not nest",
                                               .examples = examples,
                                               .options = options,
                                               .operands_min = 2,
                                               .operands_max = MAPS_MAX};
    struct hatch_mipmap *maps[MAPS_MAX];
    uint32_t tones = 0, used[MAPS_MAX];
    struct hatch_exr_writer *writer;
    struct hatch_buffer file = {.arena = &args.keep};
    cmd_begin(&program, argc, argv, &args);
    struct cmd_output *output = cmd_open_output(args.output, "exr", true);
    for (int i = 0; i < args.operand_count; i++) {
        const char *path = args.operands[i];
        cmd_check(hatch_exr_read(cmd_read(&args, path), NULL, &args.keep, &args.keep, &maps[i], &used[i], &err), path,
                  &err);
        tones = i == 0 || used[i] < tones ? used[i] : tones;
    }
    cmd_check(hatch_exr_begin(&maps[0][0], tones, &args.keep, &writer, &err), NULL, &err);
    for (uint32_t tone = 0; tone < tones; tone++) {
        struct hatch_mipmap mixed = maps[0][tone];
        for (uint32_t level = 1; level < mixed.level_count; level++) {
            const int from = (int)level < args.operand_count ? (int)level : args.operand_count - 1;
            mixed.levels[level] = maps[from][tone].levels[level];
        }
        cmd_check(hatch_exr_add_part(writer, tone, &mixed, &err), NULL, &err);
    }
    cmd_check(hatch_exr_end(writer, &file, &err), NULL, &err);
    cmd_write(output, file.data, file.size);
    return cmd_end(&args, HATCH_OK);
}
