#include "shared/map.h"

#include "io/exr/exr.h"
#include "tam/thresholds.h"
#include "tam/volume.h"

/* Dies if the parts are those of a texture that was made from a map. Such files do not tell what KTX2 does: whether
 * slices are those of a 3D texture, and its last levels. */
static void refuse_textures(const char *name, const struct hatch_mipmap *first)
{
    struct hatch_err err;
    if (hatch_mipmap_attribute(first, HATCH_VOLUME_KEY_DARKEST))
        hatch_fail(&err, HATCH_BAD_INPUT,
                   "not a tonal art map, but a volume; volumes are read in KTX2 only: tamvol -o FILE.ktx2");
    else if (hatch_mipmap_attribute(first, HATCH_THRESHOLD_KEY_BORDERS))
        hatch_fail(&err, HATCH_BAD_INPUT,
                   "not a tonal art map, but thresholds, which are read in KTX2 only: tamthresh -o FILE.ktx2");
    else
        return;
    cmd_die(name, &err);
}

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
    refuse_textures(name, parts);
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
