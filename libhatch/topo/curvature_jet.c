#include "topo/curvature_jet.h"

#include <math.h>
#include <stddef.h>

/* A pivot this small beside its diagonal entry: the points lie on a curve of the degree. */
#define PIVOT_MIN 1e-9

uint32_t hatch_jet_terms(uint32_t degree)
{
    return (degree + 1) * (degree + 2) / 2;
}

/* The place of x^i y^k. */
static uint32_t place(uint32_t i, uint32_t k)
{
    return (i + k) * (i + k + 1) / 2 + k;
}

/* Sums are taken in two lanes, side by side, and added at the end: the same on every processor. */
#define LANES 2u
typedef double lanes __attribute__((vector_size(LANES * sizeof(double))));

#define BLOCK 16u /* of lanes */
#define POWERS (2 * HATCH_JET_DEGREE_MAX + 1)

struct block {
    lanes x[POWERS][BLOCK], y[POWERS][BLOCK], z[BLOCK]; /* x: times the weight */
    uint32_t count; /* of lanes */
};

/* sums[k] = Σ a y^k for k = 0 .. most: with `most` known where this is inlined, all sums stay in registers. */
static inline __attribute__((always_inline)) void sum_row(const struct block *block, const lanes *a, uint32_t i,
                                                          uint32_t most, double *sums)
{
    lanes sum[POWERS] = {{0}};
    for (uint32_t n = 0; n < block->count; n++) {
        sum[0] += a[n];
        for (uint32_t k = 1; k <= most; k++)
            sum[k] += a[n] * block->y[k][n];
    }
    for (uint32_t k = 0; k <= most; k++)
        sums[place(i, k)] += sum[k][0] + sum[k][1];
}

static void fill_block(struct block *block, uint32_t count, const double *x, const double *y, const double *z,
                       const double *weight)
{
    lanes plain[BLOCK];
    block->count = (count + LANES - 1) / LANES;
    for (uint32_t n = 0; n < LANES * block->count; n++) {
        bool real = n < count;
        block->x[0][n / LANES][n % LANES] = real ? weight ? weight[n] : 1 : 0;
        plain[n / LANES][n % LANES] = real ? x[n] : 0;
        block->y[1][n / LANES][n % LANES] = real ? y[n] : 0;
        block->z[n / LANES][n % LANES] = real ? z[n] : 0;
    }
    for (uint32_t n = 0; n < block->count; n++) {
        block->x[1][n] = block->x[0][n] * plain[n];
        for (uint32_t i = 2; i < POWERS; i++) {
            block->x[i][n] = block->x[i - 1][n] * plain[n];
            block->y[i][n] = block->y[i - 1][n] * block->y[1][n];
        }
    }
}

static void add_block(struct hatch_jet_sums *sums, uint32_t count, const double *x, const double *y,
                      const double *z, const double *weight)
{
    struct block block;
    lanes square = {0}, scaled[HATCH_JET_DEGREE_MAX + 1][BLOCK];
    fill_block(&block, count, x, y, z, weight);
    sum_row(&block, block.x[0], 0, 8, sums->moments);
    sum_row(&block, block.x[1], 1, 7, sums->moments);
    sum_row(&block, block.x[2], 2, 6, sums->moments);
    sum_row(&block, block.x[3], 3, 5, sums->moments);
    sum_row(&block, block.x[4], 4, 4, sums->moments);
    sum_row(&block, block.x[5], 5, 3, sums->moments);
    sum_row(&block, block.x[6], 6, 2, sums->moments);
    sum_row(&block, block.x[7], 7, 1, sums->moments);
    sum_row(&block, block.x[8], 8, 0, sums->moments);
    for (uint32_t i = 0; i <= HATCH_JET_DEGREE_MAX; i++)
        for (uint32_t n = 0; n < block.count; n++)
            scaled[i][n] = block.x[i][n] * block.z[n];
    sum_row(&block, scaled[0], 0, 4, sums->products);
    sum_row(&block, scaled[1], 1, 3, sums->products);
    sum_row(&block, scaled[2], 2, 2, sums->products);
    sum_row(&block, scaled[3], 3, 1, sums->products);
    sum_row(&block, scaled[4], 4, 0, sums->products);
    for (uint32_t n = 0; n < block.count; n++)
        square += scaled[0][n] * block.z[n];
    sums->squares += square[0] + square[1];
    sums->count += count;
}

void hatch_jet_add(struct hatch_jet_sums *sums, uint32_t count, const double *x, const double *y,
                   const double *z, const double *weight)
{
    for (uint32_t n = 0; n < count; n += LANES * BLOCK)
        add_block(sums, count - n < LANES * BLOCK ? count - n : LANES * BLOCK, &x[n], &y[n], &z[n],
                  weight ? &weight[n] : NULL);
}

/* The degree of term t, and its power of y. */
static const uint32_t degree_of[HATCH_JET_TERMS] = {0, 1, 1, 2, 2, 2, 3, 3, 3, 3, 4, 4, 4, 4, 4};
static const uint32_t power_of[HATCH_JET_TERMS] = {0, 0, 1, 0, 1, 2, 0, 1, 2, 3, 0, 1, 2, 3, 4};

static void fill_normal(const struct hatch_jet_sums *sums, uint32_t terms, struct hatch_jet_system *system)
{
    for (uint32_t row = 0; row < terms; row++) {
        for (uint32_t column = 0; column <= row; column++) {
            uint32_t k = power_of[row] + power_of[column];
            system->lower[row][column] = sums->moments[place(degree_of[row] + degree_of[column] - k, k)];
        }
        system->reduced[row] = sums->products[row];
    }
}

/* Column after column, each taken from all that lies right of it: nothing waits for a sum. */
void hatch_jet_factorise(const struct hatch_jet_sums *sums, uint32_t degree,
                         struct hatch_jet_system *system)
{
    uint32_t terms = hatch_jet_terms(degree), done = 0;
    double column[HATCH_JET_TERMS], whole[HATCH_JET_TERMS];
    while (terms > sums->count && degree > 0)
        terms = hatch_jet_terms(--degree);
    fill_normal(sums, terms, system);
    for (uint32_t row = 0; row < terms; row++)
        whole[row] = system->lower[row][row];
    for (; done < terms; done++) {
        double pivot = system->lower[done][done];
        if (!(pivot > PIVOT_MIN * whole[done]))
            break;
        pivot = system->lower[done][done] = 1 / sqrt(pivot);
        double right = system->reduced[done] *= pivot;
        for (uint32_t row = done + 1; row < terms; row++) {
            double factor = column[row] = system->lower[row][done] *= pivot, *line = system->lower[row];
            for (uint32_t k = done + 1; k <= row; k++)
                line[k] -= factor * column[k];
            system->reduced[row] -= factor * right;
        }
    }
    while (degree > 0 && hatch_jet_terms(degree) > done)
        degree--;
    system->degree = degree < 2 ? 0 : degree;
    system->count = sums->count;
    system->squares = sums->squares;
}

void hatch_jet_solve(const struct hatch_jet_system *system, uint32_t degree,
                     double coefficients[HATCH_JET_TERMS])
{
    for (uint32_t row = hatch_jet_terms(degree); row-- > 0;) {
        double sum = system->reduced[row];
        for (uint32_t k = row + 1; k < hatch_jet_terms(degree); k++)
            sum -= system->lower[k][row] * coefficients[k];
        coefficients[row] = sum * system->lower[row][row];
    }
}

double hatch_jet_residual(const struct hatch_jet_system *system, uint32_t degree)
{
    double sum = system->squares;
    for (uint32_t row = 0; row < hatch_jet_terms(degree); row++)
        sum -= system->reduced[row] * system->reduced[row];
    return sum > 0 ? sum : 0;
}

/* Three substitutions side by side; each degree's sums are the first ones of the next one's. */
void hatch_jet_variances(const struct hatch_jet_system *system,
                         struct hatch_jet_variance variance[HATCH_JET_DEGREE_MAX + 1])
{
    double skew[HATCH_JET_TERMS] = {[3] = 1, [5] = -1}, mixed[HATCH_JET_TERMS] = {[4] = 1};
    double mean[HATCH_JET_TERMS] = {[3] = 1, [5] = 1};
    struct hatch_jet_variance sum = {0, 0, 0};
    for (uint32_t degree = 2, row = 3; degree <= system->degree; degree++) {
        for (; row < hatch_jet_terms(degree); row++) {
            double a = skew[row], b = mixed[row], c = mean[row], pivot = system->lower[row][row];
            for (uint32_t k = 3; k < row; k++) {
                double factor = system->lower[row][k];
                a -= factor * skew[k];
                b -= factor * mixed[k];
                c -= factor * mean[k];
            }
            skew[row] = a * pivot;
            mixed[row] = b * pivot;
            mean[row] = c * pivot;
            sum.skew += skew[row] * skew[row];
            sum.mixed += mixed[row] * mixed[row];
            sum.mean += mean[row] * mean[row];
        }
        variance[degree] = sum;
    }
}

void hatch_jet_at(const double coefficients[HATCH_JET_TERMS], uint32_t degree, double x, double y,
                  struct hatch_jet_point *point)
{
    const double *c = coefficients;
    double xx = x * x, xy = x * y, yy = y * y;
    *point = (struct hatch_jet_point){.fx = c[1] + 2 * c[3] * x + c[4] * y,
                                      .fy = c[2] + c[4] * x + 2 * c[5] * y,
                                      .fxx = 2 * c[3],
                                      .fxy = c[4],
                                      .fyy = 2 * c[5]};
    if (degree >= 3) {
        point->fx += 3 * c[6] * xx + 2 * c[7] * xy + c[8] * yy;
        point->fy += c[7] * xx + 2 * c[8] * xy + 3 * c[9] * yy;
        point->fxx += 6 * c[6] * x + 2 * c[7] * y;
        point->fxy += 2 * c[7] * x + 2 * c[8] * y;
        point->fyy += 2 * c[8] * x + 6 * c[9] * y;
    }
    if (degree >= 4) {
        point->fx += x * (4 * c[10] * xx + 3 * c[11] * xy + 2 * c[12] * yy) + c[13] * y * yy;
        point->fy += c[11] * x * xx + y * (2 * c[12] * xx + 3 * c[13] * xy + 4 * c[14] * yy);
        point->fxx += 12 * c[10] * xx + 6 * c[11] * xy + 2 * c[12] * yy;
        point->fxy += 3 * c[11] * xx + 4 * c[12] * xy + 3 * c[13] * yy;
        point->fyy += 2 * c[12] * xx + 6 * c[13] * xy + 12 * c[14] * yy;
    }
}
