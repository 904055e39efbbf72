/* Makes the images of strokes at their size on screen. */
#include <assert.h>
#include <math.h>

#include "base/random.h"
#include "seed/rptam.h"

#define SIDE_MAX 2048.0      /* largest number of texels along a side of a stroke's image */
#define TEXELS_MAX 1048576.0 /* largest number of texels of all images of a stroke, if it has several */

/* Returns the mean of an image over a box. */
static double mean_over(const struct hatch_image *image, double left, double right, double top, double bottom)
{
    double sum = 0;
    for (uint32_t row = (uint32_t)top; row < bottom && row < image->height; row++)
        for (uint32_t column = (uint32_t)left; column < right && column < image->width; column++)
            sum += (double)image->pixels[(size_t)row * image->width + column] *
                   (fmin(right, column + 1.0) - fmax(left, column)) * (fmin(bottom, row + 1.0) - fmax(top, row));
    return sum / ((right - left) * (bottom - top));
}

/* Resamples the alpha of a stroke, still without grain and border. */
static double *resample(const struct hatch_image *from, uint32_t width, uint32_t height, struct hatch_arena *arena,
                        struct hatch_err *err)
{
    double *means = HATCH_NEW(arena, double, (size_t)width *height, err);
    for (uint32_t y = 0; means && y < height; y++)
        for (uint32_t x = 0; x < width; x++)
            means[(size_t)y * width + x] =
                mean_over(from, (double)x * from->width / width, (double)(x + 1) * from->width / width,
                          (double)y * from->height / height, (double)(y + 1) * from->height / height);
    return means;
}

/* Returns the factor of the grain at a position, in pixels from the corner of a stroke's image.
 *   image  number of the image, which selects an offset */
static double grain_at(const struct hatch_image *grain, uint32_t image, double x_px, double y_px)
{
    if (!grain)
        return 1;
    uint64_t offset = image ? hatch_random_u64(1, 0, image) : 0;
    uint32_t x = ((uint32_t)x_px + (uint32_t)(offset & 0xffffu)) % grain->width;
    uint32_t y = ((uint32_t)y_px + (uint32_t)(offset >> 16 & 0xffffu)) % grain->height;
    return (double)grain->pixels[(size_t)y * grain->width + x];
}

enum hatch_status hatch_rptam_stroke_images(const struct hatch_rptam_layer_style *style, struct hatch_arena *arena,
                                            struct hatch_arena *scratch, struct hatch_image *stroke, uint32_t *images,
                                            struct hatch_err *err)
{
    uint32_t width = (uint32_t)fmin(ceil(2 * style->length_px), SIDE_MAX);
    uint32_t height = (uint32_t)fmin(ceil(2 * style->width_px), SIDE_MAX);
    uint32_t count = style->varied && style->grain ? HATCH_RPTAM_GRAIN_OFFSETS : 1;
    struct hatch_image made;
    assert(style->stroke->channel_count == 1);
    while (count > 1 && (double)count * width * height > TEXELS_MAX)
        count /= 2;
    HATCH_TRY(hatch_image_make(arena, width + 2, (height + 2) * count, "A", &made, err));
    struct hatch_arena_mark mark = hatch_arena_mark(scratch);
    const double *means = resample(style->stroke, width, height, scratch, err);
    if (!means)
        return HATCH_LIMIT;
    for (uint32_t i = 0; i < count; i++)
        for (uint32_t y = 0; y < height; y++) {
            float *row = made.pixels + ((size_t)i * (height + 2) + y + 1) * made.width + 1;
            for (uint32_t x = 0; x < width; x++) {
                double alpha =
                    means[(size_t)y * width + x] * grain_at(style->grain, i, (x + 0.5) * style->length_px / width,
                                                            (y + 0.5) * style->width_px / height);
                row[x] = (float)(floor(alpha * 255 + 0.5) / 255);
            }
        }
    hatch_arena_rewind(scratch, mark);
    made.height = height + 2;
    *stroke = made;
    *images = count;
    return HATCH_OK;
}
