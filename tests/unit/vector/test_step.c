/* Depths of a picture, and steps in depth across a line. */
#include "occluders.h"
#include "vector/step.h"
#include "views.h"

#define PIXEL (2 / SIDE_PX) /* size of a pixel of view_facing, whose eye is at z = 2 */

/* A rectangle from x = low to high, over the whole height, whose ends have the depths z_low and z_high. */
static struct hatch_mesh strip(double low, double high, double z_low, double z_high)
{
    const float positions[12] = {(float)low,  -0.9f, (float)z_low,  (float)high, -0.9f, (float)z_high,
                                 (float)high, 0.9f,  (float)z_high, (float)low,  0.9f,  (float)z_low};
    return mesh_of(positions, 4, (const uint32_t[]){0, 1, 2, 0, 2, 3}, 2);
}

/* A strip left of x = 0 at z = 0, and one right of it that begins `below` pixels deeper and falls to a slope. */
static void make_pair(double below, double slope)
{
    static const double nowhere[3] = {0, 0, 0};
    struct hatch_mesh left = strip(-0.8, 0, 0, 0), right = strip(0, 0.8, -below * PIXEL, -below * PIXEL - 0.8 * slope);
    struct hatch_mesh both = joined(&left, &right, 1, nowhere);
    hide_behind(&both, &view_facing);
}

/* The step to the right of the middle of the picture, in pixels, where the left strip ends at depth 2. */
static double step(void)
{
    static const double middle[2] = {SIDE_PX / 2, SIDE_PX / 2}, right[2] = {1, 0};
    return hatch_occluders_step(&hiding, middle, right, 2);
}

static double depth_at(double x, double y)
{
    const double at[2] = {x, y};
    return hatch_occluders_depth(&hiding, at);
}

/* Both strips are slanted; the one that is behind where they overlap comes nearly as near elsewhere. */
START_TEST(the_depth_is_that_of_the_nearest_face)
{
    static const double nowhere[3] = {0, 0, 0};
    struct hatch_mesh front = strip(-0.2, 0.2, 0.2, 0.82), back = strip(-0.6, 0.6, -0.4, 0.8);
    struct hatch_mesh both = joined(&front, &back, 1, nowhere);
    hide_behind(&both, &view_facing);
    ck_assert_double_eq_tol(depth_at(SIDE_PX / 2 + 0.04 / PIXEL, 200.5), 1.428, 1e-6);
    ck_assert_double_eq_tol(depth_at(SIDE_PX / 2 - 0.4 / PIXEL, 200.5), 2.2, 1e-6);
    ck_assert_double_eq_tol(depth_at(SIDE_PX / 2 + 0.4 / PIXEL, 200.5), 1.4, 1e-6);
    ck_assert(isinf(depth_at(SIDE_PX / 2 + 0.7 / PIXEL, 200.5)));
    ck_assert(isinf(depth_at(-1, 200.5)));
    ck_assert(isinf(depth_at(200.5, SIDE_PX + 1)));
}
END_TEST

/* The near plane, at depth 0.1, cuts a strip whose depth falls from 0.5 to -0.5. */
START_TEST(what_is_before_the_near_plane_does_not_count)
{
    struct hatch_mesh through = strip(-0.8, 0.8, 1.5, 2.5);
    hide_behind(&through, &view_facing);
    ck_assert_double_eq_tol(depth_at(SIDE_PX / 2 - 0.168 / PIXEL, 200.5), 0.105, 1e-6);
    ck_assert(isinf(depth_at(SIDE_PX / 2 - 0.152 / PIXEL, 200.5)));
}
END_TEST

START_TEST(a_step_counts_in_pixels)
{
    make_pair(3.9, 0);
    ck_assert_double_eq_tol(step(), 3.9, 1e-3);
    make_pair(50, 0);
    ck_assert_double_eq_tol(step(), 50, 1e-3);
    make_pair(-50, 0); /* nearer */
    ck_assert_double_lt(step(), 0);
}
END_TEST

/* A slope of 6 is 3.6 pixels deeper at the first place, 7.2 at the second. Steps hardly differ in perspective. */
START_TEST(a_slope_is_no_step)
{
    make_pair(0, 6);
    ck_assert_double_lt(step(), 0.1);
    make_pair(30, 6);
    ck_assert_double_eq_tol(step(), 30, 0.5);
}
END_TEST

/* Beyond a step of 6 pixels the surface is level for 1.3 pixels and then falls by 29 to the third, as in a fold: what
 * is seen at 1.25 and 2.5 pixels would all be taken for a slope. */
START_TEST(a_step_above_a_steep_slope_is_found)
{
    static const double nowhere[3] = {0, 0, 0}, level = 1.3 * PIXEL, steep = 3 * PIXEL;
    struct hatch_mesh left = strip(-0.8, 0, 0, 0), right = strip(0, level, -6 * PIXEL, -6 * PIXEL);
    struct hatch_mesh slope = strip(level, steep, -6 * PIXEL, -35 * PIXEL), two, three;
    two = joined(&left, &right, 1, nowhere);
    three = joined(&two, &slope, 1, nowhere);
    hide_behind(&three, &view_facing);
    ck_assert_double_eq_tol(step(), 6, 0.1);
}
END_TEST

START_TEST(the_background_is_a_step)
{
    struct hatch_mesh left = strip(-0.8, 0, 0, 0);
    hide_behind(&left, &view_facing);
    ck_assert(isinf(step()));
}
END_TEST

static Suite *suite(void)
{
    Suite *suite = suite_create("vector step");
    TCase *tests = tcase_create("step");
    tcase_add_checked_fixture(tests, begin, end);
    tcase_add_test(tests, the_depth_is_that_of_the_nearest_face);
    tcase_add_test(tests, what_is_before_the_near_plane_does_not_count);
    tcase_add_test(tests, a_step_counts_in_pixels);
    tcase_add_test(tests, a_slope_is_no_step);
    tcase_add_test(tests, a_step_above_a_steep_slope_is_found);
    tcase_add_test(tests, the_background_is_a_step);
    suite_add_tcase(suite, tests);
    return suite;
}

HATCH_TEST_MAIN(suite)
