#include "measure/tam_figures.h"

#include <assert.h>

#include "filter/blur.h"
#include "image/color.h"

const uint32_t hatch_evenness_divisors[HATCH_EVENNESS_BOXES] = {32, 16, 8, 4};

static uint32_t color_channels(const struct hatch_tam *tam)
{
    return tam->color ? 3 : 1;
}

static double reflectance(const struct hatch_tam *tam, const struct hatch_image *image, size_t pixel)
{
    const float *p = image->pixels + pixel * image->channel_count;
    double sum = 0;
    for (uint32_t c = 0; c < color_channels(tam); c++)
        sum += (double)p[c];
    return sum / color_channels(tam);
}

static uint64_t count_lighter(const struct hatch_tam *tam, const struct hatch_image *light,
                              const struct hatch_image *dark)
{
    uint64_t count = 0;
    for (size_t i = 0; i < (size_t)dark->width * dark->height; i++)
        for (uint32_t c = 0; c < color_channels(tam); c++)
            if (dark->pixels[i * dark->channel_count + c] > light->pixels[i * light->channel_count + c]) {
                count++;
                break;
            }
    return count;
}

/* Returns the mean absolute difference between a column (axis 0) or row (axis 1) and the next one, with wrap-around. */
static double jump(const struct hatch_tam *tam, const struct hatch_image *image, uint32_t axis, uint32_t i)
{
    uint32_t size = image->width, next = (i + 1) % size;
    double sum = 0;
    for (uint32_t j = 0; j < size; j++) {
        size_t here = axis ? (size_t)i * size + j : (size_t)j * size + i;
        size_t there = axis ? (size_t)next * size + j : (size_t)j * size + next;
        sum += fabs(reflectance(tam, image, here) - reflectance(tam, image, there));
    }
    return sum / size;
}

static double seam_z(const struct hatch_tam *tam, const struct hatch_image *image, uint32_t axis)
{
    double sum = 0, squares = 0, last = 0;
    uint32_t size = image->width;
    for (uint32_t i = 0; i < size; i++) {
        last = jump(tam, image, axis, i);
        sum += last;
        squares += last * last;
    }
    double mean = sum / size, variance = squares / size - mean * mean;
    return variance > 1e-12 ? (last - mean) / sqrt(variance) : 0;
}

static enum hatch_status box_spread(const struct hatch_image *image, uint32_t divisor, struct hatch_arena *scratch,
                                    double *spread, struct hatch_err *err)
{
    uint32_t side = image->width / divisor;
    *spread = 0;
    if (side == 0)
        return HATCH_OK;
    size_t pixels = (size_t)image->width * image->height;
    struct hatch_arena_mark mark = hatch_arena_mark(scratch);
    double *blurred = HATCH_NEW(scratch, double, pixels, err);
    enum hatch_status status = blurred ? hatch_blur_box(image, 0, side, scratch, blurred, err) : HATCH_LIMIT;
    if (status == HATCH_OK) {
        double mean = 0, variance = 0;
        for (size_t i = 0; i < pixels; i++)
            mean += blurred[i];
        mean /= (double)pixels;
        for (size_t i = 0; i < pixels; i++)
            variance += (blurred[i] - mean) * (blurred[i] - mean);
        *spread = sqrt(variance / (double)pixels);
    }
    hatch_arena_rewind(scratch, mark);
    return status;
}

enum hatch_status hatch_measure_spreads(const struct hatch_image *image, struct hatch_arena *scratch, double *spread,
                                        struct hatch_err *err)
{
    for (uint32_t box = 0; box < HATCH_EVENNESS_BOXES; box++)
        HATCH_TRY(box_spread(image, hatch_evenness_divisors[box], scratch, &spread[box], err));
    return HATCH_OK;
}

static void measure_color(const struct hatch_tam *tam, uint32_t tone, uint32_t level,
                          struct hatch_tam_image_figures *figures)
{
    double finest[2], chroma[2];
    figures->chroma = figures->hue_error_deg = NAN;
    if (!tam->color)
        return;
    hatch_color_chroma(&tam->columns[tone].levels[0], finest);
    hatch_color_chroma(&tam->columns[tone].levels[level], chroma);
    figures->chroma = hypot(chroma[0], chroma[1]);
    if (fmin(figures->chroma, hypot(finest[0], finest[1])) > HATCH_COLOR_CHROMA_MIN)
        figures->hue_error_deg = hatch_color_hue_between(finest, chroma);
}

enum hatch_status hatch_measure_tam_image(const struct hatch_tam *tam, uint32_t tone, uint32_t level,
                                          struct hatch_arena *scratch, struct hatch_tam_image_figures *figures,
                                          struct hatch_err *err)
{
    assert(tone < tam->tones && level < tam->columns[tone].level_count);
    const struct hatch_image *image = &tam->columns[tone].levels[level];
    struct hatch_tam_image_figures made = {.size_px = image->width};
    size_t pixels = (size_t)image->width * image->height;
    double sum = 0;
    for (size_t i = 0; i < pixels; i++)
        sum += reflectance(tam, image, i);
    made.mean = 1 - sum / (double)pixels;
    made.error = made.mean - (double)tam->target[tone];
    if (tone)
        made.lighter_pixels = count_lighter(tam, &tam->columns[tone - 1].levels[level], image);
    for (uint32_t axis = 0; axis < 2; axis++)
        made.seam_z[axis] = seam_z(tam, image, axis);
    measure_color(tam, tone, level, &made);
    HATCH_TRY(hatch_measure_spreads(image, scratch, made.spread, err));
    *figures = made;
    return HATCH_OK;
}
