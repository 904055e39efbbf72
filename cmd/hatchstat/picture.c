#include <math.h>

#include "shared/picture.h"
#include "subject.h"

static void encode_srgb(struct hatch_image *image)
{
    size_t texels = (size_t)image->width * image->height;
    uint32_t channels = image->channel_count, colors = channels - (channels % 2 == 0);
    for (size_t i = 0; i < texels; i++)
        for (uint32_t c = 0; c < colors; c++) {
            float *value = &image->pixels[i * channels + c];
            *value = hatch_linear_to_srgb(*value);
        }
}

static void read_picture(struct cmd_args *args, const char *path, bool srgb, float fallback, struct hatch_arena *arena,
                         struct hatch_image *image)
{
    cmd_read_picture(args, path, fallback, arena ? arena : &args->keep, image);
    if (srgb)
        encode_srgb(image);
}

void stat_read_picture(struct cmd_args *args, const char *path, bool srgb, struct hatch_arena *arena,
                       struct hatch_image *image)
{
    read_picture(args, path, srgb, 0, arena, image);
}

void stat_read_picture_as_is(struct cmd_args *args, const char *path, bool srgb, struct hatch_image *image)
{
    read_picture(args, path, srgb, NAN, NULL, image);
}

static void as_rgba(const struct hatch_image *image, size_t texel, float *rgba)
{
    uint32_t channels = image->channel_count, colors = channels - (channels % 2 == 0);
    const float *from = image->pixels + texel * channels;
    for (uint32_t c = 0; c < 3; c++)
        rgba[c] = from[colors == 1 ? 0 : c];
    rgba[3] = channels % 2 == 0 ? from[channels - 1] : 1;
}

void stat_widen(struct hatch_arena *arena, struct hatch_image *image)
{
    struct hatch_err err;
    struct hatch_image wide;
    cmd_check(hatch_image_make(arena, image->width, image->height, "RGBA", &wide, &err), NULL, &err);
    for (size_t i = 0; i < (size_t)image->width * image->height; i++)
        as_rgba(image, i, wide.pixels + 4 * i);
    *image = wide;
}

void stat_make_alike(struct hatch_arena *arena, const char *path, struct hatch_image *first, struct hatch_image *image)
{
    struct hatch_err err;
    if (first->width != image->width || first->height != image->height) {
        hatch_fail(&err, HATCH_BAD_INPUT, "%ux%u pixels, the first picture has %ux%u", image->width, image->height,
                   first->width, first->height);
        cmd_die(cmd_input_name(path), &err);
    }
    if (first->channel_count == image->channel_count)
        return;
    stat_widen(arena, first);
    stat_widen(arena, image);
}
