/* A plane is made coarser in not many more steps with a small tolerance than with a large one. */
#include "coarse/coarse.h"
#include "meshes.h"
#include "shapes/shapes.h"
#include "steps.h"

/* Returns the steps per face, in searches on the full mesh, to leave two faces of a plane. */
static double steps_a_face(double tolerance)
{
    struct hatch_mesh plane = bare_shape(HATCH_SHAPE_PLANE, 1000), out;
    double *tolerances = HATCH_NEW(&keep, double, plane.vertex_count, &err);
    ck_assert_ptr_nonnull(tolerances);
    for (uint32_t v = 0; v < plane.vertex_count; v++)
        tolerances[v] = tolerance;
    const struct hatch_coarse_part part = {&plane, tolerances, NULL};
    steps = 0;
    HATCH_TEST_OK(hatch_coarse_make(&part, 1, &keep, &scratch, &out, &err), &err);
    ck_assert_uint_eq(out.face_count, 2);
    return (double)steps / plane.face_count;
}

/* Measured: 5,520 steps a face with the large tolerance and 135,000 with the small one, with which 30 times as many
 * places of each new face are tested; 259,000 where each place is tested. */
START_TEST(a_small_tolerance_takes_few_steps_on_a_plane)
{
    double large = steps_a_face(0.01), small = steps_a_face(1e-5);
    ck_assert_double_gt(large, 30);
    ck_assert_msg(small < 35 * large, "%g steps a face with a large tolerance, %g with a small one", large, small);
}
END_TEST

static Suite *suite(void)
{
    Suite *suite = suite_create("coarse steps");
    TCase *tests = tcase_create("steps");
    tcase_add_checked_fixture(tests, begin, end);
    tcase_add_test(tests, a_small_tolerance_takes_few_steps_on_a_plane);
    suite_add_tcase(suite, tests);
    return suite;
}

HATCH_TEST_MAIN(suite)
