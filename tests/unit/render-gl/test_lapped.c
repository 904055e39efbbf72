/* Compares pictures of patches with the definition of compositing, computed here for each pixel of a plane whose pixels
 * coincide with texels of the map and of the outline, and with ordinary texture coordinates. */
#include "render_lapped.h"

/* Reflectance of a pixel under the first `count` patches at the tone of one column. */
static double composite(uint32_t count, uint32_t tone, int column, int row)
{
    double paper = 1;
    for (uint32_t p = 0; p < count; p++) {
        int x = (column + shifts[p][0]) % SIZE, y = (row + shifts[p][1]) % SIZE;
        int mx = column + shifts[p][2], my = row + shifts[p][3];
        double texel = round(255 * (double)map.columns[tone].levels[0].pixels[y * SIZE + x]) / 255;
        double share = mx < 0 || my < 0 || mx >= SIZE || my >= SIZE ? 0 : (double)mask.pixels[2 * (my * SIZE + mx) + 1];
        paper += share * (texel - paper);
    }
    return paper;
}

static double worst_against_composite(const char *technique, uint32_t materials)
{
    static const uint32_t tone = 3;
    struct cut cut = {.count = 4, .materials = materials, .place = place_shifted};
    struct hatch_image image;
    begin();
    for (uint32_t i = 0; i < SIZE * SIZE; i++)
        mask.pixels[2 * i + 1] = (float)(hatch_random_u64(3, 0, i) % 256) / 255.0f;
    struct hatch_mesh plane = frame_shape(&frame, HATCH_SHAPE_PLANE, 50);
    begin_lapped(&plane, &cut);
    ck_assert_uint_eq(frame.on_gpu.unit.item_count, materials == 1 ? 1 : 4);
    frame.shown.style.curve.low = frame.shown.style.curve.high = (double)map.target[tone];
    frame_draw(&frame, technique, &view_facing, SIZE, SIZE, 1, &image);
    double worst = 0;
    for (int row = 0; row < SIZE; row++)
        for (int column = 0; column < SIZE; column++)
            worst =
                fmax(worst, fabs((double)image.pixels[3 * (row * SIZE + column)] - composite(4, tone, column, row)));
    frame_finish(&frame);
    return worst;
}

START_TEST(patches_are_composited_in_order)
{
    static const char *const names[] = {"tam", "tam-flat", "tam-face", "tam-gouraud", "tam-triple"};
    ck_assert_double_le(worst_against_composite(names[_i], 1), 1.0 / 255);
}
END_TEST

START_TEST(lit_surfaces_stay_blank)
{
    static const char *const names[] = {"tam", "tam-flat", "tam-face", "tam-gouraud", "tam-triple", "tam-threshold"};
    struct hatch_image image;
    begin();
    round_mask();
    struct hatch_mesh sphere = frame_shape(&frame, HATCH_SHAPE_SPHERE, 500);
    begin_lapped(&sphere, &caps);
    draw_in_tiles(names[_i], 160, 1, &image);
    ck_assert_double_gt(frame_ink(&image), 0.1); /* dark parts have strokes */
    frame.shown.style.curve.high = 0;
    draw_in_tiles(names[_i], 160, 1, &image);
    for (size_t i = 0; i < 3u * 160 * 160; i++)
        ck_assert_double_ge((double)image.pixels[i], 1 - 1.0 / 255);
    frame_finish(&frame);
}
END_TEST

/* A black plane lies behind patches with an empty outline. */
START_TEST(blank_patches_hide_surfaces_behind_them)
{
    const struct cut cut = {.count = 2, .materials = 1, .place = place_shifted};
    struct hatch_image image;
    begin();
    struct hatch_mesh plane = frame_shape(&frame, HATCH_SHAPE_PLANE, 50);
    struct hatch_mesh behind = frame_shape(&frame, HATCH_SHAPE_PLANE, 50);
    for (uint32_t v = 0; v < behind.vertex_count; v++)
        behind.attributes[0].data[3 * v + 2] = -0.5f;
    make_scene(&plane, &cut);
    struct hatch_scene *scene = &frame.scene;
    struct hatch_scene_mesh *meshes = HATCH_NEW(&frame.args.keep, struct hatch_scene_mesh, 3, &frame.err);
    memcpy(meshes, scene->meshes, 2 * sizeof *meshes);
    meshes[2] = (struct hatch_scene_mesh){.mesh = behind, .material = HATCH_NONE};
    scene->meshes = meshes;
    scene->mesh_count = scene->nodes[0].mesh_count = 3;
    HATCH_TEST_OK(hatch_patches_join(scene, &frame.args.keep, &frame.args.scratch, &patches, NULL, &frame.err),
                  &frame.err);
    frame_open_scene(patches, &frame_unit, &map, &frame);
    ck_assert_uint_eq(frame.on_gpu.unit.item_count, 2);
    set_outline();
    frame.on_gpu.items[1].base_texture = 0;
    black_map();
    frame.shown.style.curve.low = frame.shown.style.curve.high = 1;
    struct hatch_item *items = frame.on_gpu.unit.items;
    struct hatch_item bare = items[0];
    struct scene_item bare_on_gpu = frame.on_gpu.items[0];
    items[0] = items[1];
    frame.on_gpu.items[0] = frame.on_gpu.items[1];
    frame_draw(&frame, _i % 2 ? "tam-triple" : "tam", &view_facing, SIZE, SIZE, 1, &image);
    ck_assert_double_gt(frame_ink(&image), 0.99); /* alone, the black plane fills the picture */
    items[_i / 2] = bare;                         /* drawn before the plane, or after it */
    frame.on_gpu.items[_i / 2] = bare_on_gpu;
    frame_draw(&frame, _i % 2 ? "tam-triple" : "tam", &view_facing, SIZE, SIZE, 1, &image);
    for (size_t i = 0; i < 3u * SIZE * SIZE; i++)
        ck_assert_double_ge((double)image.pixels[i], 1 - 1.0 / 255);
    frame_finish(&frame);
}
END_TEST

START_TEST(patches_of_two_materials_are_composited_in_order)
{
    ck_assert_double_le(worst_against_composite("tam", 2), 1.0 / 255);
    ck_assert_double_le(worst_against_composite("tam-triple", 2), 1.0 / 255);
}
END_TEST

/* Lights the scene from the upper left. */
static void light(void)
{
    frame.shown.style.light = (struct hatch_key_light){true, -0.7, 0.6};
}

static void place_plain(uint32_t patch, const float *position, float hatch[2], float outline[2])
{
    place_shifted(patch, position, hatch, outline);
    for (int k = 0; k < 2; k++)
        outline[k] = 0.5f;
}

START_TEST(one_patch_equals_ordinary_texture_coordinates)
{
    static const char *const names[] = {"tam",        "tam-flat",      "tam-face", "tam-gouraud",
                                        "tam-triple", "tam-threshold", "gouraud"};
    const struct cut cut = {.count = 1, .materials = 1, .place = place_plain};
    const struct hatch_view slant = {.eye = {0, 1.2, 2.4},
                                     .right = {1, 0, 0},
                                     .up = {0, 0.894427191, -0.447213595},
                                     .back = {0, 0.447213595, 0.894427191},
                                     .half_height = 0.5,
                                     .aspect = 1,
                                     .near = 0.1,
                                     .pivot = 2.7};
    struct hatch_image lapped, plain;
    begin();
    fill_mask();
    struct hatch_mesh mesh = frame_shape(&frame, HATCH_SHAPE_PLANE, 50);
    float *texcoord = hatch_mesh_find(&mesh, "TEXCOORD_0", 2), unused[2];
    float *normal = hatch_mesh_find(&mesh, "NORMAL", 3);
    for (size_t v = 0; v < mesh.vertex_count; v++) {
        place_shifted(0, mesh.attributes[0].data + 3 * v, texcoord + 2 * v, unused);
        normal[3 * v] = 0.4f * hatch_random_unit(5, 0, v); /* so that tones differ */
    }
    begin_lapped(&mesh, &cut);
    light();
    frame_draw(&frame, names[_i], &slant, 120, 90, 2, &lapped);
    frame_close(&frame);
    frame_open(&mesh, &frame_unit, &map, &frame);
    light();
    frame_draw(&frame, names[_i], &slant, 120, 90, 2, &plain);
    ck_assert_double_gt(frame_ink(&plain), 0.1);
    ck_assert_double_le(frame_difference(&lapped, &plain), 1.0 / 255);
    frame_finish(&frame);
}
END_TEST

START_TEST(one_pass_and_three_pass_blending_agree)
{
    struct hatch_image once, passes, tiled;
    begin();
    round_mask();
    struct hatch_mesh sphere = frame_shape(&frame, HATCH_SHAPE_SPHERE, 2000);
    begin_lapped(&sphere, &caps);
    light();
    draw_in_tiles("tam", 160, (uint32_t)_i, &once);
    draw_in_tiles("tam-triple", 160, (uint32_t)_i, &passes);
    ck_assert_double_gt(frame_ink(&once), 0.05);
    ck_assert_double_le(frame_difference(&once, &passes), 1.0 / 255);
    draw_in_tiles("tam", 64, (uint32_t)_i, &tiled);
    ck_assert_double_le(frame_difference(&once, &tiled), 1.0 / 255);
    draw_in_tiles("tam-triple", 64, (uint32_t)_i, &tiled);
    ck_assert_double_le(frame_difference(&passes, &tiled), 1.0 / 255);
    frame_finish(&frame);
}
END_TEST

START_TEST(opaque_patches_leave_no_gaps)
{
    struct hatch_image image;
    begin();
    fill_mask();
    struct hatch_mesh sphere = frame_shape(&frame, HATCH_SHAPE_SPHERE, 500);
    begin_lapped(&sphere, &caps);
    black_map();
    frame.shown.style.curve.low = frame.shown.style.curve.high = 1;
    draw_in_tiles("tam", 160, 1, &image);
    for (int y = -40; y <= 40; y++)
        for (int x = -40; x <= 40; x++)
            ck_assert_double_le((double)image.pixels[3 * ((80 + y) * 160 + 80 + x)], 1.0 / 255);
    frame_finish(&frame);
}
END_TEST

START_TEST(rotating_strokes_equals_rotating_texture_coordinates)
{
    struct hatch_image turned, other;
    begin();
    struct hatch_mesh mesh = frame_shape(&frame, HATCH_SHAPE_PLANE, 50);
    float *texcoord = hatch_mesh_find(&mesh, "TEXCOORD_0", 2), unused[2];
    for (size_t v = 0; v < mesh.vertex_count; v++)
        place_shifted(0, mesh.attributes[0].data + 3 * v, texcoord + 2 * v, unused);
    frame_open(&mesh, &frame_unit, &map, &frame);
    frame.shown.style.curve.low = frame.shown.style.curve.high = 0.5;
    frame.shown.style.hatch_turn_rad = 1.57079632679489662;
    frame.shown.style.hatch_scale = 0.5;
    frame_draw(&frame, "tam", &view_facing, SIZE, SIZE, 1, &turned);
    frame_close(&frame);
    /* Counter-clockwise on the screen: u, which rose to the right, now rises upwards, where v falls. */
    for (size_t v = 0; v < mesh.vertex_count; v++) {
        float *t = texcoord + 2 * v, u = t[0];
        t[0] = -2 * t[1];
        t[1] = 2 * u;
    }
    frame_open(&mesh, &frame_unit, &map, &frame);
    frame.shown.style.curve.low = frame.shown.style.curve.high = 0.5;
    frame_draw(&frame, "tam", &view_facing, SIZE, SIZE, 1, &other);
    ck_assert_double_gt(frame_ink(&other), 0.2);
    ck_assert_double_le(frame_difference(&turned, &other), 1.0 / 255);
    frame_finish(&frame);
}
END_TEST

static Suite *suite(void)
{
    Suite *made = suite_create("render lapped");
    TCase *tests = tcase_create("lapped");
    tcase_add_loop_test(tests, patches_are_composited_in_order, 0, 5);
    tcase_add_loop_test(tests, lit_surfaces_stay_blank, 0, 6);
    tcase_add_loop_test(tests, blank_patches_hide_surfaces_behind_them, 0, 4);
    tcase_add_test(tests, patches_of_two_materials_are_composited_in_order);
    tcase_add_loop_test(tests, one_patch_equals_ordinary_texture_coordinates, 0, 7);
    tcase_add_loop_test(tests, one_pass_and_three_pass_blending_agree, 1, 3);
    tcase_add_test(tests, opaque_patches_leave_no_gaps);
    tcase_add_test(tests, rotating_strokes_equals_rotating_texture_coordinates);
    suite_add_tcase(made, tests);
    return made;
}

HATCH_TEST_MAIN(suite)
