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

/* The scale at which a cube from 0 to 4, which nodes do not draw, is as large as a scene. */
static double scale_to(double diagonal)
{
    return diagonal / (4 * sqrt(3));
}

/* The faces of the cube get 12, 8 and 6 times as large. */
START_TEST(a_scale_is_the_root_of_what_faces_gain)
{
    double diagonal = 2 * sqrt(4 + 9 + 16), scale = sqrt(sqrt((144 + 64 + 36) / 3.0));
    place(0, 0, 2, -3, 4);
    nodes[0].translation[1] = 1e3f;
    check_extent(diagonal, scale, scale_to(diagonal));
    place(2, 1, 0.5f, 0.5f, 0.5f);
    nodes[2].translation[1] = 997; /* from 997 to 999 */
    check_extent(sqrt(4 * 4 + 6 * 6 + 8 * 8), scale, 0.5);
}
END_TEST

/* A plane keeps its size when its node makes it thinner. */
START_TEST(only_directions_that_a_mesh_has_count)
{
    static const float positions[12] = {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0};
    static const uint32_t indices[6] = {0, 1, 2, 0, 2, 3};
    meshes[0].mesh = mesh_of(positions, 4, indices, 2);
    place(0, 0, 3, 3, 1e-6f);
    check_extent(3 * sqrt(2), 3, scale_to(3 * sqrt(2)));
    meshes[0].mesh.face_count = 0;
    place(0, 1, 2, 2, 2);
    place(1, 0, 5, 5, 5);
    HATCH_TEST_OK(hatch_scene_find_extent(&scene, &keep, &scratch, &extent, &err), &err);
    ck_assert_double_eq_tol(extent.scale[0], 5, 1e-6);
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
    check_extent(1.5 * sqrt(3), 0.75, scale_to(1.5 * sqrt(3)));
}
END_TEST

START_TEST(the_largest_of_its_nodes_counts)
{
    place(0, 0, 0, 0, 0);
    place(1, 0, 2, 2, 2);
    place(2, 0, 5, 5, 5);
    check_extent(10 * sqrt(3), 5, scale_to(10 * sqrt(3)));
    place(1, 0, 1, 0, 1);
    place(2, 0, 1, 0, 1);
    check_extent(sqrt(8), sqrt(sqrt(1 / 3.0)), scale_to(sqrt(8)));
}
END_TEST

/* Where no animation gives it a size, it is as large as the scene. */
START_TEST(a_mesh_of_scale_zero_gets_the_size_of_the_scene)
{
    place(0, 0, 0.01f, 0.01f, 0.01f);
    place(1, 1, 0, 0, 0);
    check_extent(0.02 * sqrt(3), 0.01, 0.005);
}
END_TEST

static float times_s[3] = {0, 1, 2};
static float scales[9] = {0, 0, 0, 0.25f, 0.25f, 0.25f, 0.125f, 0.125f, 0.125f};
static struct hatch_animation_channel grows = {.node = 1,
                                               .path = HATCH_PATH_SCALE,
                                               .interpolation = HATCH_LINEAR,
                                               .key_count = 3,
                                               .times_s = times_s,
                                               .values = scales};
static struct hatch_animation animation = {.channel_count = 1, .channels = &grows, .duration_s = 2};

START_TEST(a_mesh_of_scale_zero_gets_the_largest_that_an_animation_sets)
{
    scene.animations = &animation;
    scene.animation_count = 1;
    place(0, 0, 1, 1, 1);
    place(1, 1, 0, 0, 0);
    check_extent(2 * sqrt(3), 1, 0.25);
    place(0, 0, 0, 0, 0); /* the scene has no size at rest */
    check_extent(sqrt(3), 0.5, 0.25);
    animation.channels->path = HATCH_PATH_TRANSLATION;
    HATCH_TEST_OK(hatch_scene_find_extent(&scene, &keep, &scratch, &extent, &err), &err);
    ck_assert_double_eq(extent.diagonal, 0);
    ck_assert_double_eq(extent.scale[1], 1);
    animation.channels->path = HATCH_PATH_SCALE;
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
    ck_assert_double_eq_tol(extent.stretch[0], 3, 1e-5);
    ck_assert_double_eq_tol(extent.stretch[1], 5, 1e-5);
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
    ck_assert_double_eq_tol(extent.stretch[0], sqrt(12.5 + sqrt(481) / 2), 1e-4);
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
    check_extent(6 * sqrt(3), 3, scale_to(6 * sqrt(3)));
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
    tcase_add_test(tests, a_scale_is_the_root_of_what_faces_gain);
    tcase_add_test(tests, only_directions_that_a_mesh_has_count);
    tcase_add_test(tests, scales_of_parents_multiply);
    tcase_add_test(tests, the_largest_of_its_nodes_counts);
    tcase_add_test(tests, a_mesh_of_scale_zero_gets_the_size_of_the_scene);
    tcase_add_test(tests, a_mesh_of_scale_zero_gets_the_largest_that_an_animation_sets);
    tcase_add_test(tests, unevenness_is_the_ratio_of_singular_values);
    tcase_add_test(tests, meshes_without_nodes_have_their_own_size);
    tcase_add_test(tests, a_skin_is_placed_by_its_joint);
    tcase_add_test(tests, every_failed_allocation_is_a_limit);
    suite_add_tcase(suite, tests);
    return suite;
}

HATCH_TEST_MAIN(suite)
