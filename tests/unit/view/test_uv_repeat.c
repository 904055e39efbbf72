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

static Suite *suite(void)
{
    Suite *made = suite_create("uv repeat");
    TCase *tests = tcase_create("uv repeat");
    tcase_add_checked_fixture(tests, begin, end);
    tcase_add_test(tests, strokes_have_one_size_on_all_patches);
    suite_add_tcase(made, tests);
    return made;
}

HATCH_TEST_MAIN(suite)
