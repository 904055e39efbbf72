#include "filter/blur.h"

#include <assert.h>

enum hatch_status hatch_blur_box(const struct hatch_image *image, uint32_t channel, uint32_t side,
                                 struct hatch_arena *scratch, double *blurred, struct hatch_err *err)
{
    uint32_t width = image->width, height = image->height, channels = image->channel_count;
    assert(channel < channels && side >= 1 && side <= width && side <= height);
    struct hatch_arena_mark mark = hatch_arena_mark(scratch);
    double *rows;
    HATCH_TRY(HATCH_ALLOC(scratch, &rows, (size_t)width * (height + (size_t)1), err));
    double *sums = rows + (size_t)width * height;
    for (uint32_t y = 0; y < height; y++) {
        const float *in = image->pixels + (size_t)y * width * channels + channel;
        double *out = rows + (size_t)y * width, sum = 0;
        for (uint32_t x = 0; x < side; x++)
            sum += (double)in[(size_t)x * channels];
        for (uint32_t x = 0; x < width; x++) {
            out[x] = sum / side;
            uint32_t next = x + side < width ? x + side : x + side - width;
            sum += (double)in[(size_t)next * channels] - (double)in[(size_t)x * channels];
        }
    }
    /* Row by row, as rows lie one after the other. */
    for (size_t y = 0; y < side; y++)
        for (size_t x = 0; x < width; x++)
            sums[x] = (y > 0 ? sums[x] : 0) + rows[y * width + x];
    for (size_t y = 0; y < height; y++) {
        const double *first = rows + y * width, *next = rows + (y + side) % height * width;
        for (size_t x = 0; x < width; x++) {
            blurred[y * width + x] = sums[x] / side;
            sums[x] += next[x] - first[x];
        }
    }
    hatch_arena_rewind(scratch, mark);
    return HATCH_OK;
}
