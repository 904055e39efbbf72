#include "shared/solid/solid.h"

#include <string.h>

#include "io/exr/exr.h"
#include "io/texture/container.h"
#include "shared/picture.h"

#define PAPER 1.0f /* takes the place of numbers that are not finite */

/* Parses the slices of an OpenEXR file. Returns false if its parts are none, or if its pixels are of a kind that is
 * read for pictures alone; dies if it cannot be read otherwise. */
static bool parse_slices(struct cmd_args *args, const char *name, struct hatch_bytes file, struct hatch_solid *solid)
{
    struct hatch_arena arena;
    struct hatch_mipmap *parts;
    struct hatch_err err;
    uint32_t count, width, height;
    hatch_arena_init(&arena, args->max_memory);
    enum hatch_status status = hatch_exr_read(file, cmd_pool(args), &arena, &args->scratch, &parts, &count, &err);
    if (status != HATCH_OK && !hatch_exr_is_other_kind(file, &width, &height))
        cmd_check(status, name, &err);
    bool slices = status == HATCH_OK && hatch_solid_is_slices(parts, count);
    if (slices) {
        size_t replaced = 0;
        for (uint32_t i = 0; i < count; i++)
            replaced += cmd_replace_non_finite(&parts[i].levels[0], PAPER);
        cmd_warn_replaced(name, replaced, PAPER);
        cmd_check(hatch_solid_of_slices(parts, count, &args->keep, solid, &err), name, &err);
    }
    hatch_arena_free(&arena);
    return slices;
}

bool cmd_parse_solid(struct cmd_args *args, const char *name, struct hatch_bytes file, struct hatch_solid *solid)
{
    struct hatch_texels texels;
    struct hatch_err err;
    const char *const *keys, *isotropic;
    if (hatch_exr_is(file))
        return parse_slices(args, name, file, solid);
    if (!hatch_ktx2_is(file))
        return false;
    cmd_check(hatch_ktx2_read(file, &args->keep, &texels, &err), name, &err);
    cmd_check(hatch_solid_take(&texels, &args->keep, solid, &err), name, &err);
    cmd_check(hatch_ktx2_read_keys(file, &args->keep, &keys, &err), name, &err);
    isotropic = hatch_texels_value(keys, HATCH_SOLID_KEY_ISOTROPIC);
    solid->isotropic = isotropic && strcmp(isotropic, "yes") == 0;
    return true;
}
