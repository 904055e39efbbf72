/* Views through the cameras of a scene, and from a place that is chosen. */
#include <string.h>

#include "math/vector.h"
#include "meshes.h"
#include "scene/unit_scene.h"
#include "view/view.h"

static const struct hatch_bounds bounds = {.center = {10, 20, 30}, .radius = 5};
static struct hatch_scene scene;
static struct hatch_pose pose;
static struct hatch_node nodes[3];
static struct hatch_camera cameras[2];

/* A square, and two nodes for cameras: 30 and 10 in front of the middle of the bounds. */
static void begin_scene(void)
{
    static const struct hatch_camera far = {.yfov_rad = 0.8f, .aspect = 1.5f, .znear = 0.5f, .zfar = 100};
    static const struct hatch_camera flat = {.orthographic = true, .ymag = 10, .znear = 0.5f, .zfar = 100};
    begin();
    struct hatch_mesh square = shape_of(HATCH_SHAPE_PLANE, 2);
    HATCH_TEST_OK(hatch_scene_of_mesh(&square, &keep, &scene, &err), &err);
    cameras[0] = far;
    cameras[1] = flat;
    for (uint32_t i = 0; i < 3; i++) {
        const double at[3] = {10, 20, i == 1 ? 60 : 40};
        nodes[i] = scene.nodes[0];
        nodes[i].mesh_count = i == 0 ? nodes[i].mesh_count : 0;
        nodes[i].camera = i == 0 ? HATCH_NONE : i - 1;
        memcpy(nodes[i].translation, at, sizeof at);
    }
    scene.nodes = nodes;
    scene.node_count = 3;
    scene.cameras = cameras;
    scene.camera_count = 2;
    HATCH_TEST_OK(hatch_pose_make(&scene, &keep, &pose, &err), &err);
}

static enum hatch_status make(const struct hatch_view_choice *choice, double aspect, struct hatch_view *view)
{
    static const struct hatch_pose_span rest = {.animation = HATCH_NONE, .moments = 1};
    const struct hatch_framing framing = {&rest, &bounds, aspect};
    hatch_pose_set(&pose, HATCH_NONE, 0);
    return hatch_view_make(choice, &pose, &framing, &scratch, view, &err);
}

static struct hatch_view through(uint32_t camera, double aspect)
{
    const struct hatch_view_choice choice = {.kind = HATCH_VIEW_CAMERA, .index = camera};
    struct hatch_view view;
    HATCH_TEST_OK(make(&choice, aspect, &view), &err);
    return view;
}

static void check_at(const double at[3], double x, double y, double z)
{
    ck_assert_double_eq_tol(at[0], x, 1e-6);
    ck_assert_double_eq_tol(at[1], y, 1e-6);
    ck_assert_double_eq_tol(at[2], z, 1e-6);
}

/* Checks that the eye is where it should be in the world, more exactly than doubles of the unit scene tell. */
static void check_exact(const struct hatch_view *view, const double world[3])
{
    for (int k = 0; k < 3; k++) {
        const struct hatch_pair eye = {view->eye[k], view->eye_low[k]};
        const struct hatch_pair at = hatch_pair_add(hatch_pair_scale(eye, 5), hatch_pair_of(bounds.center[k]));
        ck_assert_double_eq_tol(hatch_pair_round(hatch_pair_sub(at, hatch_pair_of(world[k]))), 0, 1e-28);
    }
}

/* Lengths are a fifth of those of the world. */
START_TEST(a_camera_is_scaled_with_the_scene)
{
    struct hatch_view view = through(0, 1.5);
    check_at(view.eye, 0, 0, 6);
    check_at(view.right, 1, 0, 0);
    check_at(view.up, 0, 1, 0);
    check_at(view.back, 0, 0, 1);
    ck_assert_double_eq_tol(view.half_height, tan(0.4), 1e-6);
    ck_assert_double_eq_tol(view.pivot, 6, 1e-12);
    ck_assert_double_eq_tol(view.near, 0.1, 1e-6);
    ck_assert_double_eq_tol(view.far, 20, 1e-6);
    ck_assert_double_eq(view.aspect, 1.5);
    ck_assert(view.finite && !view.orthographic && !view.near_is_automatic);
    view = through(1, 1.5);
    check_at(view.eye, 0, 0, 2);
    ck_assert_double_eq_tol(view.half_height, 2, 1e-6);
    ck_assert_double_eq_tol(view.near, 0.1, 1e-6);
    ck_assert_double_eq_tol(view.far, 20, 1e-6);
    ck_assert(!view.finite && view.orthographic);
}
END_TEST

/* Turned by 90 degrees about z, and scaled, which changes no direction. */
START_TEST(a_camera_turns_with_its_node)
{
    nodes[1].rotation[2] = nodes[1].rotation[3] = sqrtf(0.5f);
    for (int k = 0; k < 3; k++)
        nodes[1].scale[k] = 3;
    struct hatch_view view = through(0, 1.5);
    check_at(view.right, 0, 1, 0);
    check_at(view.up, -1, 0, 0);
    check_at(view.back, 0, 0, 1);
    nodes[1].scale[1] = 0;
    const struct hatch_view_choice choice = {.kind = HATCH_VIEW_CAMERA};
    ck_assert_int_eq(make(&choice, 1.5, &view), HATCH_BAD_INPUT);
    ck_assert_str_eq(err.text, "camera 0: its node is scaled to zero");
}
END_TEST

/* A narrower picture shows more above and below, a wider one more to both sides; without an aspect of the camera, all
 * pictures show as much above and below. */
START_TEST(a_picture_shows_all_that_its_camera_sees)
{
    ck_assert_double_eq_tol(through(0, 3).half_height, tan(0.4), 1e-6);
    ck_assert_double_eq_tol(through(0, 0.5).half_height, 3 * tan(0.4), 1e-6);
    cameras[0].aspect = 0;
    ck_assert_double_eq_tol(through(0, 0.5).half_height, tan(0.4), 1e-6);
    ck_assert_double_eq_tol(through(1, 0.5).half_height, 2, 1e-6);
}
END_TEST

/* Only a far plane beyond the near one counts. The near plane of a perspective view is in front of the eye. */
START_TEST(planes_of_cameras_are_in_order)
{
    cameras[0].zfar = 0;
    ck_assert(!through(0, 1.5).finite);
    ck_assert_double_eq_tol(through(0, 1.5).far, 1e4 + 0.1, 1e-6);
    cameras[0].zfar = 0.25f;
    ck_assert(!through(0, 1.5).finite);
    ck_assert_double_eq_tol(through(0, 1.5).far, 1e4 + 0.1, 1e-6);
    cameras[0] = (struct hatch_camera){.yfov_rad = 0.8f, .znear = 1e-9f, .zfar = 2e-9f};
    ck_assert(!through(0, 1.5).finite);
    ck_assert_double_eq(through(0, 1.5).near, 1e-7);
    cameras[1].znear = 0;
    ck_assert_double_eq(through(1, 1.5).near, 0);
}
END_TEST

/* A node under one that scales heights alone has leaning axes; the view's are at right angles, and look where the
 * camera does. The eye is as exact as the node's place. */
START_TEST(the_axes_of_a_view_are_at_right_angles)
{
    static const double at[3] = {13, 24, 31};
    for (int k = 0; k < 3; k++) {
        nodes[0].translation[k] = 0;
        nodes[1].translation[k] = (float)(k == 1 ? at[k] / 2 : at[k]);
    }
    nodes[0].scale[1] = 2;
    nodes[1].parent = 0;
    nodes[1].rotation[0] = (float)sin(0.25);
    nodes[1].rotation[3] = (float)cos(0.25);
    struct hatch_view view = through(0, 1.5);
    const double length = hypot(2 * sin(0.5), cos(0.5));
    check_at(view.right, 1, 0, 0);
    check_at(view.back, 0, -2 * sin(0.5) / length, cos(0.5) / length);
    check_at(view.up, 0, cos(0.5) / length, 2 * sin(0.5) / length);
    check_exact(&view, at);
}
END_TEST

/* A camera turns around what is as far as the middle of the scene, and in front of it. */
START_TEST(a_camera_beyond_the_middle_has_a_near_pivot)
{
    nodes[1].translation[0] = 15;
    ck_assert_double_eq_tol(through(0, 1.5).pivot, 6, 1e-12);
    nodes[1].translation[2] = 20;
    ck_assert_double_eq(through(0, 1.5).pivot, 0.05);
}
END_TEST

START_TEST(the_first_camera_is_that_of_the_first_node)
{
    const struct hatch_view_choice first = {.kind = HATCH_VIEW_FIRST_CAMERA, .fov_rad = 0.6};
    const struct hatch_view_choice second = {.kind = HATCH_VIEW_CAMERA, .index = 1};
    struct hatch_view view;
    nodes[1].camera = 1;
    nodes[2].camera = 0;
    ck_assert(!hatch_view_is_fixed(&first, &scene) && !hatch_view_is_fixed(&second, &scene));
    HATCH_TEST_OK(make(&first, 1.5, &view), &err);
    ck_assert(view.orthographic);
    check_at(view.eye, 0, 0, 6);
    nodes[1].camera = HATCH_NONE;
    HATCH_TEST_OK(make(&first, 1.5, &view), &err);
    ck_assert(!view.orthographic);
    check_at(view.eye, 0, 0, 2);
    ck_assert_int_eq(make(&second, 1.5, &view), HATCH_BAD_INPUT);
    ck_assert_str_eq(err.text, "camera 1 is not in the scene; its files define 2, numbered from 0");
    nodes[2].camera = HATCH_NONE;
    ck_assert(hatch_view_is_fixed(&first, &scene));
    HATCH_TEST_OK(make(&first, 1.5, &view), &err);
    ck_assert(view.near_is_automatic);
    ck_assert_double_eq_tol(view.half_height, tan(0.3), 1e-12);
}
END_TEST

/* The eye is as exact as its coordinates, although none of them is a double in the unit scene. */
START_TEST(a_chosen_eye_is_exact)
{
    struct hatch_view_choice choice = {
        .kind = HATCH_VIEW_EYE, .eye = {13, 24, 30}, .target = {13, 20, 30}, .has_target = true, .fov_rad = 0.6};
    struct hatch_view view;
    HATCH_TEST_OK(make(&choice, 1.5, &view), &err);
    check_at(view.back, 0, 1, 0);
    ck_assert_double_eq_tol(view.pivot, 0.8, 1e-12);
    ck_assert_double_eq_tol(view.half_height, tan(0.3), 1e-12);
    ck_assert_double_eq(view.near, HATCH_VIEW_NEAR);
    ck_assert(view.near_is_automatic && !view.finite && !view.orthographic);
    check_exact(&view, choice.eye);
    choice.has_target = false; /* the middle of the bounds is 3 and 4 away */
    HATCH_TEST_OK(make(&choice, 1.5, &view), &err);
    check_at(view.back, 0.6, 0.8, 0);
    ck_assert_double_eq_tol(view.pivot, 1, 1e-12);
    memcpy(choice.target, choice.eye, sizeof choice.eye);
    choice.has_target = true;
    ck_assert_int_eq(make(&choice, 1.5, &view), HATCH_BAD_INPUT);
    ck_assert_ptr_nonnull(strstr(err.text, "the camera stands on its target"));
}
END_TEST

static Suite *suite(void)
{
    Suite *made = suite_create("cameras");
    TCase *tests = tcase_create("cameras");
    tcase_add_checked_fixture(tests, begin_scene, end);
    tcase_add_test(tests, a_camera_is_scaled_with_the_scene);
    tcase_add_test(tests, a_camera_turns_with_its_node);
    tcase_add_test(tests, a_picture_shows_all_that_its_camera_sees);
    tcase_add_test(tests, planes_of_cameras_are_in_order);
    tcase_add_test(tests, the_axes_of_a_view_are_at_right_angles);
    tcase_add_test(tests, a_camera_beyond_the_middle_has_a_near_pivot);
    tcase_add_test(tests, the_first_camera_is_that_of_the_first_node);
    tcase_add_test(tests, a_chosen_eye_is_exact);
    suite_add_tcase(made, tests);
    return made;
}

HATCH_TEST_MAIN(suite)
