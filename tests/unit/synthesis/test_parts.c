/* The parts of synthesis: exemplars, principal components, features, grids. */
#include <math.h>
#include <stdbool.h>
#include <stdlib.h>

#include "arenas.h"
#include "base/random.h"
#include "synthesis/features.h"
#include "synthesis/grid.h"
#include "math/pca.h"
#include "synthesis/search.h"

static struct hatch_image noise(uint32_t width, uint32_t height, const char *names, uint64_t seed)
{
    struct hatch_image image;
    HATCH_TEST_OK(hatch_image_make(&keep, width, height, names, &image, &err), &err);
    for (uint32_t i = 0; i < width * height * image.channel_count; i++)
        image.pixels[i] = hatch_random_unit(seed, 0, i);
    return image;
}

START_TEST(principal_components_of_a_known_covariance)
{
    /* Variances 9, 4 and 1 along the columns of a rotation, (2, 1, 2) / 3 and so on. */
    static const double axes[3][3] = {{2, 1, 2}, {-2, 2, 1}, {-1, -2, 2}};
    static const double variances[3] = {9, 4, 1};
    double covariance[9] = {0}, found[9], next[9];
    for (int i = 0; i < 9; i++)
        for (int k = 0; k < 3; k++)
            covariance[i] += variances[k] * axes[k][i / 3] * axes[k][i % 3] / 9;
    hatch_pca_directions(covariance, 3, 3, found, next);
    for (int k = 0; k < 3; k++) {
        double along = 0;
        for (int i = 0; i < 3; i++)
            along += found[k * 3 + i] * axes[k][i] / 3;
        ck_assert_double_eq_tol(fabs(along), 1, 1e-12);
    }
}
END_TEST

START_TEST(principal_components_are_orthonormal_without_variance)
{
    double covariance[16] = {0}, found[16], next[16];
    covariance[5] = 2; /* one direction alone varies */
    hatch_pca_directions(covariance, 4, 4, found, next);
    ck_assert_double_eq_tol(fabs(found[1]), 1, 1e-12);
    for (int a = 0; a < 4; a++)
        for (int b = 0; b < 4; b++) {
            double dot = 0;
            for (int i = 0; i < 4; i++)
                dot += found[a * 4 + i] * found[b * 4 + i];
            ck_assert_double_eq_tol(dot, a == b, 1e-12);
        }
}
END_TEST

START_TEST(large_pictures_are_halved_and_long_ones_are_cropped)
{
    static const struct {
        uint32_t width, height, size, want_width, want_height, halvings;
        bool cropped;
    } cases[] = {
        {128, 128, 64, 128, 128, 0, false}, {129, 128, 64, 128, 128, 0, true},   {129, 140, 64, 64, 70, 1, false},
        {256, 256, 64, 128, 128, 1, false}, {256, 256, 128, 256, 256, 0, false}, {600, 600, 512, 150, 150, 2, false},
        {3000, 20, 64, 128, 20, 0, true},   {1, 1, 8, 1, 1, 0, false},
    };
    for (uint32_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        struct hatch_synthesis_figures figures = {0};
        struct hatch_image image = noise(cases[i].width, cases[i].height, "Y", 1), exemplar;
        HATCH_TEST_OK(hatch_synthesis_exemplar(&image, cases[i].size, &keep, &scratch, &exemplar, &figures, &err),
                      &err);
        ck_assert_uint_eq(exemplar.width, cases[i].want_width);
        ck_assert_uint_eq(exemplar.height, cases[i].want_height);
        ck_assert_uint_eq(figures.halvings, cases[i].halvings);
        ck_assert_int_eq(figures.cropped, cases[i].cropped);
    }
}
END_TEST

START_TEST(the_middle_of_a_long_picture_is_used_without_alpha)
{
    struct hatch_synthesis_figures figures = {0};
    struct hatch_image image = noise(200, 3, "RGBA", 1), exemplar;
    image.pixels[(36 * 4) + 1] = 7;
    image.pixels[(37 * 4) + 2] = -1;
    HATCH_TEST_OK(hatch_synthesis_exemplar(&image, 8, &keep, &scratch, &exemplar, &figures, &err), &err);
    ck_assert_uint_eq(exemplar.channel_count, 3);
    ck_assert_float_eq(exemplar.pixels[0], image.pixels[36 * 4]);
    ck_assert_float_eq(exemplar.pixels[1], 1);
    ck_assert_float_eq(exemplar.pixels[5], 0);
}
END_TEST

/* Distances between features are at most those between neighbourhoods, and equal to them where a neighbourhood has no
 * more values than a feature. */
START_TEST(features_keep_distances)
{
    for (uint32_t side = 3; side <= 8; side++) {
        struct hatch_image image = noise(24, 20, "Y", side);
        struct hatch_exemplar exemplar;
        struct hatch_features features;
        int16_t values[HATCH_EXEMPLAR_VALUES_MAX + 16] = {0}, feature[HATCH_FEATURES];
        HATCH_TEST_OK(hatch_exemplar_make(&image, side, &keep, &exemplar, &err), &err);
        HATCH_TEST_OK(hatch_features_make(&exemplar, true, NULL, &keep, &scratch, &features, &err), &err);
        for (uint32_t i = 0; i < side * side; i++)
            values[i] = (int16_t)(hatch_random_u64(side, 1, i) % 256 - 128);
        hatch_features_project(&features, values, feature);
        for (uint32_t y = 0; y < exemplar.down; y++)
            for (uint32_t x = 0; x < exemplar.across; x++) {
                double distance = sqrt(hatch_features_distance(feature, features.vectors + (y * exemplar.across + x) *
                                                                                               HATCH_FEATURES)) /
                                  HATCH_FEATURES_SCALE;
                double full =
                    sqrt(hatch_exemplar_distance(&exemplar, values, y * HATCH_EXEMPLAR_PITCH + x, UINT32_MAX));
                ck_assert_double_le(distance, full * 1.001 + 2);
                if (side * side <= HATCH_FEATURES)
                    ck_assert_double_eq_tol(distance, full, 2);
            }
    }
}
END_TEST

START_TEST(similar_neighbourhoods_of_a_periodic_exemplar_are_equal_ones)
{
    struct hatch_image image = noise(40, 40, "Y", 3);
    struct hatch_exemplar exemplar;
    struct hatch_features features;
    for (uint32_t i = 0; i < 1600; i++)
        image.pixels[i] = image.pixels[i / 40 % 10 * 40 + i % 10];
    HATCH_TEST_OK(hatch_exemplar_make(&image, 6, &keep, &exemplar, &err), &err);
    HATCH_TEST_OK(hatch_features_make(&exemplar, true, NULL, &keep, &scratch, &features, &err), &err);
    for (uint32_t i = 0; i < exemplar.across * exemplar.down; i++)
        for (uint32_t k = 0; k < HATCH_FEATURES_SIMILAR; k++) {
            uint32_t similar = features.similar[i * HATCH_FEATURES_SIMILAR + k];
            uint32_t x = similar % HATCH_EXEMPLAR_PITCH, y = similar / HATCH_EXEMPLAR_PITCH;
            ck_assert_uint_eq(x % 10, i % exemplar.across % 10);
            ck_assert_uint_eq(y % 10, i / exemplar.across % 10);
            ck_assert(x != i % exemplar.across || y != i / exemplar.across);
        }
}
END_TEST

/* Against all neighbourhoods that are not next to it: the nearest three, in order. */
START_TEST(similar_neighbourhoods_are_the_nearest)
{
    enum { SIDE = 5, APART = SIDE / 4 + 1 };
    struct hatch_image image = noise(20, 17, "Y", 5);
    struct hatch_exemplar exemplar;
    struct hatch_features features;
    HATCH_TEST_OK(hatch_exemplar_make(&image, SIDE, &keep, &exemplar, &err), &err);
    HATCH_TEST_OK(hatch_features_make(&exemplar, true, NULL, &keep, &scratch, &features, &err), &err);
    const int count = (int)(exemplar.across * exemplar.down), across = (int)exemplar.across;
    for (int at = 0; at < count; at++) {
        uint32_t before = 0;
        for (uint32_t k = 0; k < HATCH_FEATURES_SIMILAR; k++) {
            uint32_t name = features.similar[(uint32_t)at * HATCH_FEATURES_SIMILAR + k], nearer = 0;
            int found = (int)(name / HATCH_EXEMPLAR_PITCH) * across + (int)(name % HATCH_EXEMPLAR_PITCH);
            const int16_t *vector = features.vectors + at * (int)HATCH_FEATURES;
            uint32_t distance = hatch_features_distance(vector, features.vectors + found * (int)HATCH_FEATURES);
            for (int other = 0; other < count; other++)
                if (abs(other % across - at % across) >= APART || abs(other / across - at / across) >= APART)
                    nearer +=
                        hatch_features_distance(vector, features.vectors + other * (int)HATCH_FEATURES) < distance;
            ck_assert_uint_eq(nearer, k);
            ck_assert_uint_gt(distance, before);
            before = distance;
        }
    }
}
END_TEST

START_TEST(a_pyramid_of_bands_adds_up_again)
{
    static const uint32_t sizes[][3] = {{16, 16, 16}, {13, 6, 1}, {1, 1, 1}, {2, 2, 2}};
    for (uint32_t s = 0; s < 4; s++) {
        struct hatch_grid fine = {{sizes[s][0], sizes[s][1], sizes[s][2]}, sizes[s][2] > 1, NULL}, coarse;
        const size_t count = hatch_grid_count(&fine);
        fine.values = HATCH_NEW(&keep, float, count, &err);
        for (size_t i = 0; i < count; i++)
            fine.values[i] = 3;
        HATCH_TEST_OK(hatch_grid_make_half(&fine, &keep, &coarse, &err), &err);
        hatch_grid_reduce(&fine, &coarse, NULL);
        ck_assert_float_eq_tol(coarse.values[hatch_grid_count(&coarse) - 1], 3, 1e-5f);
        hatch_grid_add(&fine, &coarse, -1, NULL);
        for (size_t i = 0; i < count; i++)
            ck_assert_float_eq_tol(fine.values[i], 0, 1e-5f);
        hatch_grid_add(&fine, &coarse, 1, NULL);
        ck_assert_float_eq_tol(fine.values[count / 2], 3, 1e-5f);
    }
}
END_TEST

START_TEST(matched_values_are_distributed_as_the_others)
{
    struct hatch_grid grid = {{16, 16, 16}, true, NULL};
    static float sorted[100];
    double ranks[HATCH_GRID_RANKS], sum = 0;
    for (int i = 0; i < 100; i++)
        sorted[i] = (float)(i * i);
    grid.values = HATCH_NEW(&keep, float, 4096, &err);
    for (uint32_t i = 0; i < 4096; i++)
        grid.values[i] = -5 + 2 * hatch_random_unit(1, 0, i);
    hatch_grid_match(&grid, sorted, 100, NULL, ranks);
    for (uint32_t i = 0; i < 4096; i++)
        sum += (double)grid.values[i] / 4096;
    ck_assert_double_eq_tol(sum, 99.0 * 99 / 3, 20);
    hatch_grid_sort(&grid);
    ck_assert_float_eq_tol(grid.values[2048], 49.5f * 49.5f, 30);
    for (uint32_t i = 0; i < 4096; i++)
        grid.values[i] = hatch_random_unit(2, 0, i);
    grid.values[0] = 1e5f; /* all others are in one bin */
    hatch_grid_match(&grid, sorted, 100, NULL, ranks);
    ck_assert_float_eq(grid.values[0], 99 * 99);
    ck_assert_float_gt(grid.values[1], 0);
    ck_assert(grid.values[1] < grid.values[2] || hatch_random_unit(2, 0, 1) >= hatch_random_unit(2, 0, 2));
    ck_assert_float_ne(grid.values[1], grid.values[2]);
    hatch_grid_match(&grid, sorted + 7, 1, NULL, ranks);
    ck_assert_float_eq(grid.values[0], 49);
    hatch_grid_match(&grid, sorted, 100, NULL, ranks); /* all values are alike */
    ck_assert(grid.values[0] >= 0 && grid.values[0] <= 99 * 99);
}
END_TEST

static Suite *suite(void)
{
    Suite *suite = suite_create("synthesis parts");
    TCase *tests = tcase_create("parts");
    tcase_add_checked_fixture(tests, begin, end);
    tcase_add_test(tests, principal_components_of_a_known_covariance);
    tcase_add_test(tests, principal_components_are_orthonormal_without_variance);
    tcase_add_test(tests, large_pictures_are_halved_and_long_ones_are_cropped);
    tcase_add_test(tests, the_middle_of_a_long_picture_is_used_without_alpha);
    tcase_add_test(tests, features_keep_distances);
    tcase_add_test(tests, similar_neighbourhoods_are_the_nearest);
    tcase_add_test(tests, similar_neighbourhoods_of_a_periodic_exemplar_are_equal_ones);
    tcase_add_test(tests, a_pyramid_of_bands_adds_up_again);
    tcase_add_test(tests, matched_values_are_distributed_as_the_others);
    suite_add_tcase(suite, tests);
    return suite;
}
HATCH_TEST_MAIN(suite)
