/* Meshes that stand along z are told from those that stand along y, and scenes are turned upright. */
#include "arenas.h"
#include "scene/row.h"
#include "scene/up.h"
#include "shapes/shapes.h"

/* Makes a shape; z_up turns it, as a scanner would store it. */
static struct hatch_mesh make(enum hatch_shape shape, bool z_up)
{
    const struct hatch_shape_options options = {.faces = 2000};
    struct hatch_mesh mesh;
    ck_assert_int_eq(hatch_shape_make(shape, &options, &keep, &scratch, &mesh, &err), HATCH_OK);
    float *positions = mesh.attributes[0].data;
    for (uint32_t i = 0; i < mesh.vertex_count && z_up; i++) {
        float y = positions[3 * i + 1], z = positions[3 * i + 2];
        positions[3 * i + 1] = -z;
        positions[3 * i + 2] = y;
    }
    return mesh;
}

START_TEST(bases_along_z_are_found)
{
    static const enum hatch_shape standing[] = {HATCH_SHAPE_TEAPOT, HATCH_SHAPE_CONE, HATCH_SHAPE_FRUSTUM};
    for (size_t i = 0; i < sizeof standing / sizeof *standing; i++) {
        struct hatch_mesh y_up = make(standing[i], false), z_up = make(standing[i], true);
        ck_assert_msg(!hatch_mesh_stands_along_z(&y_up), "%s", hatch_shape_names[standing[i]]);
        ck_assert_msg(hatch_mesh_stands_along_z(&z_up), "%s", hatch_shape_names[standing[i]]);
    }
}
END_TEST

START_TEST(no_base_is_no_hint)
{
    static const enum hatch_shape round[] = {HATCH_SHAPE_SPHERE, HATCH_SHAPE_ELLIPSOID, HATCH_SHAPE_SUPERQUADRIC,
                                             HATCH_SHAPE_PLANE, HATCH_SHAPE_SADDLE};
    for (size_t i = 0; i < sizeof round / sizeof *round; i++) {
        struct hatch_mesh mesh = make(round[i], false);
        ck_assert_msg(!hatch_mesh_stands_along_z(&mesh), "%s", hatch_shape_names[round[i]]);
    }
}
END_TEST

/* The teapot's height is along y, 1.575 of its width 3; turned back, a scene is where it was. */
START_TEST(scenes_are_turned_upright)
{
    struct hatch_mesh mesh = make(HATCH_SHAPE_TEAPOT, true);
    struct hatch_scene scene;
    struct hatch_bounds lying, standing;
    ck_assert_int_eq(hatch_scene_of_mesh(&mesh, &keep, &scene, &err), HATCH_OK);
    ck_assert_int_eq(hatch_scene_measure(&scene, &scratch, &lying, &err), HATCH_OK);
    ck_assert_int_eq(hatch_scene_turn_up(&scene, HATCH_UP_Y, &keep, &err), HATCH_OK);
    ck_assert_uint_eq(scene.node_count, 1);
    ck_assert_int_eq(hatch_scene_turn_up(&scene, HATCH_UP_Z, &keep, &err), HATCH_OK);
    ck_assert_int_eq(hatch_scene_measure(&scene, &scratch, &standing, &err), HATCH_OK);
    ck_assert_double_eq_tol(standing.half[0], lying.half[0], 1e-6);
    ck_assert_double_eq_tol(standing.half[1], lying.half[2], 1e-6);
    ck_assert_double_eq_tol(standing.half[2], lying.half[1], 1e-6);
    ck_assert_double_eq_tol(standing.center[1], lying.center[2], 1e-6);
    ck_assert_double_eq_tol(standing.center[2], -lying.center[1], 1e-6);
    ck_assert_int_eq(hatch_scene_turn_up(&scene, HATCH_UP_X, &keep, &err), HATCH_OK);
    ck_assert_int_eq(hatch_scene_measure(&scene, &scratch, &lying, &err), HATCH_OK);
    ck_assert_double_eq_tol(lying.half[1], standing.half[0], 1e-6);
    ck_assert_double_eq_tol(lying.center[1], standing.center[0], 1e-6);
    ck_assert_double_eq_tol(lying.center[0], -standing.center[1], 1e-6);
}
END_TEST

static Suite *suite(void)
{
    Suite *suite = suite_create("scene up");
    TCase *tests = tcase_create("up");
    tcase_add_checked_fixture(tests, begin, end);
    tcase_add_test(tests, bases_along_z_are_found);
    tcase_add_test(tests, no_base_is_no_hint);
    tcase_add_test(tests, scenes_are_turned_upright);
    suite_add_tcase(suite, tests);
    return suite;
}

HATCH_TEST_MAIN(suite)
