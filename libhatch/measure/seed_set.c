#include "measure/seed_figures.h"

#include <math.h>
#include <string.h>

#include "base/random.h"
#include "measure/seed_parts.h"

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

/* The first points of the recursive Bayer order (Bayer, ICC 1973): the base-4 digits of i, lowest first, select
 * the quarters 00, 11, 10 or 01 in which point i lies. */
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

/* Seed points of a tile of the next level, which spans four tiles: of each tile, those remain whose last bits
 * equal the tile's parities. Returns their number. */
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
    for (uint32_t i = 0; i < count; i++) {
        u += to_unit(places[i].u) / count;
        v += to_unit(places[i].v) / count;
    }
    for (uint32_t i = 0; i < count; i++) {
        double du = to_unit(places[i].u) - u, dv = to_unit(places[i].v) - v;
        uu += du * du;
        vv += dv * dv;
        uv += du * dv;
    }
    return uu * vv > 0 ? uv / sqrt(uu * vv) : 0.0;
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
    HATCH_TRY(hatch_measure_astray(set, scratch, &f->astray, err));
    HATCH_TRY(hatch_spread_discrepancy(places, count, scratch, &f->discrepancy, err));
    return hatch_measure_spectrum(places, count, scratch, f->power, err);
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
