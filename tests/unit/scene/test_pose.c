#include <math.h>
#include <string.h>

#include "arenas.h"
#include "scene/pose.h"

#define IDENTITY                                                                                                       \
    {                                                                                                                  \
        1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1                                                                 \
    }

/* Node 0 has a triangle with a skin of nodes 1 and 2; node 2 is 5 to the right. */
static struct hatch_node nodes[3];
static uint32_t joints[2] = {1, 2};
static float bind[2][16] = {IDENTITY, IDENTITY};
static struct hatch_skin skin = {2, joints, bind[0]};
static struct hatch_scene_mesh shown;

/* At one second the first target has weight 1 and moves up by 4, the second has weight 2 and moves to the front by 1;
 * so do normals. */
static float times[2] = {0, 1}, counts[4] = {0, 0, 1, 2};
static struct hatch_animation_channel channel = {0, HATCH_PATH_WEIGHTS, HATCH_LINEAR, 2, times, counts, 2};
static struct hatch_animation animation = {1, &channel, 1};
static struct hatch_scene scene = {.nodes = nodes,
                                   .node_count = 3,
                                   .meshes = &shown,
                                   .mesh_count = 1,
                                   .skins = &skin,
                                   .skin_count = 1,
                                   .animations = &animation,
                                   .animation_count = 1};
static struct hatch_pose pose;

static void pose_triangle(const float weights[4], double at[3])
{
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
    HATCH_TEST_OK(hatch_pose_make(&scene, &keep, &pose, &err), &err);
    hatch_pose_set(&pose, HATCH_NONE, 0);
    hatch_pose_vertices(&pose, 0, 0, positions, NULL);
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

START_TEST(targets_move_before_joints_do)
{
    static const float moves[] = {0, 4, 0, 0, 0, 1};
    float *data[3];
    double at[3], positions[9];
    float normals[9];
    pose_triangle((const float[]){1, 0, 0, 0}, at);
    HATCH_TEST_OK(hatch_mesh_add(&keep, &shown.mesh, "NORMAL", 3, &data[0], &err), &err);
    HATCH_TEST_OK(hatch_mesh_add(&keep, &shown.mesh, HATCH_MORPH_POSITION, 6, &data[1], &err), &err);
    HATCH_TEST_OK(hatch_mesh_add(&keep, &shown.mesh, HATCH_MORPH_NORMAL, 6, &data[2], &err), &err);
    for (int v = 0; v < 3; v++) {
        data[0][3 * v] = 1;
        memcpy(data[1] + 6 * v, moves, sizeof moves);
        memcpy(data[2] + 6 * v, moves, sizeof moves);
    }
    ck_assert(hatch_pose_deforms(&scene, 0, &shown.mesh));
    HATCH_TEST_OK(hatch_pose_make(&scene, &keep, &pose, &err), &err);
    for (double t = 0; t <= 1; t += 0.25) {
        double length = sqrt(1 + 16 * t * t + 4 * t * t);
        hatch_pose_set(&pose, 0, t);
        hatch_pose_vertices(&pose, 0, 0, positions, normals);
        ck_assert_double_eq(positions[0], 5);
        ck_assert_double_eq(positions[1], 4 * t);
        ck_assert_double_eq(positions[2], 2 * t);
        ck_assert_double_eq_tol((double)normals[1], 4 * t / length, 1e-6);
        ck_assert_double_eq_tol((double)normals[2], 2 * t / length, 1e-6);
    }
}
END_TEST

static Suite *suite(void)
{
    Suite *suite = suite_create("render pose");
    TCase *tests = tcase_create("skins");
    tcase_add_checked_fixture(tests, begin, end);
    tcase_add_test(tests, weights_are_shares);
    tcase_add_test(tests, without_weights_the_first_joint_carries);
    tcase_add_test(tests, targets_move_before_joints_do);
    suite_add_tcase(suite, tests);
    return suite;
}

HATCH_TEST_MAIN(suite)
