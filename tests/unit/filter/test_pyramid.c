#include "arenas.h"

#include <math.h>
#include <string.h>

#include "base/random.h"
#include "fail_alloc.h"
#include "filter/blur.h"
#include "filter/pyramid.h"

static struct hatch_image noise(uint32_t width, uint32_t height, const char *names)
{
    struct hatch_image image;
    HATCH_TEST_OK(hatch_image_make(&keep, width, height, names, &image, &err), &err);
    for (size_t i = 0; i < (size_t)width * height * strlen(names); i++)
        image.pixels[i] = hatch_random_unit(4, width * 1000 + height, i);
    return image;
}

static double mean_of(const struct hatch_image *image, uint32_t channel)
{
    double sum = 0;
    for (size_t i = 0; i < (size_t)image->width * image->height; i++)
        sum += (double)image->pixels[i * image->channel_count + channel];
    return sum / ((double)image->width * image->height);
}

/* At odd sizes an average of 2×2 pixels would ignore the last row, or read beyond it. */
START_TEST(halving_keeps_the_mean_of_every_size)
{
    for (uint32_t width = 1; width <= 23; width++)
        for (uint32_t height = 1; height <= 23; height++) {
            struct hatch_arena_mark mark = hatch_arena_mark(&keep);
            struct hatch_image fine = noise(width, height, "RGB");
            struct hatch_image coarse = noise(hatch_mip_size(width, 1), hatch_mip_size(height, 1), "RGB");
            hatch_image_halve(&fine, &coarse);
            for (uint32_t c = 0; c < 3; c++)
                ck_assert_msg(fabs(mean_of(&coarse, c) - mean_of(&fine, c)) < 1e-6, "%ux%u, channel %u: %g, %g", width,
                              height, c, mean_of(&coarse, c), mean_of(&fine, c));
            hatch_arena_rewind(&keep, mark);
        }
}
END_TEST

START_TEST(even_sizes_are_the_mean_of_four)
{
    struct hatch_image fine = noise(6, 4, "YA"), coarse = noise(3, 2, "YA");
    hatch_image_halve(&fine, &coarse);
    for (uint32_t y = 0; y < 2; y++)
        for (uint32_t x = 0; x < 3; x++)
            for (uint32_t c = 0; c < 2; c++) {
                float sum = 0;
                for (uint32_t k = 0; k < 4; k++)
                    sum += fine.pixels[((2 * y + k / 2) * 6 + 2 * x + k % 2) * 2 + c];
                ck_assert_float_eq_tol(coarse.pixels[(y * 3 + x) * 2 + c], sum / 4, 1e-6f);
            }
}
END_TEST

START_TEST(a_constant_stays_constant)
{
    struct hatch_image fine = noise(257, 65, "Y"), coarse = noise(128, 32, "Y");
    for (uint32_t i = 0; i < 257 * 65; i++)
        fine.pixels[i] = 0.375f;
    hatch_image_halve(&fine, &coarse);
    for (uint32_t i = 0; i < 128 * 32; i++)
        ck_assert_float_eq_tol(coarse.pixels[i], 0.375f, 1e-6f);
}
END_TEST

START_TEST(a_completed_chain_ends_at_one_pixel_and_keeps_given_levels)
{
    struct hatch_image levels[HATCH_MIP_LEVELS_MAX] = {{0}};
    levels[0] = noise(40, 12, "Y");
    levels[1] = noise(20, 6, "Y");
    float *authored = levels[1].pixels, first = authored[0];
    struct hatch_mipmap mipmap = {.levels = levels};
    HATCH_TEST_OK(hatch_mipmap_complete(&mipmap, 2, &keep, &err), &err);
    ck_assert_uint_eq(mipmap.level_count, 6);
    ck_assert_ptr_eq(levels[1].pixels, authored);
    ck_assert_float_eq(authored[0], first);
    for (uint32_t level = 2; level < 6; level++) {
        ck_assert_uint_eq(levels[level].width, hatch_mip_size(40, level));
        ck_assert_uint_eq(levels[level].height, hatch_mip_size(12, level));
        ck_assert_double_eq_tol(mean_of(&levels[level], 0), mean_of(&levels[1], 0), 1e-6);
    }
    ck_assert_uint_eq(levels[5].width * levels[5].height, 1);
}
END_TEST

static double naive_box(const struct hatch_image *image, uint32_t channel, uint32_t side, uint32_t x, uint32_t y)
{
    double sum = 0;
    for (uint32_t j = 0; j < side; j++)
        for (uint32_t i = 0; i < side; i++)
            sum +=
                (double)image
                    ->pixels[((y + j) % image->height * image->width + (x + i) % image->width) * image->channel_count +
                             channel];
    return sum / ((double)side * side);
}

START_TEST(the_box_blur_equals_the_naive_loop)
{
    static const uint32_t sizes[][3] = {{16, 16, 1}, {16, 16, 5}, {16, 16, 16}, {13, 7, 3}, {7, 13, 7}, {1, 1, 1}};
    for (int s = 0; s < 6; s++) {
        uint32_t width = sizes[s][0], height = sizes[s][1];
        struct hatch_image image = noise(width, height, "RGB");
        double blurred[256];
        HATCH_TEST_OK(hatch_blur_box(&image, 1, sizes[s][2], &scratch, blurred, &err), &err);
        for (uint32_t y = 0; y < height; y++)
            for (uint32_t x = 0; x < width; x++)
                ck_assert_double_eq_tol(blurred[y * width + x], naive_box(&image, 1, sizes[s][2], x, y), 1e-12);
    }
    ck_assert_uint_eq(scratch.used_bytes > 0 && hatch_arena_mark(&scratch).block != NULL, 0);
}
END_TEST

static enum hatch_status complete(void *context, struct hatch_arena *to, struct hatch_arena *temporary,
                                  struct hatch_err *error)
{
    (void)temporary;
    struct hatch_image levels[HATCH_MIP_LEVELS_MAX] = {*(struct hatch_image *)context};
    struct hatch_mipmap mipmap = {.levels = levels};
    return hatch_mipmap_complete(&mipmap, 1, to, error);
}

static enum hatch_status blur(void *context, struct hatch_arena *to, struct hatch_arena *temporary,
                              struct hatch_err *error)
{
    (void)to;
    double blurred[8 * 8];
    return hatch_blur_box(context, 0, 3, temporary, blurred, error);
}

START_TEST(failed_allocations_are_reported)
{
    struct hatch_image image = noise(8, 8, "Y");
    ck_assert_uint_eq(hatch_test_fail_alloc(complete, &image, NULL, 0), 3);
    ck_assert_uint_eq(hatch_test_fail_alloc(blur, &image, NULL, 0), 1);
}
END_TEST

static Suite *suite(void)
{
    Suite *suite = suite_create("filter pyramid");
    TCase *tests = tcase_create("pyramid");
    tcase_add_checked_fixture(tests, begin, end);
    tcase_add_test(tests, halving_keeps_the_mean_of_every_size);
    tcase_add_test(tests, even_sizes_are_the_mean_of_four);
    tcase_add_test(tests, a_constant_stays_constant);
    tcase_add_test(tests, a_completed_chain_ends_at_one_pixel_and_keeps_given_levels);
    tcase_add_test(tests, the_box_blur_equals_the_naive_loop);
    tcase_add_test(tests, failed_allocations_are_reported);
    suite_add_tcase(suite, tests);
    return suite;
}
HATCH_TEST_MAIN(suite)
