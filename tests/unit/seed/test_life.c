/* Lifetimes of strokes: the recursion over nesting levels, and the distribution of weights in weighted sets. */
#include "arenas.h"

#include <math.h>

#include "seed/life.h"
#include "seed/seeds_make.h"
#include "seed/spread.h"

static struct hatch_seeds seeds;
static struct hatch_seed_point *points;
static uint8_t *life;

static void make(uint32_t count, enum hatch_fade_law law)
{
    const struct hatch_seeds_options how = {.cycle = {.count = count, .seed = 3}, .layers = 1, .candidates = 10};
    uint64_t steps;
    HATCH_TEST_OK(hatch_seeds_make(&how, &keep, &scratch, &seeds, &steps, &err), &err);
    points = HATCH_NEW(&keep, struct hatch_seed_point, count, &err);
    life = HATCH_NEW(&keep, uint8_t, 4 * (size_t)count, &err);
    hatch_seed_points(seeds.layers, points);
    HATCH_TEST_OK(hatch_life_make(seeds.layers, points, law, &scratch, life, &err), &err);
}

/* A stroke that stays is that of seed point i - 1 of the next level, at the same position. */
START_TEST(strokes_that_stay_are_in_the_next_level)
{
    static const uint32_t counts[] = {2, 7, 64, 100};
    uint32_t count = counts[_i];
    make(count, HATCH_FADE_EVEN);
    for (uint32_t i = 0; i < count; i++) {
        uint32_t stays = 0, above = (i + count - 1) % count;
        for (uint32_t tile = 0; tile < 4; tile++) {
            if (life[4 * i + tile] != HATCH_LIFE_STAYS)
                continue;
            stays++;
            uint64_t u = (points[i].u >> 1) + ((uint64_t)(tile & 1) << 63);
            uint64_t v = (points[i].v >> 1) + ((uint64_t)(tile >> 1) << 63);
            ck_assert_uint_le(points[above].u - u, 1);
            ck_assert_uint_le(points[above].v - v, 1);
        }
        ck_assert_uint_eq(stays, 1);
    }
}
END_TEST

/* The depth above the level at which a stroke in one of four by four tiles vanishes, at most 2. */
static double death(uint32_t seed, uint32_t tile_u, uint32_t tile_v)
{
    uint32_t count = seeds.layers[0].count, above = (seed + count - 1) % count;
    uint8_t now = life[4 * seed + 2 * (tile_v & 1) + (tile_u & 1)];
    uint8_t next = life[4 * above + 2 * (tile_v >> 1) + (tile_u >> 1)];
    if (now != HATCH_LIFE_STAYS)
        return hatch_life_value(now);
    return next != HATCH_LIFE_STAYS ? 1 + hatch_life_value(next) : 2;
}

/* The share of the strokes present at m that stay for more than x. */
static double share_beyond(double m, double x)
{
    uint32_t alive = 0, beyond = 0;
    for (uint32_t i = 0; i < 16 * seeds.layers[0].count; i++) {
        double depth = death(i / 16, i % 4, i / 4 % 4);
        alive += depth > m;
        beyond += depth > m + x;
    }
    return (double)beyond / alive;
}

/* It is 4^-x, up to the resolution of a byte and of 64 seed points. */
START_TEST(lifetimes_have_no_memory)
{
    make(64, HATCH_FADE_WEIGHTED);
    for (int m = 0; m <= 10; m++)
        for (int x = 0; x <= 9; x++)
            ck_assert_double_eq_tol(share_beyond(m / 10.0, x / 10.0), pow(4, -x / 10.0), 0.01);
}
END_TEST

/* Histograms of the weights at four depths. */
START_TEST(weights_have_one_distribution_at_every_depth)
{
    double shares[4][12] = {{0}}, overlap = _i / 4.0;
    make(64, HATCH_FADE_WEIGHTED);
    for (int k = 0; k < 4; k++) {
        struct hatch_fade fade = hatch_fade_at(HATCH_FADE_WEIGHTED, k / 4.0, overlap);
        uint32_t alive = 0;
        for (uint32_t i = 0; i < 16 * 64; i++) {
            double weight = hatch_fade_weight(&fade, death(i / 16, i % 4, i / 4 % 4), 0);
            alive += weight > 0;
            shares[k][weight > 0 ? (int)(weight * 10) : 11]++;
        }
        for (int bin = 0; bin < 11; bin++)
            shares[k][bin] /= alive;
        ck_assert_double_eq_tol(1 - shares[k][10], 1 - pow(4, -overlap), 0.012); /* fading */
    }
    for (int k = 1; k < 4; k++)
        for (int bin = 0; bin < 11; bin++)
            ck_assert_msg(fabs(shares[k][bin] - shares[0][bin]) < 0.025, "overlap %g, m %g, bin %d: %g, %g", overlap,
                          k / 4.0, bin, shares[k][bin], shares[0][bin]);
}
END_TEST

/* When half of the fading strokes are left, they are further apart than a random half. */
START_TEST(remaining_strokes_are_spread_well)
{
    enum { COUNT = 64 };
    make(COUNT, HATCH_FADE_EVEN);
    struct hatch_seed_point remaining[4 * COUNT];
    uint32_t count = 0;
    for (uint32_t i = 0; i < 4 * COUNT; i++)
        if (life[i] >= HATCH_LIFE_STAYS / 2)
            remaining[count++] = (struct hatch_seed_point){(points[i / 4].u >> 1) + ((uint64_t)(i & 1) << 63),
                                                           (points[i / 4].v >> 1) + ((uint64_t)(i >> 1 & 1) << 63)};
    double distance;
    HATCH_TEST_OK(hatch_spread_distance(remaining, count, &scratch, &distance, &err), &err);
    ck_assert_double_gt(distance / hatch_spread_bound(count), 0.3); /* random: under .1 */
}
END_TEST

static Suite *suite(void)
{
    Suite *suite = suite_create("seed life");
    TCase *tests = tcase_create("life");
    tcase_add_checked_fixture(tests, begin, end);
    tcase_add_loop_test(tests, strokes_that_stay_are_in_the_next_level, 0, 4);
    tcase_add_test(tests, lifetimes_have_no_memory);
    tcase_add_loop_test(tests, weights_have_one_distribution_at_every_depth, 0, 5);
    tcase_add_test(tests, remaining_strokes_are_spread_well);
    suite_add_tcase(suite, tests);
    return suite;
}

HATCH_TEST_MAIN(suite)
