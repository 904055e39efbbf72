#include "filter/blur.h"

#include <assert.h>

enum hatch_status hatch_blur_box(const struct hatch_image *image, uint32_t channel, uint32_t side,
                                 struct hatch_arena *scratch, double *blurred, struct hatch_err *err)
{
    uint32_t width = image->width, height = image->height, channels = image->channel_count;
    assert(channel < channels && side >= 1 && side <= width && side <= height);
    struct hatch_arena_mark mark = hatch_arena_mark(scratch);
    double *rows;
    HATCH_TRY(HATCH_ALLOC(scratch, &rows, (size_t)width * height, err));
    for (uint32_t y = 0; y < height; y++) {
        const float *in = image->pixels + (size_t)y * width * channels + channel;
        double *out = rows + (size_t)y * width, sum = 0;
        for (uint32_t x = 0; x < side; x++)
            sum += (double)in[(size_t)x * channels];
        for (uint32_t x = 0; x < width; x++) {
            out[x] = sum / side;
            sum += (double)in[(size_t)((x + side) % width) * channels] - (double)in[(size_t)x * channels];
        }
    }
    for (size_t x = 0; x < width; x++) {
        double sum = 0;
        for (size_t y = 0; y < side; y++)
            sum += rows[y * width + x];
        for (size_t y = 0; y < height; y++) {
            blurred[y * width + x] = sum / side;
            sum += rows[(y + side) % height * width + x] - rows[y * width + x];
        }
    }
    hatch_arena_rewind(scratch, mark);
    return HATCH_OK;
}
