#include <math.h>
#include <string.h>

#include "fail_alloc.h"
#include "math/vector.h"
#include "measure/mesh_figures.h"
#include "scene/scene.h"
#include "shapes/shapes.h"
#include "run.h"

#define HALF_SQRT 0.70710678f

static const struct hatch_node resting = {.parent = HATCH_NONE,
                                          .rotation = {0, 0, 0, 1},
                                          .scale = {1, 1, 1},
                                          .skin = HATCH_NONE,
                                          .camera = HATCH_NONE,
                                          .light = HATCH_NONE};

static void apply(const double *matrix, double x, double y, double z, double out[3])
{
    for (int row = 0; row < 3; row++)
        out[row] = matrix[row] * x + matrix[4 + row] * y + matrix[8 + row] * z + matrix[12 + row];
}

static void is_at(const double *matrix, double x, double y, double z)
{
    ck_assert_double_eq_tol(matrix[12], x, 1e-6);
    ck_assert_double_eq_tol(matrix[13], y, 1e-6);
    ck_assert_double_eq_tol(matrix[14], z, 1e-6);
}

START_TEST(nodes_are_placed_by_their_parents)
{
    struct hatch_node nodes[3] = {resting, resting, resting};
    const double matrix[16] = {2, 0, 0, 0, 0, 2, 0, 0, 0, 0, 2, 0, 5, 0, 0, 1};
    double world[48], p[3];
    nodes[0].translation[0] = 1;
    nodes[0].rotation[1] = nodes[0].rotation[3] = HALF_SQRT; /* a quarter turn around y */
    nodes[1].parent = 0;
    nodes[1].translation[2] = 1;
    nodes[1].scale[1] = 3;
    nodes[2].parent = 1;
    nodes[2].has_matrix = true;
    memcpy(nodes[2].matrix, matrix, sizeof matrix);
    const struct hatch_scene scene = {.node_count = 3, .nodes = nodes};
    hatch_scene_pose(&scene, HATCH_NONE, 0, world);
    is_at(world, 1, 0, 0);
    is_at(world + 16, 2, 0, 0);  /* z has become x */
    is_at(world + 32, 2, 0, -5); /* and x has become -z */
    apply(world + 32, 0, 1, 0, p);
    ck_assert_double_eq_tol(p[1], 6, 1e-6);
}
END_TEST

/* Floats are half a unit apart there. */
START_TEST(nodes_far_away_keep_their_places)
{
    struct hatch_node nodes[2] = {resting, resting};
    double world[32];
    nodes[0].translation[0] = 4500000.1;
    nodes[1].parent = 0;
    nodes[1].translation[0] = 0.07;
    const struct hatch_scene scene = {.node_count = 2, .nodes = nodes};
    hatch_scene_pose(&scene, HATCH_NONE, 0, world);
    ck_assert_double_eq_tol(world[16 + 12], 4500000.17, 1e-8);
}
END_TEST

/* Returns a scene of one node with one animation channel. */
static struct hatch_node moved_node;
static struct hatch_animation_channel moving;
static struct hatch_animation movement;

static struct hatch_scene moved_by(struct hatch_animation_channel channel)
{
    moved_node = resting;
    moving = channel;
    movement = (struct hatch_animation){
        .channel_count = 1, .channels = &moving, .duration_s = moving.times_s[moving.key_count - 1]};
    return (struct hatch_scene){.node_count = 1, .nodes = &moved_node, .animation_count = 1, .animations = &movement};
}

START_TEST(keys_are_interpolated_each_way)
{
    float times[] = {1, 2, 4}, values[] = {0, 0, 0, 10, 0, 0, 10, 4, 0};
    const struct hatch_scene scene = moved_by((struct hatch_animation_channel){.path = HATCH_PATH_TRANSLATION,
                                                                               .interpolation = HATCH_LINEAR,
                                                                               .key_count = 3,
                                                                               .times_s = times,
                                                                               .values = values});
    const struct {
        double time_s;
        double linear[2], step[2];
    } want[] = {
        {0, {0, 0}, {0, 0}},    {1.25, {2.5, 0}, {0, 0}}, {2, {10, 0}, {10, 0}},
        {3, {10, 2}, {10, 0}},  {4, {10, 4}, {10, 4}},    {5.25, {2.5, 0}, {0, 0}}, /* wrapped */
        {-1, {10, 2}, {10, 0}},
    };
    double world[16];
    for (size_t i = 0; i < sizeof want / sizeof *want; i++) {
        moving.interpolation = HATCH_LINEAR;
        hatch_scene_pose(&scene, 0, want[i].time_s, world);
        is_at(world, want[i].linear[0], want[i].linear[1], 0);
        moving.interpolation = HATCH_STEP;
        hatch_scene_pose(&scene, 0, want[i].time_s, world);
        is_at(world, want[i].step[0], want[i].step[1], 0);
    }
    hatch_scene_pose(&scene, HATCH_NONE, 3, world);
    is_at(world, 0, 0, 0);
}
END_TEST

START_TEST(cubic_keys_follow_their_tangents)
{
    /* In-tangent, value, out-tangent: x(t) = t³ - t over [0, 2], whose slopes are -1 and 11. */
    float times[] = {0, 2};
    float values[] = {9, 9, 9, 0, 0, 0, -1, 0, 0, 11, 0, 0, 6, 0, 0, 9, 9, 9};
    const struct hatch_scene scene = moved_by((struct hatch_animation_channel){.path = HATCH_PATH_TRANSLATION,
                                                                               .interpolation = HATCH_CUBIC,
                                                                               .key_count = 2,
                                                                               .times_s = times,
                                                                               .values = values});
    for (double t = 0; t <= 2; t += 0.125) {
        double world[16];
        hatch_scene_pose(&scene, 0, t, world);
        is_at(world, t * t * t - t, 0, 0);
    }
}
END_TEST

START_TEST(weights_of_morph_targets_move)
{
    /* The same curve for three targets; the node's own weights apply without an animation only. */
    float times[] = {0, 2}, rest[] = {0.5f, 0, -1};
    float values[] = {9, 9, 9, 0, 0, 1, -1, 0, 0, 11, 0, 0, 6, 0, 1, 9, 9, 9};
    const struct hatch_scene scene = moved_by((struct hatch_animation_channel){.path = HATCH_PATH_WEIGHTS,
                                                                               .interpolation = HATCH_CUBIC,
                                                                               .key_count = 2,
                                                                               .times_s = times,
                                                                               .values = values,
                                                                               .targets = 3});
    double weights[4] = {0, 0, 0, 7}; /* the last one is that of another node */
    moved_node.weights = rest;
    for (double t = 0; t <= 2; t += 0.125) {
        double world[16];
        hatch_scene_pose(&scene, 0, t, world);
        is_at(world, 0, 0, 0);
        hatch_scene_weights(&scene, 0, 0, t, 3, weights);
        ck_assert_double_eq_tol(weights[0], t * t * t - t, 1e-6);
        ck_assert_double_eq(weights[1], 0);
        ck_assert_double_eq_tol(weights[2], 1, 1e-12);
    }
    hatch_scene_weights(&scene, 0, HATCH_NONE, 1, 3, weights);
    ck_assert(weights[0] == 0.5 && weights[1] == 0 && weights[2] == -1 && weights[3] == 7);
}
END_TEST

START_TEST(rotations_turn_evenly_the_short_way)
{
    float times[] = {0, 1};
    /* A quarter turn around z; the end has the sign of its quaternion inverted. */
    float values[] = {0, 0, 0, 1, 0, 0, -HALF_SQRT, -HALF_SQRT};
    const struct hatch_scene scene = moved_by((struct hatch_animation_channel){.path = HATCH_PATH_ROTATION,
                                                                               .interpolation = HATCH_LINEAR,
                                                                               .key_count = 2,
                                                                               .times_s = times,
                                                                               .values = values});
    for (double t = 0; t <= 1; t += 0.125) {
        double world[16], p[3];
        hatch_scene_pose(&scene, 0, t, world);
        apply(world, 1, 0, 0, p);
        ck_assert_double_eq_tol(p[0], cos(t * 1.5707963), 1e-6);
        ck_assert_double_eq_tol(p[1], sin(t * 1.5707963), 1e-6);
    }
}
END_TEST

/* By Rodrigues' formula, about any axis: v cos a + (n x v) sin a + n (n . v) (1 - cos a). */
START_TEST(rotations_turn_about_their_axis)
{
    static const double axes[][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {2, 3, 6}, {-6, 2, 3}, {3, -6, -2}};
    for (size_t i = 0; i < sizeof axes / sizeof *axes; i++)
        for (double angle = 0.4; angle < 3; angle += 0.6) {
            double axis[3], world[16], half = angle; /* the keys are twice as far apart as the angle */
            float times[] = {0, 1}, values[8] = {0, 0, 0, 1};
            hatch_vec_copy(axes[i], axis);
            hatch_vec_normalize(axis);
            for (int k = 0; k < 3; k++)
                values[4 + k] = (float)(sin(half) * axis[k]);
            values[7] = (float)cos(half);
            const struct hatch_scene scene = moved_by((struct hatch_animation_channel){.path = HATCH_PATH_ROTATION,
                                                                                       .interpolation = HATCH_LINEAR,
                                                                                       .key_count = 2,
                                                                                       .times_s = times,
                                                                                       .values = values});
            double turn = cos(half) < 0 ? angle - 3.14159265358979324 : angle; /* half of the shorter arc */
            hatch_scene_pose(&scene, 0, 0.5, world);
            for (int column = 0; column < 3; column++) {
                double v[3] = {column == 0, column == 1, column == 2}, across[3];
                hatch_vec_cross(axis, v, across);
                for (int row = 0; row < 3; row++)
                    ck_assert_double_eq_tol(world[4 * column + row],
                                            v[row] * cos(turn) + across[row] * sin(turn) +
                                                axis[row] * axis[column] * (1 - cos(turn)),
                                            1e-5);
            }
        }
}
END_TEST

START_TEST(a_skin_at_rest_leaves_its_mesh)
{
    struct hatch_node nodes[2] = {resting, resting};
    nodes[0].translation[0] = 3;
    nodes[1].parent = 0;
    nodes[1].translation[1] = 2;
    uint32_t joints[] = {0, 1};
    float inverse[32] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, -3, 0,  0, 1,
                         1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, -3, -2, 0, 1};
    struct hatch_skin skin = {.joint_count = 2, .joints = joints, .inverse_bind = inverse};
    const struct hatch_scene scene = {.node_count = 2, .nodes = nodes, .skin_count = 1, .skins = &skin};
    double world[32], matrices[32];
    hatch_scene_pose(&scene, HATCH_NONE, 0, world);
    hatch_scene_skin(&scene, 0, world, matrices);
    is_at(matrices, 0, 0, 0);
    is_at(matrices + 16, 0, 0, 0);
    nodes[1].translation[1] = 5;
    hatch_scene_pose(&scene, HATCH_NONE, 0, world);
    hatch_scene_skin(&scene, 0, world, matrices);
    is_at(matrices, 0, 0, 0);
    is_at(matrices + 16, 0, 3, 0);
}
END_TEST

static struct hatch_arena keep, scratch;

static struct hatch_mesh make_sphere(void)
{
    struct hatch_mesh mesh;
    struct hatch_err err;
    const struct hatch_shape_options options = {.faces = 500};
    HATCH_TEST_OK(hatch_shape_make(HATCH_SHAPE_SPHERE, &options, &keep, &scratch, &mesh, &err), &err);
    return mesh;
}

static const double at_zero[3] = {0, 0, 0};

START_TEST(a_flat_scene_holds_every_instance_and_mirrors_turn_faces)
{
    hatch_arena_init(&keep, (size_t)1 << 28);
    hatch_arena_init(&scratch, (size_t)1 << 28);
    struct hatch_mesh sphere = make_sphere(), flat;
    struct hatch_scene_mesh meshes[1] = {{.mesh = sphere, .material = HATCH_NONE}};
    struct hatch_node nodes[3] = {resting, resting, resting};
    for (int i = 0; i < 3; i++)
        nodes[i].mesh_count = 1;
    nodes[1].scale[0] = -2; /* a mirror */
    nodes[1].translation[0] = 10;
    nodes[2].mesh_count = 0;
    const struct hatch_scene scene = {.mesh_count = 1, .meshes = meshes, .node_count = 3, .nodes = nodes};
    struct hatch_err err;
    HATCH_TEST_OK(hatch_scene_flatten(&scene, at_zero, false, &keep, &scratch, &flat, &err), &err);
    ck_assert_uint_eq(flat.face_count, 2 * sphere.face_count);
    const float *normals = hatch_mesh_find(&flat, "NORMAL", 3);
    uint32_t back = 0;
    for (uint32_t f = 0; f < flat.face_count; f++) {
        double c[3][3], normal[3], n[3];
        hatch_mesh_corners(&flat, f, c);
        hatch_vec_triangle(c[0], c[1], c[2], normal);
        for (uint32_t k = 0; k < 3; k++) {
            hatch_vec_of(&normals[flat.indices[f * 3 + k] * 3], n);
            ck_assert_double_eq_tol(hatch_vec_length(n), 1, 1e-6);
            back += hatch_vec_dot(n, normal) <= 0;
        }
    }
    ck_assert_uint_eq(back, 0);
    float low[3], high[3];
    hatch_mesh_bounds(&flat, low, high);
    ck_assert_float_eq_tol(low[0], -1, 0.03f);
    ck_assert_float_eq_tol(high[0], 12, 0.06f);
    nodes[0].mesh_count = nodes[1].mesh_count = 0;
    ck_assert_int_eq(hatch_scene_flatten(&scene, at_zero, false, &keep, &scratch, &flat, &err), HATCH_BAD_INPUT);
    hatch_arena_free(&scratch);
    hatch_arena_free(&keep);
}
END_TEST

/* One mesh whose target moves it by 10 along x; at rest, the weights are the nodes' own. */
START_TEST(a_flat_scene_is_morphed_as_its_nodes_say)
{
    hatch_arena_init(&keep, (size_t)1 << 28);
    hatch_arena_init(&scratch, (size_t)1 << 28);
    struct hatch_mesh sphere = make_sphere(), flat;
    float *moves, *turns, half = 0.5f, low[3], high[3];
    struct hatch_err err;
    HATCH_TEST_OK(hatch_mesh_add(&keep, &sphere, HATCH_MORPH_POSITION, 3, &moves, &err), &err);
    HATCH_TEST_OK(hatch_mesh_add(&keep, &sphere, HATCH_MORPH_NORMAL, 3, &turns, &err), &err);
    for (uint32_t v = 0; v < sphere.vertex_count; v++) {
        moves[3 * v] = 10;
        turns[3 * v + 1] = 2000;
    }
    struct hatch_scene_mesh meshes[1] = {{.mesh = sphere, .material = HATCH_NONE}};
    struct hatch_node nodes[2] = {resting, resting};
    nodes[0].mesh_count = nodes[1].mesh_count = 1;
    nodes[1].weights = &half;
    const struct hatch_scene scene = {.mesh_count = 1, .meshes = meshes, .node_count = 2, .nodes = nodes};
    HATCH_TEST_OK(hatch_scene_flatten(&scene, at_zero, false, &keep, &scratch, &flat, &err), &err);
    hatch_mesh_bounds(&flat, low, high);
    ck_assert_float_eq_tol(low[0], -1, 0.03f);
    ck_assert_float_eq_tol(high[0], 6, 0.03f);
    const float *normals = hatch_mesh_find(&flat, "NORMAL", 3), *before = hatch_mesh_find(&sphere, "NORMAL", 3);
    for (uint32_t v = 0; v < sphere.vertex_count; v++) {
        ck_assert_float_eq_tol(normals[3 * v + 1], before[3 * v + 1], 1e-6f);
        ck_assert_float_eq_tol(normals[3 * (v + sphere.vertex_count) + 1], 1, 1e-5f);
    }
    hatch_arena_free(&scratch);
    hatch_arena_free(&keep);
}
END_TEST

/* A skin whose joint scales by 1/100 and moves along x; the node's own matrix does not count (glTF 2.0, Skins). */
START_TEST(a_flat_scene_has_the_pose_of_skins_where_it_is_asked_for)
{
    hatch_arena_init(&keep, (size_t)1 << 28);
    hatch_arena_init(&scratch, (size_t)1 << 28);
    struct hatch_mesh sphere = make_sphere(), flat;
    float *joints, *weights;
    struct hatch_err err;
    HATCH_TEST_OK(hatch_mesh_add(&keep, &sphere, "JOINTS_0", 4, &joints, &err), &err);
    HATCH_TEST_OK(hatch_mesh_add(&keep, &sphere, "WEIGHTS_0", 4, &weights, &err), &err);
    for (uint32_t v = 0; v < sphere.vertex_count; v++)
        weights[4 * v] = 1;
    struct hatch_scene_mesh meshes[1] = {{.mesh = sphere, .material = HATCH_NONE}};
    struct hatch_node nodes[2] = {resting, resting};
    uint32_t joint = 1;
    float unbound[16] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
    struct hatch_skin skin = {.joint_count = 1, .joints = &joint, .inverse_bind = unbound};
    nodes[0].mesh_count = 1;
    nodes[0].skin = 0;
    nodes[0].translation[1] = 7;
    nodes[1].translation[0] = 3;
    for (int k = 0; k < 3; k++)
        nodes[1].scale[k] = 0.01f;
    const struct hatch_scene scene = {
        .mesh_count = 1, .meshes = meshes, .node_count = 2, .nodes = nodes, .skin_count = 1, .skins = &skin};
    for (int posed = 0; posed <= 1; posed++) {
        HATCH_TEST_OK(hatch_scene_flatten(&scene, (const double[3]){2, 0, 0}, posed, &keep, &scratch, &flat, &err),
                      &err);
        for (size_t i = 0; i < 3 * (size_t)sphere.vertex_count; i++) {
            double from = (double)sphere.attributes[0].data[i], x = i % 3 == 0 ? 1 : 0;
            double want = posed ? 0.01 * from + 3 * x - 2 * x : from - 2 * x;
            ck_assert_double_eq_tol((double)flat.attributes[0].data[i], want, 1e-6);
        }
        const float *normals = hatch_mesh_find(&flat, "NORMAL", 3), *before = hatch_mesh_find(&sphere, "NORMAL", 3);
        for (size_t i = 0; i < 3 * (size_t)sphere.vertex_count; i++)
            ck_assert_float_eq_tol(normals[i], before[i], 1e-5f);
    }
    hatch_arena_free(&scratch);
    hatch_arena_free(&keep);
}
END_TEST

/* Two nodes 10^7 from the origin, where floats are a whole unit apart: a small mesh keeps its shape. */
START_TEST(a_flat_scene_is_precise_near_its_origin)
{
    hatch_arena_init(&keep, (size_t)1 << 28);
    hatch_arena_init(&scratch, (size_t)1 << 28);
    struct hatch_mesh sphere = make_sphere(), flat;
    struct hatch_scene_mesh meshes[1] = {{.mesh = sphere, .material = HATCH_NONE}};
    struct hatch_node nodes[2] = {resting, resting};
    for (int i = 0; i < 2; i++) {
        nodes[i].mesh_count = 1;
        nodes[i].translation[0] = 1e7f;
        nodes[i].translation[2] = 2 * (float)i;
    }
    const struct hatch_scene scene = {.mesh_count = 1, .meshes = meshes, .node_count = 2, .nodes = nodes};
    struct hatch_err err;
    HATCH_TEST_OK(hatch_scene_flatten(&scene, (const double[3]){1e7, 0, 2}, false, &keep, &scratch, &flat, &err), &err);
    const float *from = sphere.attributes[0].data, *to = flat.attributes[0].data;
    for (size_t v = 0; v < 2 * (size_t)sphere.vertex_count; v++)
        for (size_t k = 0; k < 3; k++) {
            double moved = k == 2 && v < sphere.vertex_count ? -2 : 0;
            ck_assert_double_eq_tol((double)to[3 * v + k], (double)from[3 * (v % sphere.vertex_count) + k] + moved,
                                    2e-7);
        }
    hatch_arena_free(&scratch);
    hatch_arena_free(&keep);
}
END_TEST

struct flattening {
    struct hatch_scene scene;
    struct hatch_mesh mesh;
};

static enum hatch_status flatten_one(void *context, struct hatch_arena *kept, struct hatch_arena *temporary,
                                     struct hatch_err *err)
{
    struct flattening *f = context;
    struct hatch_scene scene;
    enum hatch_status status = hatch_scene_of_mesh(&f->scene.meshes[0].mesh, kept, &scene, err);
    return status == HATCH_OK ? hatch_scene_flatten(&scene, at_zero, false, kept, temporary, &f->mesh, err) : status;
}

START_TEST(every_failed_allocation_is_a_limit)
{
    hatch_arena_init(&keep, (size_t)1 << 28);
    hatch_arena_init(&scratch, (size_t)1 << 28);
    struct hatch_scene_mesh meshes[1] = {{.mesh = make_sphere()}};
    struct flattening f = {.scene = {.meshes = meshes}};
    hatch_test_fail_alloc(flatten_one, &f, &f.mesh, sizeof f.mesh);
    hatch_arena_free(&scratch);
    hatch_arena_free(&keep);
}
END_TEST

/* Of meshes 0 to 4, 1 and 4 are left out: nodes draw 2 and 3, all three of 0 to 2, and 4. */
START_TEST(meshes_are_left_out_and_nodes_draw_the_others)
{
    struct hatch_scene_mesh meshes[5];
    struct hatch_node nodes[3] = {resting, resting, resting};
    const bool kept[5] = {true, false, true, true, false};
    uint32_t first[6];
    for (uint32_t m = 0; m < 5; m++)
        meshes[m] = (struct hatch_scene_mesh){.file_vertices = m};
    nodes[0].first_mesh = 2, nodes[0].mesh_count = 2;
    nodes[1].first_mesh = 0, nodes[1].mesh_count = 3;
    nodes[2].first_mesh = 4, nodes[2].mesh_count = 1;
    struct hatch_scene scene = {.mesh_count = 5, .meshes = meshes, .node_count = 3, .nodes = nodes};
    hatch_scene_keep(&scene, kept, first);
    ck_assert_uint_eq(scene.mesh_count, 3);
    ck_assert_uint_eq(meshes[0].file_vertices, 0);
    ck_assert_uint_eq(meshes[1].file_vertices, 2);
    ck_assert_uint_eq(meshes[2].file_vertices, 3);
    ck_assert(nodes[0].first_mesh == 1 && nodes[0].mesh_count == 2);
    ck_assert(nodes[1].first_mesh == 0 && nodes[1].mesh_count == 2);
    ck_assert_uint_eq(nodes[2].mesh_count, 0);
    ck_assert(first[1] == 1 && first[2] == 1 && first[4] == 3 && first[5] == 3);
}
END_TEST

static Suite *suite(void)
{
    Suite *suite = suite_create("mesh scene");
    TCase *tests = tcase_create("scene");
    tcase_add_test(tests, nodes_are_placed_by_their_parents);
    tcase_add_test(tests, nodes_far_away_keep_their_places);
    tcase_add_test(tests, keys_are_interpolated_each_way);
    tcase_add_test(tests, cubic_keys_follow_their_tangents);
    tcase_add_test(tests, weights_of_morph_targets_move);
    tcase_add_test(tests, rotations_turn_evenly_the_short_way);
    tcase_add_test(tests, rotations_turn_about_their_axis);
    tcase_add_test(tests, a_skin_at_rest_leaves_its_mesh);
    tcase_add_test(tests, a_flat_scene_holds_every_instance_and_mirrors_turn_faces);
    tcase_add_test(tests, a_flat_scene_is_morphed_as_its_nodes_say);
    tcase_add_test(tests, a_flat_scene_has_the_pose_of_skins_where_it_is_asked_for);
    tcase_add_test(tests, a_flat_scene_is_precise_near_its_origin);
    tcase_add_test(tests, meshes_are_left_out_and_nodes_draw_the_others);
    tcase_add_test(tests, every_failed_allocation_is_a_limit);
    suite_add_tcase(suite, tests);
    return suite;
}

HATCH_TEST_MAIN(suite)
