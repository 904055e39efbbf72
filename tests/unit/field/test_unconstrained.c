#include <math.h>

#include "meshes.h"
#include "surface_check.h"
#include "field/field.h"

static struct hatch_surface surface;
static struct hatch_frames frames;
static double *direction, *confidence;
static bool filled[4];

/* Makes a shape, stretched along x, without data. */
static void make(enum hatch_shape shape, float longer)
{
    struct hatch_mesh mesh = shape_of(shape, 600);
    for (uint32_t v = 0; v < mesh.vertex_count; v++)
        mesh.attributes[0].data[3 * v] *= longer;
    surface = surface_of(&mesh);
    HATCH_TEST_OK(hatch_frames_make(&surface, &keep, &scratch, &frames, &err), &err);
    direction = HATCH_NEW(&keep, double, 3 * (size_t)surface.point_count, &err);
    confidence = HATCH_NEW(&keep, double, surface.point_count, &err);
    ck_assert(direction && confidence);
}

static void expect_directions_along(int axis)
{
    for (uint32_t p = 0; p < surface.point_count; p++) {
        ck_assert_double_gt(confidence[p], 0);
        for (int k = 0; k < 3; k++)
            ck_assert_double_eq_tol(fabs(direction[3 * p + (uint32_t)k]), k == axis, 1e-9);
    }
}

START_TEST(directions_lie_across_the_longest_side)
{
    make(HATCH_SHAPE_PLANE, 3);
    hatch_field_fill_unconstrained(&surface, &frames, NULL, direction, confidence, filled);
    ck_assert(filled[0]);
    expect_directions_along(1);
}
END_TEST

START_TEST(of_equal_sides_y_is_the_longest)
{
    make(HATCH_SHAPE_PLANE, 1);
    hatch_field_fill_unconstrained(&surface, &frames, NULL, direction, confidence, filled);
    expect_directions_along(0);
    make(HATCH_SHAPE_SPHERE, 1);
    hatch_field_fill_unconstrained(&surface, &frames, NULL, direction, confidence, filled);
    for (uint32_t p = 0; p < surface.point_count; p++)
        ck_assert_double_eq_tol(direction[3 * p + 1], 0, 1e-9);
}
END_TEST

START_TEST(components_with_data_are_not_filled)
{
    make(HATCH_SHAPE_TORUS, 1);
    for (uint32_t p = 0; p < surface.point_count; p++)
        confidence[p] = 0.5;
    hatch_field_fill_unconstrained(&surface, &frames, NULL, direction, confidence, filled);
    ck_assert(!filled[0]);
    ck_assert_double_eq(confidence[1], 0.5);
    make(HATCH_SHAPE_PLANE, 1); /* a single constraint is data */
    double *constraint_weight = HATCH_NEW(&keep, double, surface.point_count, &err);
    ck_assert_ptr_nonnull(constraint_weight);
    constraint_weight[3] = 1;
    hatch_field_fill_unconstrained(&surface, &frames, constraint_weight, direction, confidence, filled);
    ck_assert(!filled[0]);
    ck_assert_double_eq(confidence[1], 0);
}
END_TEST

START_TEST(filled_components_have_no_confidence)
{
    static const bool both[2] = {true, false};
    struct hatch_component components[2] = {{.point_count = 2}, {.first_point = 2, .point_count = 2}};
    const struct hatch_surface two = {.component_count = 2, .components = components};
    double of_field[4] = {0.7, 0.7, 0.7, 0.7};
    struct hatch_field field = {.confidence = of_field};
    hatch_field_clear_filled_confidence(&two, both, &field);
    ck_assert_uint_eq(field.unconstrained, 1);
    ck_assert(of_field[0] == 0 && of_field[1] == 0);
    ck_assert(of_field[2] == 0.7 && of_field[3] == 0.7);
}
END_TEST

static Suite *suite(void)
{
    Suite *made = suite_create("unconstrained components");
    TCase *tests = tcase_create("unconstrained");
    tcase_add_checked_fixture(tests, begin, end);
    tcase_add_test(tests, directions_lie_across_the_longest_side);
    tcase_add_test(tests, of_equal_sides_y_is_the_longest);
    tcase_add_test(tests, components_with_data_are_not_filled);
    tcase_add_test(tests, filled_components_have_no_confidence);
    suite_add_tcase(made, tests);
    return made;
}

HATCH_TEST_MAIN(suite)
