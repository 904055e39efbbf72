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
    HATCH_TEST_OK(hatch_patches_join(&scene, &keep, &scratch, &patches, NULL, &err), &err);
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
        HATCH_TEST_OK(hatch_patches_join(&scene, &keep, &scratch, &patches, NULL, &err), &err);
        HATCH_TEST_OK(hatch_unit_scene_make(&scene, patches, &bounds, &keep, &unit, &err), &err);
        hatch_unit_scene_pose(&unit, HATCH_NONE, 0);
        HATCH_TEST_OK(hatch_uv_repeat_set(&unit, &how, &keep, &scratch, &err), &err);
        double want = (halves == 1 ? 2 : sqrt(2 * 4)) * 150 / LAPPED_SIZE;
        for (int k = 0; k < 2; k++)
            ck_assert_double_eq_tol((double)unit.items[0].repeat[k] / want, 1, halves == 1 ? 1e-5 : 0.04);
    }
}
END_TEST

/* Makes squares beside each other, an eighth of a unit wide and high: each is a chart.
 *   tiles  per square: units of u and of v along its sides */
static struct hatch_mesh make_squares(const double (*tiles)[2], uint32_t count)
{
    struct hatch_mesh mesh;
    float *texcoord;
    HATCH_TEST_OK(hatch_mesh_make(&keep, 4 * count, 2 * count, &mesh, &err), &err);
    HATCH_TEST_OK(hatch_mesh_add(&keep, &mesh, "TEXCOORD_0", 2, &texcoord, &err), &err);
    for (uint32_t i = 0; i < count; i++) {
        const uint32_t faces[6] = {4 * i, 4 * i + 1, 4 * i + 3, 4 * i, 4 * i + 3, 4 * i + 2};
        memcpy(&mesh.indices[6 * (size_t)i], faces, sizeof faces);
        for (uint32_t c = 0; c < 4; c++)
            for (uint32_t k = 0; k < 2; k++) {
                float along = (float)(c >> k & 1);
                mesh.attributes[0].data[3 * (4 * i + c) + k] =
                    0.125f * along + (k == 0 ? 0.1875f * (float)i - 0.5f : 0);
                texcoord[2 * (4 * i + c) + k] = 10 * (float)i + along * (float)tiles[i][k];
            }
    }
    return mesh;
}

/* Squares of 16 pixels. A texel of a tile of 4 texels is as large as a pixel where 4 tiles are beside each other; more
 * tiles are as many as is next to that, but for a quarter of an octave. A chart that has more tiles than that in its
 * texture coordinates keeps them, unless there are so many that no level of 3 with strokes were drawn. */
START_TEST(charts_have_repeats_of_their_own)
{
    static const double tiles[][2] = {{1, 1}, {1, 4}, {4, 1}, {3.5, 3.5}, {3.3, 1}, {8, 8}, {50, 12.5}};
    static const float wanted[][2] = {{4, 4}, {4, 1}, {1, 4}, {1, 1}, {2, 8}, {1, 1}, {0.125f, 0.5f}};
    enum { COUNT = sizeof tiles / sizeof *tiles };
    struct hatch_scene scene;
    struct hatch_unit_scene unit;
    const struct hatch_bounds bounds = {.radius = 1};
    struct hatch_uv_repeat how = {.view = &view_facing, .height_px = 256, .size_px = 4, .levels = 3};
    struct hatch_mesh squares = make_squares(tiles, COUNT);
    HATCH_TEST_OK(hatch_scene_of_mesh(&squares, &keep, &scene, &err), &err);
    HATCH_TEST_OK(hatch_unit_scene_make(&scene, NULL, &bounds, &keep, &unit, &err), &err);
    hatch_unit_scene_pose(&unit, HATCH_NONE, 0);
    HATCH_TEST_OK(hatch_uv_repeat_set(&unit, &how, &keep, &scratch, &err), &err);
    ck_assert_uint_eq(unit.items[0].chart_count, COUNT);
    for (uint32_t i = 0; i < 4 * COUNT; i++)
        for (int k = 0; k < 2; k++)
            ck_assert_float_eq(unit.items[0].repeats[2 * i + (uint32_t)k], wanted[i / 4][k]);
    ck_assert(unit.items[0].repeat[0] == 4 && unit.items[0].repeat[1] == 4); /* the first of the largest charts */
    how.repeat = 3;
    HATCH_TEST_OK(hatch_uv_repeat_set(&unit, &how, &keep, &scratch, &err), &err);
    ck_assert_ptr_null(unit.items[0].repeats);
    ck_assert_uint_eq(unit.items[0].chart_count, 0);
    ck_assert(unit.items[0].repeat[0] == 3 && unit.items[0].repeat[1] == 3);
}
END_TEST

/* Two squares, with 64 and 16 pixels per unit, of which the nearer one has 16 times the weight in a mean. Tiles are as
 * many as suit what is in the picture; if nothing is, as many as suit both. */
START_TEST(what_is_seen_decides_about_repeats)
{
    static const double tiles[][2] = {{1, 1}, {1, 1}};
    for (int aside = 0; aside < 4; aside++) {
        struct hatch_scene scene;
        struct hatch_unit_scene unit;
        const struct hatch_bounds bounds = {.radius = 1};
        struct hatch_view view = view_facing;
        const struct hatch_uv_repeat how = {.view = &view, .height_px = 256, .size_px = 4, .levels = 3};
        struct hatch_mesh squares = make_squares(tiles, 2);
        view.orthographic = false;
        for (uint32_t v = 0; v < 8; v++) {
            squares.attributes[0].data[3 * v] += aside >> v / 4 & 1 ? 100 : 0;
            squares.attributes[0].data[3 * v + 2] = v < 4 ? 0 : -6;
        }
        HATCH_TEST_OK(hatch_scene_of_mesh(&squares, &keep, &scene, &err), &err);
        HATCH_TEST_OK(hatch_unit_scene_make(&scene, NULL, &bounds, &keep, &unit, &err), &err);
        hatch_unit_scene_pose(&unit, HATCH_NONE, 0);
        HATCH_TEST_OK(hatch_uv_repeat_set(&unit, &how, &keep, &scratch, &err), &err);
        for (uint32_t i = 0; i < 16; i++)
            ck_assert_float_eq(unit.items[0].repeats[i], aside == 1 ? 1 : 2);
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
    tcase_add_test(tests, charts_have_repeats_of_their_own);
    tcase_add_test(tests, what_is_seen_decides_about_repeats);
    suite_add_tcase(made, tests);
    return made;
}

HATCH_TEST_MAIN(suite)
