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
static struct hatch_skin skin = {.joint_count = 2, .joints = joints, .inverse_bind = bind[0]};
static struct hatch_scene_mesh shown;

/* At one second the first target has weight 1 and moves up by 4, the second has weight 2 and moves to the front by 1;
 * so do normals. */
static float times[2] = {0, 1}, counts[4] = {0, 0, 1, 2};
static struct hatch_animation_channel channel = {0, HATCH_PATH_WEIGHTS, HATCH_LINEAR, 2, times, counts, 2};
static struct hatch_animation animation = {.channel_count = 1, .channels = &channel, .duration_s = 1};
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

/* Two faces of a flat square, one of which a target folds up by a right angle about their diagonal, and another down
 * from there: what is flat stays flat, and the rest stays as it is. */
START_TEST(faces_without_normals_turn_as_they_move)
{
    static const float square[] = {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0};
    static const float up[] = {-0.5f, 0.5f, 0.70710678f}, root = 0.70710678f;
    const uint32_t faces[] = {0, 1, 2, 0, 2, 3};
    const bool less[] = {false, true};
    float *moves, folded[3] = {-root, root, 0}, flat[3] = {0, 0, 1};
    struct hatch_mesh mesh;
    HATCH_TEST_OK(hatch_mesh_make(&keep, 4, 2, &mesh, &err), &err);
    memcpy(mesh.attributes[0].data, square, sizeof square);
    memcpy(mesh.indices, faces, sizeof faces);
    HATCH_TEST_OK(hatch_mesh_add(&keep, &mesh, HATCH_MORPH_POSITION, 6, &moves, &err), &err);
    memcpy(moves + 6, up, sizeof up); /* corner 1, by the first target */
    for (int k = 0; k < 3; k++)
        moves[6 + 3 + k] = -up[k]; /* that of the second one leads here, and back with a weight of -1 */
    HATCH_TEST_OK(hatch_mesh_add_flat_normals(&keep, &mesh, less, &err), &err);
    ck_assert_uint_eq(mesh.vertex_count, 6);
    const float *normals = hatch_mesh_find(&mesh, "NORMAL", 3), *turns = hatch_mesh_find(&mesh, HATCH_MORPH_NORMAL, 6);
    for (uint32_t v = 0; v < 6; v++)
        for (int k = 0; k < 3; k++) {
            float first = v < 3 ? folded[k] - flat[k] : 0;
            ck_assert_float_eq_tol(normals[3 * v + (uint32_t)k], flat[k], 1e-6f);
            ck_assert_float_eq_tol(turns[6 * v + (uint32_t)k], first, 1e-6f);
            ck_assert_float_eq_tol(turns[6 * v + 3 + (uint32_t)k], -first, 1e-6f);
        }
}
END_TEST

/* A triangle one wide that goes from 0 to 10 and back within a second. */
static struct hatch_mesh wide;
static float turns[3] = {0, 0.5f, 1}, places[9] = {0, 0, 0, 10, 0, 0, 0, 0, 0};
static struct hatch_animation_channel moving = {0, HATCH_PATH_TRANSLATION, HATCH_LINEAR, 3, turns, places, 0};
static struct hatch_animation swing = {.channel_count = 1, .channels = &moving, .duration_s = 1};

static void begin_film(void)
{
    begin();
    HATCH_TEST_OK(hatch_mesh_make(&keep, 3, 1, &wide, &err), &err);
    wide.attributes[0].data[3] = 1;
    wide.attributes[0].data[7] = 1;
    for (uint32_t v = 0; v < 3; v++)
        wide.indices[v] = v;
}

/* Measures the bounds of a film of the triangle. Returns the number of its moments. */
static uint32_t measure_film(const struct hatch_film *film, double *low, double *high)
{
    struct hatch_scene moved;
    struct hatch_pose_span span;
    struct hatch_bounds bounds;
    HATCH_TEST_OK(hatch_scene_of_mesh(&wide, &keep, &moved, &err), &err);
    moved.animations = &swing;
    moved.animation_count = 1;
    HATCH_TEST_OK(hatch_film_span(&moved, film, &keep, &span, &err), &err);
    HATCH_TEST_OK(hatch_pose_make(&moved, &keep, &pose, &err), &err);
    HATCH_TEST_OK(hatch_pose_bounds(&pose, &span, &scratch, &bounds, &err), &err);
    *low = bounds.center[0] - bounds.half[0];
    *high = bounds.center[0] + bounds.half[0];
    for (uint32_t i = 0; i < span.moments; i++)
        ck_assert(i == 0 || span.times_s[i] > span.times_s[i - 1]);
    return span.moments;
}

/* Moments that are spaced evenly over whole seconds would all find the triangle at the same places. */
START_TEST(a_film_is_bounded_however_often_the_animation_repeats)
{
    static const struct {
        struct hatch_film film;
        double low, high;
        uint32_t moments;
    } films[] = {
        {{HATCH_NONE, 0.25, 24, 193}, 0, 1, 1},
        {{0, 0.25, 24, 1}, 5, 6, 1},
        {{0, 0, 24, 193}, 0, 11, 0},
        {{0, 0, 32, 257}, 0, 11, 33},
        {{0, 0, 2, 17}, 0, 11, 3},
        {{0, 8, 16, 5}, 0, 6, 5},       /* 0 to 0.25 s of the ninth round */
        {{0, 8.75, 16, 9}, 0, 6, 10},   /* over the end of a round: 0.75 to 1 s, and 0 to 0.25 s */
        {{0, 0.375, 4, 2}, 7.5, 11, 3}, /* the key at 0.5 s lies between its pictures */
        {{0, 0, 1000, 4096}, 0, 11, 0},
        {{0, 1e6 - 8, 24, 193}, 0, 11, 0},
    };
    for (size_t i = 0; i < sizeof films / sizeof *films; i++) {
        double low, high;
        const uint32_t moments = measure_film(&films[i].film, &low, &high);
        ck_assert_double_eq_tol(low, films[i].low, 1e-6);
        ck_assert_double_eq_tol(high, films[i].high, 1e-6);
        ck_assert(!films[i].moments || moments == films[i].moments);
    }
}
END_TEST

/* A mesh so large that 17 moments remain keeps the keys, where motion turns back. */
START_TEST(films_of_large_meshes_have_few_moments)
{
    const uint32_t faces = 400000;
    const struct hatch_film film = {0, 0.013, 500, 4096};
    double low, high;
    wide.indices = HATCH_NEW(&keep, uint32_t, 3 * (size_t)faces, &err);
    wide.face_count = faces;
    wide.indices[1] = 1;
    wide.indices[2] = 2;
    ck_assert_uint_eq(measure_film(&film, &low, &high), 17);
    ck_assert_double_eq_tol(low, 0, 1e-6);
    ck_assert_double_eq_tol(high, 11, 1e-6);
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
    tcase_add_test(tests, faces_without_normals_turn_as_they_move);
    suite_add_tcase(suite, tests);
    TCase *films = tcase_create("films");
    tcase_add_checked_fixture(films, begin_film, end);
    tcase_add_test(films, a_film_is_bounded_however_often_the_animation_repeats);
    tcase_add_test(films, films_of_large_meshes_have_few_moments);
    suite_add_tcase(suite, films);
    return suite;
}

HATCH_TEST_MAIN(suite)
