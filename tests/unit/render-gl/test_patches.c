/* Pictures of patches that depend on the surface below them: lines, skinning, and --show patches. */
#include "render_lapped.h"

/* Draws the tone and the lines of the scene. */
static void draw_lines(struct hatch_image *image)
{
    const struct line_overlay_style style = {.lines = {.kinds = HATCH_LINES_ALL, .width_px = 2, .crease_rad = 0.7}};
    struct line_overlay lines;
    HATCH_TEST_OK(line_overlay_make(&lines, &frame.on_gpu, &style, &frame.shown.programs, &frame.args, &frame.err),
                  &frame.err);
    frame.lines = &lines;
    draw_in_tiles("gouraud", 160, 2, image);
    frame.lines = NULL;
    line_overlay_free(&lines);
}

START_TEST(lines_are_those_of_the_surface_without_patches)
{
    struct hatch_image lapped, plain, none;
    begin();
    fill_mask();
    struct hatch_mesh mesh = frame_shape(&frame, _i ? HATCH_SHAPE_PLANE : HATCH_SHAPE_SPHERE, 500);
    const struct cut planes = {.count = 3, .materials = 1, .place = place_shifted};
    begin_lapped(&mesh, _i ? &planes : &caps);
    frame.shown.style.curve.high = 0.2;
    draw_lines(&lapped);
    frame_close(&frame);
    frame_open(&mesh, &frame_unit, NULL, &frame);
    frame.shown.style.curve.high = 0.2;
    frame.scene.meshes[0].had_normals = true;
    draw_lines(&plain);
    draw_in_tiles("gouraud", 160, 2, &none);
    ck_assert_double_gt(frame_difference(&plain, &none), 0.5);
    ck_assert_double_le(frame_difference(&lapped, &plain), 1.0 / 255);
    frame_finish(&frame);
}
END_TEST

/* A sphere whose upper half follows the first joint of lapped_scene_skin. */
static struct hatch_mesh skinned_sphere(void)
{
    struct hatch_mesh sphere = frame_shape(&frame, HATCH_SHAPE_SPHERE, 2000);
    float *joints, *weights;
    HATCH_TEST_OK(hatch_mesh_add(&frame.args.keep, &sphere, "JOINTS_0", 4, &joints, &frame.err), &frame.err);
    HATCH_TEST_OK(hatch_mesh_add(&frame.args.keep, &sphere, "WEIGHTS_0", 4, &weights, &frame.err), &frame.err);
    for (size_t v = 0; v < sphere.vertex_count; v++) {
        weights[4 * v] = fminf(fmaxf(0.5f + sphere.attributes[0].data[3 * v + 1], 0), 1);
        weights[4 * v + 1] = 1 - weights[4 * v];
        joints[4 * v + 1] = 1;
    }
    return sphere;
}

START_TEST(patches_follow_skinning)
{
    struct hatch_image lapped, plain, still;
    begin();
    fill_mask();
    struct hatch_mesh sphere = skinned_sphere();
    make_scene(&sphere, &caps);
    lapped_scene_skin(&frame.scene, &frame.args.keep);
    HATCH_TEST_OK(hatch_patches_join(&frame.scene, &frame.args.keep, &frame.args.scratch, &patches, NULL, &frame.err),
                  &frame.err);
    frame_open_scene(patches, &frame_unit, &map, &frame);
    set_outline();
    black_map();
    frame.shown.style.light =
        (struct hatch_key_light){.replaces = true, .azimuth_rad = 3.14159265358979324}; /* from behind: all dark */
    draw_in_tiles("tam", 160, 1, &lapped);
    frame_close(&frame);
    HATCH_TEST_OK(hatch_scene_of_mesh(&sphere, &frame.args.keep, &frame.scene, &frame.err), &frame.err);
    frame_open_scene(NULL, &frame_unit, NULL, &frame);
    frame.shown.style.light =
        (struct hatch_key_light){.replaces = true, .azimuth_rad = 3.14159265358979324}; /* from behind: all dark */
    draw_in_tiles("gouraud", 160, 1, &still);
    frame_close(&frame);
    lapped_scene_skin(&frame.scene, &frame.args.keep);
    frame_open_scene(NULL, &frame_unit, NULL, &frame);
    frame.shown.style.light =
        (struct hatch_key_light){.replaces = true, .azimuth_rad = 3.14159265358979324}; /* from behind: all dark */
    draw_in_tiles("gouraud", 160, 1, &plain);
    ck_assert_double_gt(frame_difference(&plain, &still), 0.5);
    ck_assert_double_le(frame_difference(&lapped, &plain), 1.0 / 255);
    frame_finish(&frame);
}
END_TEST

START_TEST(show_patches_gives_patches_different_tones)
{
    struct hatch_image image;
    uint32_t tones = 0;
    begin();
    round_mask();
    struct hatch_mesh sphere = frame_shape(&frame, HATCH_SHAPE_SPHERE, 2000);
    begin_lapped(&sphere, &caps);
    frame.shown.style.light = (struct hatch_key_light){.replaces = true, .azimuth_rad = 0};
    draw_in_tiles("patches", 160, 1, &image);
    /* Counts jumps of brightness along a row that are larger than those of the light. */
    for (uint32_t x = 50; x < 110; x++)
        tones += fabsf(image.pixels[3 * (80 * 160 + x)] - image.pixels[3 * (80 * 160 + x + 1)]) > 0.02f;
    ck_assert_uint_ge(tones, 3);
    frame_finish(&frame);
}
END_TEST

static Suite *suite(void)
{
    Suite *made = suite_create("pictures of patches");
    TCase *tests = tcase_create("pictures of patches");
    tcase_add_loop_test(tests, lines_are_those_of_the_surface_without_patches, 0, 2);
    tcase_add_test(tests, patches_follow_skinning);
    tcase_add_test(tests, show_patches_gives_patches_different_tones);
    suite_add_tcase(made, tests);
    return made;
}

HATCH_TEST_MAIN(suite)
