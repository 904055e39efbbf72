/* Laying out the faces around one point in an atlas takes about as many steps per face of many as of few. */
#include "lapped_make.h"
#include "steps.h"

static double steps_a_face(uint32_t count)
{
    struct field_case field = case_of(fan(count));
    set_direction(&field, 1, 0, 0);
    struct lapped_case made = make_lapped(field, &LAPPED_DEFAULTS);
    const struct hatch_lapped_input input = lapped_input(&made.field, &made.outline);
    double scale;
    float *texcoords = HATCH_NEW(&keep, float, 6 * (size_t)count, &err);
    ck_assert_ptr_nonnull(texcoords);
    steps = 0;
    HATCH_TEST_OK(hatch_lapped_atlas(&input, &made.lapped, 0.004, &scratch, texcoords, &scale, &err), &err);
    return (double)steps / count;
}

/* Measured: 5400 and 10,300 steps per face, or 3100 and 5900 with -O3. Comparing each face with all others around the
 * point makes it 190,000 and 4,400,000; a grid whose cells are not along the faces, 25,000 and 98,000. Fewer than 100
 * would mean that steps are not counted. */
START_TEST(an_atlas_of_a_fan_takes_few_steps_a_face)
{
    double few = steps_a_face(1000), many = steps_a_face(8000);
    ck_assert_double_gt(few, 100);
    ck_assert_msg(many < 3 * few, "%g steps a face of 1000, %g of 8000", few, many);
}
END_TEST

static Suite *suite(void)
{
    Suite *suite = suite_create("atlas steps");
    TCase *tests = tcase_create("steps");
    tcase_add_checked_fixture(tests, begin, end);
    tcase_add_test(tests, an_atlas_of_a_fan_takes_few_steps_a_face);
    suite_add_tcase(suite, tests);
    return suite;
}

HATCH_TEST_MAIN(suite)
