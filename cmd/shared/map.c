#include "shared/map.h"

#include "io/exr/exr.h"

void cmd_read_map(struct cmd_args *args, const char *path, struct hatch_tam *map)
{
    cmd_parse_map(args, cmd_input_name(path), cmd_read(args, path), map);
}

void cmd_parse_map(struct cmd_args *args, const char *name, struct hatch_bytes file, struct hatch_tam *map)
{
    struct hatch_err err;
    struct hatch_mipmap *parts;
    uint32_t count;
    cmd_check(hatch_exr_read(file, cmd_pool(args), &args->keep, &args->scratch, &parts, &count, &err), name, &err);
    cmd_check(hatch_tam_from_mipmaps(parts, count, map, &err), name, &err);
}

void cmd_warn_nesting(struct cmd_args *args, const char *name, const struct hatch_tam *map)
{
    struct hatch_err err;
    enum hatch_status status = hatch_tam_check_nesting(map, cmd_pool(args), &args->scratch, &err);
    if (status == HATCH_BAD_INPUT)
        cmd_warn(name, "%s", err.text);
    else
        cmd_check(status, name, &err);
}

const char *cmd_map_seed(const struct hatch_tam *map)
{
    const struct hatch_attribute *seed = hatch_mipmap_attribute(map->columns, HATCH_TAM_ATTR_SEED);
    return seed && seed->type == HATCH_ATTRIBUTE_TEXT ? seed->text : NULL;
}
