#include "fit/cubic.h"

#include <math.h>

#define MOMENTS 7u

/* Polynomials and weights are rounded to multiples of powers of two, so that doubles hold their sums exactly, in any
 * order: the bits of a polynomial, a weight, a whole coordinate and the number of fragments are at most SUM_BITS
 * together. Polynomials have GRID_BITS, and weights as many of the rest as there are of them; of large strokes weights
 * have no more than SHARE_BITS_LEAST, and polynomials what is left. */
#define SUM_BITS 53
#define GRID_BITS 19
#define SHARE_BITS 15 /* of the middle of a 16384th */
#define SHARE_BITS_LEAST 7
#define WEIGHTS 65536.0f

/* Roundings of a stroke. */
struct grid {
    float polynomials; /* inverse of what they are rounded to */
    int share_bits;    /* of weights, which are rounded to the middle of 2^(1 - share_bits) */
};

/* Sums over the fragments of a stroke. */
struct sums {
    double moments[MOMENTS]; /* of Legendre polynomials 0 to 6 */
    double places[2][HATCH_CUBIC_TERMS];
};

/* Computes the first Legendre polynomials at u. */
static void legendre(float u, uint32_t count, float *values)
{
    values[0] = 1;
    values[1] = u;
    for (uint32_t k = 2; k < count; k++)
        values[k] = ((float)(2 * k - 1) * u * values[k - 1] - (float)(k - 1) * values[k - 2]) / (float)k;
}

/* Finds the ranges of t and of places. Returns the greatest coordinate from the origin. */
static float find_range(const struct hatch_fragment *fragments, size_t count, struct hatch_cubic *cubic)
{
    double weight = 0;
    float far[2] = {0, 0};
    *cubic = (struct hatch_cubic){.t = {fragments->t, fragments->t}, .origin = {fragments->x, fragments->y}};
    for (size_t i = 0; i < count; i++) {
        const struct hatch_fragment *f = &fragments[i];
        cubic->t[0] = fminf(cubic->t[0], f->t);
        cubic->t[1] = fmaxf(cubic->t[1], f->t);
        cubic->origin[0] = fminf(cubic->origin[0], f->x);
        cubic->origin[1] = fminf(cubic->origin[1], f->y);
        far[0] = fmaxf(far[0], f->x);
        far[1] = fmaxf(far[1], f->y);
        weight += (double)rintf(f->weight * WEIGHTS);
    }
    cubic->weight = (float)(weight / (double)WEIGHTS);
    return fmaxf(far[0] - cubic->origin[0], far[1] - cubic->origin[1]);
}

/* Returns how much a fragment counts: what its stroke covers of the pixel, rounded. */
static double share_of(const struct hatch_fragment *fragment, int bits)
{
    const uint32_t weight = (uint32_t)rintf(fragment->weight * 65535);
    return ldexp((double)(2 * (weight >> (17 - bits)) + 1), -bits);
}

/* Returns the number of bits of numbers below a limit. */
static int bits_below(double limit)
{
    int bits = 0;
    while (ldexp(1, bits) < limit)
        bits++;
    return bits;
}

/* Returns the roundings of a stroke.
 *   extent_px  greatest whole coordinate from the origin */
static struct grid grid_of(size_t count, float extent_px)
{
    const int rest = SUM_BITS - bits_below((double)count) - bits_below((double)extent_px + 1);
    const int spare = rest - GRID_BITS;
    const int share_bits = spare > SHARE_BITS ? SHARE_BITS : spare < SHARE_BITS_LEAST ? SHARE_BITS_LEAST : spare;
    return (struct grid){ldexpf(1, rest - share_bits < GRID_BITS ? rest - share_bits : GRID_BITS), share_bits};
}

static void add(const struct hatch_cubic *cubic, const struct hatch_fragment *fragment, struct grid grid,
                struct sums *sums)
{
    const double share = share_of(fragment, grid.share_bits);
    const float from[2] = {fragment->x - cubic->origin[0], fragment->y - cubic->origin[1]};
    float values[MOMENTS];
    legendre(hatch_cubic_u(cubic, fragment->t), MOMENTS, values);
    for (uint32_t k = 0; k < MOMENTS; k++) {
        double value = share * (double)(rintf(values[k] * grid.polynomials) / grid.polynomials);
        sums->moments[k] += value;
        for (int axis = 0; axis < 2 && k < HATCH_CUBIC_TERMS; axis++)
            sums->places[axis][k] += value * (double)from[axis];
    }
}

/* Computes the sums of products of two of the first four polynomials from the moments, by Adams's formula. */
static void products(const double m[MOMENTS], double product[HATCH_CUBIC_TERMS][HATCH_CUBIC_TERMS])
{
    for (uint32_t k = 0; k < HATCH_CUBIC_TERMS; k++)
        product[k][0] = m[k];
    product[1][1] = (2 * m[2] + m[0]) / 3;
    product[2][1] = (3 * m[3] + 2 * m[1]) / 5;
    product[3][1] = (4 * m[4] + 3 * m[2]) / 7;
    product[2][2] = 18 * m[4] / 35 + 2 * m[2] / 7 + m[0] / 5;
    product[3][2] = 10 * m[5] / 21 + 4 * m[3] / 15 + 9 * m[1] / 35;
    product[3][3] = 100 * m[6] / 231 + 18 * m[4] / 77 + 4 * m[2] / 21 + m[0] / 7;
}

/* Computes the penalties on the factors, from the length of the line through the fragments and their mean weight. The
 * one on the line itself only keeps the solution finite where all fragments have one parameter. */
static void find_penalties(double product[HATCH_CUBIC_TERMS][HATCH_CUBIC_TERMS], const struct sums *sums, size_t count,
                           double penalty[HATCH_CUBIC_TERMS])
{
    double share = product[1][0] / product[0][0], half[2];
    penalty[0] = 0;
    penalty[1] = HATCH_CUBIC_LINE_PENALTY;
    for (int axis = 0; axis < 2; axis++)
        half[axis] = (sums->places[axis][1] - share * sums->places[axis][0]) /
                     (product[1][1] - share * product[1][0] + penalty[1]);
    double square = 4 * (half[0] * half[0] + half[1] * half[1]);
    penalty[2] = HATCH_CUBIC_PENALTY * product[0][0] / (double)count /
                 (1 + square / (HATCH_CUBIC_SHORT_PX * HATCH_CUBIC_SHORT_PX));
    penalty[3] = penalty[2];
}

/* Factors a symmetric matrix, whose lower half is given, as L D L^T. */
static void factorize(double a[HATCH_CUBIC_TERMS][HATCH_CUBIC_TERMS], double pivots[HATCH_CUBIC_TERMS])
{
    for (uint32_t i = 0; i < HATCH_CUBIC_TERMS; i++) {
        for (uint32_t j = 0; j < i; j++) {
            for (uint32_t k = 0; k < j; k++)
                a[i][j] -= a[i][k] * pivots[k] * a[j][k];
            a[i][j] /= pivots[j];
            a[i][i] -= a[i][j] * a[i][j] * pivots[j];
        }
        pivots[i] = a[i][i];
    }
}

/* Solves the system several times; each time the penalties are on the distance from the last solution. Factors that
 * the fragments determine converge to those of least squares, and the others stay small. */
static void solve(const struct sums *sums, size_t count, struct hatch_cubic *cubic)
{
    double a[HATCH_CUBIC_TERMS][HATCH_CUBIC_TERMS], penalty[HATCH_CUBIC_TERMS], pivots[HATCH_CUBIC_TERMS];
    products(sums->moments, a);
    find_penalties(a, sums, count, penalty);
    for (uint32_t k = 0; k < HATCH_CUBIC_TERMS; k++)
        a[k][k] += penalty[k];
    factorize(a, pivots);
    for (int axis = 0; axis < 2; axis++) {
        double x[HATCH_CUBIC_TERMS] = {0};
        for (uint32_t pass = 0; pass < HATCH_CUBIC_PASSES; pass++) {
            for (uint32_t i = 0; i < HATCH_CUBIC_TERMS; i++) {
                x[i] = sums->places[axis][i] + penalty[i] * x[i];
                for (uint32_t j = 0; j < i; j++)
                    x[i] -= a[i][j] * x[j];
            }
            for (uint32_t i = HATCH_CUBIC_TERMS; i-- > 0;) {
                x[i] /= pivots[i];
                for (uint32_t j = i + 1; j < HATCH_CUBIC_TERMS; j++)
                    x[i] -= a[j][i] * x[j];
            }
        }
        for (uint32_t k = 0; k < HATCH_CUBIC_TERMS; k++)
            cubic->factor[axis][k] = (float)x[k];
    }
}

void hatch_cubic_fit(const struct hatch_fragment *fragments, size_t count, struct hatch_cubic *cubic)
{
    struct sums sums = {.moments = {0}};
    const struct grid grid = grid_of(count, find_range(fragments, count, cubic));
    for (size_t i = 0; i < count; i++)
        add(cubic, &fragments[i], grid, &sums);
    solve(&sums, count, cubic);
}

float hatch_cubic_u(const struct hatch_cubic *cubic, float t)
{
    float half = 0.5f * (cubic->t[1] - cubic->t[0]);
    return half > 0 ? (t - cubic->t[0]) / half - 1 : 0;
}

void hatch_cubic_at(const struct hatch_cubic *cubic, float u, float place[2])
{
    float values[HATCH_CUBIC_TERMS], inside = fmaxf(-1, fminf(u, 1));
    legendre(inside, HATCH_CUBIC_TERMS, values);
    const float slopes[HATCH_CUBIC_TERMS] = {0, 1, 3 * inside, 7.5f * inside * inside - 1.5f};
    for (int axis = 0; axis < 2; axis++) {
        place[axis] = cubic->origin[axis];
        for (uint32_t k = 0; k < HATCH_CUBIC_TERMS; k++)
            place[axis] += cubic->factor[axis][k] * (values[k] + (u - inside) * slopes[k]);
    }
}
