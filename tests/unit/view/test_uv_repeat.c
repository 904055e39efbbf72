/* Repeats of the hatching pattern. */
#include "lapped_scene.h"
#include "meshes.h"
#include "view/uv_repeat.h"
#include "views.h"

/* Two spheres, one under a node that scales it by 3. */
START_TEST(strokes_have_one_size_on_all_patches)
{
    struct hatch_patch_mesh *patches;
    struct hatch_scene scene;
    struct hatch_unit_scene unit;
    const struct hatch_bounds bounds = {.radius = 1};
    const struct hatch_uv_repeat how = {.view = &view_facing, .height_px = 300, .size_px = LAPPED_SIZE, .levels = 3};
    struct hatch_mesh sphere = shape_of(HATCH_SHAPE_SPHERE, 500);
    lapped_scene(&sphere, &caps, &keep, &scene);
    struct hatch_node *nodes = HATCH_NEW(&keep, struct hatch_node, 2, &err);
    nodes[0] = nodes[1] = scene.nodes[0];
    for (int k = 0; k < 3; k++)
        nodes[1].scale[k] = 3;
    scene.nodes = nodes;
    scene.node_count = 2;
    HATCH_TEST_OK(hatch_patches_join(&scene, &keep, &scratch, &patches, &err), &err);
    HATCH_TEST_OK(hatch_unit_scene_make(&scene, patches, &bounds, &keep, &unit, &err), &err);
    hatch_unit_scene_pose(&unit, HATCH_NONE, 0);
    ck_assert_uint_eq(unit.item_count, 2);
    HATCH_TEST_OK(hatch_uv_repeat_set(&unit, &how, &keep, &scratch, &err), &err);
    ck_assert_double_eq_tol((double)unit.items[1].repeat[0] / (double)unit.items[0].repeat[0], 3, 1e-3);
    /* 150 pixels per unit; a unit of texture coordinates is a unit of the small sphere. */
    ck_assert_double_eq_tol((double)unit.items[0].repeat[0], 150.0 / LAPPED_SIZE, 0.05 * 150.0 / LAPPED_SIZE);
}
END_TEST

static void place_stretched(uint32_t patch, const float *position, float hatch[2], float outline[2])
{
    (void)patch;
    for (int k = 0; k < 2; k++) {
        hatch[k] = position[k] / (position[0] < 0 ? 2 : 4);
        outline[k] = 0.5f;
    }
}

static bool is_left(uint32_t patch, const double point[3])
{
    (void)patch;
    return point[0] < -0.05;
}

/* On the left of a plane a unit of texture coordinates is 2 units, at 150 pixels each; where it is 4 on the other half,
 * too, the mean is that of the logarithms. */
START_TEST(repeats_are_the_mean_over_the_area)
{
    for (int halves = 1; halves <= 2; halves++) {
        struct hatch_patch_mesh *patches;
        struct hatch_scene scene;
        struct hatch_unit_scene unit;
        const struct hatch_bounds bounds = {.radius = 1};
        const struct hatch_uv_repeat how = {
            .view = &view_facing, .height_px = 300, .size_px = LAPPED_SIZE, .levels = 3};
        const struct cut cut = {
            .count = 1, .materials = 1, .holds = halves == 1 ? is_left : NULL, .place = place_stretched};
        struct hatch_mesh plane = shape_of(HATCH_SHAPE_PLANE, 5000);
        lapped_scene(&plane, &cut, &keep, &scene);
        HATCH_TEST_OK(hatch_patches_join(&scene, &keep, &scratch, &patches, &err), &err);
        HATCH_TEST_OK(hatch_unit_scene_make(&scene, patches, &bounds, &keep, &unit, &err), &err);
        hatch_unit_scene_pose(&unit, HATCH_NONE, 0);
        HATCH_TEST_OK(hatch_uv_repeat_set(&unit, &how, &keep, &scratch, &err), &err);
        double want = (halves == 1 ? 2 : sqrt(2 * 4)) * 150 / LAPPED_SIZE;
        for (int k = 0; k < 2; k++)
            ck_assert_double_eq_tol((double)unit.items[0].repeat[k] / want, 1, halves == 1 ? 1e-5 : 0.04);
    }
}
END_TEST

static Suite *suite(void)
{
    Suite *made = suite_create("uv repeat");
    TCase *tests = tcase_create("uv repeat");
    tcase_add_checked_fixture(tests, begin, end);
    tcase_add_test(tests, strokes_have_one_size_on_all_patches);
    tcase_add_test(tests, repeats_are_the_mean_over_the_area);
    suite_add_tcase(made, tests);
    return made;
}

HATCH_TEST_MAIN(suite)
