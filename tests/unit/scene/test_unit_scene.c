/* Items of a posed scene: their matrices against positions computed in world coordinates. */
#include "math/vector.h"
#include "meshes.h"
#include "scene/unit_scene.h"

static struct hatch_scene scene;
static struct hatch_unit_scene unit;

/* A torus away from its mesh's origin, in a node that is rotated, translated and scaled by `scale` along x. */
static struct hatch_mesh place_torus(float scale)
{
    const struct hatch_bounds bounds = {.center = {3, -2, 1}, .radius = 100};
    struct hatch_mesh torus = shape_of(HATCH_SHAPE_TORUS, 100);
    move(&torus, 1, 50);
    HATCH_TEST_OK(hatch_scene_of_mesh(&torus, &keep, &scene, &err), &err);
    struct hatch_node *node = &scene.nodes[0];
    node->translation[1] = 2.5f;
    node->rotation[2] = 0.6f;
    node->rotation[3] = 0.8f;
    node->scale[0] = scale;
    HATCH_TEST_OK(hatch_unit_scene_make(&scene, NULL, &bounds, &keep, &unit, &err), &err);
    hatch_unit_scene_pose(&unit, HATCH_NONE, 0);
    return torus;
}

START_TEST(the_matrix_leads_to_the_unit_scene)
{
    const struct hatch_mesh torus = place_torus(3);
    const struct hatch_item *item = &unit.items[0];
    double *world = HATCH_NEW(&keep, double, 3 * (size_t)torus.vertex_count, &err);
    double matrix[17] = {[16] = 7}; /* the last one is not of the matrix */
    ck_assert_uint_eq(unit.item_count, 1);
    ck_assert_double_gt(unit.meshes[0].origin[0], 40);
    hatch_pose_matrix(&unit.pose, 0, matrix);
    ck_assert(matrix[16] == 7 && matrix[15] == 1 && matrix[13] == 2.5);
    hatch_pose_vertices(&unit.pose, 0, 0, world, NULL);
    for (size_t v = 0; v < torus.vertex_count; v++) {
        double want[3];
        hatch_bounds_to_unit(&unit.bounds, world + 3 * v, want);
        for (int k = 0; k < 3; k++) {
            double at = (double)item->to_unit[12 + k];
            for (int i = 0; i < 3; i++)
                at += (double)item->to_unit[4 * i + k] *
                      ((double)torus.attributes[0].data[3 * v + (size_t)i] - unit.meshes[0].origin[i]);
            ck_assert_double_eq_tol(at, want[k], 1e-6);
        }
    }
}
END_TEST

START_TEST(a_mirroring_node_mirrors_its_item)
{
    place_torus(3);
    ck_assert(!unit.items[0].mirrored);
    place_torus(-3);
    ck_assert(unit.items[0].mirrored);
}
END_TEST

START_TEST(an_item_has_the_sides_and_holes_of_its_material)
{
    struct hatch_material material = {.base_color = {1, 1, 1, 0.5f}, .alpha_cutoff = 0.25f};
    place_torus(1);
    ck_assert(unit.items[0].double_sided);
    ck_assert_float_eq(unit.items[0].alpha_cutoff, 0);
    scene.materials = &material;
    scene.material_count = 1;
    scene.meshes[0].material = 0;
    for (int sides = 0; sides < 2; sides++) {
        material.double_sided = sides;
        HATCH_TEST_OK(hatch_unit_scene_make(&scene, NULL, &unit.bounds, &keep, &unit, &err), &err);
        ck_assert_int_eq(unit.items[0].double_sided, sides);
        ck_assert_float_eq(unit.items[0].alpha_cutoff, 0.5f);
    }
}
END_TEST

START_TEST(posing_again_at_the_same_moment_is_no_change)
{
    place_torus(1);
    ck_assert_uint_eq(unit.pose_number, 1);
    hatch_unit_scene_pose(&unit, HATCH_NONE, 0);
    ck_assert_uint_eq(unit.pose_number, 1);
    hatch_unit_scene_pose(&unit, HATCH_NONE, 1);
    ck_assert_uint_eq(unit.pose_number, 2);
}
END_TEST

/* Places of the mesh's point x, y, z in the texture, before the offset. */
static void place_of(const struct hatch_item_rest *rest, double x, double y, double z, double place[3])
{
    const double point[3] = {x / rest->unit, y / rest->unit, z / rest->unit};
    for (int k = 0; k < 3; k++)
        place[k] = hatch_vec_dot(rest->axes[k], point);
}

/* A quarter turn of the texture around x takes its y to z and its z to -y; one around y then takes x to -z and z to x.
 */
START_TEST(solid_textures_turn_around_x_then_y_then_z)
{
    const double quarter = acos(-1) / 2;
    double place[3];
    place_torus(1);
    hatch_unit_scene_turn_rest(&unit, (const double[]){quarter, quarter, 0});
    struct hatch_item_rest rest = hatch_item_rest(&unit, 0);
    place_of(&rest, 1 * rest.unit, 2 * rest.unit, 3 * rest.unit, place);
    ck_assert_double_eq_tol(place[0], -3, 1e-14);
    ck_assert_double_eq_tol(place[1], 1, 1e-14);
    ck_assert_double_eq_tol(place[2], -2, 1e-14);
    hatch_unit_scene_turn_rest(&unit, (const double[]){0, 0, quarter});
    rest = hatch_item_rest(&unit, 0);
    place_of(&rest, 1 * rest.unit, 2 * rest.unit, 3 * rest.unit, place);
    ck_assert_double_eq_tol(place[0], 2, 1e-14);
    ck_assert_double_eq_tol(place[1], -1, 1e-14);
    ck_assert_double_eq_tol(place[2], 3, 1e-14);
}
END_TEST

/* A mesh that lies 5 farther along y has the places of points 5 farther along y, up to 64 periods. */
START_TEST(turned_textures_continue_from_mesh_to_mesh)
{
    double before[3];
    place_torus(1);
    hatch_unit_scene_turn_rest(&unit, (const double[]){0.3, -0.7, 1.1});
    struct hatch_item_rest rest = hatch_item_rest(&unit, 0);
    memcpy(before, rest.offset, sizeof before);
    unit.meshes[0].origin[1] += 5;
    rest = hatch_item_rest(&unit, 0);
    for (int k = 0; k < 3; k++) {
        double turns = (rest.offset[k] - before[k] - 5 * rest.axes[k][1] / rest.unit) / 64;
        ck_assert_double_eq_tol(turns, round(turns), 1e-12);
    }
}
END_TEST

/* Poses a shape that its node scales. Returns the length of a unit. */
static double scale_of(enum hatch_shape shape, double x, double y, double z)
{
    const struct hatch_bounds bounds = {.radius = 1};
    struct hatch_mesh mesh = shape_of(shape, 2000);
    HATCH_TEST_OK(hatch_scene_of_mesh(&mesh, &keep, &scene, &err), &err);
    memcpy(scene.nodes[0].scale, (const double[]){x, y, z}, 3 * sizeof x);
    HATCH_TEST_OK(hatch_unit_scene_make(&scene, NULL, &bounds, &keep, &unit, &err), &err);
    hatch_unit_scene_pose(&unit, HATCH_NONE, 0);
    struct hatch_item_rest rest = hatch_item_rest(&unit, 0);
    return rest.scale / rest.unit;
}

/* A square across z grows by the factors along x and y alone. A sphere grows like a cube, of which a third each of the
 * faces grows by y z, by z x and by x y. */
START_TEST(solid_textures_have_the_size_of_the_surface)
{
    ck_assert_double_eq_tol(scale_of(HATCH_SHAPE_PLANE, 10, 10, 10), 10, 1e-6);
    ck_assert_double_eq_tol(scale_of(HATCH_SHAPE_PLANE, 10, 10, 1), 10, 1e-6);
    ck_assert_double_eq_tol(scale_of(HATCH_SHAPE_PLANE, 10, -10, 0), 10, 1e-6);
    ck_assert_double_eq_tol(scale_of(HATCH_SHAPE_PLANE, 8, 2, 5), 4, 1e-6);
    ck_assert_double_eq_tol(scale_of(HATCH_SHAPE_TORUS, 3, 3, 3), 3, 1e-6);
    ck_assert_double_eq_tol(scale_of(HATCH_SHAPE_SPHERE, 2, 3, 4), sqrt(sqrt((144 + 64 + 36) / 3.0)), 0.01);
}
END_TEST

static Suite *suite(void)
{
    Suite *made = suite_create("unit scene");
    TCase *tests = tcase_create("unit scene");
    tcase_add_checked_fixture(tests, begin, end);
    tcase_add_test(tests, the_matrix_leads_to_the_unit_scene);
    tcase_add_test(tests, a_mirroring_node_mirrors_its_item);
    tcase_add_test(tests, an_item_has_the_sides_and_holes_of_its_material);
    tcase_add_test(tests, posing_again_at_the_same_moment_is_no_change);
    tcase_add_test(tests, solid_textures_turn_around_x_then_y_then_z);
    tcase_add_test(tests, turned_textures_continue_from_mesh_to_mesh);
    tcase_add_test(tests, solid_textures_have_the_size_of_the_surface);
    suite_add_tcase(made, tests);
    return made;
}

HATCH_TEST_MAIN(suite)
