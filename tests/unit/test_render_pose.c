#include <string.h>

#include "arenas.h"
#include "render-gl/pose.h"

#define IDENTITY {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}

/* Node 0 shows a triangle with a skin of nodes 1 and 2, of which the second stands 5 to the right. */
static struct hatch_node nodes[3];
static uint32_t joints[2] = {1, 2};
static float bind[2][16] = {IDENTITY, IDENTITY};
static struct hatch_skin skin = {2, joints, bind[0]};
static struct hatch_scene_mesh shown;

static void pose_triangle(const float weights[4], double at[3])
{
    struct hatch_scene scene = {
        .nodes = nodes, .node_count = 3, .meshes = &shown, .mesh_count = 1, .skins = &skin, .skin_count = 1};
    struct pose pose;
    double positions[9];
    float *joint, *weight;
    HATCH_TEST_OK(hatch_mesh_make(&keep, 3, 1, &shown.mesh, &err), &err);
    HATCH_TEST_OK(hatch_mesh_add(&keep, &shown.mesh, "JOINTS_0", 4, &joint, &err), &err);
    HATCH_TEST_OK(hatch_mesh_add(&keep, &shown.mesh, "WEIGHTS_0", 4, &weight, &err), &err);
    for (int v = 0; v < 3; v++) {
        joint[4 * v] = 1;
        memcpy(weight + 4 * v, weights, 4 * sizeof *weight);
    }
    for (int n = 0; n < 3; n++)
        nodes[n] = (struct hatch_node){.parent = HATCH_NONE,
                                       .rotation = {0, 0, 0, 1},
                                       .scale = {1, 1, 1},
                                       .translation = {n == 2 ? 5.0f : 0.0f, 0, 0},
                                       .mesh_count = n == 0,
                                       .skin = n == 0 ? 0 : HATCH_NONE};
    HATCH_TEST_OK(pose_make(&scene, &keep, &pose, &err), &err);
    pose_at(&pose, HATCH_NONE, 0);
    pose_vertices(&pose, 0, 0, positions, NULL);
    memcpy(at, positions, 3 * sizeof *at);
}

START_TEST(weights_are_shares)
{
    double at[3];
    pose_triangle((const float[]){1, 1, 0, 0}, at); /* of joints 1 and 0 */
    ck_assert_double_eq(at[0], 2.5);
    pose_triangle((const float[]){0.25f, 0, 0, 0}, at);
    ck_assert_double_eq(at[0], 5);
}
END_TEST

START_TEST(without_weights_the_first_joint_carries)
{
    double at[3];
    pose_triangle((const float[]){0, 0, 0, 0}, at);
    ck_assert_double_eq(at[0], 5);
}
END_TEST

static Suite *suite(void)
{
    Suite *suite = suite_create("render pose");
    TCase *tests = tcase_create("skins");
    tcase_add_checked_fixture(tests, begin, end);
    tcase_add_test(tests, weights_are_shares);
    tcase_add_test(tests, without_weights_the_first_joint_carries);
    suite_add_tcase(suite, tests);
    return suite;
}

HATCH_TEST_MAIN(suite)
