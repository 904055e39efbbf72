/* Inputs on which hidden lines fail in renderers that sample depth: surfaces that touch or coincide, needles, faces
 * seen edge-on, a camera in the midst of faces; and paths without extent or in great numbers at one place. */
#include "base/random.h"
#include "lines.h"
#include "occluders.h"
#include "vector/tidy/tidy.h"
#include "views.h"

static struct hatch_vector_paths visible, hidden;

static void see_line(const double *points, const uint32_t *faces)
{
    static const struct hatch_vector_curve curve = {.count = 2};
    static const float slack[2] = {1e-6f, 0};
    const struct hatch_vector_curves curves = {
        .count = 1, .curves = &curve, .points = points, .faces = faces, .slack = slack};
    see(&curves, &visible, &hidden);
}

/* Squares in one plane: the line on them is visible, whichever face it is said to lie on, and however they overlap. */
START_TEST(sheets_that_touch_do_not_hide_what_is_drawn_on_them)
{
    struct hatch_mesh sheet = shape_of(HATCH_SHAPE_PLANE, 2), other = shape_of(HATCH_SHAPE_PLANE, 50);
    for (int turn = 0; turn < 2; turn++) {
        struct hatch_mesh both = joined(&sheet, &other, turn ? -0.7 : 0.7, (const double[3]){0.1, 0.05, 0});
        struct hatch_view view = turn ? view_from(1, 2, 3, false) : view_facing;
        hide_behind(&both, &view);
        for (uint32_t face = 0; face < both.face_count; face += 7) {
            see_line((const double[]){-0.8, -0.31, 0, 0.77, 0.29, 0}, (const uint32_t[]){face, face});
            ck_assert_uint_eq(hidden.count, 0);
            ck_assert_uint_eq(visible.count, 1);
        }
    }
}
END_TEST

START_TEST(a_sheet_just_behind_another_is_hidden)
{
    struct hatch_mesh front = shape_of(HATCH_SHAPE_PLANE, 50);
    hide_behind(&front, &view_facing);
    see_line((const double[]){-0.8, -0.31, -1e-5, 0.77, 0.29, -1e-5}, NULL);
    ck_assert_uint_eq(visible.count, 0);
    ck_assert_uint_eq(hidden.count, 1);
}
END_TEST

/* There is no gap where thousands of thin faces meet in one point. */
START_TEST(a_fan_of_needles_has_no_gaps)
{
    uint32_t count = 3000;
    struct hatch_mesh fan;
    HATCH_TEST_OK(hatch_mesh_make(&keep, count + 1, count, &fan, &err), &err);
    for (uint32_t i = 0; i < count; i++) {
        double angle = 2 * 3.14159265358979 * i / count;
        float *at = &fan.attributes[0].data[3 * (i + 1)];
        at[0] = (float)(0.9 * cos(angle));
        at[1] = (float)(0.9 * sin(angle));
        const uint32_t corners[3] = {0, i + 1, (i + 1) % count + 1};
        memcpy(&fan.indices[3 * i], corners, sizeof corners);
    }
    hide_behind(&fan, &view_facing);
    for (uint32_t i = 0; i < 50; i++) {
        double a = 6.28 * (double)hatch_random_unit(1, 0, i), b = 6.28 * (double)hatch_random_unit(1, 1, i);
        see_line((const double[]){0.8 * cos(a), 0.8 * sin(a), -0.5, 0.8 * cos(b), 0.8 * sin(b), -0.5}, NULL);
        ck_assert_uint_eq(visible.count, 0);
    }
    see_line((const double[]){-0.8, 0, -0.5, 0.8, 0, -0.5}, NULL); /* through the point, along edges */
    ck_assert_uint_eq(visible.count, 0);
}
END_TEST

/* A plane seen edge-on hides nothing, and lines on it are visible. */
START_TEST(faces_seen_edge_on_hide_nothing)
{
    struct hatch_mesh plane = shape_of(HATCH_SHAPE_PLANE, 50);
    for (uint32_t v = 0; v < plane.vertex_count; v++) {
        float *at = &plane.attributes[0].data[3 * v];
        at[2] = at[0];
        at[0] = 0;
    }
    hide_behind(&plane, &view_facing);
    see_line((const double[]){-0.5, 0.1, -1, 0.5, 0.2, -1}, NULL);
    ck_assert_uint_eq(hidden.count, 0);
    see_line((const double[]){0, 0.1, -0.5, 0, 0.2, 0.5}, NULL);
    ck_assert_uint_eq(hidden.count, 0);
}
END_TEST

/* From the middle of a sphere every point inside is visible, and none outside. */
START_TEST(a_camera_inside_sees_what_is_inside)
{
    struct hatch_mesh ball = shape_of(HATCH_SHAPE_SPHERE, 2000);
    struct hatch_view view = view_from(0.1, 0.05, 0.1, false);
    view.near = 1e-6;
    hide_behind(&ball, &view);
    for (uint32_t i = 0; i < 100; i++) {
        double p[6], out[6];
        for (uint32_t k = 0; k < 2; k++) {
            for (uint32_t j = 0; j < 3; j++)
                p[3 * k + j] = (double)hatch_random_unit(2, 3 * k + j, i) - 0.5;
            hatch_vec_normalize(p + 3 * k);
            for (uint32_t j = 0; j < 3; j++) {
                out[3 * k + j] = 1.9 * p[3 * k + j];
                p[3 * k + j] *= 0.9;
            }
        }
        see_line(p, NULL);
        ck_assert_uint_eq(hidden.count, 0);
        double middle[3] = {out[0] + out[3], out[1] + out[4], out[2] + out[5]};
        if (hatch_vec_length(middle) < 2.2)
            continue; /* it passes through the sphere */
        see_line(out, NULL);
        ck_assert_uint_eq(visible.count, 0);
    }
}
END_TEST

START_TEST(a_scene_without_faces_hides_nothing)
{
    struct hatch_mesh none = mesh_of((const float[]){0, 0, 0}, 1, (const uint32_t[]){0}, 0);
    hide_behind(&none, &view_facing);
    see_line((const double[]){-0.5, 0.1, -1, 0.5, 0.2, -1}, NULL);
    ck_assert_uint_eq(visible.count, 1);
}
END_TEST

/* Points that coincide, and thousands of paths that end at one place, take little time. */
START_TEST(many_paths_at_one_place_are_tidied)
{
    struct hatch_vector_builder builder = hatch_vector_builder_of(&keep);
    for (uint32_t i = 0; i < 2400; i++) {
        double angle = 2 * 3.14159265358979 * i / 2400;
        hatch_vector_begin(&builder, &(struct hatch_vector_path){.id = i});
        HATCH_TEST_OK(hatch_vector_add(&builder, (const double[]){0, 0}, &err), &err);
        if (i % 3)
            HATCH_TEST_OK(hatch_vector_add(&builder, (const double[]){cos(angle), sin(angle)}, &err), &err);
        HATCH_TEST_OK(hatch_vector_end(&builder, false, &err), &err);
    }
    struct hatch_vector_paths paths = hatch_vector_built(&builder), single, joined;
    HATCH_TEST_OK(hatch_vector_drop_doubles(&paths, NULL, 1e-4, &keep, &scratch, &single, &err), &err);
    HATCH_TEST_OK(hatch_vector_join(&single, 1e-4, &keep, &scratch, &joined, &err), &err);
    ck_assert_uint_lt(joined.count, 2000);
    HATCH_TEST_OK(hatch_vector_simplify(&joined, 1e-3, 1e-9, &scratch, &err), &err);
    HATCH_TEST_OK(hatch_vector_sort(&joined, HATCH_VECTOR_IMPROVED, &scratch, &err), &err);
}
END_TEST

static Suite *suite(void)
{
    Suite *suite = suite_create("vector limits");
    TCase *tests = tcase_create("limits");
    tcase_add_checked_fixture(tests, begin, end);
    tcase_add_test(tests, sheets_that_touch_do_not_hide_what_is_drawn_on_them);
    tcase_add_test(tests, a_sheet_just_behind_another_is_hidden);
    tcase_add_test(tests, a_fan_of_needles_has_no_gaps);
    tcase_add_test(tests, faces_seen_edge_on_hide_nothing);
    tcase_add_test(tests, a_camera_inside_sees_what_is_inside);
    tcase_add_test(tests, a_scene_without_faces_hides_nothing);
    tcase_add_test(tests, many_paths_at_one_place_are_tidied);
    suite_add_tcase(suite, tests);
    return suite;
}
HATCH_TEST_MAIN(suite)
