#include "curvature/jet.h"

#include <math.h>
#include <stddef.h>
#include <string.h>

/* Smallest pivot, as a share of its diagonal entry: below it the points lie on an algebraic curve of the degree. */
#define PIVOT_MIN 1e-9

uint32_t hatch_jet_terms(uint32_t degree)
{
    return (degree + 1) * (degree + 2) / 2;
}

/* Returns the index of x^i y^k. */
static uint32_t term_index(uint32_t i, uint32_t k)
{
    return (i + k) * (i + k + 1) / 2 + k;
}

/* Sums run in two lanes that are added at the end: the same on every processor. */
#define LANES 2u
typedef double lanes __attribute__((vector_size(LANES * sizeof(double))));

#define BLOCK 16u /* of lanes */
#define POWERS (2 * HATCH_JET_DEGREE_MAX + 1)

struct block {
    lanes x[POWERS][BLOCK], y[POWERS][BLOCK], z[BLOCK]; /* x[i] = w x^i, y[k] = y^k (y[0] is unused) */
    uint32_t count;                                     /* of lanes */
};

/* Adds Σ a y^k to the sum of x^i y^k for k = 0 .. k_max. Inlined with a constant k_max, it keeps all sums in
 * registers. */
static inline __attribute__((always_inline)) void sum_row(const struct block *block, const lanes *a, uint32_t i,
                                                          uint32_t k_max, double *sums)
{
    lanes sum[POWERS] = {{0}};
    for (uint32_t n = 0; n < block->count; n++) {
        sum[0] += a[n];
        for (uint32_t k = 1; k <= k_max; k++)
            sum[k] += a[n] * block->y[k][n];
    }
    for (uint32_t k = 0; k <= k_max; k++)
        sums[term_index(i, k)] += sum[k][0] + sum[k][1];
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

static void add_block(struct hatch_jet_sums *sums, uint32_t count, const double *x, const double *y, const double *z,
                      const double *weight)
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

void hatch_jet_add(struct hatch_jet_sums *sums, uint32_t count, const double *x, const double *y, const double *z,
                   const double *weight)
{
    for (uint32_t n = 0; n < count; n += LANES * BLOCK)
        add_block(sums, count - n < LANES * BLOCK ? count - n : LANES * BLOCK, &x[n], &y[n], &z[n],
                  weight ? &weight[n] : NULL);
}

/* Per term x^i y^k: i + k, and k. */
static const uint32_t degree_of[HATCH_JET_TERMS] = {0, 1, 1, 2, 2, 2, 3, 3, 3, 3, 4, 4, 4, 4, 4};
static const uint32_t power_of[HATCH_JET_TERMS] = {0, 0, 1, 0, 1, 2, 0, 1, 2, 3, 0, 1, 2, 3, 4};

/* The matrix of the normal equations, in lanes. */
struct normal {
    lanes line[HATCH_JET_TERMS][(HATCH_JET_TERMS + 1) / LANES]; /* lower triangle; the entry after it is undefined */
    double diagonal[HATCH_JET_TERMS];                           /* before factorisation */
};

static double *entry_of(struct normal *normal, uint32_t row, uint32_t column)
{
    return (double *)normal->line[row] + column;
}

static void fill_normal(const struct hatch_jet_sums *sums, uint32_t terms, struct normal *normal)
{
    for (uint32_t row = 0; row < terms; row++) {
        normal->line[row][row / LANES] = (lanes){0};
        for (uint32_t column = 0; column <= row; column++) {
            uint32_t degree = degree_of[row] + degree_of[column];
            *entry_of(normal, row, column) =
                sums->moments[degree * (degree + 1) / 2 + power_of[row] + power_of[column]];
        }
        normal->diagonal[row] = *entry_of(normal, row, row);
    }
}

/* Subtracts the outer product of a finished column from the columns right of it: independent operations in place of
 * sums, which have latency.
 *   column  in lanes; 0 up to row `done` */
static void subtract_column(struct normal *normal, uint32_t terms, uint32_t done, const lanes *column)
{
    for (uint32_t row = done + 1; row < terms; row++) {
        double factor = *entry_of(normal, row, done);
        for (uint32_t k = (done + 1) / LANES; k <= row / LANES; k++)
            normal->line[row][k] -= factor * column[k];
    }
}

void hatch_jet_factorise(const struct hatch_jet_sums *sums, uint32_t degree, struct hatch_jet_system *system)
{
    uint32_t terms = hatch_jet_terms(degree), done = 0;
    struct normal normal;
    lanes column[(HATCH_JET_TERMS + 1) / LANES] = {{0}};
    while (terms > sums->count && degree > 0)
        terms = hatch_jet_terms(--degree);
    fill_normal(sums, terms, &normal);
    memcpy(system->reduced, sums->products, terms * sizeof *system->reduced);
    for (; done < terms; done++) {
        double pivot = *entry_of(&normal, done, done);
        if (!(pivot > PIVOT_MIN * normal.diagonal[done]))
            break;
        pivot = system->lower[done][done] = 1 / sqrt(pivot);
        system->reduced[done] *= pivot;
        column[done / LANES][done % LANES] = 0;
        for (uint32_t row = done + 1; row < terms; row++) {
            double factor = *entry_of(&normal, row, done) *= pivot;
            column[row / LANES][row % LANES] = system->lower[row][done] = factor;
            system->reduced[row] -= factor * system->reduced[done];
        }
        subtract_column(&normal, terms, done, column);
    }
    while (degree > 0 && hatch_jet_terms(degree) > done)
        degree--;
    system->degree = degree < 2 ? 0 : degree;
    system->count = sums->count;
    system->squares = sums->squares;
}

void hatch_jet_solve(const struct hatch_jet_system *system, uint32_t degree, double coefficients[HATCH_JET_TERMS])
{
    uint32_t terms = hatch_jet_terms(degree);
    memcpy(coefficients, system->reduced, terms * sizeof *coefficients);
    for (uint32_t row = terms; row-- > 0;) {
        double value = coefficients[row] *= system->lower[row][row];
        for (uint32_t k = 0; k < row; k++)
            coefficients[k] -= system->lower[row][k] * value;
    }
}

double hatch_jet_residual(const struct hatch_jet_system *system, uint32_t degree)
{
    double sum = system->squares;
    for (uint32_t row = 0; row < hatch_jet_terms(degree); row++)
        sum -= system->reduced[row] * system->reduced[row];
    return sum > 0 ? sum : 0;
}

/* Three forward substitutions at once; the sums of a degree continue those of the degree below. */
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
