#include "slices.h"

#include "io/png/png.h"

#define GAP_PX 4u

/* Copies a slice into the picture.
 *   axis  the axis that the slice crosses: 0 x, 1 y, 2 z
 *   left  column of the picture */
static void copy_slice(const struct hatch_solid *solid, uint32_t axis, uint32_t left, struct hatch_image *image)
{
    uint32_t size = solid->size, channels = solid->channels, right = axis == 0 ? 1 : 0, down = axis == 2 ? 1 : 2;
    uint32_t at[3];
    at[axis] = size / 2;
    for (at[down] = 0; at[down] < size; at[down]++)
        for (at[right] = 0; at[right] < size; at[right]++) {
            const uint8_t *from = solid->texels + (((size_t)at[2] * size + at[1]) * size + at[0]) * channels;
            float *to = image->pixels + ((size_t)at[down] * image->width + left + at[right]) * channels;
            for (uint32_t c = 0; c < channels; c++)
                to[c] = (float)from[c] / 255;
        }
}

void solidgen_draw_slices(struct cmd_args *args, const struct hatch_solid *solid, const char *path,
                          struct hatch_buffer *file)
{
    struct hatch_err err;
    struct hatch_image image;
    struct hatch_arena_mark mark = hatch_arena_mark(&args->scratch);
    uint32_t width = 3 * solid->size + 2 * GAP_PX;
    cmd_check(hatch_image_make(&args->scratch, width, solid->size, solid->channels == 1 ? "Y" : "RGB", &image, &err),
              path, &err);
    for (size_t i = 0; i < (size_t)width * solid->size * solid->channels; i++)
        image.pixels[i] = 1;
    for (uint32_t i = 0; i < 3; i++)
        copy_slice(solid, 2 - i, i * (solid->size + GAP_PX), &image);
    cmd_check(hatch_png_write(&image, HATCH_PNG_SRGB, 8, NULL, &args->scratch, file, &err), path, &err);
    hatch_arena_rewind(&args->scratch, mark);
}
