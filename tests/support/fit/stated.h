/* The problem that fit/cubic.h states, with its penalties, solved by another way, in doubles: singular values of the
 * weighted polynomials' matrix with a row for each penalty below, instead of sums of products, pivots and rounding.
 * Fragments count as much as they are covered, without rounding to 64ths. */
#ifndef HATCH_TEST_FIT_STATED_H
#define HATCH_TEST_FIT_STATED_H

#include "fit/reference.h"

struct fit_stated {
    double t[2], origin[2];
    double factor[2][HATCH_CUBIC_TERMS]; /* of Legendre polynomials of u, from the origin */
};

static inline void fit_stated_polynomials(const struct fit_stated *stated, double t, double *values)
{
    const double half = (stated->t[1] - stated->t[0]) / 2, u = half > 0 ? (t - stated->t[0]) / half - 1 : 0;
    values[0] = 1;
    values[1] = u;
    values[2] = 1.5 * u * u - 0.5;
    values[3] = (2.5 * u * u - 1.5) * u;
}

static inline void fit_stated_at(const struct fit_stated *stated, double t, double place[2])
{
    double values[HATCH_CUBIC_TERMS];
    fit_stated_polynomials(stated, t, values);
    for (int axis = 0; axis < 2; axis++) {
        place[axis] = stated->origin[axis];
        for (uint32_t k = 0; k < HATCH_CUBIC_TERMS; k++)
            place[axis] += stated->factor[axis][k] * values[k];
    }
}

/* Adds the rows of the fragments to a triangle, with the first `terms` polynomials. */
static inline void fit_stated_add(const struct fit_stated *stated, const struct hatch_fragment *fragments, size_t count,
                                  uint32_t terms, double triangle[HATCH_CUBIC_TERMS][HATCH_CUBIC_TERMS + 2])
{
    for (size_t i = 0; i < count; i++) {
        const double root = sqrt((double)fragments[i].weight);
        double row[HATCH_CUBIC_TERMS + 2];
        fit_stated_polynomials(stated, (double)fragments[i].t, row);
        for (uint32_t k = 0; k < HATCH_CUBIC_TERMS; k++)
            row[k] = k < terms ? root * row[k] : 0;
        row[HATCH_CUBIC_TERMS] = root * ((double)fragments[i].x - stated->origin[0]);
        row[HATCH_CUBIC_TERMS + 1] = root * ((double)fragments[i].y - stated->origin[1]);
        fit_reference_add(triangle, row);
    }
}

/* Solves the rows of a triangle with penalties on the distance from the last factors, which it replaces. */
static inline void fit_stated_pass(double rows[HATCH_CUBIC_TERMS][HATCH_CUBIC_TERMS + 2], const double *penalty,
                                   struct fit_stated *stated)
{
    double triangle[HATCH_CUBIC_TERMS][HATCH_CUBIC_TERMS + 2];
    struct fit_reference found = {.t = {0, 0}};
    for (uint32_t i = 0; i < HATCH_CUBIC_TERMS; i++)
        for (uint32_t j = 0; j < HATCH_CUBIC_TERMS + 2; j++)
            triangle[i][j] = rows[i][j];
    for (uint32_t k = 0; k < HATCH_CUBIC_TERMS; k++) {
        double row[HATCH_CUBIC_TERMS + 2] = {0};
        row[k] = sqrt(penalty[k]);
        for (int axis = 0; axis < 2; axis++)
            row[(int)HATCH_CUBIC_TERMS + axis] = row[k] * stated->factor[axis][k];
        fit_reference_add(triangle, row);
    }
    fit_reference_solve(triangle, FIT_REFERENCE_SHARE, &found);
    for (int axis = 0; axis < 2; axis++)
        for (uint32_t k = 0; k < HATCH_CUBIC_TERMS; k++)
            stated->factor[axis][k] = found.factor[axis][k];
}

static inline void fit_stated_find(const struct hatch_fragment *fragments, size_t count, struct fit_stated *stated)
{
    double line[HATCH_CUBIC_TERMS][HATCH_CUBIC_TERMS + 2] = {{0}},
                                                       all[HATCH_CUBIC_TERMS][HATCH_CUBIC_TERMS + 2] = {{0}};
    double penalty[HATCH_CUBIC_TERMS] = {0, HATCH_CUBIC_LINE_PENALTY, 0, 0}, weight = 0;
    *stated = (struct fit_stated){.t = {1, 0}, .origin = {(double)fragments->x, (double)fragments->y}};
    for (size_t i = 0; i < count; i++) {
        stated->t[0] = fmin(stated->t[0], (double)fragments[i].t);
        stated->t[1] = fmax(stated->t[1], (double)fragments[i].t);
        weight += (double)fragments[i].weight;
    }
    fit_stated_add(stated, fragments, count, 2, line);
    fit_stated_pass(line, penalty, stated);
    const double length = 2 * hypot(stated->factor[0][1], stated->factor[1][1]) / HATCH_CUBIC_SHORT_PX;
    penalty[2] = penalty[3] = HATCH_CUBIC_PENALTY * weight / (double)count / (1 + length * length);
    for (int axis = 0; axis < 2; axis++)
        for (uint32_t k = 0; k < HATCH_CUBIC_TERMS; k++)
            stated->factor[axis][k] = 0;
    fit_stated_add(stated, fragments, count, HATCH_CUBIC_TERMS, all);
    for (uint32_t pass = 0; pass < HATCH_CUBIC_PASSES; pass++)
        fit_stated_pass(all, penalty, stated);
}

/* Finds the solution without penalties, from the singular values of the same matrix that are over a share of the
 * largest: the pseudo-inverse of its numerical rank. Returns the rank. */
static inline int fit_stated_ranked(const struct hatch_fragment *fragments, size_t count, double share,
                                    struct fit_stated *stated)
{
    double triangle[HATCH_CUBIC_TERMS][HATCH_CUBIC_TERMS + 2] = {{0}};
    struct fit_reference found = {.t = {0, 0}};
    *stated = (struct fit_stated){.t = {1, 0}, .origin = {(double)fragments->x, (double)fragments->y}};
    for (size_t i = 0; i < count; i++) {
        stated->t[0] = fmin(stated->t[0], (double)fragments[i].t);
        stated->t[1] = fmax(stated->t[1], (double)fragments[i].t);
    }
    fit_stated_add(stated, fragments, count, HATCH_CUBIC_TERMS, triangle);
    fit_reference_solve(triangle, share, &found);
    for (int axis = 0; axis < 2; axis++)
        for (uint32_t k = 0; k < HATCH_CUBIC_TERMS; k++)
            stated->factor[axis][k] = found.factor[axis][k];
    return found.rank;
}

#endif
