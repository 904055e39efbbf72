/* Scenes side by side. */
#include "fail_alloc.h"
#include "lapped_scene.h"
#include "meshes.h"
#include "scene/row.h"

static enum hatch_status row(void *context, struct hatch_arena *lasting, struct hatch_arena *temporary,
                             struct hatch_err *why)
{
    struct hatch_scene joined;
    return hatch_scene_join_row(context, 2, false, lasting, temporary, &joined, why);
}

START_TEST(scenes_stand_in_a_row)
{
    struct hatch_scene scene, scenes[2], joined;
    double world[16 * 8];
    struct hatch_mesh sphere = shape_of(HATCH_SHAPE_SPHERE, 100);
    struct hatch_mesh large = shape_of(HATCH_SHAPE_SPHERE, 100);
    for (size_t i = 0; i < 3 * (size_t)large.vertex_count; i++)
        large.attributes[0].data[i] = 5 * large.attributes[0].data[i] + 7;
    lapped_scene(&sphere, &caps, &keep, &scene);
    lapped_scene_skin(&scene, &keep);
    scenes[0] = scene;
    lapped_scene(&large, &caps, &keep, &scene);
    scenes[1] = scene;
    HATCH_TEST_OK(hatch_scene_join_row(scenes, 2, false, &keep, &scratch, &joined, &err), &err);
    ck_assert_uint_eq(joined.node_count, 6);
    ck_assert_uint_eq(joined.nodes[1].parent, 0);
    ck_assert_uint_eq(joined.skins[0].joints[1], 3);
    ck_assert_uint_eq(joined.nodes[5].parent, 4);
    ck_assert_uint_eq(joined.nodes[5].first_mesh, CAPS);
    ck_assert_uint_eq(joined.meshes[CAPS].material, 2);
    ck_assert_uint_eq(joined.materials[2].base.texture, 1);
    hatch_scene_pose(&joined, HATCH_NONE, 0, world);
    /* The second scene is scaled by 1/5; the centres are half of each width and the gap apart. */
    const double *place = world + 16 * 5;
    ck_assert_double_eq_tol(place[0], 0.2, 0.01);
    ck_assert_double_eq_tol(place[0] * 7 + place[12], 2 + 0.2 * sqrt(3), 0.05);
    ck_assert_double_eq_tol(place[5] * 7 + place[13], 0, 0.01);
    ck_assert_uint_gt(hatch_test_fail_alloc(row, scenes, NULL, 0), 8);
}
END_TEST

/* Of a scene five times as large as the first: one that is scaled looks as it does alone. */
START_TEST(cameras_and_lamps_are_scaled_with_their_scene)
{
    struct hatch_scene scenes[2], joined;
    struct hatch_mesh small = shape_of(HATCH_SHAPE_SPHERE, 100), large = shape_of(HATCH_SHAPE_SPHERE, 100);
    struct hatch_camera camera = {.orthographic = true, .ymag = 15, .aspect = 2, .znear = 5, .zfar = 50};
    struct hatch_light lights[] = {{.type = HATCH_LIGHT_POINT, .intensity = 100, .range = 40},
                                   {.type = HATCH_LIGHT_SPOT, .intensity = 50, .outer_cone_rad = 0.5f},
                                   {.type = HATCH_LIGHT_DIRECTIONAL, .intensity = 3}};
    for (size_t i = 0; i < 3 * (size_t)large.vertex_count; i++)
        large.attributes[0].data[i] *= 5;
    HATCH_TEST_OK(hatch_scene_of_mesh(&small, &keep, &scenes[0], &err), &err);
    HATCH_TEST_OK(hatch_scene_of_mesh(&large, &keep, &scenes[1], &err), &err);
    scenes[1].cameras = &camera;
    scenes[1].camera_count = 1;
    scenes[1].lights = lights;
    scenes[1].light_count = 3;
    HATCH_TEST_OK(hatch_scene_join_row(scenes, 2, false, &keep, &scratch, &joined, &err), &err);
    ck_assert_float_eq_tol(joined.cameras[0].ymag, 3, 1e-5f);
    ck_assert_float_eq_tol(joined.cameras[0].znear, 1, 1e-5f);
    ck_assert_float_eq_tol(joined.cameras[0].zfar, 10, 1e-5f);
    ck_assert_float_eq(joined.cameras[0].aspect, 2);
    ck_assert_float_eq_tol(joined.lights[0].range, 8, 1e-5f);
    ck_assert_float_eq_tol(joined.lights[0].intensity, 4, 1e-5f);
    ck_assert_float_eq_tol(joined.lights[1].intensity, 2, 1e-5f);
    ck_assert_float_eq(joined.lights[1].range, 0);
    ck_assert_float_eq(joined.lights[2].intensity, 3);
    ck_assert_float_eq(camera.ymag, 15);
}
END_TEST

static Suite *suite(void)
{
    Suite *made = suite_create("row");
    TCase *tests = tcase_create("row");
    tcase_add_checked_fixture(tests, begin, end);
    tcase_add_test(tests, scenes_stand_in_a_row);
    tcase_add_test(tests, cameras_and_lamps_are_scaled_with_their_scene);
    suite_add_tcase(made, tests);
    return made;
}

HATCH_TEST_MAIN(suite)
