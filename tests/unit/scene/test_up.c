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

/* Adds a right-angled triangle with short sides of a length along x and y; it touches the planes of both axes only if
 * the length is 1. */
static void add_level(struct hatch_mesh *mesh, double length, double z)
{
    size_t face = mesh->face_count++;
    double low = (1 - length) / 4;
    const double corners[3][2] = {{low + length, low}, {low, low + length}, {low, low}};
    for (size_t c = 0; c < 3; c++) {
        float *p = &mesh->attributes[0].data[3 * (3 * face + c)];
        p[0] = (float)corners[c][0];
        p[1] = (float)corners[c][1];
        p[2] = (float)z;
        mesh->indices[3 * face + c] = (uint32_t)(3 * face + c);
    }
}

/* Returns whether a mesh stands along z whose levels are triangles at the bottom, in the middle and at the top, of
 * given lengths, and one of length 0.5 at a height that has a corner beside the bottom's edge along x, unless the
 * height is 0. */
static bool levels_stand(double bottom, double middle, double top, double beside)
{
    struct hatch_mesh mesh;
    HATCH_TEST_OK(hatch_mesh_make(&keep, 12, 4, &mesh, &err), &err);
    mesh.face_count = 0;
    add_level(&mesh, bottom, 0);
    add_level(&mesh, middle, 0.5);
    add_level(&mesh, top, 1);
    if (beside > 0) {
        add_level(&mesh, 0.5, beside);
        mesh.attributes[0].data[9 * 3 + 1] = 0;
    }
    return hatch_mesh_stands_along_z(&mesh);
}

/* Seen along z, a base covers at least 0.15 of the mesh's rectangle, and twice as much as the top; seen along y, the
 * lowest points cover at most a quarter of that: here as much as the height of the corner beside the base. */
START_TEST(bases_are_told_from_others_at_the_limits)
{
    ck_assert(levels_stand(0.39, 1, 0.1, 0));
    ck_assert(!levels_stand(0.38, 1, 0.1, 0));
    ck_assert(levels_stand(1, 0.5, 0.7, 0));
    ck_assert(!levels_stand(1, 0.5, 0.72, 0));
    ck_assert(levels_stand(1, 0.5, 0.5, 0.24));
    ck_assert(!levels_stand(1, 0.5, 0.5, 0.26));
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
    ck_assert_int_eq(hatch_scene_measure(&scene, NULL, &scratch, &lying, &err), HATCH_OK);
    ck_assert_int_eq(hatch_scene_turn_up(&scene, HATCH_UP_Y, &keep, &err), HATCH_OK);
    ck_assert_uint_eq(scene.node_count, 1);
    ck_assert_int_eq(hatch_scene_turn_up(&scene, HATCH_UP_Z, &keep, &err), HATCH_OK);
    ck_assert_int_eq(hatch_scene_measure(&scene, NULL, &scratch, &standing, &err), HATCH_OK);
    ck_assert_double_eq_tol(standing.half[0], lying.half[0], 1e-6);
    ck_assert_double_eq_tol(standing.half[1], lying.half[2], 1e-6);
    ck_assert_double_eq_tol(standing.half[2], lying.half[1], 1e-6);
    ck_assert_double_eq_tol(standing.center[1], lying.center[2], 1e-6);
    ck_assert_double_eq_tol(standing.center[2], -lying.center[1], 1e-6);
    ck_assert_int_eq(hatch_scene_turn_up(&scene, HATCH_UP_X, &keep, &err), HATCH_OK);
    ck_assert_int_eq(hatch_scene_measure(&scene, NULL, &scratch, &lying, &err), HATCH_OK);
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
    tcase_add_test(tests, bases_are_told_from_others_at_the_limits);
    tcase_add_test(tests, no_base_is_no_hint);
    tcase_add_test(tests, borders_of_terrains_are_no_bases);
    tcase_add_test(tests, ends_that_are_alike_are_no_bases);
    tcase_add_test(tests, scenes_are_turned_upright);
    suite_add_tcase(suite, tests);
    return suite;
}

HATCH_TEST_MAIN(suite)
