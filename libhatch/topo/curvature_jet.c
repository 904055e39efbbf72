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

#define LANES 4u

/* Four partial sums, added in one order: the compiler may run them side by side. */
static double dot(const double *a, const double *b, uint32_t count)
{
    double sum[LANES] = {0, 0, 0, 0};
    for (uint32_t n = 0; n < count; n += LANES)
        for (uint32_t l = 0; l < LANES; l++)
            sum[l] += a[n + l] * b[n + l];
    return (sum[0] + sum[1]) + (sum[2] + sum[3]);
}

#define BLOCK 32u
#define POWERS (2 * HATCH_JET_DEGREE_MAX + 1)

/* Adds at most BLOCK points: powers first, then one dot product a moment. */
static void add_block(struct hatch_jet_sums *sums, uint32_t count, const double *x,
                      const double *y, const double *z)
{
    double px[POWERS][BLOCK], py[POWERS][BLOCK], heights[BLOCK], scaled[BLOCK];
    uint32_t padded = (count + LANES - 1) / LANES * LANES;
    for (uint32_t n = 0; n < padded; n++) {
        bool real = n < count;
        px[0][n] = py[0][n] = real ? 1 : 0;
        px[1][n] = real ? x[n] : 0;
        py[1][n] = real ? y[n] : 0;
        heights[n] = real ? z[n] : 0;
    }
    for (uint32_t i = 2; i < POWERS; i++)
        for (uint32_t n = 0; n < padded; n++) {
            px[i][n] = px[i - 1][n] * px[1][n];
            py[i][n] = py[i - 1][n] * py[1][n];
        }
    for (uint32_t i = 0; i < POWERS; i++)
        for (uint32_t k = 0; i + k < POWERS; k++)
            sums->moments[place(i, k)] += dot(px[i], py[k], padded);
    for (uint32_t i = 0; i <= HATCH_JET_DEGREE_MAX; i++) {
        for (uint32_t n = 0; n < padded; n++)
            scaled[n] = px[i][n] * heights[n];
        for (uint32_t k = 0; i + k <= HATCH_JET_DEGREE_MAX; k++)
            sums->products[place(i, k)] += dot(scaled, py[k], padded);
    }
    sums->squares += dot(heights, heights, padded);
    sums->count += count;
}

void hatch_jet_add(struct hatch_jet_sums *sums, uint32_t count, const double *x, const double *y,
                   const double *z)
{
    for (uint32_t n = 0; n < count; n += BLOCK)
        add_block(sums, count - n < BLOCK ? count - n : BLOCK, &x[n], &y[n], &z[n]);
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
