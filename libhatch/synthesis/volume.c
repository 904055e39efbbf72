#include "synthesis/volume.h"

#include <math.h>
#include <string.h>

#include "base/random.h"

/* Returns one of count numbers for 32 random bits. */
static uint32_t pick(uint64_t bits, uint32_t count)
{
    return (uint32_t)((bits & 0xffffffff) * count >> 32);
}

void hatch_volume_randomize(const struct hatch_volume *volume, const struct hatch_exemplar *exemplar, uint64_t key)
{
    const size_t count = hatch_volume_count(volume);
    for (size_t i = 0; i < count; i++) {
        for (uint32_t axis = 0; axis <= HATCH_AXES; axis++) {
            uint64_t bits = hatch_random_at(key, i * (HATCH_AXES + 1) + axis);
            if (axis < HATCH_AXES) {
                volume->matches[axis][i] =
                    (uint16_t)(pick(bits, exemplar->down) * HATCH_EXEMPLAR_PITCH + pick(bits >> 32, exemplar->across));
                continue;
            }
            size_t pixel =
                (size_t)pick(bits, exemplar->height) * HATCH_EXEMPLAR_PITCH + pick(bits >> 32, exemplar->width);
            memcpy(volume->texels + i * volume->channels, exemplar->pixels + pixel * volume->channels,
                   volume->channels);
        }
    }
}

/* Returns twice a coordinate, moved, within 0 .. count-1. */
static uint32_t refine_coordinate(uint32_t coarse, int32_t move, uint32_t count)
{
    int32_t fine = (int32_t)(2 * coarse) + move;
    return fine < 0 ? 0 : (uint32_t)fine < count ? (uint32_t)fine : count - 1;
}

void hatch_volume_refine(const struct hatch_volume *coarse, const struct hatch_exemplar *coarse_exemplar,
                         const struct hatch_volume *volume, const struct hatch_exemplar *exemplar)
{
    const uint32_t size = volume->size, channels = volume->channels;
    /* From the corners of neighbourhoods to the pixels on their texels, and back. */
    const int32_t move = 2 * (int32_t)(coarse_exemplar->side / 2) - (int32_t)(exemplar->side / 2);
    for (size_t to = 0; to < hatch_volume_count(volume); to++) {
        size_t x = to % size, y = to / size % size, z = to / size / size;
        size_t from = (z / 2 * coarse->size + y / 2) * coarse->size + x / 2;
        memcpy(volume->texels + to * channels, coarse->texels + from * channels, channels);
        /* The same for slices, rows and columns. */
        for (uint32_t axis = 0; axis < HATCH_AXES; axis++) {
            uint32_t match = coarse->matches[axis][from];
            volume->matches[axis][to] =
                (uint16_t)(refine_coordinate(match / HATCH_EXEMPLAR_PITCH, move + (int32_t)(y & 1), exemplar->down) *
                               HATCH_EXEMPLAR_PITCH +
                           refine_coordinate(match % HATCH_EXEMPLAR_PITCH, move + (int32_t)(x & 1), exemplar->across));
        }
    }
}

void hatch_volume_gather(const struct hatch_volume *volume, uint32_t side, uint32_t axis, uint32_t slice, uint32_t u,
                         uint32_t v, int16_t *values)
{
    const uint32_t size = volume->size, before = size - side / 2 % size;
    const struct hatch_slices steps = hatch_slices_of(axis, size);
    for (uint32_t j = 0; j < side; j++)
        for (uint32_t i = 0; i < side; i++) {
            size_t texel =
                slice * steps.slice + (v + j + before) % size * steps.row + (u + i + before) % size * steps.column;
            for (uint32_t c = 0; c < volume->channels; c++)
                *values++ = (int16_t)(volume->texels[texel * volume->channels + c] - 128);
        }
}

struct energy_job {
    const struct hatch_volume *volume;
    const struct hatch_exemplar *exemplar;
    double *sums; /* per axis and slice */
};

static void sum_slice(void *context, uint32_t index)
{
    const struct energy_job *job = context;
    const uint32_t size = job->volume->size, axis = index / size, slice = index % size;
    int16_t values[HATCH_EXEMPLAR_VALUES_MAX];
    const double count = (double)job->exemplar->side * job->exemplar->side * job->volume->channels;
    double sum = 0;
    for (uint32_t v = 0; v < size && hatch_volume_has(job->volume, axis); v++)
        for (uint32_t u = 0; u < size; u++) {
            hatch_volume_gather(job->volume, job->exemplar->side, axis, slice, u, v, values);
            uint32_t match = job->volume->matches[axis][((size_t)slice * size + v) * size + u];
            sum += sqrt(hatch_exemplar_distance(job->exemplar, values, match, UINT32_MAX) / count) / 255;
        }
    job->sums[index] = sum;
}

enum hatch_status hatch_volume_energy(const struct hatch_volume *volume, const struct hatch_exemplar *exemplar,
                                      struct hatch_pool *pool, struct hatch_arena *scratch, double *energy,
                                      struct hatch_err *err)
{
    struct energy_job job = {volume, exemplar, NULL};
    struct hatch_arena_mark mark = hatch_arena_mark(scratch);
    HATCH_TRY(HATCH_ALLOC_UNSET(scratch, &job.sums, HATCH_AXES * volume->size, err));
    hatch_parallel_for(pool, HATCH_AXES * volume->size, sum_slice, &job);
    double sum = 0;
    for (uint32_t i = 0; i < HATCH_AXES * volume->size; i++)
        sum += job.sums[i];
    *energy = sum / ((double)hatch_volume_axis_count(volume) * (double)hatch_volume_count(volume));
    hatch_arena_rewind(scratch, mark);
    return HATCH_OK;
}
