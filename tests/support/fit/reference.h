/* The curve that fit/cubic.h should find, by another way: the pseudo-inverse of the matrix of powers (1, v, v^2, v^3),
 * whose rows are scaled by the square roots of weights, in doubles. v runs from 0 to 1 over the fragments' range of t.
 * Rows are turned into a triangle by Givens rotations, and the triangle's columns made orthogonal by Jacobi rotations
 * (Hestenes 1958). */
#ifndef HATCH_TEST_FIT_REFERENCE_H
#define HATCH_TEST_FIT_REFERENCE_H

#include <math.h>

#include "fit/cubic.h"

#define FIT_REFERENCE_SHARE 1e-12 /* singular values below this share of the largest are noise of doubles */

struct fit_reference {
    double t[2];
    double factor[2][HATCH_CUBIC_TERMS]; /* of the powers of v */
    double values[HATCH_CUBIC_TERMS];    /* singular values */
    int rank;
};

static inline void fit_reference_powers(const struct fit_reference *reference, double t, double *powers)
{
    double range = reference->t[1] - reference->t[0], v = range > 0 ? (t - reference->t[0]) / range : 0;
    powers[0] = 1;
    for (uint32_t k = 1; k < HATCH_CUBIC_TERMS; k++)
        powers[k] = powers[k - 1] * v;
}

static inline void fit_reference_at(const struct fit_reference *reference, double t, double place[2])
{
    double powers[HATCH_CUBIC_TERMS];
    fit_reference_powers(reference, t, powers);
    for (int axis = 0; axis < 2; axis++) {
        place[axis] = 0;
        for (uint32_t k = 0; k < HATCH_CUBIC_TERMS; k++)
            place[axis] += reference->factor[axis][k] * powers[k];
    }
}

/* Returns the least singular value. */
static inline double fit_reference_least(const struct fit_reference *reference)
{
    double least = reference->values[0];
    for (uint32_t k = 1; k < HATCH_CUBIC_TERMS; k++)
        least = fmin(least, reference->values[k]);
    return least;
}

/* Adds a row to a triangle with two right sides. */
static inline void fit_reference_add(double triangle[HATCH_CUBIC_TERMS][HATCH_CUBIC_TERMS + 2], double *row)
{
    for (uint32_t k = 0; k < HATCH_CUBIC_TERMS; k++) {
        double length = hypot(triangle[k][k], row[k]);
        if (!(length > 0))
            continue;
        double c = triangle[k][k] / length, s = row[k] / length;
        for (uint32_t j = k; j < HATCH_CUBIC_TERMS + 2; j++) {
            double above = triangle[k][j];
            triangle[k][j] = c * above + s * row[j];
            row[j] = c * row[j] - s * above;
        }
    }
}

/* Turns columns i and j of a matrix and of the product of all turns, so that they are orthogonal. */
static inline void fit_reference_turn(double matrix[HATCH_CUBIC_TERMS][HATCH_CUBIC_TERMS],
                                      double turns[HATCH_CUBIC_TERMS][HATCH_CUBIC_TERMS], uint32_t i, uint32_t j)
{
    double a = 0, b = 0, product = 0;
    for (uint32_t k = 0; k < HATCH_CUBIC_TERMS; k++) {
        a += matrix[k][i] * matrix[k][i];
        b += matrix[k][j] * matrix[k][j];
        product += matrix[k][i] * matrix[k][j];
    }
    double angle = 0.5 * atan2(2 * product, a - b), c = cos(angle), s = sin(angle);
    for (uint32_t k = 0; k < HATCH_CUBIC_TERMS; k++) {
        double *const rows[2] = {matrix[k], turns[k]};
        for (int m = 0; m < 2; m++) {
            double before = rows[m][i];
            rows[m][i] = c * before + s * rows[m][j];
            rows[m][j] = c * rows[m][j] - s * before;
        }
    }
}

/* Solves a triangle. Singular values of at most `share` of the largest count as 0. */
static inline void fit_reference_solve(double triangle[HATCH_CUBIC_TERMS][HATCH_CUBIC_TERMS + 2], double share,
                                       struct fit_reference *reference)
{
    enum { SWEEPS = 12 };
    double matrix[HATCH_CUBIC_TERMS][HATCH_CUBIC_TERMS], turns[HATCH_CUBIC_TERMS][HATCH_CUBIC_TERMS] = {{0}}, most = 0;
    for (uint32_t i = 0; i < HATCH_CUBIC_TERMS; i++)
        for (uint32_t j = 0; j < HATCH_CUBIC_TERMS; j++) {
            matrix[i][j] = j >= i ? triangle[i][j] : 0;
            turns[i][j] = i == j;
        }
    for (int sweep = 0; sweep < SWEEPS; sweep++)
        for (uint32_t i = 0; i < HATCH_CUBIC_TERMS; i++)
            for (uint32_t j = i + 1; j < HATCH_CUBIC_TERMS; j++)
                fit_reference_turn(matrix, turns, i, j);
    for (uint32_t k = 0; k < HATCH_CUBIC_TERMS; k++) {
        double square = 0;
        for (uint32_t i = 0; i < HATCH_CUBIC_TERMS; i++)
            square += matrix[i][k] * matrix[i][k];
        reference->values[k] = sqrt(square);
        most = fmax(most, reference->values[k]);
    }
    for (uint32_t k = 0; k < HATCH_CUBIC_TERMS; k++) {
        if (!(reference->values[k] > share * most))
            continue;
        reference->rank++;
        for (int axis = 0; axis < 2; axis++) {
            double part = 0;
            for (uint32_t i = 0; i < HATCH_CUBIC_TERMS; i++)
                part += matrix[i][k] * triangle[i][(int)HATCH_CUBIC_TERMS + axis];
            part /= reference->values[k] * reference->values[k];
            for (uint32_t i = 0; i < HATCH_CUBIC_TERMS; i++)
                reference->factor[axis][i] += part * turns[i][k];
        }
    }
}

static inline void fit_reference_find(const struct hatch_fragment *fragments, size_t count,
                                      struct fit_reference *reference)
{
    double triangle[HATCH_CUBIC_TERMS][HATCH_CUBIC_TERMS + 2] = {{0}};
    *reference = (struct fit_reference){.t = {1, 0}};
    for (size_t i = 0; i < count; i++) {
        reference->t[0] = fmin(reference->t[0], (double)fragments[i].t);
        reference->t[1] = fmax(reference->t[1], (double)fragments[i].t);
    }
    for (size_t i = 0; i < count; i++) {
        double row[HATCH_CUBIC_TERMS + 2];
        fit_reference_powers(reference, (double)fragments[i].t, row);
        row[HATCH_CUBIC_TERMS] = (double)fragments[i].x;
        row[HATCH_CUBIC_TERMS + 1] = (double)fragments[i].y;
        for (uint32_t k = 0; k < HATCH_CUBIC_TERMS + 2; k++)
            row[k] *= sqrt((double)fragments[i].weight);
        fit_reference_add(triangle, row);
    }
    fit_reference_solve(triangle, FIT_REFERENCE_SHARE, reference);
}

/* Returns how well fragments determine a cubic: the least singular value of the matrix of Legendre polynomials over the
 * range of t, whose rows are scaled by the square roots of weights. If the places of the fragments have independent
 * errors of a pixel (standard deviation), no factor has a larger one than the reciprocal. */
static inline double fit_reference_determined(const struct hatch_fragment *fragments, size_t count)
{
    double triangle[HATCH_CUBIC_TERMS][HATCH_CUBIC_TERMS + 2] = {{0}};
    struct fit_reference found = {.t = {1, 0}};
    for (size_t i = 0; i < count; i++) {
        found.t[0] = fmin(found.t[0], (double)fragments[i].t);
        found.t[1] = fmax(found.t[1], (double)fragments[i].t);
    }
    for (size_t i = 0; i < count; i++) {
        double range = found.t[1] - found.t[0], root = sqrt((double)fragments[i].weight);
        double u = range > 0 ? 2 * ((double)fragments[i].t - found.t[0]) / range - 1 : 0;
        double row[HATCH_CUBIC_TERMS + 2] = {root, root * u, root * (1.5 * u * u - 0.5),
                                             root * (2.5 * u * u - 1.5) * u};
        fit_reference_add(triangle, row);
    }
    fit_reference_solve(triangle, FIT_REFERENCE_SHARE, &found);
    return fit_reference_least(&found);
}

#endif
