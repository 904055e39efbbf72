/* Curvature of a surface from a simplified mesh, face by face. */
#include "curvature_make.h"

static struct hatch_curvature transfer(const struct field_case *fine, const struct field_case *coarse)
{
    struct hatch_curvature found;
    HATCH_TEST_OK(hatch_curvature_coarse(&fine->surface, &fine->frames, &coarse->mesh, &keep, &scratch, &found, &err),
                  &err);
    return found;
}

static void copy_point(const struct hatch_surface *surface, uint32_t face, size_t corner, double at[3])
{
    hatch_surface_position(surface, surface->corners[3 * (size_t)face + corner], at);
}

/* Returns the radius of a face's neighbourhood, and its centre and normal. */
static double radius_of(const struct hatch_surface *surface, uint32_t face, double center[3], double normal[3])
{
    double at[3][3], other[3], radius = 0;
    for (size_t c = 0; c < 3; c++)
        copy_point(surface, face, c, at[c]);
    for (size_t k = 0; k < 3; k++)
        center[k] = (at[0][k] + at[1][k] + at[2][k]) / 3;
    hatch_vec_triangle(at[0], at[1], at[2], normal);
    for (uint32_t f = 0; f < surface->face_count; f++) /* all points of the faces around the three corners */
        for (size_t i = 0; i < 9; i++)
            if (surface->corners[3 * (size_t)f + i / 3] == surface->corners[3 * (size_t)face + i % 3])
                for (size_t c = 0; c < 3; c++) {
                    copy_point(surface, f, c, other);
                    radius = fmax(radius, hatch_vec_distance(other, center));
                }
    return radius;
}

/* The radius tells which face of the simplified mesh a point has its curvature from. */
START_TEST(points_have_the_curvature_of_the_nearest_face)
{
    struct field_case fine = case_of_shape(HATCH_SHAPE_TORUS, 1200, 1);
    struct field_case coarse = case_of_shape(HATCH_SHAPE_TORUS, 160, 1);
    struct hatch_curvature found = transfer(&fine, &coarse);
    double scale = fine.surface.components[0].scale;
    for (uint32_t p = 0; p < fine.surface.point_count; p++) {
        double at[3], center[3], normal[3], least = INFINITY, radius = 0;
        hatch_surface_position(&fine.surface, p, at);
        for (uint32_t f = 0; f < coarse.surface.face_count; f++) {
            double reach = radius_of(&coarse.surface, f, center, normal), distance = hatch_vec_distance(center, at);
            distance *= hatch_vec_dot(normal, &fine.frames.normal[3 * (size_t)p]) > 0 ? 1 : 3;
            radius = distance < least ? reach : radius;
            least = fmin(least, distance);
        }
        ck_assert_double_eq_tol(found.radius[p], radius / scale, 1e-9);
    }
}
END_TEST

/* The curvatures change their sign with the side, and so does the normal that they are seen from. */
START_TEST(the_side_of_the_simplified_mesh_does_not_matter)
{
    struct field_case fine = case_of_shape(HATCH_SHAPE_WAVE, 1200, 1), coarse = case_of_shape(HATCH_SHAPE_WAVE, 200, 1);
    struct hatch_curvature found = transfer(&fine, &coarse);
    for (size_t f = 0; f < coarse.mesh.face_count; f++) {
        uint32_t *corner = &coarse.mesh.indices[3 * f], second = corner[1];
        corner[1] = corner[2];
        corner[2] = second;
    }
    struct hatch_curvature turned = transfer(&fine, &coarse);
    uint32_t curved = 0;
    for (size_t i = 0; i < 2 * (size_t)fine.surface.point_count; i++) {
        ck_assert_double_eq_tol(turned.value[i], found.value[i], 1e-6);
        curved += fabs(found.value[i]) > 0.1;
    }
    ck_assert_uint_gt(curved, 100);
}
END_TEST

/* Six points determine a quadric without telling how well: four around and two above and below. Of seven, one is
 * left. */
START_TEST(six_points_have_no_confidence)
{
    for (uint32_t around = 4; around <= 5; around++) {
        float positions[21] = {0, 0, 1, 0, 0, -1};
        uint32_t faces[30];
        for (uint32_t i = 0; i < around; i++) {
            uint32_t next = 2 + (i + 1) % around;
            double radius = 1 + 0.3 * i; /* points on a conic would determine no quadric */
            positions[3 * (2 + i)] = (float)(radius * cos(2 * PI * i / around));
            positions[3 * (2 + i) + 1] = (float)(radius * sin(2 * PI * i / around));
            memcpy(&faces[6 * (size_t)i], (uint32_t[6]){0, 2 + i, next, 1, next, 2 + i}, 6 * sizeof *faces);
        }
        struct field_case coarse = case_of(mesh_of(positions, 2 + around, faces, 2 * around));
        struct field_case fine = case_of_shape(HATCH_SHAPE_SPHERE, 100, 1);
        struct hatch_curvature found = transfer(&fine, &coarse);
        uint32_t fitted = 0;
        for (uint32_t p = 0; p < fine.surface.point_count; p++) {
            if (around == 4) {
                ck_assert_double_eq(found.confidence[p], 0);
                ck_assert_double_eq(found.standard_error_rad[p], atan(1));
            }
            fitted += found.value[2 * (size_t)p] != 0;
        }
        ck_assert_uint_eq(fitted, around == 4 ? 0 : fine.surface.point_count);
    }
}
END_TEST

/* A cylinder's directions are certain, a plane's are not. */
START_TEST(confidence_tells_whether_the_directions_differ)
{
    struct field_case fine = case_of_shape(HATCH_SHAPE_CYLINDER, 1000, 0);
    struct field_case coarse = case_of_shape(HATCH_SHAPE_CYLINDER, 400, 0);
    struct hatch_curvature found = transfer(&fine, &coarse);
    for (uint32_t p = 0; p < fine.surface.point_count; p++) {
        ck_assert_double_gt(found.confidence[p], 0.9);
        ck_assert_double_lt(found.standard_error_rad[p], 0.1);
    }
    fine = case_of_shape(HATCH_SHAPE_PLANE, 100, 0);
    coarse = case_of_shape(HATCH_SHAPE_PLANE, 50, 0);
    found = transfer(&fine, &coarse);
    for (uint32_t p = 0; p < fine.surface.point_count; p++)
        ck_assert_double_lt(found.confidence[p], 1e-3);
}
END_TEST

static Suite *suite(void)
{
    Suite *suite = suite_create("curvature coarse");
    TCase *tests = tcase_create("coarse");
    tcase_add_checked_fixture(tests, begin, end);
    tcase_add_test(tests, points_have_the_curvature_of_the_nearest_face);
    tcase_add_test(tests, the_side_of_the_simplified_mesh_does_not_matter);
    tcase_add_test(tests, six_points_have_no_confidence);
    tcase_add_test(tests, confidence_tells_whether_the_directions_differ);
    suite_add_tcase(suite, tests);
    return suite;
}
HATCH_TEST_MAIN(suite)
