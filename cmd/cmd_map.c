#include "cmd_map.h"

#include "io/exr.h"

void cmd_read_map(struct cmd_args *args, const char *path, struct hatch_tam *map)
{
    const char *name = cmd_input_name(path);
    struct hatch_bytes file = cmd_read(args, path);
    struct hatch_err err;
    struct hatch_mipmap *parts;
    uint32_t count;
    cmd_check(hatch_exr_read(file, &args->keep, &args->scratch, &parts, &count, &err), name, &err);
    cmd_check(hatch_tam_from_mipmaps(parts, count, map, &err), name, &err);
}
