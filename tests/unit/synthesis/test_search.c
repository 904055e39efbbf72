/* The search for matches, against all neighbourhoods one by one. */
#include <math.h>

#include "arenas.h"
#include "base/random.h"
#include "synthesis/search.h"

enum { SIDE = 3, SIZE = 5 };

static struct hatch_exemplar exemplar;
static struct hatch_features features;
static struct hatch_volume volume;
static float prices[HATCH_CELLS];

/* Makes an exemplar of noise in some steps of grey, and a solid of noise in the same.
 *   levels  1: all pixels are alike */
static void make(uint32_t levels, bool priced)
{
    struct hatch_image image;
    HATCH_TEST_OK(hatch_image_make(&keep, 14, 11, "Y", &image, &err), &err);
    for (uint32_t i = 0; i < 14 * 11; i++)
        image.pixels[i] = (float)(hatch_random_u64(1, 0, i) % levels) / 8;
    HATCH_TEST_OK(hatch_exemplar_make(&image, SIDE, &keep, &exemplar, &err), &err);
    HATCH_TEST_OK(hatch_features_make(&exemplar, false, NULL, &keep, &scratch, &features, &err), &err);
    volume = (struct hatch_volume){.size = SIZE, .channels = 1, .axes = 7};
    volume.texels = HATCH_NEW(&keep, uint8_t, hatch_volume_count(&volume), &err);
    for (int axis = 0; axis < HATCH_AXES; axis++)
        volume.matches[axis] = HATCH_NEW(&keep, uint16_t, hatch_volume_count(&volume), &err);
    hatch_volume_randomize(&volume, &exemplar, 3);
    for (uint32_t cell = 0; cell < HATCH_CELLS; cell++)
        prices[cell] = priced ? 0.5f + hatch_random_unit(4, 0, cell) : 1;
}

/* The texels around one, by their coordinates, which wrap around. */
static void values_around(uint32_t axis, uint32_t slice, uint32_t u, uint32_t v, int16_t *values)
{
    static const int columns[HATCH_AXES] = {1, 0, 0}, rows[HATCH_AXES] = {2, 2, 1};
    for (uint32_t j = 0; j < SIDE; j++)
        for (uint32_t i = 0; i < SIDE; i++) {
            uint32_t at[3];
            at[axis] = slice;
            at[columns[axis]] = (u + i + SIZE - SIDE / 2) % SIZE;
            at[rows[axis]] = (v + j + SIZE - SIDE / 2) % SIZE;
            values[j * SIDE + i] = (int16_t)(volume.texels[(at[2] * SIZE + at[1]) * SIZE + at[0]] - 128);
        }
}

/* Finds the cheapest neighbourhood; of equal ones the first. */
static uint16_t cheapest(const int16_t *values, bool exhaustive)
{
    float least = INFINITY;
    uint16_t best = 0;
    int16_t feature[HATCH_FEATURES];
    hatch_features_project(&features, values, feature);
    for (uint32_t y = 0; y < exemplar.down; y++)
        for (uint32_t x = 0; x < exemplar.across; x++) {
            uint32_t match = y * HATCH_EXEMPLAR_PITCH + x;
            const int16_t *other = features.vectors + (y * exemplar.across + x) * HATCH_FEATURES;
            float cost = prices[hatch_cell_of(match)] *
                         (float)(exhaustive ? hatch_exemplar_distance(&exemplar, values, match, UINT32_MAX)
                                            : hatch_features_distance(feature, other));
            if (cost < least) {
                least = cost;
                best = (uint16_t)match;
            }
        }
    return best;
}

START_TEST(the_match_is_the_first_of_the_cheapest)
{
    const bool exhaustive = _i / 4 == 0;
    make(_i % 4 == 0 ? 1 : _i % 4 == 1 ? 2 : 8, _i % 4 == 3);
    const struct hatch_search search = {.exemplar = &exemplar,
                                        .features = &features,
                                        .volume = &volume,
                                        .prices = prices,
                                        .exhaustive = exhaustive,
                                        .scan = !exhaustive,
                                        .key = 1};
    HATCH_TEST_OK(hatch_search_run(&search, NULL, &scratch, &err), &err);
    for (uint32_t axis = 0; axis < HATCH_AXES; axis++)
        for (uint32_t n = 0; n < hatch_volume_count(&volume); n++) {
            int16_t values[HATCH_EXEMPLAR_VALUES_MAX + 16] = {0};
            values_around(axis, n / (SIZE * SIZE), n % SIZE, n / SIZE % SIZE, values);
            ck_assert_uint_eq(volume.matches[axis][n], cheapest(values, exhaustive));
        }
}
END_TEST

/* Nine cells of 4x4 neighbourhoods, the last three with one row. Matches of two axes count: half of them lie in the
 * first cell, ten in the second, the others in the last. */
START_TEST(cells_that_many_matches_lie_in_get_dearer)
{
    static uint32_t counts[HATCH_CELLS];
    make(8, false);
    ck_assert(exemplar.across == 12 && exemplar.down == 9);
    volume.axes = 3;
    for (uint32_t n = 0; n < SIZE * SIZE * SIZE; n++) {
        volume.matches[0][n] = (uint16_t)(n / 4 % 4 * HATCH_EXEMPLAR_PITCH + n % 4);
        volume.matches[1][n] = (uint16_t)(n < 10 ? 4 + n % 4 : 8 * HATCH_EXEMPLAR_PITCH + 8 + n % 4);
        volume.matches[2][n] = 4 * HATCH_EXEMPLAR_PITCH;
    }
    for (int times = 1; times <= 20; times++) {
        hatch_search_price(&volume, &exemplar, counts, prices);
        for (uint32_t cell = 0; cell < 9; cell++) {
            const uint32_t at = cell / 3 * HATCH_CELLS_ACROSS + cell % 3;
            const uint32_t used = cell == 0 ? 125 : cell == 1 ? 10 : cell == 8 ? 115 : 0;
            double fair = 250 * (cell < 6 ? 16 : 4) / (12.0 * 9);
            double change = fmin(fmax(sqrt((used + 0.1 * fair) / (1.1 * fair)), 0.5), 2);
            double price = fmin(fmax(pow(change, times), 0.02), 50);
            ck_assert_uint_eq(counts[at], used);
            ck_assert_double_eq_tol((double)prices[at], price, 1e-4 * price);
        }
        ck_assert_float_eq(prices[3], 1); /* the exemplar has no fourth column of cells */
    }
}
END_TEST

static Suite *suite(void)
{
    Suite *suite = suite_create("synthesis search");
    TCase *tests = tcase_create("search");
    tcase_add_checked_fixture(tests, begin, end);
    tcase_add_loop_test(tests, the_match_is_the_first_of_the_cheapest, 0, 8);
    tcase_add_test(tests, cells_that_many_matches_lie_in_get_dearer);
    suite_add_tcase(suite, tests);
    return suite;
}
HATCH_TEST_MAIN(suite)
