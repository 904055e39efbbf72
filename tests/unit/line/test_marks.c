/* Direction marks. */
#include "line/marks.h"
#include "meshes.h"
#include "views.h"

/* Directions along x on a plane, half of them with inverted sign. */
START_TEST(marks_lie_evenly_along_directions)
{
    struct hatch_scene scene;
    struct hatch_unit_scene unit;
    const struct hatch_bounds bounds = {.radius = 1};
    struct hatch_marks marks;
    float *directions;
    struct hatch_mesh plane = shape_of(HATCH_SHAPE_PLANE, 200);
    HATCH_TEST_OK(hatch_mesh_add(&keep, &plane, "_HATCH_DIR", 4, &directions, &err), &err);
    for (size_t v = 0; v < plane.vertex_count; v++) {
        directions[4 * v] = v % 2 ? 1.0f : -1.0f;
        directions[4 * v + 3] = 0.5f;
    }
    HATCH_TEST_OK(hatch_scene_of_mesh(&plane, &keep, &scene, &err), &err);
    HATCH_TEST_OK(hatch_unit_scene_make(&scene, NULL, &bounds, &keep, &unit, &err), &err);
    hatch_unit_scene_pose(&unit, HATCH_NONE, 0);
    HATCH_TEST_OK(hatch_marks_make(&unit, &view_facing, 200, &keep, &scratch, &marks, &err), &err);
    hatch_marks_place(&marks);
    /* 100 pixels per unit, 11 pixels between marks. */
    ck_assert_uint_gt(marks.count, 200);
    for (uint32_t a = 0; a < marks.count; a++) {
        const struct hatch_mark_line *line = marks.lines + a;
        ck_assert_double_eq_tol(fabs((double)line->half[0]), 0.5 * 0.9 * 0.11, 1e-6);
        ck_assert_double_le(fabs((double)line->half[1]), 1e-6);
        ck_assert_double_eq_tol((double)line->confidence, 0.5, 1e-6);
        for (uint32_t b = 0; b < a; b++) {
            const struct hatch_mark_line *other = marks.lines + b;
            ck_assert_double_gt(
                hypot((double)(line->middle[0] - other->middle[0]), (double)(line->middle[1] - other->middle[1])),
                0.1099);
        }
    }
}
END_TEST

/* In a picture where marks a distance of pixels apart would be millions, as many are made as there is room for, evenly
 * over all faces: each half of the plane in x and in y has its share. */
START_TEST(marks_are_no_more_than_there_is_room_for)
{
    struct hatch_scene scene;
    struct hatch_unit_scene unit;
    const struct hatch_bounds bounds = {.radius = 1};
    struct hatch_marks marks;
    float *directions;
    uint32_t beyond[2] = {0, 0};
    struct hatch_mesh plane = shape_of(HATCH_SHAPE_PLANE, 2);
    HATCH_TEST_OK(hatch_mesh_add(&keep, &plane, "_HATCH_DIR", 4, &directions, &err), &err);
    for (size_t v = 0; v < plane.vertex_count; v++)
        directions[4 * v] = 1;
    HATCH_TEST_OK(hatch_scene_of_mesh(&plane, &keep, &scene, &err), &err);
    HATCH_TEST_OK(hatch_unit_scene_make(&scene, NULL, &bounds, &keep, &unit, &err), &err);
    hatch_unit_scene_pose(&unit, HATCH_NONE, 0);
    HATCH_TEST_OK(hatch_marks_make(&unit, &view_facing, 1e5, &keep, &scratch, &marks, &err), &err);
    hatch_marks_place(&marks);
    ck_assert_uint_gt(marks.count, 100000);
    ck_assert_uint_lt(marks.count, 200000);
    for (uint32_t i = 0; i < marks.count; i++)
        for (int k = 0; k < 2; k++)
            beyond[k] += marks.lines[i].middle[k] > 0;
    for (int k = 0; k < 2; k++)
        ck_assert_double_eq_tol((double)beyond[k] / marks.count, 0.5, 0.01);
}
END_TEST

static Suite *suite(void)
{
    Suite *made = suite_create("marks");
    TCase *tests = tcase_create("marks");
    tcase_add_checked_fixture(tests, begin, end);
    tcase_add_test(tests, marks_lie_evenly_along_directions);
    tcase_add_test(tests, marks_are_no_more_than_there_is_room_for);
    suite_add_tcase(made, tests);
    return made;
}

HATCH_TEST_MAIN(suite)
