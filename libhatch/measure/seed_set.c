#include "measure/seed_figures.h"

#include <math.h>
#include <string.h>
#include <complex.h>
#include <stdlib.h>

#include "base/random.h"

/* Reads a seed point's coordinate as an integer of N bits, the highest first, one per byte. Deliberately simple:
 * it checks faster code. */
static void read_integer(const struct hatch_seed_set *set, uint32_t seed, uint32_t shift, uint8_t *bits)
{
    for (uint32_t k = 0; k < set->count; k++)
        bits[k] = (uint8_t)((uint32_t)set->crumbs[(seed + k) % set->count] >> shift & 1u);
}

/* Doubles an integer modulo 2^count - 1: a carry out of the highest bit is added at the lowest. */
static void zoom(uint8_t *bits, uint32_t count)
{
    uint32_t carry = 0;
    for (uint32_t k = count; k-- > 0;) {
        uint32_t sum = 2u * bits[k] + carry;
        bits[k] = sum & 1u;
        carry = sum >> 1;
    }
    for (uint32_t k = count; carry && k-- > 0;) {
        uint32_t sum = bits[k] + carry;
        bits[k] = sum & 1u;
        carry = sum >> 1;
    }
}

/* Counts coordinates that zooming by two does not map to the next seed point, in exact integers: with
 * s = b / (2^N - 1), 2 b mod (2^N - 1) must be the next b, for u and for v. */
static enum hatch_status count_astray(const struct hatch_seed_set *set, struct hatch_arena *scratch, uint32_t *astray,
                                      struct hatch_err *err)
{
    struct hatch_arena_mark mark = hatch_arena_mark(scratch);
    uint8_t *zoomed = HATCH_NEW(scratch, uint8_t, set->count, err);
    uint8_t *next = zoomed ? HATCH_NEW(scratch, uint8_t, set->count, err) : NULL;
    if (!next) {
        hatch_arena_rewind(scratch, mark);
        return HATCH_LIMIT;
    }
    uint32_t found = 0;
    for (uint32_t shift = 0; shift < 2; shift++) {
        read_integer(set, 0, shift, zoomed);
        for (uint32_t seed = 0; seed < set->count; seed++) {
            zoom(zoomed, set->count);
            read_integer(set, seed + 1, shift, next);
            found += memcmp(zoomed, next, set->count) != 0;
        }
    }
    hatch_arena_rewind(scratch, mark);
    *astray = found;
    return HATCH_OK;
}

/* Computes e^(-2 pi i k x) for k = 0 .. steps - 1. */
static void fill_waves(double x, uint32_t steps, double complex *waves)
{
    for (uint32_t k = 0; k < steps; k++) {
        double angle = fmod((double)k * x, 1.0) * 6.283185307179586;
        waves[k] = cos(angle) - sin(angle) * I;
    }
}

struct waves {
    uint32_t count, steps;
    double complex *u, *v; /* per seed point, `steps` numbers */
};

static double power_at(const struct waves *waves, uint32_t ku, int32_t kv)
{
    double complex sum = 0;
    for (size_t i = 0; i < waves->count; i++) {
        double complex v = waves->v[i * waves->steps + (size_t)abs(kv)];
        sum += waves->u[i * waves->steps + ku] * (kv < 0 ? conj(v) : v);
    }
    return (creal(sum) * creal(sum) + cimag(sum) * cimag(sum)) / waves->count;
}

/* Computes the mean of |sum of e^(-2 pi i k·s)|² / N over the integer frequencies k in each ring, which begins at
 * sqrt(N) / 8 below its radius and ends before sqrt(N) / 8 above it. */
static enum hatch_status measure_spectrum(const struct hatch_seed_point *places, uint32_t count,
                                          struct hatch_arena *scratch, double power[HATCH_SEED_RINGS],
                                          struct hatch_err *err)
{
    struct hatch_arena_mark mark = hatch_arena_mark(scratch);
    double unit = sqrt(count);
    struct waves waves = {.count = count, .steps = (uint32_t)(1.125 * unit) + 2};
    uint32_t frequencies[HATCH_SEED_RINGS] = {0};
    waves.u = HATCH_NEW(scratch, double complex, (size_t)count *waves.steps, err);
    waves.v = waves.u ? HATCH_NEW(scratch, double complex, (size_t)count *waves.steps, err) : NULL;
    if (!waves.v) {
        hatch_arena_rewind(scratch, mark);
        return HATCH_LIMIT;
    }
    for (size_t i = 0; i < count; i++) {
        fill_waves((double)places[i].u * 0x1p-64, waves.steps, waves.u + i * waves.steps);
        fill_waves((double)places[i].v * 0x1p-64, waves.steps, waves.v + i * waves.steps);
    }
    memset(power, 0, sizeof *power * HATCH_SEED_RINGS);
    for (uint32_t ku = 0; ku < waves.steps; ku++)
        for (int32_t kv = 1 - (int32_t)waves.steps; kv < (int32_t)waves.steps; kv++) {
            double radius = hypot(ku, kv) / unit * 4;
            int ring = (int)floor(radius + 0.5) - 1;
            if ((ku == 0 && kv <= 0) || ring < 0 || ring >= (int)HATCH_SEED_RINGS)
                continue;
            power[ring] += power_at(&waves, ku, kv);
            frequencies[ring]++;
        }
    for (uint32_t ring = 0; ring < HATCH_SEED_RINGS; ring++)
        power[ring] = frequencies[ring] ? power[ring] / frequencies[ring] : NAN;
    hatch_arena_rewind(scratch, mark);
    return HATCH_OK;
}

static double to_unit(uint64_t bits)
{
    return (double)bits * 0x1p-64;
}

static enum hatch_status count_uneven(const struct hatch_seed_set *set, struct hatch_arena *scratch, uint32_t *uneven,
                                      struct hatch_err *err)
{
    uint32_t count = set->count, found = 0;
    for (uint32_t length = 1; (uint64_t)1 << 2 * (length - 1) <= count; length++) {
        struct hatch_arena_mark mark = hatch_arena_mark(scratch);
        uint32_t patterns = (uint32_t)1 << 2 * length, least = count / patterns, pattern = 0;
        uint32_t *occurrences;
        HATCH_TRY(HATCH_ALLOC(scratch, &occurrences, patterns, err));
        for (uint32_t i = 0; i < count + length - 1; i++) {
            pattern = (4 * pattern + set->crumbs[i % count]) % patterns;
            if (i >= length - 1)
                occurrences[pattern]++;
        }
        for (uint32_t p = 0; p < patterns; p++)
            found += occurrences[p] != least && !(count % patterns && occurrences[p] == least + 1);
        hatch_arena_rewind(scratch, mark);
    }
    *uneven = found;
    return HATCH_OK;
}

static enum hatch_status ratio_of(const struct hatch_seed_point *places, uint32_t count, double bound,
                                  struct hatch_arena *scratch, double *ratio, struct hatch_err *err)
{
    HATCH_TRY(hatch_spread_distance(places, count, scratch, ratio, err));
    *ratio /= bound;
    return HATCH_OK;
}

/* Computes the first points of the recursive Bayer order (Bayer, ICC 1973): the base-4 digits of i, lowest first,
 * select ever smaller quarters in which point i lies: 0, 1, 2 and 3 stand for (u, v) = 00, 11, 10 and 01. */
static void bayer_places(struct hatch_seed_point *places, uint32_t count)
{
    static const uint64_t u_of[4] = {0, 1, 1, 0}, v_of[4] = {0, 1, 0, 1};
    for (uint32_t i = 0; i < count; i++) {
        places[i] = (struct hatch_seed_point){0, 0};
        for (uint32_t digit = 0; digit < 16; digit++) {
            places[i].u |= u_of[i >> 2 * digit & 3] << (63 - digit);
            places[i].v |= v_of[i >> 2 * digit & 3] << (63 - digit);
        }
    }
}

/* Computes the seed points of a tile of the next level, which spans four tiles. In each of these, those seed points
 * remain whose last crumb is the tile's number, 2 v + u. Returns their number. */
static uint32_t sparse_places(const struct hatch_seed_set *set, const struct hatch_seed_point *dense,
                              struct hatch_seed_point *sparse)
{
    uint32_t remaining = 0;
    for (uint64_t tile = 0; tile < 4; tile++)
        for (uint32_t i = 0; i < set->count; i++) {
            uint8_t last = set->crumbs[(i + set->count - 1) % set->count];
            if (last != tile)
                continue;
            sparse[remaining].u = dense[i].u >> 1 | (tile & 1) << 63;
            sparse[remaining++].v = dense[i].v >> 1 | (tile >> 1) << 63;
        }
    return remaining;
}

static enum hatch_status measure_distances(const struct hatch_seed_set *set, uint32_t throws,
                                           const struct hatch_seed_point *places, struct hatch_seed_point *others,
                                           struct hatch_arena *scratch, struct hatch_seed_figures *f,
                                           struct hatch_err *err)
{
    uint32_t count = set->count;
    double bound = hatch_spread_bound(count), ratio;
    HATCH_TRY(ratio_of(places, count, bound, scratch, &f->distance, err));
    HATCH_TRY(ratio_of(others, sparse_places(set, places, others), bound, scratch, &f->distance_sparse, err));
    bayer_places(others, count);
    HATCH_TRY(ratio_of(others, count, bound, scratch, &f->distance_bayer, err));
    f->distance_random = 0;
    for (uint32_t throw = 0; throw < throws; throw ++) {
        for (uint32_t i = 0; i < count; i++) {
            others[i].u = hatch_random_u64(0, throw, 2 * (uint64_t)i);
            others[i].v = hatch_random_u64(0, throw, 2 * (uint64_t)i + 1);
        }
        HATCH_TRY(ratio_of(others, count, bound, scratch, &ratio, err));
        f->distance_random += ratio / throws;
    }
    return HATCH_OK;
}

static double correlate(const struct hatch_seed_point *places, uint32_t count)
{
    double u = 0, v = 0, uu = 0, vv = 0, uv = 0;
    bool differ[2] = {false, false};
    for (uint32_t i = 0; i < count; i++) {
        u += to_unit(places[i].u) / count;
        v += to_unit(places[i].v) / count;
        differ[0] |= places[i].u != places[0].u;
        differ[1] |= places[i].v != places[0].v;
    }
    for (uint32_t i = 0; i < count; i++) {
        double du = to_unit(places[i].u) - u, dv = to_unit(places[i].v) - v;
        uu += du * du;
        vv += dv * dv;
        uv += du * dv;
    }
    return differ[0] && differ[1] ? uv / sqrt(uu * vv) : NAN;
}

static enum hatch_status measure(const struct hatch_seed_set *set, uint32_t throws, struct hatch_arena *scratch,
                                 struct hatch_seed_figures *f, struct hatch_err *err)
{
    uint32_t count = set->count;
    struct hatch_seed_point *places, *others;
    HATCH_TRY(HATCH_ALLOC(scratch, &places, count, err));
    HATCH_TRY(HATCH_ALLOC(scratch, &others, count, err));
    hatch_seed_points(set, places);
    HATCH_TRY(count_uneven(set, scratch, &f->uneven, err));
    HATCH_TRY(measure_distances(set, throws, places, others, scratch, f, err));
    f->correlation = correlate(places, count);
    f->complete = count <= HATCH_SEED_FIGURES_MAX;
    if (!f->complete)
        return HATCH_OK;
    HATCH_TRY(count_astray(set, scratch, &f->astray, err));
    HATCH_TRY(hatch_spread_discrepancy(places, count, scratch, &f->discrepancy, err));
    return measure_spectrum(places, count, scratch, f->power, err);
}

enum hatch_status hatch_measure_seeds(const struct hatch_seed_set *set, uint32_t throws, struct hatch_arena *scratch,
                                      struct hatch_seed_figures *figures, struct hatch_err *err)
{
    struct hatch_arena_mark mark = hatch_arena_mark(scratch);
    struct hatch_seed_figures found = {.seeds = set->count};
    enum hatch_status status = measure(set, throws, scratch, &found, err);
    hatch_arena_rewind(scratch, mark);
    if (status == HATCH_OK)
        *figures = found;
    return status;
}
