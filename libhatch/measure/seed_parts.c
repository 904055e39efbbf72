#include "measure/seed_parts.h"

#include <complex.h>
#include <stdlib.h>
#include <math.h>
#include <string.h>

/* Reads a seed point's coordinate as an integer of N bits, the highest first, one per byte. Deliberately simple:
 * it checks faster code. */
static void read_integer(const struct hatch_seed_set *set, uint32_t seed, uint32_t shift, uint8_t *bits)
{
    for (uint32_t k = 0; k < set->count; k++)
        bits[k] = set->crumbs[(seed + k) % set->count] >> shift & 1u;
}

/* Doubles modulo 2^count - 1: a carry out of the highest bit is added at the lowest. */
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

enum hatch_status hatch_measure_astray(const struct hatch_seed_set *set, struct hatch_arena *scratch, uint32_t *astray,
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

/* e^(-2 pi i k x) for k = 0 .. steps - 1. */
static void fill_waves(double x, uint32_t steps, double complex *waves)
{
    for (uint32_t k = 0; k < steps; k++) {
        double angle = fmod((double)k * x, 1.0) * 6.283185307179586;
        waves[k] = cos(angle) - sin(angle) * I;
    }
}

struct waves {
    uint32_t count, steps;
    double complex *u, *v; /* steps per seed point */
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

enum hatch_status hatch_measure_spectrum(const struct hatch_seed_point *places, uint32_t count,
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
        power[ring] = frequencies[ring] ? power[ring] / frequencies[ring] : 0;
    hatch_arena_rewind(scratch, mark);
    return HATCH_OK;
}
