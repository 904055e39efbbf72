/* How long strokes stay: the recursion, and the spread of weights that weighted sets promise. */
#include "arenas.h"

#include <math.h>

#include "seed/life.h"
#include "seed/spread.h"

static struct hatch_seeds seeds;
static struct hatch_seed_place *places;
static uint8_t *life;

static void make(uint32_t count, enum hatch_fade_law law)
{
    const struct hatch_seeds_options how = {.cycle = {.count = count, .seed = 3}, .layers = 1, .candidates = 10};
    uint64_t steps;
    HATCH_TEST_OK(hatch_seeds_make(&how, &keep, &scratch, &seeds, &steps, &err), &err);
    places = HATCH_NEW(&keep, struct hatch_seed_place, count, &err);
    life = HATCH_NEW(&keep, uint8_t, 4 * (size_t)count, &err);
    hatch_seed_places(seeds.layers, places);
    HATCH_TEST_OK(hatch_life_make(seeds.layers, places, law, &scratch, life, &err), &err);
}

/* A stroke that stays is seed i - 1 of the next level, at the same place. */
START_TEST(what_stays_has_a_place_in_the_next_level)
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
            uint64_t u = (places[i].u >> 1) + ((uint64_t)(tile & 1) << 63);
            uint64_t v = (places[i].v >> 1) + ((uint64_t)(tile >> 1) << 63);
            ck_assert_uint_le(places[above].u - u, 1);
            ck_assert_uint_le(places[above].v - v, 1);
        }
        ck_assert_uint_eq(stays, 1);
    }
}
END_TEST

/* Depth above the level at which a stroke of the four by four tiles dies; beyond 2 it is 2. */
static double death(uint32_t seed, uint32_t tile_u, uint32_t tile_v)
{
    uint32_t count = seeds.layers[0].count, above = (seed + count - 1) % count;
    uint8_t now = life[4 * seed + 2 * (tile_v & 1) + (tile_u & 1)];
    uint8_t next = life[4 * above + 2 * (tile_v >> 1) + (tile_u >> 1)];
    if (now != HATCH_LIFE_STAYS)
        return hatch_life_value(now);
    return next != HATCH_LIFE_STAYS ? 1 + hatch_life_value(next) : 2;
}

/* The share of those alive at m that live on for more than x. */
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

/* 4^-x, as far as a byte tells depths apart and 64 seeds fill the scale. */
START_TEST(lives_have_no_memory)
{
    make(64, HATCH_FADE_WEIGHTED);
    for (int m = 0; m <= 10; m++)
        for (int x = 0; x <= 9; x++)
            ck_assert_double_eq_tol(share_beyond(m / 10.0, x / 10.0), pow(4, -x / 10.0), 0.01);
}
END_TEST

/* Weights in tenths, those alive and whole or not, at four depths. */
START_TEST(weights_are_spread_alike_on_levels_and_between)
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
        ck_assert_double_eq_tol(1 - shares[k][10], 1 - pow(4, -overlap), 0.012); /* on their way */
    }
    for (int k = 1; k < 4; k++)
        for (int bin = 0; bin < 11; bin++)
            ck_assert_msg(fabs(shares[k][bin] - shares[0][bin]) < 0.025, "overlap %g, m %g, bin %d: %g, %g", overlap,
                          k / 4.0, bin, shares[k][bin], shares[0][bin]);
}
END_TEST

/* Half of those that go, the last, keep farther from all others than a half by chance would. */
START_TEST(what_is_left_keeps_apart)
{
    enum { COUNT = 64 };
    make(COUNT, HATCH_FADE_EVEN);
    struct hatch_seed_place left[4 * COUNT];
    uint32_t count = 0;
    for (uint32_t i = 0; i < 4 * COUNT; i++)
        if (life[i] >= HATCH_LIFE_STAYS / 2)
            left[count++] = (struct hatch_seed_place){(places[i / 4].u >> 1) + ((uint64_t)(i & 1) << 63),
                                                      (places[i / 4].v >> 1) + ((uint64_t)(i >> 1 & 1) << 63)};
    double distance;
    HATCH_TEST_OK(hatch_spread_distance(left, count, &scratch, &distance, &err), &err);
    ck_assert_double_gt(distance / hatch_spread_bound(count), 0.3); /* by chance: under .1 */
}
END_TEST

static Suite *suite(void)
{
    Suite *suite = suite_create("seed life");
    TCase *tests = tcase_create("life");
    tcase_add_checked_fixture(tests, begin, end);
    tcase_add_loop_test(tests, what_stays_has_a_place_in_the_next_level, 0, 4);
    tcase_add_test(tests, lives_have_no_memory);
    tcase_add_loop_test(tests, weights_are_spread_alike_on_levels_and_between, 0, 5);
    tcase_add_test(tests, what_is_left_keeps_apart);
    suite_add_tcase(suite, tests);
    return suite;
}

HATCH_TEST_MAIN(suite)
