/* Patches joined to one mesh, and what must see the surface below them once. */
#include "fail_alloc.h"
#include "scene/row.h"
#include "render_lapped.h"

static uint32_t layer_of(const struct hatch_patch_mesh *from, const struct hatch_mesh *mesh, uint32_t patch)
{
    uint32_t layer = 0;
    for (uint32_t i = 0; i < 3 * mesh->face_count; i++) {
        while (i >= from->layer_end[layer])
            layer++;
        if (mesh->indices[i] >= from->first_vertex[patch] && mesh->indices[i] < from->first_vertex[patch + 1])
            return layer;
    }
    ck_abort_msg("patch %u has no face", patch);
    return 0;
}

/* By their middles: do two patches share a face? */
static bool overlap(uint32_t a, uint32_t b, const struct hatch_mesh *sphere)
{
    for (size_t f = 0; f < sphere->face_count; f++) {
        double middle[3];
        middle_of(sphere, f, middle);
        if (cap_holds(a, middle) && cap_holds(b, middle))
            return true;
    }
    return false;
}

START_TEST(joined_patches_are_the_surface)
{
    begin();
    struct hatch_mesh sphere = frame_shape(&frame, HATCH_SHAPE_SPHERE, 500);
    make_scene(&sphere, &caps);
    HATCH_TEST_OK(hatch_patches_join(&frame.scene, &frame.arena, &frame.scratch, &patches, &frame.err), &frame.err);
    ck_assert_uint_eq(frame.scene.mesh_count, 1);
    ck_assert_uint_eq(frame.scene.nodes[0].mesh_count, 1);
    ck_assert_uint_eq(patches[0].patch_count, CAPS);
    const struct hatch_mesh *joined = &frame.scene.meshes[0].mesh, *surface = &patches[0].surface;
    ck_assert_uint_eq(surface->face_count, sphere.face_count);
    ck_assert_uint_gt(joined->face_count, surface->face_count);
    for (uint32_t v = 0; v < surface->vertex_count; v++)
        ck_assert_mem_eq(surface->attributes[0].data + 3 * v, joined->attributes[0].data + 3 * patches[0].vertex_of[v],
                         3 * sizeof(float));
    ck_assert_uint_eq(patches[0].layer_end[patches[0].layer_count - 1], 3 * joined->face_count);
    for (uint32_t a = 0; a < CAPS; a++)
        for (uint32_t b = a + 1; b < CAPS; b++)
            if (overlap(a, b, &sphere))
                ck_assert_uint_lt(layer_of(&patches[0], joined, a), layer_of(&patches[0], joined, b));
    hatch_arena_free(&frame.arena);
    hatch_arena_free(&frame.scratch);
}
END_TEST

static enum hatch_status join(void *context, struct hatch_arena *keep, struct hatch_arena *scratch,
                              struct hatch_err *err)
{
    struct hatch_scene *scene = context, before = *scene;
    struct hatch_node node = scene->nodes[0];
    enum hatch_status status = hatch_patches_join(scene, keep, scratch, &patches, err);
    if (status == HATCH_OK) {
        *scene = before;
        scene->nodes[0] = node;
    }
    return status;
}

START_TEST(joining_survives_every_failed_allocation)
{
    begin();
    struct hatch_mesh sphere = frame_shape(&frame, HATCH_SHAPE_SPHERE, 100);
    make_scene(&sphere, &caps);
    ck_assert_uint_gt(hatch_test_fail_alloc(join, &frame.scene, &frame.scene, sizeof frame.scene), 20);
    hatch_arena_free(&frame.arena);
    hatch_arena_free(&frame.scratch);
}
END_TEST

/* Draws tone and lines of what frame holds. */
static void draw_lines(struct hatch_image *image)
{
    const struct line_style style = {.kinds = HATCH_LINES_ALL, .asked = true, .width_px = 2, .crease_rad = 0.7};
    struct lines lines;
    HATCH_TEST_OK(lines_make(&frame.gpu, &style, &frame.renderer.shaders, (uint64_t)1 << 30, &frame.arena,
                             &frame.scratch, &lines, &frame.err),
                  &frame.err);
    frame.renderer.lines = &lines;
    draw_in_tiles("gouraud", 160, 2, image);
    frame.renderer.lines = NULL;
    lines_free(&lines);
}

START_TEST(lines_see_the_surface_once)
{
    struct hatch_image lapped, plain, none;
    begin();
    fill_mask();
    struct hatch_mesh mesh = frame_shape(&frame, _i ? HATCH_SHAPE_PLANE : HATCH_SHAPE_SPHERE, 500);
    const struct cut planes = {.count = 3, .materials = 1, .place = place_shifted};
    begin_lapped(&mesh, _i ? &planes : &caps);
    frame.renderer.style.curve.high = 0.2;
    draw_lines(&lapped);
    frame_close(&frame);
    frame_begin(&mesh, &frame_unit, NULL, &frame);
    frame.renderer.style.curve.high = 0.2;
    frame.scene.meshes[0].had_normals = true;
    draw_lines(&plain);
    draw_in_tiles("gouraud", 160, 2, &none);
    ck_assert_double_gt(frame_difference(&plain, &none), 0.5);
    ck_assert_double_le(frame_difference(&lapped, &plain), 1.0 / 255);
    frame_end(&frame);
}
END_TEST

/* The upper half of a sphere follows a joint that leans and moves to the right. */
static struct hatch_mesh skinned_sphere(void)
{
    struct hatch_mesh sphere = frame_shape(&frame, HATCH_SHAPE_SPHERE, 2000);
    float *joints, *weights;
    HATCH_TEST_OK(hatch_mesh_add(&frame.arena, &sphere, "JOINTS_0", 4, &joints, &frame.err), &frame.err);
    HATCH_TEST_OK(hatch_mesh_add(&frame.arena, &sphere, "WEIGHTS_0", 4, &weights, &frame.err), &frame.err);
    for (size_t v = 0; v < sphere.vertex_count; v++) {
        weights[4 * v] = fminf(fmaxf(0.5f + sphere.attributes[0].data[3 * v + 1], 0), 1);
        weights[4 * v + 1] = 1 - weights[4 * v];
        joints[4 * v + 1] = 1;
    }
    return sphere;
}

static void add_skin(struct hatch_scene *scene)
{
    struct hatch_node *nodes = HATCH_NEW(&frame.arena, struct hatch_node, 3, &frame.err);
    scene->skins = HATCH_NEW(&frame.arena, struct hatch_skin, 1, &frame.err);
    scene->skins[0] = (struct hatch_skin){.joint_count = 2,
                                          .joints = HATCH_NEW(&frame.arena, uint32_t, 2, &frame.err),
                                          .inverse_bind = HATCH_NEW(&frame.arena, float, 32, &frame.err)};
    for (uint32_t j = 0; j < 2; j++) {
        scene->skins[0].joints[j] = 1 + j;
        for (uint32_t i = 0; i < 4; i++)
            scene->skins[0].inverse_bind[16 * j + 5 * i] = 1;
    }
    nodes[0] = nodes[1] = nodes[2] = scene->nodes[0];
    nodes[0].skin = 0;
    nodes[1].mesh_count = nodes[2].mesh_count = 0;
    nodes[1].translation[0] = 0.1f;
    nodes[1].rotation[2] = -0.1f;
    nodes[1].rotation[3] = sqrtf(0.99f);
    scene->nodes = nodes;
    scene->node_count = 3;
    scene->skin_count = 1;
}

START_TEST(patches_move_with_a_skin)
{
    struct hatch_image lapped, plain, still;
    begin();
    fill_mask();
    struct hatch_mesh sphere = skinned_sphere();
    make_scene(&sphere, &caps);
    add_skin(&frame.scene);
    HATCH_TEST_OK(hatch_patches_join(&frame.scene, &frame.arena, &frame.scratch, &patches, &frame.err), &frame.err);
    frame_begin_scene(patches, &frame_unit, &map, &frame);
    lend_outline();
    black_map();
    frame.renderer.style.light = (struct own_light){true, 3.14159265358979324, 0}; /* behind it */
    draw_in_tiles("tam", 160, 1, &lapped);
    frame_close(&frame);
    HATCH_TEST_OK(hatch_scene_of_mesh(&sphere, &frame.arena, &frame.scene, &frame.err), &frame.err);
    frame_begin_scene(NULL, &frame_unit, NULL, &frame);
    frame.renderer.style.light = (struct own_light){true, 3.14159265358979324, 0}; /* behind it */
    draw_in_tiles("gouraud", 160, 1, &still);
    frame_close(&frame);
    add_skin(&frame.scene);
    frame_begin_scene(NULL, &frame_unit, NULL, &frame);
    frame.renderer.style.light = (struct own_light){true, 3.14159265358979324, 0}; /* behind it */
    draw_in_tiles("gouraud", 160, 1, &plain);
    ck_assert_double_gt(frame_difference(&plain, &still), 0.5);
    ck_assert_double_le(frame_difference(&lapped, &plain), 1.0 / 255);
    frame_end(&frame);
}
END_TEST

static enum hatch_status row(void *context, struct hatch_arena *keep, struct hatch_arena *scratch,
                             struct hatch_err *err)
{
    struct hatch_scene joined;
    return hatch_scene_join_row(context, 2, false, keep, scratch, &joined, err);
}

START_TEST(scenes_stand_in_a_row)
{
    struct hatch_scene scenes[2], joined;
    float world[16 * 8];
    begin();
    struct hatch_mesh sphere = frame_shape(&frame, HATCH_SHAPE_SPHERE, 100);
    struct hatch_mesh large = frame_shape(&frame, HATCH_SHAPE_SPHERE, 100);
    for (size_t i = 0; i < 3 * (size_t)large.vertex_count; i++)
        large.attributes[0].data[i] = 5 * large.attributes[0].data[i] + 7;
    make_scene(&sphere, &caps);
    add_skin(&frame.scene);
    scenes[0] = frame.scene;
    make_scene(&large, &caps);
    scenes[1] = frame.scene;
    HATCH_TEST_OK(hatch_scene_join_row(scenes, 2, false, &frame.arena, &frame.scratch, &joined, &frame.err),
                  &frame.err);
    ck_assert_uint_eq(joined.node_count, 6);
    ck_assert_uint_eq(joined.nodes[1].parent, 0);
    ck_assert_uint_eq(joined.skins[0].joints[1], 3);
    ck_assert_uint_eq(joined.nodes[5].parent, 4);
    ck_assert_uint_eq(joined.nodes[5].first_mesh, CAPS);
    ck_assert_uint_eq(joined.meshes[CAPS].material, 2);
    ck_assert_uint_eq(joined.materials[2].base.texture, 1);
    hatch_scene_pose(&joined, HATCH_NONE, 0, world);
    /* A fifth as large, and its middle beside the first by two half widths and a gap. */
    const float *place = world + 16 * 5;
    ck_assert_double_eq_tol((double)place[0], 0.2, 0.01);
    ck_assert_double_eq_tol((double)(place[0] * 7 + place[12]), 2 + 0.2 * sqrt(3), 0.05);
    ck_assert_double_eq_tol((double)(place[5] * 7 + place[13]), 0, 0.01);
    ck_assert_uint_gt(hatch_test_fail_alloc(row, scenes, NULL, 0), 8);
    hatch_arena_free(&frame.arena);
    hatch_arena_free(&frame.scratch);
}
END_TEST

START_TEST(patches_have_tones_of_their_own)
{
    struct hatch_image image;
    uint32_t tones = 0;
    begin();
    round_mask();
    struct hatch_mesh sphere = frame_shape(&frame, HATCH_SHAPE_SPHERE, 2000);
    begin_lapped(&sphere, &caps);
    frame.renderer.style.light = (struct own_light){true, 0, 0};
    draw_in_tiles("patches", 160, 1, &image);
    /* Along a row, steps between neighbours that the light does not make. */
    for (uint32_t x = 50; x < 110; x++)
        tones += fabsf(image.pixels[3 * (80 * 160 + x)] - image.pixels[3 * (80 * 160 + x + 1)]) > 0.02f;
    ck_assert_uint_ge(tones, 3);
    frame_end(&frame);
}
END_TEST

/* Directions along x on a plane, half of them the other way round. */
START_TEST(marks_lie_evenly_along_directions)
{
    struct field field;
    float *directions;
    begin();
    struct hatch_mesh plane = frame_shape(&frame, HATCH_SHAPE_PLANE, 200);
    HATCH_TEST_OK(hatch_mesh_add(&frame.arena, &plane, "_HATCH_DIR", 4, &directions, &frame.err), &frame.err);
    for (size_t v = 0; v < plane.vertex_count; v++) {
        directions[4 * v] = v % 2 ? 1.0f : -1.0f;
        directions[4 * v + 3] = 0.5f;
    }
    frame_begin(&plane, &frame_unit, NULL, &frame);
    HATCH_TEST_OK(field_make(&frame.gpu, &map_facing, 200, &frame.renderer.shaders, &frame.arena, &frame.scratch,
                             &field, &frame.err),
                  &frame.err);
    struct target target;
    HATCH_TEST_OK(target_make(8, 8, 1, &frame.renderer.shaders, &target, &frame.err), &frame.err);
    target_begin(&target, frame.renderer.style.inks.paper);
    field_draw(&field, &target);
    /* 100 pixels to a unit, 11 from mark to mark. */
    ck_assert_uint_gt(field.count, 200);
    for (uint32_t a = 0; a < field.count; a++) {
        const float *line = field.lines + FIELD_FLOATS * a;
        ck_assert_double_eq_tol(fabs((double)line[3]), 0.5 * 0.9 * 0.11, 1e-6);
        ck_assert_double_le(fabs((double)line[4]), 1e-6);
        ck_assert_double_eq_tol((double)line[6], 0.5, 1e-6);
        for (uint32_t b = 0; b < a; b++) {
            const float *other = field.lines + FIELD_FLOATS * b;
            ck_assert_double_gt(hypot((double)(line[0] - other[0]), (double)(line[1] - other[1])), 0.1099);
        }
    }
    field_free(&field);
    target_free(&target);
    frame_end(&frame);
}
END_TEST

/* Two spheres, one in a node that makes it three times as large. */
START_TEST(strokes_have_one_size_on_all_patches)
{
    begin();
    struct hatch_mesh sphere = frame_shape(&frame, HATCH_SHAPE_SPHERE, 500);
    make_scene(&sphere, &caps);
    struct hatch_node *nodes = HATCH_NEW(&frame.arena, struct hatch_node, 2, &frame.err);
    nodes[0] = nodes[1] = frame.scene.nodes[0];
    for (int k = 0; k < 3; k++)
        nodes[1].scale[k] = 3;
    frame.scene.nodes = nodes;
    frame.scene.node_count = 2;
    HATCH_TEST_OK(hatch_patches_join(&frame.scene, &frame.arena, &frame.scratch, &patches, &frame.err), &frame.err);
    frame_begin_scene(patches, &frame_unit, &map, &frame);
    ck_assert_uint_eq(frame.gpu.item_count, 2);
    HATCH_TEST_OK(repeat_set(&frame.gpu, 0, &map_facing, 300, SIZE, 3, &frame.scratch, &frame.err), &frame.err);
    ck_assert_double_eq_tol((double)frame.gpu.items[1].repeat[0] / (double)frame.gpu.items[0].repeat[0], 3, 1e-3);
    /* 150 pixels to a unit; a unit of the hatch coordinates is one of the small sphere. */
    ck_assert_double_eq_tol((double)frame.gpu.items[0].repeat[0], 150.0 / SIZE, 0.05 * 150.0 / SIZE);
    frame_end(&frame);
}
END_TEST

static Suite *suite(void)
{
    Suite *made = suite_create("render patches");
    TCase *tests = tcase_create("patches");
    tcase_add_test(tests, joined_patches_are_the_surface);
    tcase_add_test(tests, joining_survives_every_failed_allocation);
    tcase_add_loop_test(tests, lines_see_the_surface_once, 0, 2);
    tcase_add_test(tests, patches_move_with_a_skin);
    tcase_add_test(tests, scenes_stand_in_a_row);
    tcase_add_test(tests, patches_have_tones_of_their_own);
    tcase_add_test(tests, marks_lie_evenly_along_directions);
    tcase_add_test(tests, strokes_have_one_size_on_all_patches);
    suite_add_tcase(made, tests);
    return made;
}

HATCH_TEST_MAIN(suite)
