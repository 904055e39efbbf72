/* The look of strokes along their line: zigzags, profiles, colours. */
#include <math.h>
#include <string.h>

#include "curve/stroke_look.h"
#include "run.h"

enum { STROKES = 1 << 16 };

START_TEST(a_zigzag_is_a_triangle_wave_at_whole_levels)
{
    for (int level = -3; level <= 3; level++)
        for (int i = 0; i < 400; i++) {
            double wave = i / 100.0, from = wave - floor(wave);
            double wanted = from < 0.25 ? 4 * from : from < 0.75 ? 2 - 4 * from : 4 * from - 4;
            ck_assert_double_eq_tol(hatch_zigzag_beside(ldexp(wave, -level), level), wanted, 1e-9);
            ck_assert_double_eq_tol(hatch_zigzag_beside(ldexp(wave, -level), level + 0.2), wanted, 1e-9);
        }
}
END_TEST

START_TEST(a_zigzag_changes_evenly_with_its_level)
{
    for (int i = 0; i < 1000; i++) {
        double at = i / 100.0;
        for (double level = 0; level < 2; level += 1e-3)
            ck_assert_double_lt(fabs(hatch_zigzag_beside(at, level + 1e-3) - hatch_zigzag_beside(at, level)), 0.005);
    }
}
END_TEST

/* Between turns a zigzag is straight. */
START_TEST(a_zigzag_turns_nowhere_else)
{
    for (double level = -2; level <= 2; level += 0.17) {
        double from = 0.0371, to = hatch_zigzag_turn(from, level);
        for (int i = 0; i < 100; i++, from = to, to = hatch_zigzag_turn(from, level)) {
            ck_assert_double_gt(to, from + 1e-9);
            double low = hatch_zigzag_beside(from, level), high = hatch_zigzag_beside(to, level);
            for (double share = 0.1; share < 1; share += 0.2)
                ck_assert_double_eq_tol(hatch_zigzag_beside(from + share * (to - from), level),
                                        low + share * (high - low), 1e-9);
        }
    }
}
END_TEST

START_TEST(a_zigzag_is_as_long_as_its_sides)
{
    struct hatch_stroke_look look = {.zigzag = 3, .zigzag_length = 16}; /* rises 3 over 4 widths */
    ck_assert_double_eq_tol(hatch_zigzag_stretch(&look), 1.25, 1e-12);
    look.zigzag = 0;
    ck_assert_double_eq(hatch_zigzag_stretch(&look), 1);
}
END_TEST

START_TEST(a_profile_is_linear_between_its_values)
{
    const struct hatch_profile none = {.count = 0}, profile = {.count = 3, .values = {0.25f, 1, 0.5f}};
    static const double wanted[][2] = {{-1, 0.25}, {0, 0.25}, {0.25, 0.625}, {0.5, 1}, {0.9, 0.6}, {1, 0.5}, {2, 0.5}};
    for (size_t i = 0; i < sizeof wanted / sizeof *wanted; i++)
        ck_assert_double_eq_tol(hatch_profile_at(&profile, wanted[i][0]), wanted[i][1], 1e-6);
    ck_assert_double_eq_tol(hatch_profile_mean(&profile), 0.6875, 1e-6);
    ck_assert_double_eq(hatch_profile_at(&none, 0.3), 1);
    ck_assert_double_eq(hatch_profile_mean(&none), 1);
}
END_TEST

START_TEST(strokes_share_the_colours_of_a_list)
{
    struct hatch_stroke_look look = {.color_count = 5};
    uint32_t counts[5] = {0};
    for (uint32_t i = 0; i < 5; i++)
        look.colors[i][1] = (float)i;
    for (uint32_t id = 0; id < STROKES; id++) {
        float rgb[3], again[3];
        hatch_stroke_color(&look, id, rgb);
        hatch_stroke_color(&look, id | 0xfff00000u, again); /* bits above those of the number */
        ck_assert_mem_eq(rgb, again, sizeof rgb);
        counts[(uint32_t)rgb[1]]++;
    }
    for (uint32_t i = 0; i < 5; i++)
        ck_assert_uint_lt(counts[i] - STROKES / 5 + 600, 1200);
}
END_TEST

START_TEST(strokes_have_all_colours_of_a_range)
{
    struct hatch_stroke_look look = {.color_count = 3, .mixes = true, .colors = {{0, 0, 1}, {1, 0, 1}, {1, 2, 1}}};
    double sums[2] = {0, 0};
    uint32_t between = 0;
    for (uint32_t id = 0; id < STROKES; id++) {
        float rgb[3];
        hatch_stroke_color(&look, id, rgb);
        ck_assert_float_eq(rgb[2], 1);
        ck_assert(rgb[0] >= 0 && rgb[0] <= 1 && rgb[1] >= 0 && rgb[1] < 2 && (rgb[0] >= 1 || rgb[1] <= 0));
        between += rgb[0] > 0.1f && rgb[0] < 0.9f;
        sums[0] += (double)rgb[0];
        sums[1] += (double)rgb[1];
    }
    ck_assert_double_eq_tol(sums[0] / STROKES, 0.75, 0.01);
    ck_assert_double_eq_tol(sums[1] / STROKES, 0.5, 0.01);
    ck_assert_double_eq_tol((double)between / STROKES, 0.4, 0.01);
}
END_TEST

static Suite *suite(void)
{
    Suite *made = suite_create("stroke look");
    TCase *tests = tcase_create("look");
    tcase_add_test(tests, a_zigzag_is_a_triangle_wave_at_whole_levels);
    tcase_add_test(tests, a_zigzag_changes_evenly_with_its_level);
    tcase_add_test(tests, a_zigzag_turns_nowhere_else);
    tcase_add_test(tests, a_zigzag_is_as_long_as_its_sides);
    tcase_add_test(tests, a_profile_is_linear_between_its_values);
    tcase_add_test(tests, strokes_share_the_colours_of_a_list);
    tcase_add_test(tests, strokes_have_all_colours_of_a_range);
    suite_add_tcase(made, tests);
    return made;
}

HATCH_TEST_MAIN(suite)
