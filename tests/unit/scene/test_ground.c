/* The ground plane, and the alignment of rows. */
#include <math.h>

#include "scene/ground.h"
#include "scene/row.h"

#include "meshes.h"

static struct hatch_scene scene_of(enum hatch_shape kind, float scale)
{
    struct hatch_scene scene;
    struct hatch_mesh mesh = shape_of(kind, 500);
    move(&mesh, scale, 3);
    HATCH_TEST_OK(hatch_scene_of_mesh(&mesh, &keep, &scene, &err), &err);
    return scene;
}

static struct hatch_bounds bounds_of(const struct hatch_scene *scene)
{
    struct hatch_bounds bounds;
    HATCH_TEST_OK(hatch_scene_measure(scene, NULL, &scratch, &bounds, &err), &err);
    return bounds;
}

START_TEST(ground_touches_from_below)
{
    /* As large as the block that comes after it, which has room for all that follows: arrays lie side by side. */
    ck_assert_ptr_nonnull(HATCH_NEW(&keep, uint8_t, 1 << 20, &err));
    struct hatch_scene scene = scene_of(HATCH_SHAPE_TORUS, 2);
    struct hatch_bounds before = bounds_of(&scene);
    HATCH_TEST_OK(hatch_scene_add_ground(&scene, NULL, 4, &keep, &scratch, &err), &err);
    struct hatch_bounds after = bounds_of(&scene);
    ck_assert_double_eq(after.radius, before.radius);
    ck_assert_uint_eq(scene.mesh_count, 2);
    ck_assert_uint_eq(scene.node_count, 2);
    const struct hatch_mesh *ground = &scene.meshes[1].mesh;
    float low[3], high[3];
    ck_assert(hatch_mesh_bounds(ground, low, high));
    double level = before.center[1] - before.half[1];
    ck_assert_double_eq_tol((double)low[1], level, 1e-6);
    ck_assert_double_eq_tol((double)high[1], level, 1e-6);
    for (int k = 0; k < 3; k += 2) {
        ck_assert_double_eq_tol((double)low[k], before.center[k] - 4 * before.radius, 1e-5);
        ck_assert_double_eq_tol((double)high[k], before.center[k] + 4 * before.radius, 1e-5);
    }
    const float *normal = hatch_mesh_find(ground, "NORMAL", 3), *p = ground->attributes[0].data;
    const uint32_t *i = ground->indices;
    ck_assert_float_eq(normal[1], 1);
    double ax = (double)(p[3 * i[1]] - p[3 * i[0]]), az = (double)(p[3 * i[1] + 2] - p[3 * i[0] + 2]);
    double bx = (double)(p[3 * i[2]] - p[3 * i[0]]), bz = (double)(p[3 * i[2] + 2] - p[3 * i[0] + 2]);
    ck_assert_double_gt(az * bx - ax * bz, 0); /* the face is turned upwards */
    ck_assert_ptr_nonnull(hatch_mesh_find(ground, "TEXCOORD_0", 2));
}
END_TEST

/* A sphere and a flat torus in a row: their lowest points, then their centres, are level. */
START_TEST(rows_stand_or_hang_by_their_middles)
{
    for (int stand = 0; stand < 2; stand++) {
        const struct hatch_scene scenes[2] = {scene_of(HATCH_SHAPE_SPHERE, 1), scene_of(HATCH_SHAPE_TORUS, 5)};
        struct hatch_scene row;
        HATCH_TEST_OK(hatch_scene_join_row(scenes, 2, stand, &keep, &scratch, &row, &err), &err);
        struct hatch_bounds parts[2];
        for (uint32_t i = 0; i < 2; i++) {
            struct hatch_scene alone = row;
            uint32_t other = row.nodes[1].mesh_count ? 1 + 2 * (1 - i) : 2 * (1 - i);
            struct hatch_node *nodes = HATCH_NEW(&keep, struct hatch_node, row.node_count, &err);
            memcpy(nodes, row.nodes, row.node_count * sizeof *nodes);
            nodes[other].mesh_count = 0;
            alone.nodes = nodes;
            parts[i] = bounds_of(&alone);
        }
        double low[2] = {parts[0].center[1] - parts[0].half[1], parts[1].center[1] - parts[1].half[1]};
        if (stand)
            ck_assert_double_eq_tol(low[0], low[1], 1e-5);
        else
            ck_assert_double_eq_tol(parts[0].center[1], parts[1].center[1], 1e-5);
    }
}
END_TEST

static Suite *suite(void)
{
    Suite *made = suite_create("render ground");
    TCase *tests = tcase_create("ground");
    tcase_add_checked_fixture(tests, begin, end);
    tcase_add_test(tests, ground_touches_from_below);
    tcase_add_test(tests, rows_stand_or_hang_by_their_middles);
    suite_add_tcase(made, tests);
    return made;
}

HATCH_TEST_MAIN(suite)
