/* Compares ways to fit a cubic to the pixels of a stroke (Szécsi et al., "Tonal Art Maps with Image Space Strokes",
 * §2.2):
 *     inversion  equation (1) in powers of t, sums in floats as blending makes them, inverted in floats as GLSL does
 *     cholesky   the same system by Cholesky factors, in floats
 *     cg         the same system by conjugate gradients in floats, from zero; the paper takes 4 iterations
 *     legendre   cg in Legendre polynomials over the part in sight
 *     dropping   Cholesky factors in Legendre polynomials, without those that the lower ones nearly explain
 *     libhatch   hatch_cubic_fit
 *     reference  the pseudo-inverse in doubles (fit/reference.h)
 * Strokes are 100 to 400 pixels long and 1 to 6 wide, in a picture of 1920x1200.
 *     bench_fit error  errors by the number of different parameters, by the share of the stroke in sight, and by that
 *                      at each end of strokes whose middle is hidden
 *     bench_fit time   time per stroke, and errors */
#include <stdio.h>
#include <stdlib.h>
#include <time.h>

#include "fit/reference.h"
#include "fit/strokes.h"
#include "math/percentile.h"

enum { STROKES = 1000, ITERATIONS = 8, STEPS = 64, RUNS = 9, TIMED = 200, TERMS = HATCH_CUBIC_TERMS };

/* Share of a polynomial's sum of squares below which it is dropped. */
#define LEAST 1e-3f

enum method { INVERSION, CHOLESKY, CG, LEGENDRE, DROPPING, LIBHATCH, REFERENCE };

static const char *const names[] = {"inversion", "cholesky", "cg", "legendre", "dropping", "libhatch", "reference"};

/* A way to fit a curve, and the result. */
struct fitted {
    enum method method;
    uint32_t iterations; /* of CG and LEGENDRE */
    double t[2];
    float factor[2][TERMS];
    struct hatch_cubic cubic;
    struct fit_reference reference;
};

/* Sums in floats. */
struct system {
    float a[TERMS][TERMS], b[2][TERMS];
};

static float in_sight(const double t[2], double at)
{
    return t[1] > t[0] ? (float)(2 * (at - t[0]) / (t[1] - t[0]) - 1) : 0;
}

/* Computes the basis of a method, up to degree 6 for the sums. */
static void basis(const struct fitted *fitted, double t, uint32_t count, float *values)
{
    bool legendre = fitted->method == LEGENDRE || fitted->method == DROPPING;
    float at = legendre ? in_sight(fitted->t, t) : (float)t;
    values[0] = 1;
    values[1] = at;
    for (uint32_t k = 2; k < count; k++)
        values[k] = legendre ? ((float)(2 * k - 1) * at * values[k - 1] - (float)(k - 1) * values[k - 2]) / (float)k
                             : values[k - 1] * at;
}

static void gather(const struct hatch_fragment *fragments, size_t count, struct fitted *fitted, struct system *system)
{
    *system = (struct system){.a = {{0}}};
    fitted->t[0] = fitted->t[1] = (double)fragments[0].t;
    for (size_t i = 1; i < count; i++) {
        fitted->t[0] = fmin(fitted->t[0], (double)fragments[i].t);
        fitted->t[1] = fmax(fitted->t[1], (double)fragments[i].t);
    }
    for (size_t i = 0; i < count; i++) {
        float values[TERMS];
        basis(fitted, (double)fragments[i].t, TERMS, values);
        for (uint32_t k = 0; k < TERMS; k++) {
            for (uint32_t j = 0; j <= k; j++)
                system->a[k][j] += values[k] * values[j];
            system->b[0][k] += values[k] * fragments[i].x;
            system->b[1][k] += values[k] * fragments[i].y;
        }
    }
    for (uint32_t k = 0; k < TERMS; k++)
        for (uint32_t j = k + 1; j < TERMS; j++)
            system->a[k][j] = system->a[j][k];
}

/* Returns the determinant of the matrix without a row and a column, with its sign. */
static float cofactor(const struct system *system, uint32_t row, uint32_t column)
{
    const float *r[3] = {NULL};
    uint32_t c[3] = {0}, rows = 0, columns = 0;
    for (uint32_t k = 0; k < TERMS; k++) {
        if (k != row)
            r[rows++] = system->a[k];
        if (k != column)
            c[columns++] = k;
    }
    float whole = r[0][c[0]] * (r[1][c[1]] * r[2][c[2]] - r[1][c[2]] * r[2][c[1]]) -
                  r[0][c[1]] * (r[1][c[0]] * r[2][c[2]] - r[1][c[2]] * r[2][c[0]]) +
                  r[0][c[2]] * (r[1][c[0]] * r[2][c[1]] - r[1][c[1]] * r[2][c[0]]);
    return (row + column) % 2 ? -whole : whole;
}

static void invert(const struct system *system, struct fitted *fitted)
{
    float cofactors[TERMS][TERMS], whole = 0;
    for (uint32_t i = 0; i < TERMS; i++)
        for (uint32_t j = 0; j < TERMS; j++)
            cofactors[i][j] = cofactor(system, i, j);
    for (uint32_t k = 0; k < TERMS; k++)
        whole += system->a[0][k] * cofactors[0][k];
    for (int axis = 0; axis < 2; axis++)
        for (uint32_t i = 0; i < TERMS; i++) {
            fitted->factor[axis][i] = 0;
            for (uint32_t k = 0; k < TERMS; k++)
                fitted->factor[axis][i] += cofactors[i][k] / whole * system->b[axis][k];
        }
}

static void factorize(struct system *system, struct fitted *fitted)
{
    float(*a)[TERMS] = system->a;
    uint32_t n = 0;
    for (; n < TERMS; n++) {
        float whole = a[n][n];
        for (uint32_t j = 0; j <= n; j++) {
            for (uint32_t k = 0; k < j; k++)
                a[n][j] -= a[n][k] * a[j][k];
            if (j < n)
                a[n][j] /= a[j][j];
        }
        if (fitted->method == DROPPING && !(a[n][n] > LEAST * whole))
            break;
        a[n][n] = sqrtf(a[n][n]);
    }
    for (int axis = 0; axis < 2; axis++) {
        float *x = fitted->factor[axis];
        for (uint32_t i = 0; i < n; i++) {
            x[i] = system->b[axis][i];
            for (uint32_t j = 0; j < i; j++)
                x[i] -= a[i][j] * x[j];
            x[i] /= a[i][i];
        }
        for (uint32_t i = n; i-- > 0;) {
            for (uint32_t j = i + 1; j < n; j++)
                x[i] -= a[j][i] * x[j];
            x[i] /= a[i][i];
        }
    }
}

static float dot(const float a[TERMS], const float b[TERMS])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2] + a[3] * b[3];
}

/* Nocedal & Wright, algorithm 5.2. */
static void descend(const struct system *system, struct fitted *fitted)
{
    for (int axis = 0; axis < 2; axis++) {
        float *x = fitted->factor[axis], rest[TERMS], along[TERMS], turned[TERMS];
        for (uint32_t k = 0; k < TERMS; k++) {
            x[k] = 0;
            rest[k] = along[k] = system->b[axis][k];
        }
        float square = dot(rest, rest);
        for (uint32_t i = 0; i < fitted->iterations && square > 0; i++) {
            for (uint32_t k = 0; k < TERMS; k++)
                turned[k] = dot(system->a[k], along);
            float step = square / dot(along, turned), before = square;
            for (uint32_t k = 0; k < TERMS; k++) {
                x[k] += step * along[k];
                rest[k] -= step * turned[k];
            }
            square = dot(rest, rest);
            for (uint32_t k = 0; k < TERMS; k++)
                along[k] = rest[k] + square / before * along[k];
        }
    }
}

static void fit(const struct hatch_fragment *fragments, size_t count, struct fitted *fitted)
{
    struct system system;
    if (fitted->method == LIBHATCH) {
        hatch_cubic_fit(fragments, count, &fitted->cubic);
        return;
    }
    if (fitted->method == REFERENCE) {
        fit_reference_find(fragments, count, &fitted->reference);
        return;
    }
    gather(fragments, count, fitted, &system);
    if (fitted->method == INVERSION)
        invert(&system, fitted);
    else if (fitted->method == CHOLESKY || fitted->method == DROPPING)
        factorize(&system, fitted);
    else
        descend(&system, fitted);
}

static void place_at(const struct fitted *fitted, double t, double place[2])
{
    if (fitted->method == LIBHATCH) {
        fit_curve_at(&fitted->cubic, t, place);
        return;
    }
    if (fitted->method == REFERENCE) {
        fit_reference_at(&fitted->reference, t, place);
        return;
    }
    float values[TERMS];
    basis(fitted, t, TERMS, values);
    for (int axis = 0; axis < 2; axis++) {
        place[axis] = 0;
        for (uint32_t k = 0; k < TERMS; k++)
            place[axis] += (double)fitted->factor[axis][k] * (double)values[k];
    }
}

/* Errors of the strokes of a row, in pixels; NaN counts as FAILED. */
struct errors {
    size_t count;
    struct hatch_weighted apart[STROKES]; /* largest distance from the reference at the fragments */
    struct hatch_weighted out[STROKES];   /* largest distance of the curve from the box of the fragments */
    struct hatch_weighted off[STROKES];   /* largest distance from the true middle, over the part in sight */
};

#define FAILED 1e6

static void note(struct hatch_weighted *error, double by)
{
    *error = (struct hatch_weighted){by < FAILED ? by : FAILED, 1};
}

static void measure(const struct fit_stroke *stroke, const struct fitted *fitted, const struct fitted *reference,
                    struct errors *errors)
{
    double apart = 0, out = 0, off = 0, least[2] = {1e9, 1e9}, most[2] = {-1e9, -1e9}, here[2], there[2], at[3][2];
    for (size_t i = 0; i < stroke->count; i++) {
        const struct hatch_fragment *f = &stroke->fragments[i];
        const double place[2] = {(double)f->x, (double)f->y};
        place_at(fitted, (double)f->t, here);
        place_at(reference, (double)f->t, there);
        apart = fmax(apart, hypot(here[0] - there[0], here[1] - there[1]));
        for (int axis = 0; axis < 2; axis++) {
            least[axis] = fmin(least[axis], place[axis]);
            most[axis] = fmax(most[axis], place[axis]);
        }
    }
    for (int i = 0; i <= STEPS; i++) {
        double t = reference->reference.t[0] + (reference->reference.t[1] - reference->reference.t[0]) * i / STEPS;
        place_at(fitted, t, here);
        fit_bezier_at(&stroke->middle, t, at);
        off = fmax(off, hypot(here[0] - at[0][0], here[1] - at[0][1]));
        for (int axis = 0; axis < 2; axis++)
            out = fmax(out, fmax(least[axis] - here[axis], here[axis] - most[axis]));
        if (!isfinite(here[0] + here[1]))
            apart = out = off = FAILED;
    }
    note(&errors->apart[errors->count], apart);
    note(&errors->out[errors->count], out);
    note(&errors->off[errors->count++], off);
}

/* Parts in sight of the strokes of a row, and how they are known. */
struct work {
    const char *sweep;
    double parameters; /* different ones of the fragments, or 0: as many as the pixels have */
    double seen;       /* share in sight, in one piece; or at each end */
    bool ends;
};

static void draw(const struct work *work, uint64_t index, struct fit_stroke *stroke)
{
    struct fit_way way = fit_draw_way(FIT_WHOLE, index, 0.8);
    double begin = (1 - work->seen) * fit_between(index, 6, 0, 0, 1);
    float by[2] = {floorf((float)fit_between(index, 6, 1, 0, 1500)), floorf((float)fit_between(index, 6, 2, 0, 780))};
    way.length_px = fit_between(index, 6, 3, 100, 400);
    way.hidden[0][0] = work->ends ? work->seen : -1;
    way.hidden[0][1] = work->ends ? 1 - work->seen : begin;
    way.hidden[1][0] = work->ends ? 2 : begin + work->seen;
    way.hidden[1][1] = 2;
    fit_fragments(&way, stroke);
    for (size_t i = 0; i < stroke->count; i++) {
        struct hatch_fragment *f = &stroke->fragments[i];
        f->weight = 1; /* as in the paper: what is compared are the ways to solve */
        f->x += by[0];
        f->y += by[1];
        if (work->parameters > 0)
            f->t =
                (float)((fmin(floor((double)f->t * work->parameters), work->parameters - 1) + 0.5) / work->parameters);
    }
    for (int axis = 0; axis < 2; axis++)
        for (int k = 0; k < 4; k++)
            stroke->middle.corner[axis][k] += (double)by[axis];
}

/* All ways to fit. */
enum { WAYS = 2 * ITERATIONS + 5 };

static struct fitted way(uint32_t i)
{
    static const enum method single[] = {INVERSION, CHOLESKY, DROPPING, LIBHATCH, REFERENCE};
    if (i < 5)
        return (struct fitted){.method = single[i]};
    i -= 5;
    return (struct fitted){.method = i < ITERATIONS ? CG : LEGENDRE, .iterations = i % ITERATIONS + 1};
}

static void print_errors(struct errors *errors)
{
    static const double shares[] = {0.5, 0.99, 1};
    struct hatch_weighted *const sets[] = {errors->apart, errors->out, errors->off};
    for (int i = 0; i < 3; i++) {
        double found[3];
        hatch_percentiles(sets[i], errors->count, shares, 3, found);
        printf("\t%.4g\t%.4g\t%.4g", found[0], found[1], found[2]);
    }
    printf("\n");
}

static void find_errors(const struct work *work, struct errors errors[WAYS])
{
    static struct fit_stroke stroke;
    for (uint32_t i = 0; i < WAYS; i++)
        errors[i].count = 0;
    for (uint64_t index = 0; index < STROKES; index++) {
        draw(work, index, &stroke);
        if (stroke.count == 0)
            continue;
        struct fitted reference = {.method = REFERENCE};
        fit(stroke.fragments, stroke.count, &reference);
        for (uint32_t i = 0; i < WAYS; i++) {
            struct fitted fitted = way(i);
            fit(stroke.fragments, stroke.count, &fitted);
            measure(&stroke, &fitted, &reference, &errors[i]);
        }
    }
}

#define ERRORS "apart_p50\tapart_p99\tapart_most\tout_p50\tout_p99\tout_most\toff_p50\toff_p99\toff_most\n"

static struct errors errors[WAYS];

static void print_error_rows(const struct work *work)
{
    find_errors(work, errors);
    for (uint32_t i = 0; i < WAYS; i++) {
        struct fitted fitted = way(i);
        printf("%s\t%s\t%u\t%g\t%g\t%zu", work->sweep, names[fitted.method], fitted.iterations, work->parameters,
               work->seen, errors[i].count);
        print_errors(&errors[i]);
    }
}

static double now(void)
{
    struct timespec time;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
    return (double)time.tv_sec + 1e-9 * (double)time.tv_nsec;
}

/* Returns the seconds of processor time per stroke of one run.
 *   most  fragments of a stroke that count */
static double seconds(uint32_t i, const struct fit_stroke *strokes, size_t most, uint32_t times)
{
    double from = now();
    for (uint32_t time = 0; time < times; time++)
        for (size_t k = 0; k < TIMED; k++) {
            struct fitted fitted = way(i);
            fit(strokes[k].fragments, strokes[k].count < most ? strokes[k].count : most, &fitted);
        }
    return (now() - from) / (TIMED * times);
}

static void print_time_rows(void)
{
    static const double shares[] = {0, 0.5, 1};
    const struct work whole = {.seen = 1};
    static struct fit_stroke strokes[TIMED];
    size_t fragments = 0;
    printf("method\titerations\tfragments\tseconds\tseconds_min\tseconds_max\tseconds_of_4_fragments\t" ERRORS);
    for (size_t k = 0; k < TIMED; k++) {
        draw(&whole, k, &strokes[k]);
        fragments += strokes[k].count;
    }
    find_errors(&whole, errors);
    for (uint32_t i = 0; i < WAYS; i++) {
        struct fitted fitted = way(i);
        struct hatch_weighted total[RUNS], solved[RUNS];
        double found[3], solve[3];
        for (uint32_t run = 0; run < RUNS; run++) {
            total[run] = (struct hatch_weighted){seconds(i, strokes, FIT_MOST, 20), 1};
            solved[run] = (struct hatch_weighted){seconds(i, strokes, 4, 1000), 1};
        }
        hatch_percentiles(total, RUNS, shares, 3, found);
        hatch_percentiles(solved, RUNS, shares, 3, solve);
        printf("%s\t%u\t%zu\t%.4g\t%.4g\t%.4g\t%.4g", names[fitted.method], fitted.iterations, fragments / TIMED,
               found[1], found[0], found[2], solve[1]);
        print_errors(&errors[i]);
    }
}

int main(int argc, char **argv)
{
    static const double parameters[] = {1, 2, 3, 4, 5, 6, 8, 12, 16, 24, 32, 64, 128};
    const char *what = argc > 1 ? argv[1] : "error";
    if (strcmp(what, "time") == 0) {
        print_time_rows();
        return 0;
    }
    printf("sweep\tmethod\titerations\tparameters\tseen\tstrokes\t" ERRORS);
    for (size_t i = 0; i < sizeof parameters / sizeof *parameters; i++)
        print_error_rows(&(struct work){"parameters", parameters[i], 1, false});
    for (double seen = 1; seen > 0.01; seen *= 0.5)
        print_error_rows(&(struct work){"seen", 0, seen, false});
    for (double seen = 0.32; seen > 0.004; seen *= 0.5)
        print_error_rows(&(struct work){"ends", 0, seen, true});
    return 0;
}
