#include "filter/difference.h"

#include <assert.h>
#include <math.h>
#include <stdbool.h>

static size_t number_count(const struct hatch_image *image)
{
    return (size_t)image->width * image->height * image->channel_count;
}

static void assert_alike(const struct hatch_image *a, const struct hatch_image *b)
{
    assert(a->width == b->width && a->height == b->height);
    assert(a->channel_count == b->channel_count);
}

static double difference_of(float a, float b)
{
    return isnan(a) || isnan(b) ? 0 : (double)a - (double)b;
}

void hatch_image_difference(const struct hatch_image *a, const struct hatch_image *b,
                            struct hatch_difference *difference)
{
    assert_alike(a, b);
    double max = 0, sum = 0, sum_signed = 0, sum_squares = 0;
    size_t count = number_count(a), differing = 0;
    for (size_t i = 0; i < count; i += a->channel_count) {
        bool differs = false;
        for (uint32_t c = 0; c < a->channel_count; c++) {
            float left = a->pixels[i + c], right = b->pixels[i + c];
            if (isnan(left) != isnan(right)) {
                max = INFINITY;
                differs = true;
            }
            double d = difference_of(left, right), size = fabs(d);
            max = size > max ? size : max;
            sum += size;
            sum_signed += d;
            sum_squares += d * d;
            differs |= size > 0;
        }
        differing += differs;
    }
    double n = (double)count, rmse = sqrt(sum_squares / n);
    *difference = (struct hatch_difference){
        .max = max,
        .mean = sum / n,
        .bias = sum_signed / n,
        .rmse = rmse,
        .psnr_db = rmse > 0 ? -20 * log10(rmse) : INFINITY,
        .differing = (double)differing * a->channel_count / n,
    };
}

/* Computes a summed-area table of a channel of a - b: sums[y * (width + 1) + x] is the sum over the pixels above y and
 * left of x.
 *   b  NULL: of a alone */
static void sum_areas(const struct hatch_image *a, const struct hatch_image *b, uint32_t channel, double *sums)
{
    size_t pitch = (size_t)a->width + 1;
    for (uint32_t y = 0; y < a->height; y++) {
        double row = 0;
        for (uint32_t x = 0; x < a->width; x++) {
            size_t at = ((size_t)y * a->width + x) * a->channel_count + channel;
            row += difference_of(a->pixels[at], b ? b->pixels[at] : 0);
            sums[(y + 1) * pitch + x + 1] = sums[y * pitch + x + 1] + row;
        }
    }
}

static double largest_window(const double *sums, uint32_t width, uint32_t height, uint32_t box_px)
{
    size_t pitch = (size_t)width + 1;
    uint32_t across = box_px < width ? box_px : width, down = box_px < height ? box_px : height;
    double largest = 0;
    for (uint32_t y = 0; y + down <= height; y++)
        for (uint32_t x = 0; x + across <= width; x++) {
            const double *top = sums + y * pitch + x, *bottom = top + down * pitch;
            double mean = fabs(bottom[across] - bottom[0] - top[across] + top[0]);
            largest = mean > largest ? mean : largest;
        }
    return largest / ((double)across * down);
}

enum hatch_status hatch_image_low_difference(const struct hatch_image *a, const struct hatch_image *b, uint32_t box_px,
                                             struct hatch_arena *scratch, double *difference, struct hatch_err *err)
{
    assert(box_px > 0);
    if (b)
        assert_alike(a, b);
    struct hatch_arena_mark mark = hatch_arena_mark(scratch);
    double *sums;
    HATCH_TRY(HATCH_ALLOC(scratch, &sums, ((size_t)a->width + 1) * (a->height + 1u), err));
    double largest = 0;
    for (uint32_t c = 0; c < a->channel_count; c++) {
        sum_areas(a, b, c, sums);
        double found = largest_window(sums, a->width, a->height, box_px);
        largest = found > largest ? found : largest;
    }
    hatch_arena_rewind(scratch, mark);
    *difference = largest;
    return HATCH_OK;
}

double hatch_image_mean(const struct hatch_image *image)
{
    double sum = 0;
    size_t count = number_count(image);
    for (size_t i = 0; i < count; i++)
        sum += (double)image->pixels[i];
    return sum / (double)count;
}

double hatch_image_second_difference(const struct hatch_image *before, const struct hatch_image *now,
                                     const struct hatch_image *after, struct hatch_image *change)
{
    assert_alike(before, now);
    assert_alike(now, after);
    assert_alike(now, change);
    double sum = 0;
    size_t count = number_count(now);
    for (size_t i = 0; i < count; i++) {
        double value = (double)before->pixels[i] - 2 * (double)now->pixels[i] + (double)after->pixels[i];
        change->pixels[i] = (float)value;
        sum += fabs(value);
    }
    return sum / (double)count;
}
