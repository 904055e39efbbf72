/* A stroke takes steps for the cells along it, not for those of the box around it. */
#include <math.h>
#include <stdio.h>

#include "made.h"
#include "run.h"
#include "solid/points.h"
#include "steps.h"

#define WIDTH 0.03

/* Returns the steps for each stroke of a length, without those of spreading their middles. */
static double steps_of(double length)
{
    const double radius = WIDTH / 2, volume = 3.1415927 * radius * radius * (length + 4 * radius / 3);
    const uint32_t count = (uint32_t)ceil(2 / volume);
    char text[128];
    struct hatch_solid_points points;
    snprintf(text, sizeof text, "kind strokes\ndensity 2\ndirection 1 1 1\nwidth %g\nlength %g", WIDTH, length);
    steps = 0;
    make_solid(text, HATCH_SOLID_SIZE_MIN, 1, NULL);
    uint64_t whole = steps;
    steps = 0;
    HATCH_TEST_OK(hatch_solid_points_spread(count, 0, 1, NULL, NULL, &keep, &scratch, &points, &err), &err);
    return (double)(whole - steps) / count;
}

/* Measured: 4,100 steps a stroke of 0.15 and 14,200 of 0.6. Visiting all cells of the box makes it 4,200 and 46,500.
 * Fewer than 100 would mean that steps are not counted. */
START_TEST(a_stroke_takes_steps_for_its_length)
{
    double little = steps_of(0.15), much = steps_of(0.6);
    ck_assert_double_gt(little, 100);
    ck_assert_msg(much < 5 * little, "%g steps a stroke of 0.15, %g of 0.6", little, much);
}
END_TEST

static Suite *suite(void)
{
    Suite *suite = suite_create("solid strokes steps");
    TCase *tests = tcase_create("steps");
    tcase_add_checked_fixture(tests, begin, end);
    tcase_add_test(tests, a_stroke_takes_steps_for_its_length);
    suite_add_tcase(suite, tests);
    return suite;
}
HATCH_TEST_MAIN(suite)
