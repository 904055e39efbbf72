#include "shared/picture.h"

#include <math.h>

#include "io/foreign/foreign.h"

static size_t replace_non_finite(struct hatch_image *image, float fallback)
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

void cmd_read_picture(struct cmd_args *args, const char *path, float fallback, struct hatch_arena *arena,
                      struct hatch_image *image)
{
    struct hatch_err err;
    struct hatch_bytes file = cmd_read_into(arena, path);
    const char *name = cmd_input_name(path), *plugin = cmd_installed_path(args, "lib/hatch/hatch-oiio.so");
    cmd_check(hatch_image_read_any(file, path, plugin, arena, &args->scratch, image, &err), name, &err);
    size_t replaced = replace_non_finite(image, fallback);
    const char *are = cmd_plural(replaced, "number is not", "numbers are not");
    if (replaced && isnan(fallback))
        cmd_warn(name, "%zu %s finite", replaced, are);
    else if (replaced)
        cmd_warn(name, "%zu %s finite: replaced by %g", replaced, are, (double)fallback);
}
