#include "tam/whole.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/text.h"
#include "image/texels.h"

#define STEP_MAX 0.125f
#define STEP_MIN 0x1p-11f
#define BLOCK 8u

void hatch_tam_whole_print(const struct hatch_tam *tam, struct hatch_tam_whole_keys *keys)
{
    const struct hatch_tam_whole *whole = &tam->whole;
    static const char *const names[4] = {HATCH_TAM_ATTR_WHOLE_SIZE, HATCH_TAM_ATTR_WHOLE_TONE, HATCH_TAM_ATTR_LAST_TONE,
                                         HATCH_TAM_ATTR_TOLERANCE};
    const double values[4] = {whole->size_px, (double)whole->darkest, (double)tam->target[tam->tones - 1],
                              (double)whole->tolerance};
    keys->pairs[0] = NULL;
    for (int i = 0; i < 4 && !hatch_tam_is_whole(tam); i++) {
        snprintf(keys->values[i], sizeof keys->values[i], "%.9g", values[i]);
        keys->pairs[2 * i] = names[i];
        keys->pairs[2 * i + 1] = keys->values[i];
        keys->pairs[2 * i + 2] = NULL;
    }
}

static enum hatch_status read_key(const char *const *key_values, const char *key, double low, double high,
                                  double *value, struct hatch_err *err)
{
    const char *text = hatch_texels_value(key_values, key);
    if (!text || !hatch_text_number((struct hatch_text){text, strlen(text)}, value) ||
        !(*value >= low && *value <= high))
        return hatch_fail(err, HATCH_BAD_INPUT, "%s '%s': want a number from %g to %g", key, text ? text : "", low,
                          high);
    return HATCH_OK;
}

enum hatch_status hatch_tam_whole_read(const char *const *key_values, uint32_t size_px, struct hatch_tam_whole *whole,
                                       float *last, struct hatch_err *err)
{
    double size, darkest, tone, tolerance;
    if (!hatch_texels_value(key_values, HATCH_TAM_ATTR_TOLERANCE)) {
        *whole = (struct hatch_tam_whole){.size_px = size_px};
        return HATCH_OK;
    }
    HATCH_TRY(read_key(key_values, HATCH_TAM_ATTR_WHOLE_SIZE, size_px, HATCH_TAM_SIZE_MAX, &size, err));
    HATCH_TRY(read_key(key_values, HATCH_TAM_ATTR_WHOLE_TONE, 0, 1, &darkest, err));
    HATCH_TRY(read_key(key_values, HATCH_TAM_ATTR_LAST_TONE, 0, darkest, &tone, err));
    HATCH_TRY(read_key(key_values, HATCH_TAM_ATTR_TOLERANCE, 1e-6, 1, &tolerance, err));
    *whole =
        (struct hatch_tam_whole){.size_px = (uint32_t)size, .darkest = (float)darkest, .tolerance = (float)tolerance};
    *last = (float)tone;
    return HATCH_OK;
}

void hatch_tam_cut(struct hatch_tam *tam, uint32_t tones, uint32_t finer, double tolerance)
{
    for (uint32_t i = 0; i < tones; i++) {
        tam->columns[i].levels += finer;
        tam->columns[i].level_count -= finer;
    }
    tam->size_px = tam->columns[0].levels[0].width;
    tam->levels -= finer;
    tam->tones = tones;
    tam->whole.tolerance = (float)tolerance;
}

/* Rounds to multiples of a step.
 *   per  their number in 1: exact, as steps are powers of 1/2 */
static inline float round_to(float value, float step, float per)
{
    return (float)(int)(value * per + 0.5f) * step;
}

/* The change by rounding, of blocks of pixels that have ink. */
struct change {
    double squares; /* sum of the squares of the changes of their means, per channel */
    uint64_t count; /* of these */
};

/* Adds a block of a channel.
 *   before  pixels of the column before, as they were rounded: none gets lighter */
static void add_block(const struct hatch_image *image, const float *before, uint32_t channel, const uint32_t at[2],
                      float step, struct change *change)
{
    const uint32_t width = image->width - at[0] < BLOCK ? image->width - at[0] : BLOCK;
    const uint32_t height = image->height - at[1] < BLOCK ? image->height - at[1] : BLOCK;
    const uint32_t stride = image->channel_count;
    const float per = 1 / step;
    float sums[BLOCK] = {0}, inks[BLOCK] = {0}, sum = 0, ink = 0; /* of columns of pixels */
    for (uint32_t y = at[1]; y < at[1] + height; y++) {
        const size_t first = ((size_t)y * image->width + at[0]) * stride + channel;
        const float *row = &image->pixels[first], *old = &before[first];
        for (uint32_t x = 0; x < width; x++) {
            const float value = round_to(row[x * stride], step, per), least = old[x * stride];
            sums[x] += (value < least ? value : least) - row[x * stride];
            inks[x] += 1 - row[x * stride];
        }
    }
    for (uint32_t x = 0; x < width; x++) {
        sum += sums[x];
        ink += inks[x];
    }
    if (ink > 0) {
        const double mean = (double)sum / (width * height);
        change->squares += mean * mean;
        change->count++;
    }
}

/* Returns the root of the mean of the squares of what rounding changes in blocks that have ink. */
static double change_by(const struct hatch_image *image, const float *before, uint32_t channels, float step)
{
    struct change change = {0};
    uint32_t at[2];
    for (at[1] = 0; at[1] < image->height; at[1] += BLOCK)
        for (at[0] = 0; at[0] < image->width; at[0] += BLOCK)
            for (uint32_t c = 0; c < channels; c++)
                add_block(image, before, c, at, step, &change);
    return change.count > 0 ? sqrt(change.squares / (double)change.count) : 0;
}

float hatch_tam_step_max(double tolerance)
{
    float step = STEP_MAX;
    while ((double)step > 16 * tolerance && step >= STEP_MIN)
        step /= 2;
    return step >= STEP_MIN ? step : 0;
}

/* Returns the step for a level: the largest that changes little, or else that which changes least; 0: it is not
 * rounded. A finer step may change more than that of the column before, since what was rounded down there stays as
 * dark, while what was rounded up does not. */
static float find_step(const struct hatch_image *image, const float *before, uint32_t channels, double tolerance)
{
    float best = 0;
    double least = INFINITY;
    for (float step = hatch_tam_step_max(tolerance); step >= STEP_MIN; step /= 2) {
        double change = change_by(image, before, channels, step);
        if (change <= tolerance / 2)
            return step;
        if (change < least) {
            least = change;
            best = step;
        }
    }
    return best;
}

/* Rounds the numbers of a grey image where they are not darker already; the loop is at once on vector units. */
static void round_grey(const float *restrict from, size_t pixels, float step, float *restrict to)
{
    const float per = 1 / step;
    for (size_t i = 0; i < pixels; i++) {
        float value = round_to(from[i], step, per);
        to[i] = to[i] < value ? to[i] : value;
    }
}

/* Rounds a channel where it is not darker already.
 *   stride  channels of a pixel
 *   step    0: it is copied */
static void round_channel(const float *from, size_t pixels, uint32_t stride, float step, float *to)
{
    const float per = step > 0 ? 1 / step : 0;
    if (stride == 1 && step > 0) {
        round_grey(from, pixels, step, to);
        return;
    }
    for (size_t i = 0; i < pixels * stride; i += stride) {
        float value = step > 0 ? round_to(from[i], step, per) : from[i];
        to[i] = to[i] < value ? to[i] : value;
    }
}

void hatch_tam_round(const struct hatch_mipmap *column, uint32_t levels, double tolerance, struct hatch_mipmap *rounded)
{
    for (uint32_t level = 0; level < column->level_count; level++) {
        const struct hatch_image *image = &column->levels[level];
        const uint32_t channels = image->channels[0].name[0] == 'Y' ? 1 : 3, stride = image->channel_count;
        float *to = rounded->levels[level].pixels;
        const float step = level < levels ? find_step(image, to, channels, tolerance) : 0;
        const size_t pixels = (size_t)image->width * image->height;
        for (uint32_t c = 0; c < channels; c++)
            round_channel(image->pixels + c, pixels, stride, step, to + c);
        for (size_t i = 0; channels < stride && i < pixels; i++) /* ids */
            memcpy(&to[i * stride + channels], &image->pixels[i * stride + channels], (stride - channels) * sizeof *to);
    }
}
