/* The interactive camera: what turns, pans and steps of the zoom do to the eye and to the picture. */
#include "math/vector.h"
#include "run.h"
#include "view/orbit_control.h"

static const double quarter = 1.57079632679489662;

/* A view that looks at (1, 2, 3) from a distance of 4 along z. */
static struct hatch_view view_along_z(bool orthographic)
{
    struct hatch_view view = {.eye = {1, 2, 7},
                              .orthographic = orthographic,
                              .half_height = 0.5,
                              .aspect = 1.5,
                              .near = 0.1,
                              .far = 20,
                              .finite = true,
                              .pivot = 4};
    hatch_view_set_back(&view, (const double[3]){0, 0, 1});
    return view;
}

static struct hatch_orbit orbit_along_z(bool orthographic)
{
    const struct hatch_view view = view_along_z(orthographic);
    struct hatch_orbit orbit;
    hatch_orbit_start(&orbit, &view);
    return orbit;
}

static void check_at(const double at[3], double x, double y, double z)
{
    ck_assert_double_eq_tol(at[0], x, 1e-12);
    ck_assert_double_eq_tol(at[1], y, 1e-12);
    ck_assert_double_eq_tol(at[2], z, 1e-12);
}

static void check_center(const struct hatch_orbit *orbit, double x, double y, double z)
{
    const double at[3] = {hatch_pair_round(orbit->center[0]), hatch_pair_round(orbit->center[1]),
                          hatch_pair_round(orbit->center[2])};
    check_at(at, x, y, z);
}

/* Whatever the direction that the view has, a turn by nothing leaves it as it is. */
START_TEST(a_start_keeps_the_view)
{
    static const double backs[4][3] = {{3, 1, 2}, {-1, -4, 0.5}, {-2, 0.5, -3}, {0.1, 2, -0.1}};
    for (int i = 0; i < 4; i++) {
        struct hatch_view view = view_along_z(false);
        struct hatch_orbit orbit;
        hatch_view_set_back(&view, backs[i]);
        hatch_orbit_start(&orbit, &view);
        ck_assert_double_eq(orbit.distance, 4);
        check_center(&orbit, view.eye[0] - 4 * view.back[0], view.eye[1] - 4 * view.back[1],
                     view.eye[2] - 4 * view.back[2]);
        hatch_orbit_turn(&orbit, 0, 0);
        check_at(orbit.view.eye, view.eye[0], view.eye[1], view.eye[2]);
        check_at(orbit.view.back, view.back[0], view.back[1], view.back[2]);
        check_at(orbit.view.up, view.up[0], view.up[1], view.up[2]);
        ck_assert(orbit.view.finite && orbit.view.near == 0.1 && orbit.view.pivot == 4);
    }
}
END_TEST

START_TEST(the_eye_turns_around_the_centre)
{
    struct hatch_orbit orbit = orbit_along_z(false);
    hatch_orbit_turn(&orbit, quarter, 0);
    check_at(orbit.view.eye, 5, 2, 3);
    check_at(orbit.view.right, 0, 0, -1);
    hatch_orbit_turn(&orbit, quarter, quarter / 3);
    check_at(orbit.view.eye, 1, 4, 3 - 4 * sqrt(0.75));
    check_at(orbit.view.up, 0, sqrt(0.75), 0.5);
    check_center(&orbit, 1, 2, 3);
}
END_TEST

/* The elevation stops a hundredth short of the poles: from there, every turn back counts. A view from a pole, whose
 * direction may be rounded to more than 1, is turned there as well. */
START_TEST(the_elevation_stops_at_the_poles)
{
    for (int sign = -1; sign <= 1; sign += 2) {
        struct hatch_orbit orbit = orbit_along_z(false);
        hatch_orbit_turn(&orbit, 0, sign * 5.0);
        ck_assert_double_eq_tol(orbit.view.back[1], sign * cos(0.01), 1e-6);
        ck_assert_double_eq_tol(orbit.view.back[2], sin(0.01), 1e-3);
        hatch_orbit_turn(&orbit, 0, sign * (0.01 - quarter));
        ck_assert_double_eq_tol(orbit.view.back[1], 0, 1e-3);
        struct hatch_view above = view_along_z(false);
        hatch_view_set_back(&above, (const double[3]){0, sign, 0});
        above.back[1] = sign * nextafter(1, 2);
        hatch_orbit_start(&orbit, &above);
        hatch_orbit_turn(&orbit, 0, 0);
        ck_assert_double_eq_tol(orbit.view.back[1], sign * cos(0.01), 1e-6);
    }
}
END_TEST

/* A point at the centre's distance moves through the picture by the shares of its height that the camera moves. */
START_TEST(a_pan_moves_the_picture_by_shares_of_its_height)
{
    static const struct hatch_tile whole = {0, 0, 300, 200, 300, 200};
    for (int orthographic = 0; orthographic < 2; orthographic++) {
        struct hatch_orbit orbit = orbit_along_z(orthographic);
        float clip[16], at[4];
        hatch_orbit_turn(&orbit, 0.7, 0.4);
        hatch_orbit_pan(&orbit, 0.25, -0.125);
        hatch_view_matrix(&orbit.view, &whole, clip);
        for (int row = 0; row < 4; row++)
            at[row] = clip[row] * 1 + clip[4 + row] * 2 + clip[8 + row] * 3 + clip[12 + row];
        ck_assert_float_eq_tol(at[0] / at[3], -2 * 0.25f / 1.5f, 1e-5f);
        ck_assert_float_eq_tol(at[1] / at[3], 2 * 0.125f, 1e-5f);
        const double distance = hatch_vec_distance(
            orbit.view.eye, (const double[3]){orbit.center[0].high, orbit.center[1].high, orbit.center[2].high});
        ck_assert_double_eq_tol(distance, 4, 1e-12);
    }
}
END_TEST

/* Nothing is cut off where the eye goes: the near plane follows the surface, and there is no far plane any more. */
START_TEST(a_zoom_goes_towards_the_centre)
{
    struct hatch_orbit orbit = orbit_along_z(false);
    hatch_orbit_zoom(&orbit, 0.25);
    check_at(orbit.view.eye, 1, 2, 4);
    check_center(&orbit, 1, 2, 3);
    ck_assert_double_eq(orbit.view.half_height, 0.5);
    ck_assert_double_eq(orbit.view.pivot, 1);
    ck_assert(orbit.view.near_is_automatic && orbit.view.near <= HATCH_VIEW_NEAR && !orbit.view.finite);
}
END_TEST

START_TEST(a_zoom_of_an_orthographic_view_changes_its_height)
{
    struct hatch_orbit orbit = orbit_along_z(true);
    hatch_orbit_zoom(&orbit, 0.25);
    check_at(orbit.view.eye, 1, 2, 7);
    ck_assert_double_eq(orbit.view.half_height, 0.125);
    ck_assert_double_eq(orbit.distance, 4);
    ck_assert_double_eq(orbit.view.near, 0.1);
}
END_TEST

/* Steps beyond the limits change nothing, near planes and far planes included. */
START_TEST(a_zoom_stops_at_its_limits)
{
    for (int orthographic = 0; orthographic < 2; orthographic++) {
        struct hatch_orbit orbit = orbit_along_z(orthographic);
        const double *size = orthographic ? &orbit.view.half_height : &orbit.distance, begin = *size;
        hatch_orbit_zoom(&orbit, 0.9 * HATCH_ORBIT_NEAREST / begin);
        hatch_orbit_zoom(&orbit, 1.1 * HATCH_ORBIT_FARTHEST / begin);
        ck_assert_double_eq(*size, begin);
        ck_assert(orbit.view.finite && orbit.view.near == 0.1);
        hatch_orbit_zoom(&orbit, 0.9 * HATCH_ORBIT_FARTHEST / begin);
        ck_assert_double_eq_tol(*size, 0.9 * HATCH_ORBIT_FARTHEST, 1e-9);
        hatch_orbit_zoom(&orbit, 1.1 * HATCH_ORBIT_NEAREST / *size);
        ck_assert_double_eq_tol(*size / HATCH_ORBIT_NEAREST, 1.1, 1e-9);
    }
}
END_TEST

/* At the least distance the eye is nearer to the centre than doubles around it are to each other; its low parts tell
 * where it is. */
START_TEST(the_eye_is_exact_beside_the_centre)
{
    const double least = 1.5 * HATCH_ORBIT_NEAREST;
    struct hatch_orbit orbit = orbit_along_z(false);
    hatch_orbit_turn(&orbit, 0.7, 0.4);
    hatch_orbit_zoom(&orbit, least / 4);
    for (int k = 0; k < 3; k++) {
        const struct hatch_pair eye = {orbit.view.eye[k], orbit.view.eye_low[k]};
        const double from = hatch_pair_round(hatch_pair_sub(eye, orbit.center[k]));
        ck_assert_double_eq_tol(from / least, orbit.view.back[k], 1e-9);
    }
    struct hatch_orbit again;
    hatch_orbit_start(&again, &orbit.view);
    for (int k = 0; k < 3; k++) {
        const double moved = hatch_pair_round(hatch_pair_sub(again.center[k], orbit.center[k]));
        ck_assert_double_eq_tol(moved / least, 0, 1e-9);
    }
}
END_TEST

/* The centre moves along the view axis; the picture stays, and turns and steps of the zoom go by the new one. */
START_TEST(the_centre_moves_without_the_picture)
{
    struct hatch_orbit orbit = orbit_along_z(false);
    hatch_orbit_set_distance(&orbit, 1);
    check_at(orbit.view.eye, 1, 2, 7);
    check_center(&orbit, 1, 2, 6);
    ck_assert_double_eq(orbit.view.pivot, 1);
    hatch_orbit_zoom(&orbit, 0.5);
    check_at(orbit.view.eye, 1, 2, 6.5);
    hatch_orbit_turn(&orbit, quarter, 0);
    check_at(orbit.view.eye, 1.5, 2, 6);
}
END_TEST

static Suite *suite(void)
{
    Suite *made = suite_create("orbit");
    TCase *tests = tcase_create("orbit");
    tcase_add_test(tests, a_start_keeps_the_view);
    tcase_add_test(tests, the_eye_turns_around_the_centre);
    tcase_add_test(tests, the_elevation_stops_at_the_poles);
    tcase_add_test(tests, a_pan_moves_the_picture_by_shares_of_its_height);
    tcase_add_test(tests, a_zoom_goes_towards_the_centre);
    tcase_add_test(tests, a_zoom_of_an_orthographic_view_changes_its_height);
    tcase_add_test(tests, a_zoom_stops_at_its_limits);
    tcase_add_test(tests, the_eye_is_exact_beside_the_centre);
    tcase_add_test(tests, the_centre_moves_without_the_picture);
    suite_add_tcase(made, tests);
    return made;
}

HATCH_TEST_MAIN(suite)
