#include <math.h>
#include <string.h>

#include "fail_alloc.h"
#include "measure/field_figures.h"
#include "meshes.h"

static struct hatch_mesh shape(enum hatch_shape kind, bool field)
{
    return shape_with(kind, (struct hatch_shape_options){.faces = 2000, .jitter = 0.5f, .seed = 3, .field = field});
}

/* A plane with a constant field, at an angle to x, the direction of rising u. */
static struct hatch_mesh plane(double degrees)
{
    struct hatch_mesh mesh = shape(HATCH_SHAPE_PLANE, false);
    float *field;
    HATCH_TEST_OK(hatch_mesh_add(&keep, &mesh, "_HATCH_DIR", 4, &field, &err), &err);
    for (uint32_t v = 0; v < mesh.vertex_count; v++) {
        field[4 * v] = (float)cos(degrees * PI / 180);
        field[4 * v + 1] = (float)sin(degrees * PI / 180);
        field[4 * v + 3] = 1;
    }
    return mesh;
}

static struct hatch_field_figures measure(const struct hatch_mesh *mesh, const struct hatch_mesh *reference,
                                          double share)
{
    struct hatch_field_sum sum = {.arena = &keep, .scratch = &scratch};
    struct hatch_field_figures figures;
    HATCH_TEST_OK(hatch_measure_field_add(&sum, mesh, reference, &err), &err);
    HATCH_TEST_OK(hatch_measure_field_end(&sum, share, &figures, &err), &err);
    return figures;
}

START_TEST(a_rotated_field_has_the_rotation_as_error)
{
    struct hatch_mesh a = plane(45), b = plane(0), c = plane(170);
    struct hatch_field_figures f = measure(&a, &b, 1);
    ck_assert_uint_eq(f.compared, f.points);
    for (int i = 0; i < 4; i++)
        ck_assert_double_eq_tol(f.degrees[i], 45, 1e-5);
    f = measure(&c, &b, 1);
    ck_assert_double_eq_tol(f.degrees[3], 10, 1e-5); /* lines have no sign */
}
END_TEST

START_TEST(the_angle_to_rising_u_is_measured)
{
    struct hatch_mesh a = plane(0), b = plane(-30);
    ck_assert_double_eq_tol(measure(&a, NULL, 1).uv_degrees[2], 0, 1e-4);
    ck_assert_double_eq_tol(measure(&b, NULL, 1).uv_degrees[0], 30, 1e-4);
    for (uint32_t i = 0; i < b.attribute_count; i++)
        if (strcmp(b.attributes[i].name, "TEXCOORD_0") == 0)
            b.attributes[i].name[0] = '_';
    ck_assert_ptr_null(hatch_mesh_find(&b, "TEXCOORD_0", 2));
    ck_assert(isnan(measure(&b, NULL, 1).uv_degrees[0]));
}
END_TEST

START_TEST(a_constant_field_is_smooth_without_singularities)
{
    struct hatch_mesh mesh = plane(20);
    struct hatch_field_figures f = measure(&mesh, NULL, 1);
    ck_assert_double_eq_tol(f.smoothness, 0, 1e-9);
    ck_assert_uint_eq(f.singularities, 0);
    ck_assert_int_eq(f.euler, 1);
    ck_assert_double_eq(f.index_sum, 1);
    ck_assert_uint_eq(f.compared, 0);
    ck_assert(isnan(f.degrees[0]));
}
END_TEST

/* Lines at half the polar angle around a position inside a face: index 1/2; the border contributes the other half. */
START_TEST(singularities_are_counted)
{
    struct hatch_mesh mesh = plane(0);
    float *field = hatch_mesh_find(&mesh, "_HATCH_DIR", 4), *at = mesh.attributes[0].data;
    for (uint32_t v = 0; v < mesh.vertex_count; v++) {
        double angle = atan2((double)at[3 * v + 1] - 0.013, (double)at[3 * v] - 0.017) / 2;
        field[4 * v] = (float)cos(angle);
        field[4 * v + 1] = (float)sin(angle);
    }
    struct hatch_field_figures f = measure(&mesh, NULL, 1);
    ck_assert_uint_eq(f.singularities, 1);
    ck_assert_double_eq(f.index_sum, 1);
    ck_assert(f.smoothness > 1);
    for (uint32_t i = 0; i < 3 * mesh.vertex_count; i++)
        at[i] *= 1000;
    ck_assert_double_eq_tol(measure(&mesh, NULL, 1).smoothness, f.smoothness, 1e-4);
}
END_TEST

START_TEST(indices_sum_to_the_euler_characteristic)
{
    struct hatch_mesh ellipsoid = shape(HATCH_SHAPE_ELLIPSOID, true), torus = shape(HATCH_SHAPE_TORUS, true);
    struct hatch_field_sum sum = {.arena = &keep, .scratch = &scratch};
    struct hatch_field_figures f = measure(&ellipsoid, &ellipsoid, 1);
    ck_assert_uint_eq(f.singularities, 4);
    ck_assert_double_eq(f.index_sum, 2);
    ck_assert_double_eq_tol(f.degrees[3], 0, 1e-5);
    f = measure(&torus, NULL, 1);
    ck_assert_uint_eq(f.singularities, 0);
    ck_assert_double_eq(f.index_sum, 0);
    HATCH_TEST_OK(hatch_measure_field_add(&sum, &torus, NULL, &err), &err);
    HATCH_TEST_OK(hatch_measure_field_add(&sum, &ellipsoid, NULL, &err), &err);
    HATCH_TEST_OK(hatch_measure_field_end(&sum, 1, &f, &err), &err);
    ck_assert_int_eq(f.euler, 2);
    ck_assert_uint_eq(f.components, 2);
    ck_assert_uint_eq(f.singularities, 4);
}
END_TEST

START_TEST(only_the_most_confident_share_is_compared)
{
    struct hatch_mesh a = plane(0), b = plane(10);
    float *field = hatch_mesh_find(&b, "_HATCH_DIR", 4);
    uint32_t confident = 0;
    for (uint32_t v = 0; v < b.vertex_count; v++) {
        bool is_confident = v % 4 == 0;
        confident += is_confident;
        field[4 * v + 3] = is_confident ? 0.9f : v % 4 == 1 ? 0.0f : 0.2f;
        field[4 * v] = is_confident ? field[4 * v] : 0.0f;
    }
    struct hatch_field_figures f = measure(&a, &b, 1);
    ck_assert_double_eq_tol(f.degrees[3], 90, 1e-4);
    ck_assert_uint_lt(f.compared, f.points); /* those of confidence 0 are not compared */
    double share = (double)confident / (double)f.compared - 0.001;
    f = measure(&a, &b, share);
    ck_assert_uint_eq(f.compared, confident);
    ck_assert_double_eq_tol(f.degrees[3], 10, 1e-4);
}
END_TEST

/* Half of the lines are off by 10 degrees, half by 80; all are equally confident. */
START_TEST(equal_confidences_all_count_and_axes_are_interchangeable)
{
    struct hatch_mesh a = plane(0), b = plane(10), across = plane(80);
    float *field = hatch_mesh_find(&b, "_HATCH_DIR", 4), *other = hatch_mesh_find(&across, "_HATCH_DIR", 4);
    for (uint32_t v = 0; v < b.vertex_count; v += 2)
        memcpy(&field[4 * v], &other[4 * v], 4 * sizeof *field);
    struct hatch_field_figures all = measure(&a, &b, 1), some = measure(&a, &b, 0.1);
    ck_assert_uint_eq(some.compared, all.compared);
    ck_assert_double_eq_tol(some.degrees[3], 80, 1e-4);
    ck_assert_double_eq_tol(some.axis_degrees[0], 10, 1e-4);
    ck_assert_double_eq_tol(some.axis_degrees[1], 10, 1e-4);
}
END_TEST

START_TEST(points_are_matched_by_position_else_by_number)
{
    struct hatch_mesh a = plane(0), b = plane(0), few = shape(HATCH_SHAPE_TORUS, true);
    struct hatch_field_sum sum = {.arena = &keep, .scratch = &scratch};
    float *field = hatch_mesh_find(&b, "_HATCH_DIR", 4), *at = b.attributes[0].data;
    uint32_t last = b.vertex_count - 1;
    field[4 * last] = 0; /* one vertex's line is at 90 degrees */
    field[4 * last + 1] = 1;
    for (int k = 0; k < 4; k++) { /* renumber that vertex */
        float swapped = field[k];
        field[k] = field[4 * last + (uint32_t)k];
        field[4 * last + (uint32_t)k] = swapped;
    }
    for (int k = 0; k < 3; k++) {
        float swapped = at[k];
        at[k] = at[3 * last + (uint32_t)k];
        at[3 * last + (uint32_t)k] = swapped;
    }
    for (uint32_t i = 0; i < 3 * b.face_count; i++)
        b.indices[i] = b.indices[i] == 0 ? last : b.indices[i] == last ? 0 : b.indices[i];
    struct hatch_field_figures f = measure(&a, &b, 1);
    ck_assert_double_eq_tol(f.degrees[3], 90, 1e-4);
    ck_assert_double_eq_tol(f.degrees[2], 0, 1e-4);
    for (uint32_t v = 0; v < last; v++) /* one position remains common: too few to match by position */
        at[3 * v + 2] += 0.01f;
    f = measure(&a, &b, 1);
    ck_assert_uint_eq(f.compared, f.points);
    ck_assert_double_eq_tol(f.degrees[3], 90, 1e-4);
    ck_assert_int_eq(hatch_measure_field_add(&sum, &a, &few, &err), HATCH_BAD_INPUT);
    ck_assert_ptr_nonnull(strstr(err.text, "no point coincides with one of the reference, and there are"));
}
END_TEST

/* The angle of the lines rises along x. The other mesh has the same vertices in reverse order. */
START_TEST(the_order_of_the_vertices_does_not_matter)
{
    struct hatch_mesh a = plane(0), b = plane(0);
    float *field = hatch_mesh_find(&a, "_HATCH_DIR", 4), *other = hatch_mesh_find(&b, "_HATCH_DIR", 4);
    const float *at = a.attributes[0].data;
    uint32_t last = a.vertex_count - 1;
    for (uint32_t v = 0; v <= last; v++) {
        field[4 * v] = cosf(at[3 * v]);
        field[4 * v + 1] = sinf(at[3 * v]);
        memcpy(&other[4 * (last - v)], &field[4 * v], 4 * sizeof *field);
        memcpy(&b.attributes[0].data[3 * (last - v)], &at[3 * v], 3 * sizeof *at);
    }
    for (uint32_t i = 0; i < 3 * b.face_count; i++)
        b.indices[i] = last - b.indices[i];
    struct hatch_field_figures f = measure(&b, &a, 1);
    ck_assert_uint_eq(f.compared, f.points);
    ck_assert_double_eq_tol(f.degrees[3], 0, 1e-4);
    for (uint32_t v = 0; v <= last; v++) /* by number, lines of other places are compared */
        a.attributes[0].data[3 * v + 2] += 1;
    f = measure(&b, &a, 1);
    ck_assert_uint_eq(f.compared, f.points);
    ck_assert_double_gt(f.degrees[3], 10);
}
END_TEST

START_TEST(a_mesh_without_a_field_is_refused)
{
    struct hatch_mesh mesh = shape(HATCH_SHAPE_PLANE, false), with_field = plane(0);
    struct hatch_field_sum sum = {.arena = &keep, .scratch = &scratch};
    ck_assert_int_eq(hatch_measure_field_add(&sum, &mesh, NULL, &err), HATCH_BAD_INPUT);
    ck_assert_ptr_nonnull(strstr(err.text, "_HATCH_DIR"));
    ck_assert(!sum.reference_failed);
    ck_assert_int_eq(hatch_measure_field_add(&sum, &with_field, &mesh, &err), HATCH_BAD_INPUT);
    ck_assert(sum.reference_failed && strstr(err.text, "_HATCH_DIR"));
}
END_TEST

static enum hatch_status call(void *context, struct hatch_arena *arena, struct hatch_arena *work,
                              struct hatch_err *error)
{
    static struct hatch_field_figures unused;
    struct hatch_field_sum sum = {.arena = arena, .scratch = work};
    HATCH_TRY(hatch_measure_field_add(&sum, context, context, error));
    return hatch_measure_field_end(&sum, 0.5, &unused, error);
}

START_TEST(figures_survive_every_failed_allocation)
{
    struct hatch_mesh mesh = plane(0);
    hatch_test_fail_alloc(call, &mesh, NULL, 0);
}
END_TEST

static Suite *suite(void)
{
    Suite *made = suite_create("measure field");
    TCase *tests = tcase_create("field");
    tcase_add_checked_fixture(tests, begin, end);
    tcase_add_test(tests, a_rotated_field_has_the_rotation_as_error);
    tcase_add_test(tests, the_angle_to_rising_u_is_measured);
    tcase_add_test(tests, a_constant_field_is_smooth_without_singularities);
    tcase_add_test(tests, singularities_are_counted);
    tcase_add_test(tests, indices_sum_to_the_euler_characteristic);
    tcase_add_test(tests, only_the_most_confident_share_is_compared);
    tcase_add_test(tests, equal_confidences_all_count_and_axes_are_interchangeable);
    tcase_add_test(tests, points_are_matched_by_position_else_by_number);
    tcase_add_test(tests, the_order_of_the_vertices_does_not_matter);
    tcase_add_test(tests, a_mesh_without_a_field_is_refused);
    tcase_add_test(tests, figures_survive_every_failed_allocation);
    suite_add_tcase(made, tests);
    return made;
}

HATCH_TEST_MAIN(suite)
