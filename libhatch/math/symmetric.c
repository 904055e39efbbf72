#include "math/symmetric.h"

#include <math.h>

#define SWEEPS_MAX 60

/* Makes entry p, q of the matrix zero by a rotation of both axes. */
static void rotate(size_t n, double *matrix, double *vectors, size_t p, size_t q)
{
    double apart = matrix[q * n + q] - matrix[p * n + p], twice = 2 * matrix[p * n + q];
    double tangent = twice / (fabs(apart) + hypot(apart, twice)) * (apart < 0 ? -1 : 1);
    double c = 1 / sqrt(1 + tangent * tangent), s = c * tangent;
    for (size_t k = 0; k < n; k++) {
        double a = matrix[k * n + p], b = matrix[k * n + q];
        matrix[k * n + p] = c * a - s * b;
        matrix[k * n + q] = s * a + c * b;
    }
    for (size_t k = 0; k < n; k++) {
        double a = matrix[p * n + k], b = matrix[q * n + k], u = vectors[p * n + k], v = vectors[q * n + k];
        matrix[p * n + k] = c * a - s * b;
        matrix[q * n + k] = s * a + c * b;
        vectors[p * n + k] = c * u - s * v;
        vectors[q * n + k] = s * u + c * v;
    }
}

/* Moves the largest eigenvalue to the front, then the next, and so on. */
static void sort(size_t n, double *vectors, double *values)
{
    for (size_t i = 0; i < n; i++) {
        size_t best = i;
        for (size_t k = i + 1; k < n; k++)
            best = values[k] > values[best] ? k : best;
        double value = values[i];
        values[i] = values[best];
        values[best] = value;
        for (size_t k = 0; k < n && best != i; k++) {
            double entry = vectors[i * n + k];
            vectors[i * n + k] = vectors[best * n + k];
            vectors[best * n + k] = entry;
        }
    }
}

void hatch_symmetric_eigen(size_t n, double *matrix, double *vectors, double *values)
{
    double all = 0;
    for (size_t i = 0; i < n * n; i++) {
        vectors[i] = i % (n + 1) == 0;
        all = fmax(all, fabs(matrix[i]));
    }
    double largest = all;
    for (int sweep = 0; sweep < SWEEPS_MAX && largest > 1e-15 * all; sweep++) {
        largest = 0;
        for (size_t p = 0; p < n; p++)
            for (size_t q = p + 1; q < n; q++) {
                largest = fmax(largest, fabs(matrix[p * n + q]));
                if (fabs(matrix[p * n + q]) > 1e-16 * all)
                    rotate(n, matrix, vectors, p, q);
            }
    }
    for (size_t i = 0; i < n; i++)
        values[i] = matrix[i * n + i];
    sort(n, vectors, values);
}
