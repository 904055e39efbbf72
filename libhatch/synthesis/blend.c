#include "synthesis/blend.h"

#include <math.h>
#include <string.h>

#define CONTRIBUTIONS_MAX (HATCH_AXES * HATCH_SYNTHESIS_SIDE_MAX * HATCH_SYNTHESIS_SIDE_MAX)
#define EXPONENT (0.8 - 2)

struct job {
    const struct hatch_volume *volume;
    const struct hatch_exemplar *exemplar;
    const struct hatch_blend_tables *tables;
};

/* Lists the pixels of the exemplar that the neighbourhoods over a texel contribute, by their places. Returns their
 * number. */
static uint32_t list_contributions(const struct job *job, const uint32_t at[3], uint32_t *list)
{
    const uint32_t size = job->volume->size, side = job->exemplar->side, after = side / 2 + 2 * size;
    const uint32_t mask = size - 1; /* sizes are powers of two */
    const uint32_t places[HATCH_AXES][3] = {{at[0], at[2], at[1]}, {at[1], at[2], at[0]}, {at[2], at[1], at[0]}};
    uint32_t count = 0;
    for (uint32_t axis = 0; axis < HATCH_AXES; axis++) {
        if (!hatch_volume_has(job->volume, axis))
            continue;
        const uint16_t *matches = job->volume->matches[axis] + (size_t)places[axis][0] * size * size;
        for (uint32_t j = 0; j < side; j++) {
            const uint16_t *row = matches + (size_t)((places[axis][1] + after - j) & mask) * size;
            for (uint32_t i = 0; i < side; i++)
                list[count++] = row[(places[axis][2] + after - i) & mask] + j * HATCH_EXEMPLAR_PITCH + i;
        }
    }
    return count;
}

static uint32_t distance_of(const uint8_t *a, const uint8_t *b, uint32_t channels)
{
    int32_t sum = 0;
    for (uint32_t c = 0; c < channels; c++)
        sum += (a[c] - b[c]) * (a[c] - b[c]);
    return (uint32_t)sum;
}

static void average_texel(const struct job *job, const uint32_t at[3], const uint8_t *before, uint8_t *mean)
{
    const uint32_t channels = job->volume->channels;
    uint32_t list[CONTRIBUTIONS_MAX], count = list_contributions(job, at, list);
    float sums[3] = {0, 0, 0}, total = 0;
    for (uint32_t n = 0; n < count; n++) {
        const uint8_t *pixel = job->exemplar->pixels + (size_t)list[n] * channels;
        float weight = job->tables->weights[(uint32_t)sqrtf((float)distance_of(pixel, before, channels))];
        for (uint32_t c = 0; c < channels; c++)
            sums[c] += weight * pixel[c];
        total += weight;
    }
    for (uint32_t c = 0; c < channels; c++)
        mean[c] = (uint8_t)(sums[c] / total + 0.5f);
}

/* Replaces a mean by the contributed pixel nearest to its mapped value. */
static void choose_texel(const struct job *job, const uint32_t at[3], uint8_t *texel)
{
    const uint32_t channels = job->volume->channels;
    uint32_t list[CONTRIBUTIONS_MAX], count = list_contributions(job, at, list), least = UINT32_MAX;
    const uint8_t *nearest = texel;
    uint8_t target[3] = {0};
    for (uint32_t c = 0; c < channels; c++)
        target[c] = job->tables->values[c * 256 + texel[c]];
    for (uint32_t n = 0; n < count && least > 0; n++) {
        const uint8_t *pixel = job->exemplar->pixels + (size_t)list[n] * channels;
        uint32_t distance = distance_of(target, pixel, channels);
        if (distance < least) {
            least = distance;
            nearest = pixel;
        }
    }
    memcpy(texel, nearest, channels);
}

static void average_plane(void *context, uint32_t z)
{
    const struct job *job = context;
    const uint32_t size = job->volume->size;
    for (uint32_t y = 0; y < size; y++)
        for (uint32_t x = 0; x < size; x++) {
            const uint32_t at[3] = {x, y, z};
            size_t texel = (((size_t)z * size + y) * size + x) * job->volume->channels;
            average_texel(job, at, job->volume->texels + texel, job->volume->next + texel);
        }
}

static void choose_plane(void *context, uint32_t z)
{
    const struct job *job = context;
    const uint32_t size = job->volume->size;
    for (uint32_t y = 0; y < size; y++)
        for (uint32_t x = 0; x < size; x++) {
            const uint32_t at[3] = {x, y, z};
            choose_texel(job, at, job->volume->next + (((size_t)z * size + y) * size + x) * job->volume->channels);
        }
}

/* Maps the means of a channel so that they have the histogram of the exemplar: each to the value with the same share of
 * pixels below it. */
static void map_means(const struct job *job, uint32_t channel, uint8_t *values)
{
    const struct hatch_exemplar *exemplar = job->exemplar;
    const size_t count = hatch_volume_count(job->volume);
    const uint32_t channels = job->volume->channels;
    uint64_t have[256] = {0}, want[256] = {0}, pixels = (uint64_t)exemplar->width * exemplar->height;
    for (size_t i = 0; i < count; i++)
        have[job->volume->next[i * channels + channel]]++;
    for (uint32_t y = 0; y < exemplar->height; y++)
        for (uint32_t x = 0; x < exemplar->width; x++)
            want[exemplar->pixels[((size_t)y * HATCH_EXEMPLAR_PITCH + x) * channels + channel]]++;
    uint64_t below = 0, up_to = want[0];
    uint32_t value = 0;
    for (uint32_t mean = 0; mean < 256; mean++) {
        /* Share of the texels below the middle of this mean: (below + have / 2) / count. */
        while (value < 255 && 2 * up_to * count < (2 * below + have[mean]) * pixels)
            up_to += want[++value];
        below += have[mean];
        values[mean] = (uint8_t)value;
    }
}

void hatch_blend_run(struct hatch_volume *volume, const struct hatch_exemplar *exemplar, uint32_t tolerance,
                     struct hatch_pool *pool, struct hatch_blend_tables *tables)
{
    struct job job = {volume, exemplar, tables};
    const uint32_t weights = sizeof tables->weights / sizeof *tables->weights;
    for (uint32_t d = 0; d < weights; d++)
        tables->weights[d] = (float)pow((d > tolerance ? d : tolerance) + 1, EXPONENT);
    hatch_parallel_for(pool, volume->size, average_plane, &job);
    for (uint32_t c = 0; c < volume->channels; c++)
        map_means(&job, c, tables->values + (size_t)c * 256);
    hatch_parallel_for(pool, volume->size, choose_plane, &job);
    uint8_t *texels = volume->texels;
    volume->texels = volume->next;
    volume->next = texels;
}
