#include <math.h>
#include <string.h>

#include "math/vector.h"
#include "meshes.h"
#include "surface_check.h"
#include "curvature/curvature.h"

/* Two squares that meet at a dihedral angle, along points 2 and 3. */
static struct hatch_mesh roof(double degrees)
{
    double turn = degrees * 3.14159265358979323846 / 180;
    const float at[6][3] = {{-1, 0, 0},
                            {-1, 1, 0},
                            {0, 0, 0},
                            {0, 1, 0},
                            {(float)cos(turn), 0, -(float)sin(turn)},
                            {(float)cos(turn), 1, -(float)sin(turn)}};
    static const uint32_t corners[12] = {0, 2, 3, 0, 3, 1, 2, 4, 5, 2, 5, 3};
    return mesh_of(at[0], 6, corners, 4);
}

/* Counts the points whose confidence is set to 0. */
static uint32_t count_cleared(const struct hatch_mesh *mesh)
{
    double confidence[32];
    struct hatch_curvature curvature = {.confidence = confidence};
    uint32_t count = 0;
    struct hatch_surface surface = surface_of(mesh);
    ck_assert_uint_le(surface.point_count, 32);
    for (uint32_t p = 0; p < surface.point_count; p++)
        confidence[p] = 0.5;
    hatch_curvature_clear_crease_confidence(&surface, 3.14159265358979323846 / 3, &curvature);
    for (uint32_t p = 0; p < surface.point_count; p++) {
        double position[3];
        hatch_surface_position(&surface, p, position);
        bool on_ridge = fabs(position[0]) < 1e-9;
        ck_assert(confidence[p] == 0.5 || (on_ridge && confidence[p] == 0));
        count += confidence[p] == 0;
    }
    return count;
}

START_TEST(only_creases_lose_confidence)
{
    static const double sharp[] = {61, 90, 150, -61, -90}, soft[] = {0, 45, 59, -59};
    for (size_t i = 0; i < sizeof sharp / sizeof *sharp; i++) {
        struct hatch_mesh mesh = roof(sharp[i]);
        ck_assert_uint_eq(count_cleared(&mesh), 2);
    }
    for (size_t i = 0; i < sizeof soft / sizeof *soft; i++) {
        struct hatch_mesh mesh = roof(soft[i]);
        ck_assert_uint_eq(count_cleared(&mesh), 0);
    }
}
END_TEST

/* A Möbius strip has a contrary edge; the dihedral angles of this one are small. */
START_TEST(a_contrary_edge_is_no_crease)
{
    struct hatch_mesh mesh;
    HATCH_TEST_OK(hatch_mesh_make(&keep, 24, 24, &mesh, &err), &err);
    for (uint32_t i = 0; i < 12; i++)
        for (uint32_t side = 0; side < 2; side++) {
            double a = i * 3.14159265358979323846 / 6, across = side ? 0.2 : -0.2, r = 3 + across * cos(a / 2);
            float *at = &mesh.attributes[0].data[(size_t)(2 * i + side) * 3];
            at[0] = (float)(r * cos(a));
            at[1] = (float)(r * sin(a));
            at[2] = (float)(across * sin(a / 2));
        }
    for (uint32_t i = 0; i < 12; i++) {
        uint32_t a = 2 * i, b = a + 1, c = i < 11 ? a + 2 : 1, d = i < 11 ? a + 3 : 0;
        const uint32_t corners[6] = {a, c, d, a, d, b};
        memcpy(&mesh.indices[(size_t)i * 6], corners, sizeof corners);
    }
    ck_assert_uint_eq(count_cleared(&mesh), 0);
}
END_TEST

/* Both squares of a right-angled roof are planes, bounded by hard edges and borders. Whatever was measured at their
 * points, in the end these have the planes' normals and directions. */
START_TEST(points_of_planes_have_their_normal_and_direction)
{
    double direction[24], value[16], confidence[8] = {0}, error[8], normal[24];
    struct hatch_curvature curvature = {.direction = direction,
                                        .value = value,
                                        .confidence = confidence,
                                        .standard_error_rad = error,
                                        .normal = normal};
    struct hatch_mesh mesh = roof(90);
    struct hatch_surface surface;
    HATCH_TEST_OK(hatch_surface_make_cut(&mesh, &keep, &scratch, &surface, &notes, &err), &err);
    ck_assert_uint_eq(surface.point_count, 8);
    for (int i = 0; i < 24; i++)
        normal[i] = 0.5;
    hatch_curvature_set_planes(&surface, &curvature);
    for (uint32_t i = 0; i < 3 * surface.face_count; i++) {
        uint32_t p = surface.corners[i];
        double face[3];
        hatch_surface_face_normal(&surface, i / 3, face);
        ck_assert_double_eq_tol(fabs(hatch_vec_dot(face, &normal[3 * p])), hatch_vec_length(face), 1e-12);
        ck_assert_double_eq_tol(hatch_vec_dot(&normal[3 * p], &direction[3 * p]), 0, 1e-12);
        ck_assert_double_eq(confidence[p], 1);
    }
}
END_TEST

static Suite *suite(void)
{
    Suite *made = suite_create("creases");
    TCase *tests = tcase_create("creases");
    tcase_add_checked_fixture(tests, begin, end);
    tcase_add_test(tests, only_creases_lose_confidence);
    tcase_add_test(tests, a_contrary_edge_is_no_crease);
    tcase_add_test(tests, points_of_planes_have_their_normal_and_direction);
    suite_add_tcase(made, tests);
    return made;
}

HATCH_TEST_MAIN(suite)
