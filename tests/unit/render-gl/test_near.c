/* Pieces of near faces on lapped, moving and skinned surfaces, and with too little memory. */
#include "render_lapped.h"

#include "math/vector.h"
#include "rptam_model.h"

enum { WIDE = 64, HIGH = 48 };

static struct hatch_rptam rptam;

/* Gives each patch different hatch coordinates. */
static void place_turned(uint32_t patch, const float *position, float hatch[2], float outline[2])
{
    float turn = 0.3f + (float)patch;
    hatch[0] = cosf(turn) * position[0] - sinf(turn) * position[1] + 0.3f * position[2];
    hatch[1] = sinf(turn) * position[0] + cosf(turn) * position[1] - 0.2f * position[2];
    outline[0] = outline[1] = 0.5f;
}

static const struct cut whole = {.count = 3, .materials = 1, .place = place_turned};

static void make_model(void)
{
    static const struct model_how how_drawn = {.layers = 2, .tile_px = 40, .length_px = 14, .width_px = 2};
    model_make(&how_drawn, &frame.args.keep, &frame.args.scratch, &rptam);
    frame.model = &rptam;
    frame.shown.style.curve.low = frame.shown.style.curve.high = 0.5;
}

/* A view of face 300 from a distance, oblique to its normal.
 *   shift  translation of the mesh */
static struct hatch_view view_near(const struct hatch_mesh *mesh, double distance, const double shift[3])
{
    double corner[3][3], normal[3], side[3];
    struct hatch_view_choice choice = {.kind = HATCH_VIEW_EYE, .fov_rad = 0.5, .has_target = true};
    struct hatch_view view;
    ck_assert(hatch_mesh_corners(mesh, 300, corner));
    hatch_vec_triangle(corner[0], corner[1], corner[2], normal);
    hatch_vec_normalize(normal);
    hatch_vec_any_orthogonal(normal, side);
    for (int k = 0; k < 3; k++) {
        choice.target[k] = 0.3 * corner[0][k] + 0.3 * corner[1][k] + 0.4 * corner[2][k] + shift[k];
        choice.eye[k] = choice.target[k] + distance * (0.9 * normal[k] + 0.44 * side[k]);
    }
    const struct hatch_framing framing = {.bounds = &frame.on_gpu.unit.bounds, .aspect = (double)WIDE / HIGH};
    HATCH_TEST_OK(hatch_view_make(&choice, &frame.on_gpu.unit.pose, &framing, &frame.args.scratch, &view, &frame.err),
                  &frame.err);
    return view;
}

static const double nowhere[3] = {0, 0, 0};

/* All patches are opaque, so the picture equals that of the surface with the last patch's coordinates. */
START_TEST(a_close_up_of_patches_shows_the_top_patch)
{
    const double distance = exp2(-12 - 8 * _i);
    struct hatch_image pictures[2];
    begin();
    for (uint32_t i = 0; i < SIZE * SIZE; i++)
        mask.pixels[2 * i + 1] = 1;
    struct hatch_mesh torus = frame_shape(&frame, HATCH_SHAPE_TORUS, 1000);
    begin_lapped(&torus, &whole);
    make_model();
    struct hatch_view view = view_near(&torus, distance, nowhere);
    frame_draw(&frame, "rptam", &view, WIDE, HIGH, 1, &pictures[0]);
    ck_assert_ptr_nonnull(hatch_near_item_at(&frame.shown.near.found, 0));
    struct hatch_mesh last = patch_of(&torus, &whole, whole.count - 1, &frame.args.keep, &frame.err);
    frame_close(&frame);
    frame_open(&last, &frame_unit, NULL, &frame);
    make_model();
    frame_draw(&frame, "rptam", &view, WIDE, HIGH, 1, &pictures[1]);
    double ink = 0;
    for (size_t i = 0; i < 3 * WIDE * HIGH; i++)
        ink += 1 - (double)pictures[1].pixels[i];
    ck_assert_double_gt(ink, 3 * WIDE * HIGH * 0.1);
    ck_assert_double_le(frame_difference(&pictures[0], &pictures[1]), 1 / 255.0);
    frame_finish(&frame);
}
END_TEST

/* Which patch lies on top, and whose strokes are drawn, is found in pieces as in faces, at a distance at which floats
 * place both. */
START_TEST(a_close_up_of_patches_has_the_strokes_of_the_top_patch)
{
    struct hatch_image pictures[2];
    uint32_t strokes[2];
    begin();
    for (uint32_t i = 0; i < SIZE * SIZE; i++)
        mask.pixels[2 * i + 1] = 1;
    struct hatch_mesh torus = frame_shape(&frame, HATCH_SHAPE_TORUS, 1000);
    begin_lapped(&torus, &whole);
    make_model();
    rptam_options.stroke_px[0] = 14;
    rptam_options.stroke_px[1] = 2;
    rptam_options.ink = 1;
    const struct hatch_view view = view_near(&torus, 0x1p-10, nowhere);
    for (int alone = 0; alone < 2; alone++) {
        frame.shown.floats_alone = alone;
        frame_draw(&frame, "strokes", &view, WIDE, HIGH, 1, &pictures[alone]);
        ck_assert_int_eq(hatch_near_item_at(&frame.shown.near.found, 0) == NULL, alone);
        strokes[alone] = (uint32_t)frame.instances[0].technique->count(&frame.instances[0]).strokes;
    }
    ck_assert_uint_gt(strokes[0], 20);
    ck_assert_uint_eq(strokes[0], strokes[1]);
    ck_assert_double_gt(frame_ink(&pictures[0]), 0.05);
    ck_assert_double_eq_tol(frame_ink(&pictures[0]), frame_ink(&pictures[1]), 0.002);
    frame_finish(&frame);
}
END_TEST

/* Surface and eye move together, and back. */
START_TEST(a_close_up_moves_with_the_surface)
{
    static const double away[3] = {0.25, -0.5, 0.125};
    struct hatch_image pictures[3];
    begin();
    struct hatch_mesh torus = frame_shape(&frame, HATCH_SHAPE_TORUS, 1000);
    frame_open(&torus, &frame_unit, NULL, &frame);
    make_model();
    for (int i = 0; i < 3; i++) {
        for (int k = 0; k < 3; k++)
            frame.scene.nodes[0].translation[k] = i == 1 ? (float)away[k] : 0.0f;
        HATCH_TEST_OK(scene_set_pose(&frame.on_gpu, HATCH_NONE, i, &frame.args.scratch, &frame.err), &frame.err);
        struct hatch_view view = view_near(&torus, 0x1p-30, i == 1 ? away : nowhere);
        frame_draw(&frame, "rptam", &view, WIDE, HIGH, 1, &pictures[i]);
        ck_assert_ptr_nonnull(hatch_near_item_at(&frame.shown.near.found, 0));
    }
    ck_assert_double_le(frame_difference(&pictures[0], &pictures[2]), 0);
    /* Coordinates of another magnitude are rounded differently, by at most 2^-23 of the distance. */
    ck_assert_double_le(frame_difference(&pictures[0], &pictures[1]), 0.02);
    frame_finish(&frame);
}
END_TEST

/* The larger texture coordinates are, the farther away their rounding is seen. Those of a thousand tiles are rounded a
 * thousand times as coarsely as those of the first. */
START_TEST(texture_coordinates_of_far_tiles_are_near_from_farther_away)
{
    struct hatch_image picture;
    begin();
    struct hatch_mesh plane = frame_shape(&frame, HATCH_SHAPE_PLANE, 700);
    float *texcoord = hatch_mesh_find(&plane, "TEXCOORD_0", 2);
    for (int far = 0; far < 2; far++) {
        for (size_t i = 0; far && i < 2 * (size_t)plane.vertex_count; i++)
            texcoord[i] += 1000;
        frame_open(&plane, &frame_unit, NULL, &frame);
        make_model();
        const struct hatch_view view = view_near(&plane, 0x1p-4, nowhere);
        frame_draw(&frame, "rptam", &view, WIDE, HIGH, 1, &picture);
        ck_assert_int_eq(hatch_near_item_at(&frame.shown.near.found, 0) != NULL, far);
        if (!far)
            frame_close(&frame);
    }
    frame_finish(&frame);
}
END_TEST

/* Joints and eye move together. Derivatives by texture coordinates are kept per vertex only for static surfaces; on a
 * plane they are constant either way. */
START_TEST(a_close_up_of_a_skinned_plane_equals_an_unskinned_one)
{
    static const double away[3] = {0.25, -0.5, 0.125};
    const double distance = exp2(-11 - 10 * _i);
    struct hatch_image plain, skinned;
    begin();
    struct hatch_mesh plane = frame_shape(&frame, HATCH_SHAPE_PLANE, 700);
    frame_open(&plane, &frame_unit, NULL, &frame);
    make_model();
    struct hatch_view view = view_near(&plane, distance, nowhere);
    frame_draw(&frame, "rptam", &view, WIDE, HIGH, 1, &plain);
    frame_close(&frame);
    frame_skin(&plane, &frame);
    frame_open_scene(NULL, &frame_unit, NULL, &frame);
    make_model();
    for (int moved = 0; moved < 3; moved++) {
        for (int i = 0; i < 6; i++)
            frame.scene.nodes[1 + i / 3].translation[i % 3] = moved == 1 ? (float)away[i % 3] : 0;
        HATCH_TEST_OK(scene_set_pose(&frame.on_gpu, HATCH_NONE, moved, &frame.args.scratch, &frame.err), &frame.err);
        view = view_near(&plane, distance, moved == 1 ? away : nowhere);
        frame_draw(&frame, "rptam", &view, WIDE, HIGH, 1, &skinned);
        ck_assert_ptr_nonnull(hatch_near_item_at(&frame.shown.near.found, 0));
        ck_assert_double_le(frame_difference(&plain, &skinned), 0.02);
    }
    frame_finish(&frame);
}
END_TEST

/* With every limit of memory the pieces are either found or refused with a status. */
START_TEST(too_little_memory_is_a_limit)
{
    static const struct hatch_tile tile = {0, 0, WIDE, HIGH, WIDE, HIGH};
    uint32_t refused = 0;
    begin();
    struct hatch_mesh torus = frame_shape(&frame, HATCH_SHAPE_TORUS, 1000);
    frame_open(&torus, &frame_unit, NULL, &frame);
    struct hatch_view view = view_near(&torus, 0x1p-30, nowhere);
    for (uint64_t bytes = 1024; bytes < (uint64_t)64 << 20; bytes += bytes / 3) {
        const struct hatch_near_options options = {
            .places = HATCH_NEAR_TEXCOORDS, .turn = {1, 0}, .tile = &tile, .max_memory = bytes};
        struct hatch_near near = {.is_open = false};
        enum hatch_status status = HATCH_LIMIT;
        for (int again = 0; again < 3; again++)
            status = hatch_near_find(&near, &frame.on_gpu.unit, &options, &view, &frame.err);
        ck_assert(status == HATCH_OK || status == HATCH_LIMIT);
        ck_assert_int_eq(hatch_near_item_at(&near, 0) != NULL, status == HATCH_OK);
        refused += status == HATCH_LIMIT;
        hatch_near_free(&near);
    }
    ck_assert_uint_gt(refused, 3);
    frame_finish(&frame);
}
END_TEST

static Suite *suite(void)
{
    Suite *suite = suite_create("render near");
    TCase *tests = tcase_create("near");
    tcase_add_loop_test(tests, a_close_up_of_patches_shows_the_top_patch, 0, 4);
    tcase_add_test(tests, a_close_up_of_patches_has_the_strokes_of_the_top_patch);
    tcase_add_test(tests, a_close_up_moves_with_the_surface);
    tcase_add_test(tests, texture_coordinates_of_far_tiles_are_near_from_farther_away);
    tcase_add_loop_test(tests, a_close_up_of_a_skinned_plane_equals_an_unskinned_one, 0, 4);
    tcase_add_test(tests, too_little_memory_is_a_limit);
    suite_add_tcase(suite, tests);
    return suite;
}

HATCH_TEST_MAIN(suite)
