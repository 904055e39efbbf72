#include "math/pca.h"

#include <assert.h>
#include <math.h>
#include <string.h>

#include "base/random.h"

#define ROUNDS 60 /* of the iteration; directions of nearly equal variance stay mixed, which distances do not feel */

static double dot(const double *a, const double *b, uint32_t length)
{
    double sum = 0;
    for (uint32_t i = 0; i < length; i++)
        sum += a[i] * b[i];
    return sum;
}

/* Makes a vector orthogonal to those before it and of length 1. Returns false where nothing is left of it. */
static int orthonormalize(double *vectors, uint32_t which, uint32_t length)
{
    double *vector = vectors + (size_t)which * length;
    double before = sqrt(dot(vector, vector, length));
    for (int twice = 0; twice < 2; twice++)
        for (uint32_t d = 0; d < which; d++) {
            const double *other = vectors + (size_t)d * length;
            double along = dot(vector, other, length);
            for (uint32_t i = 0; i < length; i++)
                vector[i] -= along * other[i];
        }
    double norm = sqrt(dot(vector, vector, length));
    if (!(norm > 1e-9 * before))
        return 0;
    for (uint32_t i = 0; i < length; i++)
        vector[i] /= norm;
    return 1;
}

/* Puts another vector in place of one of which nothing is left: the first axis that is none of the space before it. */
static void replace(double *vectors, uint32_t which, uint32_t length)
{
    double *vector = vectors + (size_t)which * length;
    uint32_t axis = 0;
    do {
        assert(axis < length);
        memset(vector, 0, length * sizeof *vector);
        vector[axis++] = 1;
    } while (!orthonormalize(vectors, which, length));
}

void hatch_pca_directions(const double *covariance, uint32_t length, uint32_t count, double *directions, double *next)
{
    assert(count >= 1 && count <= length);
    for (uint32_t i = 0; i < count * length; i++)
        directions[i] = (double)hatch_random_unit(1, 0, i) - 0.5;
    for (uint32_t round = 0; round < ROUNDS; round++) {
        for (uint32_t d = 0; d < count; d++)
            for (uint32_t i = 0; i < length; i++)
                next[d * length + i] = dot(covariance + (size_t)i * length, directions + (size_t)d * length, length);
        memcpy(directions, next, (size_t)count * length * sizeof *next);
        for (uint32_t d = 0; d < count; d++)
            if (!orthonormalize(directions, d, length))
                replace(directions, d, length);
    }
}
