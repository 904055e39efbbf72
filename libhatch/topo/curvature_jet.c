#include "topo/curvature_jet.h"

#include <math.h>

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
    lanes x[POWERS][BLOCK], y[POWERS][BLOCK], z[BLOCK];
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

static void fill_block(struct block *block, uint32_t count, const double *x, const double *y, const double *z)
{
    block->count = (count + LANES - 1) / LANES;
    for (uint32_t n = 0; n < LANES * block->count; n++) {
        bool real = n < count;
        block->x[0][n / LANES][n % LANES] = real ? 1 : 0;
        block->x[1][n / LANES][n % LANES] = real ? x[n] : 0;
        block->y[1][n / LANES][n % LANES] = real ? y[n] : 0;
        block->z[n / LANES][n % LANES] = real ? z[n] : 0;
    }
    for (uint32_t i = 2; i < POWERS; i++)
        for (uint32_t n = 0; n < block->count; n++) {
            block->x[i][n] = block->x[i - 1][n] * block->x[1][n];
            block->y[i][n] = block->y[i - 1][n] * block->y[1][n];
        }
}

static void add_block(struct hatch_jet_sums *sums, uint32_t count, const double *x, const double *y,
                      const double *z)
{
    struct block block;
    lanes square = {0}, scaled[HATCH_JET_DEGREE_MAX + 1][BLOCK];
    fill_block(&block, count, x, y, z);
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
        square += block.z[n] * block.z[n];
    sums->squares += square[0] + square[1];
    sums->count += count;
}

void hatch_jet_add(struct hatch_jet_sums *sums, uint32_t count, const double *x, const double *y,
                   const double *z)
{
    for (uint32_t n = 0; n < count; n += LANES * BLOCK)
        add_block(sums, count - n < LANES * BLOCK ? count - n : LANES * BLOCK, &x[n], &y[n], &z[n]);
}

/* powers[t]: i and k of term t. */
static const uint32_t powers[HATCH_JET_TERMS][2] = {{0, 0}, {1, 0}, {0, 1}, {2, 0}, {1, 1},
                                                    {0, 2}, {3, 0}, {2, 1}, {1, 2}, {0, 3},
                                                    {4, 0}, {3, 1}, {2, 2}, {1, 3}, {0, 4}};

static double entry(const struct hatch_jet_sums *sums, uint32_t row, uint32_t column)
{
    return sums->moments[place(powers[row][0] + powers[column][0], powers[row][1] + powers[column][1])];
}

void hatch_jet_factorise(const struct hatch_jet_sums *sums, uint32_t degree,
                         struct hatch_jet_system *system)
{
    uint32_t terms = hatch_jet_terms(degree), row = 0;
    while (terms > sums->count && degree > 0)
        terms = hatch_jet_terms(--degree);
    for (; row < terms; row++) {
        double *line = system->lower[row];
        for (uint32_t column = 0; column < row; column++) {
            double sum = entry(sums, row, column);
            for (uint32_t k = 0; k < column; k++)
                sum -= line[k] * system->lower[column][k];
            line[column] = sum * system->lower[column][column];
        }
        double whole = entry(sums, row, row), pivot = whole, right = sums->products[row];
        for (uint32_t k = 0; k < row; k++) {
            pivot -= line[k] * line[k];
            right -= line[k] * system->reduced[k];
        }
        if (!(pivot > PIVOT_MIN * whole))
            break;
        line[row] = 1 / sqrt(pivot);
        system->reduced[row] = right * line[row];
    }
    while (degree > 0 && hatch_jet_terms(degree) > row)
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

double hatch_jet_variance(const struct hatch_jet_system *system, uint32_t degree,
                          const double functional[HATCH_JET_TERMS])
{
    double solved[HATCH_JET_TERMS], sum = 0;
    uint32_t first = 0;
    while (first + 1 < hatch_jet_terms(degree) && functional[first] == 0)
        first++;
    for (uint32_t row = first; row < hatch_jet_terms(degree); row++) {
        double value = functional[row];
        for (uint32_t k = first; k < row; k++)
            value -= system->lower[row][k] * solved[k];
        solved[row] = value * system->lower[row][row];
        sum += solved[row] * solved[row];
    }
    return sum;
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

void hatch_jet_second(uint32_t degree, double a, double b, double c,
                      double functional[HATCH_JET_TERMS])
{
    for (uint32_t t = 0; t < hatch_jet_terms(degree); t++)
        functional[t] = 0;
    functional[3] = 2 * a;
    functional[4] = b;
    functional[5] = 2 * c;
}
