/* Making surfaces and frames takes as many steps per face of a large mesh as of a small one. */
#include "field_make.h"
#include "steps.h"
#include "surface/nearest.h"

static double steps_a_face(struct hatch_mesh mesh)
{
    steps = 0;
    struct field_case of = case_of(mesh);
    ck_assert_uint_eq(of.surface.face_count, mesh.face_count);
    return (double)steps / mesh.face_count;
}

/* Measured: 860 steps per face of both fans, 797 and 796 of the tori; a search through the fan adds 500 per thousand
 * faces. Fewer than 100 would mean that steps are not counted. */
START_TEST(a_fan_takes_as_many_steps_as_it_has_faces)
{
    double few = steps_a_face(fan(3000)), many = steps_a_face(fan(50000));
    ck_assert_double_gt(few, 100);
    ck_assert_msg(many < 1.02 * few, "%g steps a face of 3000, %g of 50000", few, many);
}
END_TEST

START_TEST(a_torus_takes_as_many_steps_as_it_has_faces)
{
    double few = steps_a_face(shape_of(HATCH_SHAPE_TORUS, 3000));
    double many = steps_a_face(shape_of(HATCH_SHAPE_TORUS, 50000));
    ck_assert_double_gt(few, 100);
    ck_assert_msg(many < 1.02 * few, "%g steps a face of 3000, %g of 50000", few, many);
}
END_TEST

static double steps_a_search(uint32_t faces)
{
    enum { SEARCHES = 200 };
    struct field_case of = case_of_shape(HATCH_SHAPE_TORUS, faces, 1);
    struct hatch_surface_points points;
    HATCH_TEST_OK(hatch_surface_points_make(&of.surface, &keep, &points, &err), &err);
    steps = 0;
    for (uint32_t i = 0; i < SEARCHES; i++) {
        double position[3];
        hatch_surface_position(&of.surface, (uint32_t)(hatch_random_u64(1, 1, i) % of.surface.point_count), position);
        position[0] += 0.01;
        hatch_surface_nearest(&points, position);
    }
    return (double)steps / SEARCHES;
}

/* Measured: 149 and 240 steps, of the distances; those of the tree itself are not counted. A search through all points
 * takes 16 times as many among 25,000 as among 1500. */
START_TEST(a_search_does_not_visit_all_points)
{
    double few = steps_a_search(3000), many = steps_a_search(50000);
    ck_assert_double_gt(few, 10);
    ck_assert_msg(many < 2 * few, "%g steps a search among 1500 points, %g among 25000", few, many);
}
END_TEST

static Suite *suite(void)
{
    Suite *suite = suite_create("surface steps");
    TCase *tests = tcase_create("steps");
    tcase_add_checked_fixture(tests, begin, end);
    tcase_add_test(tests, a_fan_takes_as_many_steps_as_it_has_faces);
    tcase_add_test(tests, a_torus_takes_as_many_steps_as_it_has_faces);
    tcase_add_test(tests, a_search_does_not_visit_all_points);
    suite_add_tcase(suite, tests);
    return suite;
}

HATCH_TEST_MAIN(suite)
