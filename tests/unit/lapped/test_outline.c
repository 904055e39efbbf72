#include "arenas.h"
#include "base/random.h"
#include "fail_alloc.h"
#include "lapped/outline.h"

#include <math.h>

#define PI 3.14159265358979323846

static double random_in(uint64_t stream, uint64_t i, double low, double high)
{
    return low + (high - low) * (double)hatch_random_unit(11, stream, i);
}

START_TEST(a_circle_is_a_circle)
{
    struct hatch_outline outline;
    hatch_outline_make(5, 0, 0.1, &outline);
    ck_assert_double_eq_tol(outline.core_min + 0.1, outline.reach_max, 1e-9);
    for (uint64_t i = 0; i < 1000; i++) {
        double uv[2] = {random_in(0, i, 0, 1), random_in(1, i, 0, 1)};
        double away = hypot(uv[0] - 0.5, uv[1] - 0.5);
        double want = fmin(1, fmax(0, 1 - (away - outline.core_min) / 0.1));
        ck_assert_double_eq_tol(hatch_outline_opacity(&outline, uv), want, 1e-9);
        ck_assert_double_eq_tol(hatch_outline_depth(&outline, uv), outline.core_min - away, 1e-9);
    }
}
END_TEST

/* All points nearer than the depth lie in the core; all nearer than the distance have opacity 0. */
START_TEST(depth_and_distance_are_bounds)
{
    for (uint64_t seed = 0; seed < 20; seed++) {
        struct hatch_outline outline;
        hatch_outline_make(seed, 1, 0.05, &outline);
        ck_assert(outline.core_min > 0.2 && outline.reach_max < 0.5 && outline.steep >= 1);
        uint32_t inside = 0, outside = 0;
        for (uint64_t i = 0; i < 2000; i++) {
            double uv[2] = {random_in(2, i, 0, 1), random_in(3, i, 0, 1)};
            double depth = hatch_outline_depth(&outline, uv);
            double gap = hatch_outline_distance(&outline, uv);
            double reach = fmax(depth, gap), angle = random_in(4, i, 0, 6.2831853);
            double at[2] = {uv[0] + reach * 0.999 * cos(angle), uv[1] + reach * 0.999 * sin(angle)};
            ck_assert(depth <= 0 || hatch_outline_opacity(&outline, at) == 1);
            ck_assert(gap <= 0 || hatch_outline_opacity(&outline, at) == 0);
            ck_assert((depth > 0) + (gap > 0) <= 1);
            ck_assert(depth > 0 || hatch_outline_opacity(&outline, uv) < 1 || depth > -1e-12);
            inside += depth > 0;
            outside += gap > 0;
        }
        /* Of 2000 places the core's circle alone has some 700, the corners beyond the reach some 400. */
        ck_assert_uint_gt(inside, 600);
        ck_assert_uint_gt(outside, 350);
    }
}
END_TEST

/* The core's radius is a sum of waves, the bounds of which are those over 512 directions per half turn and the change
 * between two of them. */
START_TEST(bounds_are_those_of_the_radius)
{
    for (uint64_t seed = 0; seed < 10; seed++) {
        const double roughness = 0.1 * (double)(seed + 1), feather = 0.03 * (double)(seed + 1),
                     core_max = 0.48 - feather;
        struct hatch_outline outline;
        hatch_outline_make(seed, roughness, feather, &outline);
        double low = HUGE_VAL, high = 0, slope = 0;
        for (int i = 0; i < 100000; i++) {
            double angle = 2e-5 * PI * i, radius = outline.wave[0][0];
            for (int k = 1; k < 8; k++)
                radius += outline.wave[k][0] * cos(k * angle) + outline.wave[k][1] * sin(k * angle);
            low = fmin(low, radius);
            high = fmax(high, radius);
            if (i % 1000)
                continue;
            double at = radius + 0.3 * feather, uv[2] = {0.5 + at * cos(angle), 0.5 + at * sin(angle)};
            ck_assert_double_eq_tol(hatch_outline_opacity(&outline, uv), 0.7, 1e-9);
        }
        for (int k = 1; k < 8; k++)
            slope += k * hypot(outline.wave[k][0], outline.wave[k][1]);
        double between = 2 * slope / 512;
        ck_assert(low >= outline.core_min && low <= outline.core_min + between + 1e-9);
        ck_assert(high <= outline.reach_max - feather && high >= outline.reach_max - feather - between - 1e-9);
        ck_assert_double_eq_tol(outline.reach_max, 0.48, 1e-9);
        double dent = outline.reach_max - feather - outline.core_min;
        ck_assert_double_eq_tol(dent, 0.22 * roughness * core_max, 1e-9);
        ck_assert_double_eq_tol(outline.steep, hypot(1, slope / (outline.core_min - dent / 2)), 1e-9);
    }
}
END_TEST

/* Of a circle: 1 where the square of 4, 7 or 13 texels around a texel reaches into it, and a ramp to 0 at its reach
 * where a square 1.4 times as large does not. */
START_TEST(the_raster_of_a_circle_is_a_ramp)
{
    static const struct {
        uint32_t side;
        double half;
    } sizes[] = {{200, 2}, {600, 3.5}, {1024, 6.5}};
    const uint32_t side = sizes[_i].side;
    struct hatch_outline outline;
    struct hatch_image mask;
    uint32_t opaque = 0, ramp = 0;
    hatch_outline_make(1, 0, 0.15, &outline);
    HATCH_TEST_OK(hatch_outline_raster(&outline, side, &keep, &mask, &err), &err);
    for (uint32_t i = 0; i < side * side; i++) {
        double x = fabs((i % side + 0.5) / side - 0.5), y = fabs((i / side + 0.5) / side - 0.5),
               half = sizes[_i].half / side;
        double start = outline.core_min + 1.42 * half, end = outline.reach_max;
        if (hypot(fmax(0, x - half), fmax(0, y - half)) < outline.core_min) {
            ck_assert_float_eq(mask.pixels[i], 1);
            opaque++;
        } else if (hypot(fmax(0, x - 1.4 * half), fmax(0, y - 1.4 * half)) > outline.core_min) {
            double want = fmin(1, fmax(0, (end - hypot(x, y)) / (end - start)));
            ck_assert_double_eq_tol((double)mask.pixels[i], want, 1e-6);
            ramp += want > 0 && want < 1;
        }
    }
    ck_assert_uint_gt(opaque, 10000);
    ck_assert_uint_gt(ramp, 1000);
}
END_TEST

START_TEST(seeds_make_different_outlines)
{
    struct hatch_outline a, b, same;
    hatch_outline_make(1, 1, 0.05, &a);
    hatch_outline_make(2, 1, 0.05, &b);
    hatch_outline_make(1, 1, 0.05, &same);
    ck_assert_mem_eq(&a, &same, sizeof a);
    ck_assert(a.wave[2][0] != b.wave[2][0]);
    ck_assert(a.reach_max - a.feather - a.core_min > 0.05);
}
END_TEST

/* Masks of fewer texels keep the soft border: they are opaque on fewer levels. */
START_TEST(small_rasters_keep_the_ramp)
{
    static const double widths[][2] = {{1024, 0.034}, {512, 0.033}, {256, 0.031}, {128, 0.019}};
    struct hatch_outline outline;
    hatch_outline_make(1, 0.3, 0.045, &outline);
    for (size_t i = 0; i < 4; i++) {
        const uint32_t side = (uint32_t)widths[i][0];
        struct hatch_image mask;
        HATCH_TEST_OK(hatch_outline_raster(&outline, side, &keep, &mask, &err), &err);
        double grey = 0;
        for (uint32_t t = 0; t < side * side; t++)
            grey += mask.pixels[t] > 0 && mask.pixels[t] < 1;
        ck_assert_double_gt(grey / side / side, 2 * PI * outline.core_min * widths[i][1]);
    }
}
END_TEST

/* The raster is opaque wherever the core is, when read bilinearly on any of its levels. */
START_TEST(the_raster_is_opaque_where_the_core_is)
{
    static const uint32_t sizes[] = {64, 128, 256, 512, 1024};
    struct hatch_outline outline;
    struct hatch_image mask;
    const uint32_t whole = sizes[_i % 5], levels = hatch_outline_levels(whole);
    ck_assert_uint_eq(levels, whole == 1024 ? 3 : whole == 512 ? 2 : 1);
    hatch_outline_make((uint64_t)_i, 1, _i < 5 ? 0.01 : 0.05, &outline);
    HATCH_TEST_OK(hatch_outline_raster(&outline, whole, &keep, &mask, &err), &err);
    for (uint32_t level = 0; level < levels; level++) {
        uint32_t side = whole >> level, met = 0;
        for (uint64_t i = 0; i < 4000; i++) {
            double uv[2] = {random_in(5, i, 0.05, 0.95), random_in(6, i, 0.05, 0.95)};
            if (hatch_outline_depth(&outline, uv) <= 0)
                continue;
            int x = (int)floor(uv[0] * side - 0.5), y = (int)floor(uv[1] * side - 0.5);
            for (size_t k = 0; k < 4; k++)
                ck_assert_float_eq(mask.pixels[((size_t)y + k / 2) * side + (size_t)x + k % 2], 1);
            met++;
        }
        ck_assert_uint_gt(met, 1500); /* the core's circle alone: some 1700 of 4000 */
        for (uint32_t i = 0; i < side; i++)
            ck_assert(mask.pixels[i] == 0 && mask.pixels[(size_t)i * side] == 0 &&
                      mask.pixels[(size_t)(side - 1) * side + i] == 0);
        /* the next level: means of four */
        for (uint32_t y = 0; y < side / 2; y++)
            for (uint32_t x = 0; x < side / 2; x++) {
                const float *from = &mask.pixels[(size_t)2 * y * side + 2 * x];
                mask.pixels[(size_t)y * (side / 2) + x] = (from[0] + from[1] + from[side] + from[side + 1]) / 4;
            }
    }
}
END_TEST

static enum hatch_status raster(void *context, struct hatch_arena *result, struct hatch_arena *work,
                                struct hatch_err *error)
{
    struct hatch_outline outline;
    (void)work;
    hatch_outline_make(4, 1, 0.05, &outline);
    return hatch_outline_raster(&outline, HATCH_OUTLINE_PX_MIN, result, context, error);
}

START_TEST(failed_allocations_are_reported)
{
    struct hatch_image mask = {0};
    hatch_test_fail_alloc(raster, &mask, &mask, sizeof mask);
}
END_TEST

static Suite *suite(void)
{
    Suite *suite = suite_create("lapped outline");
    TCase *tests = tcase_create("outline");
    tcase_add_checked_fixture(tests, begin, end);
    tcase_add_test(tests, a_circle_is_a_circle);
    tcase_add_test(tests, depth_and_distance_are_bounds);
    tcase_add_test(tests, bounds_are_those_of_the_radius);
    tcase_add_loop_test(tests, the_raster_of_a_circle_is_a_ramp, 0, 3);
    tcase_add_test(tests, small_rasters_keep_the_ramp);
    tcase_add_test(tests, seeds_make_different_outlines);
    tcase_add_loop_test(tests, the_raster_is_opaque_where_the_core_is, 0, 15);
    tcase_add_test(tests, failed_allocations_are_reported);
    suite_add_tcase(suite, tests);
    return suite;
}
HATCH_TEST_MAIN(suite)
