/* Meshes that stand along z are told from those that stand along y, and scenes are turned upright. */
#include <math.h>
#include <string.h>

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

/* Makes a terrain with y up, whose borders along z have hills of two heights. */
static struct hatch_mesh make_terrain(float low_hills, float high_hills)
{
    enum { N = 20 };
    struct hatch_mesh mesh;
    HATCH_TEST_OK(hatch_mesh_make(&keep, (N + 1) * (N + 1), 2 * N * N, &mesh, &err), &err);
    for (uint32_t i = 0; i < mesh.vertex_count; i++) {
        float x = (float)(i % (N + 1)) / N, z = (float)(i / (N + 1)) / N;
        const float p[3] = {x, (low_hills * (1 - z) + high_hills * z) * sinf(7 * x) - 0.5f * z * (1 - z), z};
        memcpy(&mesh.attributes[0].data[3 * i], p, sizeof p);
    }
    for (uint32_t q = 0; q < N * N; q++) {
        uint32_t a = q / N * (N + 1) + q % N, b = a + N + 1;
        const uint32_t faces[6] = {a, b, a + 1, a + 1, b, b + 1};
        memcpy(&mesh.indices[6 * q], faces, sizeof faces);
    }
    return mesh;
}

/* The lowest points of a terrain along z are one of its borders. */
START_TEST(borders_of_terrains_are_no_bases)
{
    struct hatch_mesh alike = make_terrain(0.1f, 0.1f), coast = make_terrain(0.1f, 0);
    ck_assert(!hatch_mesh_stands_along_z(&alike));
    ck_assert(!hatch_mesh_stands_along_z(&coast));
}
END_TEST

/* A torus from -1 to 1 in x and y lies on circles, at the bottom and at the top. */
START_TEST(ends_that_are_alike_are_no_bases)
{
    struct hatch_mesh ring = make(HATCH_SHAPE_TORUS, true);
    ck_assert(!hatch_mesh_stands_along_z(&ring));
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
    tcase_add_test(tests, borders_of_terrains_are_no_bases);
    tcase_add_test(tests, ends_that_are_alike_are_no_bases);
    tcase_add_test(tests, scenes_are_turned_upright);
    suite_add_tcase(suite, tests);
    return suite;
}

HATCH_TEST_MAIN(suite)
