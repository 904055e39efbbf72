#include "synthesis/features.h"

#include <math.h>
#include <string.h>

#include "math/pca.h"

#define BASIS_BITS 12
#define SAMPLES_MAX 4096u /* neighbourhoods from which the covariance is taken */

/* Copies a neighbourhood of the exemplar as hatch_features_project wants it. */
static void gather(const struct hatch_exemplar *exemplar, uint32_t x, uint32_t y, int16_t *values)
{
    uint32_t row = exemplar->side * exemplar->channels;
    for (uint32_t j = 0; j < exemplar->side; j++) {
        const uint8_t *from = exemplar->pixels + ((size_t)(y + j) * HATCH_EXEMPLAR_PITCH + x) * exemplar->channels;
        for (uint32_t i = 0; i < row; i++)
            values[j * row + i] = (int16_t)(from[i] - 128);
    }
}

/* Sums the products of all pairs of values over evenly spread neighbourhoods. */
static void sum_covariance(const struct hatch_exemplar *exemplar, uint32_t length, double *covariance)
{
    int16_t values[HATCH_EXEMPLAR_VALUES_MAX + 16] = {0};
    double mean[HATCH_EXEMPLAR_VALUES_MAX] = {0};
    uint32_t count = exemplar->across * exemplar->down, samples = count < SAMPLES_MAX ? count : SAMPLES_MAX;
    memset(covariance, 0, (size_t)length * length * sizeof *covariance);
    for (uint32_t s = 0; s < samples; s++) {
        uint32_t at = (uint32_t)((uint64_t)s * count / samples);
        gather(exemplar, at % exemplar->across, at / exemplar->across, values);
        for (uint32_t i = 0; i < length; i++) {
            double value = values[i];
            mean[i] += value;
            for (uint32_t j = 0; j <= i; j++)
                covariance[(size_t)i * length + j] += value * values[j];
        }
    }
    for (uint32_t i = 0; i < length; i++)
        for (uint32_t j = 0; j <= i; j++) {
            double of_pair = covariance[(size_t)i * length + j] - mean[i] * mean[j] / samples;
            covariance[(size_t)i * length + j] = covariance[(size_t)j * length + i] = of_pair;
        }
}

static enum hatch_status make_basis(const struct hatch_exemplar *exemplar, struct hatch_arena *scratch,
                                    struct hatch_features *features, struct hatch_err *err)
{
    uint32_t length = exemplar->side * exemplar->side * exemplar->channels;
    uint32_t count = length < HATCH_FEATURES ? length : HATCH_FEATURES;
    double *covariance, *directions, *next;
    HATCH_TRY(HATCH_ALLOC_UNSET(scratch, &covariance, (size_t)length * length, err));
    HATCH_TRY(HATCH_ALLOC_UNSET(scratch, &directions, (size_t)count * length, err));
    HATCH_TRY(HATCH_ALLOC_UNSET(scratch, &next, (size_t)count * length, err));
    sum_covariance(exemplar, length, covariance);
    hatch_pca_directions(covariance, length, count, directions, next);
    for (uint32_t d = 0; d < count; d++)
        for (uint32_t i = 0; i < length; i++)
            features->basis[(size_t)d * features->length + i] =
                (int16_t)floor(directions[(size_t)d * length + i] * (1 << BASIS_BITS) + 0.5);
    return HATCH_OK;
}

void hatch_features_project(const struct hatch_features *features, const int16_t *values,
                            int16_t feature[HATCH_FEATURES])
{
    const uint32_t length = features->length & ~15u; /* for vectors of whole length */
    const int32_t unit = (1 << BASIS_BITS) / HATCH_FEATURES_SCALE;
    for (uint32_t d = 0; d < HATCH_FEATURES; d++) {
        const int16_t *row = features->basis + (size_t)d * features->length;
        int32_t sum = 0;
        for (uint32_t i = 0; i < length; i++)
            sum += row[i] * values[i];
        feature[d] = (int16_t)((sum + (sum < 0 ? -unit : unit) / 2) / unit);
    }
}

struct job {
    const struct hatch_exemplar *exemplar;
    struct hatch_features *features;
};

/* Projects the neighbourhoods of one row. */
static void project_row(void *context, uint32_t y)
{
    const struct job *job = context;
    int16_t values[HATCH_EXEMPLAR_VALUES_MAX + 16] = {0};
    for (uint32_t x = 0; x < job->exemplar->across; x++) {
        size_t at = (size_t)y * job->exemplar->across + x;
        gather(job->exemplar, x, y, values);
        hatch_features_project(job->features, values, job->features->vectors + at * HATCH_FEATURES);
    }
}

/* Finds the neighbourhoods that are most similar to each of one row, and not next to it. */
static void find_similar(void *context, uint32_t row)
{
    const struct job *job = context;
    const struct hatch_exemplar *exemplar = job->exemplar;
    const int16_t *vectors = job->features->vectors;
    const uint32_t apart = exemplar->side / 4 + 1;
    for (uint32_t column = 0; column < exemplar->across; column++) {
        size_t at = (size_t)row * exemplar->across + column;
        uint16_t *similar = job->features->similar + at * HATCH_FEATURES_SIMILAR;
        uint32_t least[HATCH_FEATURES_SIMILAR];
        memset(least, 0xff, sizeof least);
        for (uint32_t i = 0; i < HATCH_FEATURES_SIMILAR; i++)
            similar[i] = (uint16_t)(row * HATCH_EXEMPLAR_PITCH + column);
        const int16_t *other = vectors;
        for (uint32_t y = 0; y < exemplar->down; y++)
            for (uint32_t x = 0; x < exemplar->across; x++, other += HATCH_FEATURES) {
                uint32_t distance = hatch_features_distance(vectors + at * HATCH_FEATURES, other);
                if (distance >= least[HATCH_FEATURES_SIMILAR - 1])
                    continue;
                if (x + apart > column && column + apart > x && y + apart > row && row + apart > y)
                    continue;
                uint32_t i = HATCH_FEATURES_SIMILAR - 1;
                for (; i > 0 && distance < least[i - 1]; i--) {
                    least[i] = least[i - 1];
                    similar[i] = similar[i - 1];
                }
                least[i] = distance;
                similar[i] = (uint16_t)(y * HATCH_EXEMPLAR_PITCH + x);
            }
    }
}

size_t hatch_features_bytes(const struct hatch_exemplar *exemplar)
{
    const size_t length = (size_t)exemplar->side * exemplar->side * exemplar->channels;
    const size_t count = (size_t)exemplar->across * exemplar->down;
    return count * (HATCH_FEATURES * sizeof(int16_t) + HATCH_FEATURES_SIMILAR * sizeof(uint16_t)) +
           HATCH_FEATURES * (length + 15) * sizeof(int16_t) + (length + 2 * HATCH_FEATURES) * length * sizeof(double);
}

enum hatch_status hatch_features_make(const struct hatch_exemplar *exemplar, bool similar, struct hatch_pool *pool,
                                      struct hatch_arena *arena, struct hatch_arena *scratch,
                                      struct hatch_features *features, struct hatch_err *err)
{
    struct hatch_features made = {(exemplar->side * exemplar->side * exemplar->channels + 15) / 16 * 16, NULL, NULL,
                                  NULL};
    size_t count = (size_t)exemplar->across * exemplar->down;
    HATCH_TRY(HATCH_ALLOC(arena, &made.basis, HATCH_FEATURES * made.length, err));
    HATCH_TRY(HATCH_ALLOC_UNSET(arena, &made.vectors, count * HATCH_FEATURES, err));
    if (similar)
        HATCH_TRY(HATCH_ALLOC_UNSET(arena, &made.similar, count * HATCH_FEATURES_SIMILAR, err));
    struct hatch_arena_mark mark = hatch_arena_mark(scratch);
    enum hatch_status status = make_basis(exemplar, scratch, &made, err);
    hatch_arena_rewind(scratch, mark);
    HATCH_TRY(status);
    struct job job = {exemplar, &made};
    hatch_parallel_for(pool, exemplar->down, project_row, &job);
    if (similar)
        hatch_parallel_for(pool, exemplar->down, find_similar, &job);
    *features = made;
    return HATCH_OK;
}
