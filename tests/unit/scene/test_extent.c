/* Sizes of scenes at rest. */
#include "fail_alloc.h"
#include "meshes.h"
#include "scene/extent.h"

static struct hatch_scene_mesh meshes[2];
static struct hatch_node nodes[3];
static struct hatch_skin skin;
static uint32_t joint = 1;
static float inverse_bind[16] = {2, 0, 0, 0, 0, 2, 0, 0, 0, 0, 2, 0, 0, 0, 0, 1};
static struct hatch_scene scene;
static struct hatch_scene_extent extent;

/* Two cubes, from -1 to 1 and from 0 to 4; nodes draw nothing yet. */
static void begin_scene(void)
{
    begin();
    meshes[0] = (struct hatch_scene_mesh){.mesh = cube(-1, 1)};
    meshes[1] = (struct hatch_scene_mesh){.mesh = cube(0, 4)};
    for (int n = 0; n < 3; n++)
        nodes[n] = (struct hatch_node){.parent = HATCH_NONE,
                                       .rotation = {0, 0, 0, 1},
                                       .scale = {1, 1, 1},
                                       .skin = HATCH_NONE,
                                       .camera = HATCH_NONE,
                                       .light = HATCH_NONE};
    skin = (struct hatch_skin){.joint_count = 1, .joints = &joint, .inverse_bind = inverse_bind};
    scene = (struct hatch_scene){
        .mesh_count = 2, .node_count = 3, .skin_count = 1, .meshes = meshes, .nodes = nodes, .skins = &skin};
}

static void place(uint32_t node, uint32_t mesh, float x, float y, float z)
{
    nodes[node].first_mesh = mesh;
    nodes[node].mesh_count = 1;
    nodes[node].scale[0] = x;
    nodes[node].scale[1] = y;
    nodes[node].scale[2] = z;
}

/* Checks the diagonal of the box and the meshes' scales. */
static void check_extent(double diagonal, double first, double second)
{
    HATCH_TEST_OK(hatch_scene_find_extent(&scene, &keep, &scratch, &extent, &err), &err);
    ck_assert_double_eq_tol(extent.diagonal, diagonal, 1e-5 * diagonal);
    ck_assert_double_eq_tol(extent.scale[0], first, 1e-6 * first);
    ck_assert_double_eq_tol(extent.scale[1], second, 1e-6 * second);
}

START_TEST(a_scale_is_the_cube_root_of_the_volume)
{
    place(0, 0, 2, -3, 4);
    nodes[0].translation[1] = 1e3f;
    check_extent(2 * sqrt(4 + 9 + 16), cbrt(24), 1);
    place(2, 1, 0.5f, 0.5f, 0.5f);
    nodes[2].translation[1] = 997; /* from 997 to 999 */
    check_extent(sqrt(4 * 4 + 6 * 6 + 8 * 8), cbrt(24), 0.5);
}
END_TEST

START_TEST(scales_of_parents_multiply)
{
    place(2, 0, 3, 3, 3);
    nodes[2].parent = 1;
    nodes[1].parent = 0;
    for (int k = 0; k < 3; k++)
        nodes[0].scale[k] = nodes[1].scale[k] = 0.5f;
    nodes[2].rotation[2] = nodes[2].rotation[3] = (float)sqrt(0.5); /* a right angle: the box stays as large */
    check_extent(1.5 * sqrt(3), 0.75, 1);
}
END_TEST

START_TEST(the_first_node_that_has_a_size_counts)
{
    place(0, 0, 0, 0, 0);
    place(1, 0, 5, 5, 5);
    place(2, 0, 2, 2, 2);
    check_extent(10 * sqrt(3), 5, 1);
    place(1, 0, 1, 0, 1);
    place(2, 0, 1, 0, 1);
    check_extent(sqrt(8), 1, 1);
}
END_TEST

static void check_unevenness(double first, double second)
{
    HATCH_TEST_OK(hatch_scene_find_extent(&scene, &keep, &scratch, &extent, &err), &err);
    ck_assert_double_eq_tol(extent.unevenness[0], first, 1e-5 * first);
    ck_assert_double_eq_tol(extent.unevenness[1], second, 1e-5 * second);
}

/* A scale by 1 and 3, an eighth of a turn, and a scale by 2 and 1 have singular values whose squares are
 * 12.5 +- sqrt(481) / 2. */
START_TEST(unevenness_is_the_ratio_of_singular_values)
{
    check_unevenness(1, 1);
    place(0, 0, 1, -3, 1);
    place(1, 1, 5, 5, 5);
    check_unevenness(3, 1);
    place(2, 0, 2, 2, 0.5f);
    check_unevenness(4, 1);
    place(2, 0, 1, 0, 1); /* flat: does not count */
    check_unevenness(3, 1);
    place(0, 0, 2, 1, 2);
    nodes[0].mesh_count = 0;
    place(2, 0, 1, -3, 1);
    nodes[2].parent = 0;
    nodes[2].rotation[2] = (float)sin(0.39269908169872414);
    nodes[2].rotation[3] = (float)cos(0.39269908169872414);
    check_unevenness(sqrt((12.5 + sqrt(481) / 2) / (12.5 - sqrt(481) / 2)), 1);
}
END_TEST

/* The box is then that of all meshes as they are. */
START_TEST(meshes_without_nodes_have_their_own_size)
{
    check_extent(5 * sqrt(3), 1, 1);
    scene.node_count = 0;
    check_extent(5 * sqrt(3), 1, 1);
    scene.mesh_count = 0;
    HATCH_TEST_OK(hatch_scene_find_extent(&scene, &keep, &scratch, &extent, &err), &err);
    ck_assert_double_eq(extent.diagonal, 0);
}
END_TEST

/* A skin's first joint places its meshes; their node does not. */
START_TEST(a_skin_is_placed_by_its_joint)
{
    place(0, 0, 7, 7, 7);
    nodes[0].skin = 0;
    for (int k = 0; k < 3; k++)
        nodes[1].scale[k] = 1.5f;
    check_extent(6 * sqrt(3), 3, 1);
}
END_TEST

static enum hatch_status measure(void *context, struct hatch_arena *kept, struct hatch_arena *temporary,
                                 struct hatch_err *error)
{
    return hatch_scene_find_extent(context, kept, temporary, &extent, error);
}

START_TEST(every_failed_allocation_is_a_limit)
{
    place(0, 0, 1, 1, 1);
    nodes[0].skin = 0;
    hatch_test_fail_alloc(measure, &scene, &extent, sizeof extent);
}
END_TEST

static Suite *suite(void)
{
    Suite *suite = suite_create("scene extent");
    TCase *tests = tcase_create("extent");
    tcase_add_checked_fixture(tests, begin_scene, end);
    tcase_add_test(tests, a_scale_is_the_cube_root_of_the_volume);
    tcase_add_test(tests, scales_of_parents_multiply);
    tcase_add_test(tests, the_first_node_that_has_a_size_counts);
    tcase_add_test(tests, unevenness_is_the_ratio_of_singular_values);
    tcase_add_test(tests, meshes_without_nodes_have_their_own_size);
    tcase_add_test(tests, a_skin_is_placed_by_its_joint);
    tcase_add_test(tests, every_failed_allocation_is_a_limit);
    suite_add_tcase(suite, tests);
    return suite;
}

HATCH_TEST_MAIN(suite)
