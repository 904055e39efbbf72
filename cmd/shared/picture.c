#include "shared/picture.h"

#include <math.h>

#include "io/foreign/foreign.h"

size_t cmd_replace_non_finite(const struct hatch_image *image, float fallback)
{
    size_t texels = (size_t)image->width * image->height, replaced = 0;
    int alpha = hatch_image_channel(image, "A");
    for (size_t i = 0; i < texels; i++)
        for (uint32_t c = 0; c < image->channel_count; c++) {
            float *value = &image->pixels[i * image->channel_count + c];
            if (isfinite(*value))
                continue;
            *value = (int)c == alpha && !isnan(fallback) ? 0 : fallback;
            replaced++;
        }
    return replaced;
}

void cmd_warn_replaced(const char *name, size_t replaced, float fallback)
{
    const char *are = cmd_plural(replaced, "number is not", "numbers are not");
    if (replaced && isnan(fallback))
        cmd_warn(name, "%zu %s finite", replaced, are);
    else if (replaced)
        cmd_warn(name, "%zu %s finite: replaced by %g", replaced, are, (double)fallback);
}

void cmd_parse_picture(struct cmd_args *args, const char *path, struct hatch_bytes file, float fallback,
                       struct hatch_arena *arena, struct hatch_image *image)
{
    struct hatch_err err;
    const char *name = cmd_input_name(path), *plugin = cmd_installed_path(args, "lib/hatch/hatch-oiio.so");
    cmd_check(hatch_image_read_any(file, path, plugin, arena, &args->scratch, image, &err), name, &err);
    cmd_warn_replaced(name, cmd_replace_non_finite(image, fallback), fallback);
}

void cmd_read_picture(struct cmd_args *args, const char *path, float fallback, struct hatch_arena *arena,
                      struct hatch_image *image)
{
    cmd_parse_picture(args, path, cmd_read_into(arena, path), fallback, arena, image);
}
