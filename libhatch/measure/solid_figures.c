#include "measure/solid_figures.h"

#include <math.h>
#include <string.h>

#include "base/random.h"
#include "image/color.h"
#include "synthesis/volume.h"

#define SEED 1 /* random seed of the samples; fixed, so that measuring a file again gives the same figures */

static void count_values(const struct hatch_solid *solid, uint32_t channel, uint64_t counts[256])
{
    const size_t texels = (size_t)solid->size * solid->size * solid->size;
    memset(counts, 0, 256 * sizeof *counts);
    for (size_t i = 0; i < texels; i++)
        counts[solid->texels[i * solid->channels + channel]]++;
}

static void measure_channel(const struct hatch_solid *solid, uint32_t channel, struct hatch_solid_figures *figures)
{
    const double texels = (double)solid->size * solid->size * solid->size;
    uint64_t counts[256];
    double sum = 0, squares = 0;
    count_values(solid, channel, counts);
    for (uint32_t value = 0; value < 256; value++)
        sum += (double)counts[value] * value;
    for (uint32_t value = 0; value < 256; value++)
        squares += (double)counts[value] * (value - sum / texels) * (value - sum / texels);
    figures->mean[channel] = sum / texels / 255;
    figures->deviation[channel] = sqrt(squares / texels) / 255;
}

/* Returns the mean difference between the texels of a slice and those of the next one. */
static double slice_step(const struct hatch_solid *solid, uint32_t axis, uint32_t slice)
{
    const uint32_t size = solid->size, channels = solid->channels;
    const struct hatch_slices steps = hatch_slices_of(axis, size);
    uint64_t sum = 0;
    for (uint32_t row = 0; row < size; row++)
        for (uint32_t column = 0; column < size; column++) {
            const size_t beside = row * steps.row + column * steps.column;
            const uint8_t *from = solid->texels + (slice * steps.slice + beside) * channels;
            const uint8_t *to = solid->texels + ((slice + 1) % size * steps.slice + beside) * channels;
            for (uint32_t c = 0; c < channels; c++)
                sum += (uint64_t)(from[c] < to[c] ? to[c] - from[c] : from[c] - to[c]);
        }
    return (double)sum / 255 / ((double)size * size * channels);
}

static void measure_steps(const struct hatch_solid *solid, struct hatch_solid_figures *figures)
{
    double least = INFINITY, most = 0;
    for (uint32_t axis = 0; axis < HATCH_AXES; axis++) {
        double sum = 0, largest = 0, border = slice_step(solid, axis, solid->size - 1);
        for (uint32_t slice = 0; slice + 1 < solid->size; slice++) {
            double step = slice_step(solid, axis, slice);
            sum += step;
            largest = fmax(largest, step);
        }
        figures->step[axis] = sum / (solid->size - 1);
        least = fmin(least, figures->step[axis]);
        most = fmax(most, figures->step[axis]);
        figures->seam = fmax(figures->seam, border > 0 ? border / largest : 0);
    }
    figures->isotropy = most > 0 ? least / most : 1;
}

/* Gives the exemplar the channels of the solid. */
static enum hatch_status convert_channels(const struct hatch_image *exemplar, uint32_t channels,
                                          struct hatch_arena *scratch, struct hatch_image *converted,
                                          struct hatch_err *err)
{
    *converted = *exemplar;
    if (exemplar->channel_count == channels)
        return HATCH_OK;
    HATCH_TRY(
        hatch_image_make(scratch, exemplar->width, exemplar->height, channels == 1 ? "Y" : "RGB", converted, err));
    for (size_t i = 0; i < (size_t)exemplar->width * exemplar->height; i++)
        for (uint32_t c = 0; c < channels; c++)
            converted->pixels[i * channels + c] =
                channels == 1 ? hatch_color_luminance(exemplar->pixels + 3 * i) : exemplar->pixels[i];
    return HATCH_OK;
}

/* Earth mover's distance between the histograms of a channel: the sum of the differences of their running sums. */
static double histogram_distance(const struct hatch_solid *solid, const struct hatch_exemplar *exemplar,
                                 uint32_t channel)
{
    const double texels = (double)solid->size * solid->size * solid->size;
    const double pixels = (double)exemplar->width * exemplar->height;
    uint64_t have[256], want[256] = {0};
    double sum = 0, running = 0;
    count_values(solid, channel, have);
    for (uint32_t y = 0; y < exemplar->height; y++)
        for (uint32_t x = 0; x < exemplar->width; x++)
            want[exemplar->pixels[((size_t)y * HATCH_EXEMPLAR_PITCH + x) * exemplar->channels + channel]]++;
    for (uint32_t value = 0; value < 255; value++) {
        running += (double)have[value] / texels - (double)want[value] / pixels;
        sum += fabs(running);
    }
    return sum / 255;
}

struct comparison {
    const struct hatch_volume *volume;
    const struct hatch_exemplar *exemplar;
    double *distances; /* per sample and axis: root mean square difference to the nearest neighbourhood */
};

static void compare_sample(void *context, uint32_t sample)
{
    const struct comparison *comparison = context;
    const struct hatch_exemplar *exemplar = comparison->exemplar;
    const uint32_t size = comparison->volume->size, axis = sample % HATCH_AXES;
    const uint64_t bits = hatch_random_u64(SEED, 0, sample / HATCH_AXES);
    const uint32_t at[3] = {(uint32_t)bits % size, (uint32_t)(bits >> 16) % size, (uint32_t)(bits >> 32) % size};
    int16_t values[HATCH_EXEMPLAR_VALUES_MAX];
    uint32_t least = UINT32_MAX;
    hatch_volume_gather(comparison->volume, exemplar->side, axis, at[0], at[1], at[2], values);
    for (uint32_t y = 0; y < exemplar->down; y++)
        for (uint32_t x = 0; x < exemplar->across; x++) {
            uint32_t distance = hatch_exemplar_distance(exemplar, values, y * HATCH_EXEMPLAR_PITCH + x, least);
            least = distance < least ? distance : least;
        }
    comparison->distances[sample] =
        sqrt((double)least / ((double)exemplar->side * exemplar->side * exemplar->channels)) / 255;
}

static enum hatch_status compare(const struct hatch_solid *solid, const struct hatch_image *picture, uint32_t samples,
                                 struct hatch_pool *pool, struct hatch_arena *scratch,
                                 struct hatch_solid_figures *figures, struct hatch_err *err)
{
    struct hatch_synthesis_figures reduction;
    struct hatch_image reduced, image;
    struct hatch_exemplar exemplar;
    const struct hatch_volume volume = {.size = solid->size, .channels = solid->channels, .texels = solid->texels};
    struct comparison comparison = {&volume, &exemplar, NULL};
    struct hatch_arena_mark mark = hatch_arena_mark(scratch);
    HATCH_TRY(hatch_synthesis_exemplar(picture, solid->size, scratch, scratch, &reduced, &reduction, err));
    HATCH_TRY(convert_channels(&reduced, solid->channels, scratch, &image, err));
    const uint32_t shorter = image.width < image.height ? image.width : image.height;
    const uint32_t side = shorter < HATCH_SOLID_NEIGHBORHOOD ? shorter : HATCH_SOLID_NEIGHBORHOOD;
    HATCH_TRY(hatch_exemplar_make(&image, side, scratch, &exemplar, err));
    HATCH_TRY(HATCH_ALLOC_UNSET(scratch, &comparison.distances, (size_t)samples * HATCH_AXES, err));
    hatch_parallel_for(pool, samples * HATCH_AXES, compare_sample, &comparison);
    figures->histogram = 0;
    for (uint32_t c = 0; c < solid->channels; c++)
        figures->histogram += histogram_distance(solid, &exemplar, c) / solid->channels;
    figures->neighborhood_all = 0;
    for (uint32_t axis = 0; axis < HATCH_AXES; axis++) {
        double sum = 0;
        for (uint32_t sample = 0; sample < samples; sample++)
            sum += comparison.distances[(size_t)sample * HATCH_AXES + axis];
        figures->neighborhood[axis] = sum / samples;
        figures->neighborhood_all += figures->neighborhood[axis] / HATCH_AXES;
    }
    hatch_arena_rewind(scratch, mark);
    return HATCH_OK;
}

enum hatch_status hatch_measure_solid(const struct hatch_solid *solid, const struct hatch_image *exemplar,
                                      uint32_t samples, struct hatch_pool *pool, struct hatch_arena *scratch,
                                      struct hatch_solid_figures *figures, struct hatch_err *err)
{
    struct hatch_solid_figures found = {.mean = {NAN, NAN, NAN},
                                        .deviation = {NAN, NAN, NAN},
                                        .histogram = NAN,
                                        .neighborhood = {NAN, NAN, NAN},
                                        .neighborhood_all = NAN};
    struct hatch_arena_mark mark = hatch_arena_mark(scratch);
    enum hatch_status status = exemplar ? compare(solid, exemplar, samples, pool, scratch, &found, err) : HATCH_OK;
    hatch_arena_rewind(scratch, mark);
    if (status != HATCH_OK)
        return status;
    for (uint32_t c = 0; c < solid->channels; c++)
        measure_channel(solid, c, &found);
    measure_steps(solid, &found);
    *figures = found;
    return HATCH_OK;
}
