/* Coarse meshes of scenes: how far a surface may move follows from what nodes, joints and views make of a length. */
#include "coarse/scene.h"

#include "coarse/coarse.h"
#include "math/vector.h"
#include "meshes.h"
#include "run.h"
#include "views.h"

enum { NODES = 5, MESHES = 4, HIGH_PX = 500 };

/* In the picture, the unit scene is 500 pixels high for two units: a length of 1 in the world covers 250 / 8 pixels. */
static const struct hatch_bounds bounds = {.center = {1, -2, 0.5}, .radius = 8};
static const double error_px = 4, flat_tolerance = 4.0 * 8 / 250;
static struct hatch_view view;
static const struct hatch_view_set views = {&bounds, 1, &view, HIGH_PX, HIGH_PX};

static struct hatch_scene_mesh shown[MESHES];
static struct hatch_node nodes[NODES];
static struct hatch_scene scene;
static struct hatch_mesh made[MESHES];

/* Makes a scene of nodes that do not move and draw nothing yet. */
static void make_scene(uint32_t node_count, uint32_t mesh_count)
{
    view = view_facing;
    scene = (struct hatch_scene){.mesh_count = mesh_count, .node_count = node_count, .meshes = shown, .nodes = nodes};
    for (uint32_t n = 0; n < node_count; n++)
        nodes[n] = (struct hatch_node){.parent = HATCH_NONE,
                                       .rotation = {0, 0, 0, 1},
                                       .scale = {1, 1, 1},
                                       .skin = HATCH_NONE,
                                       .camera = HATCH_NONE,
                                       .light = HATCH_NONE};
    for (uint32_t m = 0; m < mesh_count; m++)
        shown[m] = (struct hatch_scene_mesh){.mesh = bare_shape(m % 2 ? HATCH_SHAPE_SPHERE : HATCH_SHAPE_TORUS, 900),
                                             .material = HATCH_NONE};
}

static void make_coarse(const float *share)
{
    struct hatch_pose pose;
    HATCH_TEST_OK(hatch_pose_make(&scene, &keep, &pose, &err), &err);
    hatch_pose_set(&pose, HATCH_NONE, 0);
    HATCH_TEST_OK(hatch_coarse_scene(&pose, &views, error_px, share, &keep, &scratch, made, &err), &err);
}

static double *all_of(const struct hatch_mesh *mesh, double tolerance)
{
    double *tolerances = HATCH_NEW(&keep, double, mesh->vertex_count, &err);
    for (uint32_t v = 0; v < mesh->vertex_count; v++)
        tolerances[v] = tolerance;
    return tolerances;
}

/* Checks that the first meshes of the scene have become as coarse as these tolerances alone make them. */
static void check(uint32_t count, double *const *tolerances)
{
    struct hatch_coarse_part parts[MESHES] = {{0}};
    struct hatch_mesh want[MESHES];
    for (uint32_t m = 0; m < count; m++)
        parts[m] = (struct hatch_coarse_part){&shown[m].mesh, tolerances[m], NULL};
    HATCH_TEST_OK(hatch_coarse_make(parts, count, &keep, &scratch, want, &err), &err);
    for (uint32_t m = 0; m < count; m++) {
        ck_assert_uint_lt(want[m].face_count, shown[m].mesh.face_count);
        ck_assert_uint_eq(made[m].face_count, want[m].face_count);
        ck_assert_mem_eq(made[m].indices, want[m].indices, 3 * (size_t)want[m].face_count * sizeof(uint32_t));
        ck_assert_mem_eq(made[m].attributes[0].data, want[m].attributes[0].data,
                         3 * (size_t)want[m].vertex_count * sizeof(float));
    }
}

static void check_flat(uint32_t count, double first, double second)
{
    check(count, (double *[]){all_of(&shown[0].mesh, first), count > 1 ? all_of(&shown[1].mesh, second) : NULL});
}

/* The largest factor counts, along whichever axis it is, in a turned node, too. */
START_TEST(nodes_that_scale_lower_the_tolerance)
{
    for (int axis = 0; axis < 3; axis++) {
        make_scene(1, 1);
        nodes[0].mesh_count = 1;
        for (int k = 0; k < 3; k++)
            nodes[0].scale[k] = k == axis ? 4 : 0.5f;
        make_coarse(NULL);
        check_flat(1, flat_tolerance / 4, 0);
    }
    make_scene(1, 1);
    nodes[0].mesh_count = 1;
    nodes[0].scale[0] = nodes[0].scale[1] = nodes[0].scale[2] = 2;
    nodes[0].rotation[1] = 0.6f;
    nodes[0].rotation[3] = 0.8f;
    make_coarse(NULL);
    uint32_t turned = made[0].face_count;
    nodes[0].rotation[1] = 0;
    nodes[0].rotation[3] = 1;
    make_coarse(NULL);
    check_flat(1, flat_tolerance / 2, 0);
    ck_assert_double_eq_tol(turned, made[0].face_count, 0.05 * made[0].face_count);
}
END_TEST

/* A mesh without size at rest counts as large as the animation makes it: a point where it stands, at half of its size.
 */
START_TEST(what_grows_from_nothing_counts_at_its_largest)
{
    static float times_s[2] = {0, 1}, scales[6] = {0, 0, 0, 0.5f, 0.5f, 0.5f};
    static struct hatch_animation_channel channel = {
        .path = HATCH_PATH_SCALE, .key_count = 2, .times_s = times_s, .values = scales};
    static struct hatch_animation animation = {.channel_count = 1, .channels = &channel, .duration_s = 1};
    make_scene(2, 2);
    nodes[0].mesh_count = nodes[1].mesh_count = nodes[1].first_mesh = 1;
    for (int k = 0; k < 3; k++)
        nodes[0].scale[k] = 0;
    scene.animations = &animation;
    scene.animation_count = 1;
    make_coarse(NULL);
    check_flat(1, 2 * flat_tolerance, 0);
}
END_TEST

/* Copies share their mesh: of what the nodes allow, each vertex has the least. The shares are in the order of the
 * copies: of node 0, which draws the first two meshes, and of node 2, which does at twice the size. Node 4 draws the
 * third, and no node the last. */
START_TEST(copies_allow_the_least_of_all)
{
    static const float share[2][2] = {{0.25f, 1}, {1, 0.75f}};
    float *shares;
    size_t at = 0;
    make_scene(NODES, MESHES);
    nodes[0].mesh_count = nodes[2].mesh_count = 2;
    nodes[2].scale[0] = nodes[2].scale[1] = nodes[2].scale[2] = 2;
    nodes[4].mesh_count = 1;
    nodes[4].first_mesh = 2;
    make_coarse(NULL);
    check_flat(2, flat_tolerance / 2, flat_tolerance / 2);
    HATCH_TEST_OK(HATCH_ALLOC(&keep, &shares, 4000, &err), &err);
    for (int copy = 0; copy < 2; copy++)
        for (int m = 0; m < 2; m++)
            for (uint32_t v = 0; v < shown[m].mesh.vertex_count; v++)
                shares[at++] = share[copy][m];
    ck_assert_uint_le(at + shown[2].mesh.vertex_count, 4000);
    for (uint32_t v = 0; v < shown[2].mesh.vertex_count; v++)
        shares[at++] = 1;
    make_coarse(shares);
    check_flat(2, flat_tolerance * 0.25, flat_tolerance * 0.75 / 2);
    ck_assert_uint_lt(made[2].face_count, shown[2].mesh.face_count);
    ck_assert_ptr_eq(made[3].indices, shown[3].mesh.indices);
}
END_TEST

/* One half has a joint of its own, which scales it by 4: only there is the tolerance lower. */
START_TEST(joints_that_scale_lower_the_tolerance_of_their_vertices)
{
    static uint32_t joints[2] = {1, 2};
    static float bind[32];
    static struct hatch_skin skin = {.joint_count = 2, .joints = joints, .inverse_bind = bind};
    float *data[2];
    make_scene(3, 1);
    struct hatch_mesh halves[2] = {shown[0].mesh, bare_shape(HATCH_SHAPE_SPHERE, 900)};
    move(&halves[1], 1, 4);
    shown[0].mesh = both(&halves[0], &halves[1]);
    for (int i = 0; i < 32; i++)
        bind[i] = i % 16 % 5 == 0;
    HATCH_TEST_OK(hatch_mesh_add(&keep, &shown[0].mesh, "JOINTS_0", 4, &data[0], &err), &err);
    HATCH_TEST_OK(hatch_mesh_add(&keep, &shown[0].mesh, "WEIGHTS_0", 4, &data[1], &err), &err);
    double *tolerances = all_of(&shown[0].mesh, flat_tolerance);
    for (uint32_t v = 0; v < shown[0].mesh.vertex_count; v++) {
        bool second = v >= halves[0].vertex_count;
        data[0][4 * v] = second;
        data[1][4 * v] = 1;
        tolerances[v] = second ? flat_tolerance / 4 : flat_tolerance;
    }
    scene.skins = &skin;
    scene.skin_count = 1;
    nodes[0].skin = 0;
    nodes[0].mesh_count = 1;
    nodes[2].scale[0] = nodes[2].scale[1] = nodes[2].scale[2] = 4;
    make_coarse(NULL);
    check(1, &tolerances);
}
END_TEST

/* In perspective, a vertex may move farther the farther from the eye its node places it. */
START_TEST(distance_raises_the_tolerance)
{
    make_scene(1, 1);
    nodes[0].mesh_count = 1;
    nodes[0].translation[2] = 2;
    view.orthographic = false;
    double *tolerances = all_of(&shown[0].mesh, 0);
    for (uint32_t v = 0; v < shown[0].mesh.vertex_count; v++) {
        double at[3];
        hatch_vec_of(&shown[0].mesh.attributes[0].data[3 * (size_t)v], at);
        at[2] += 2;
        tolerances[v] = error_px / hatch_views_pixels(&views, at);
    }
    make_coarse(NULL);
    check(1, &tolerances);
}
END_TEST

static Suite *suite(void)
{
    Suite *suite = suite_create("coarse scene");
    TCase *tests = tcase_create("scene");
    tcase_add_checked_fixture(tests, begin, end);
    tcase_add_test(tests, nodes_that_scale_lower_the_tolerance);
    tcase_add_test(tests, what_grows_from_nothing_counts_at_its_largest);
    tcase_add_test(tests, copies_allow_the_least_of_all);
    tcase_add_test(tests, joints_that_scale_lower_the_tolerance_of_their_vertices);
    tcase_add_test(tests, distance_raises_the_tolerance);
    suite_add_tcase(suite, tests);
    return suite;
}
HATCH_TEST_MAIN(suite)
