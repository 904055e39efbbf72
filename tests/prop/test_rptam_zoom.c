/* Zooming in by forty octaves: positions of strokes compared with a reference in pairs of doubles, and coverage. */
#include "run.h"

#include "rptam_model.h"
#include "view/orbit_control.h"
#include "zoom_reference.h"

enum { WIDTH = 64, HEIGHT = 48 };

static struct test_frame frame;
static struct hatch_rptam rptam;
static struct hatch_mesh mesh;

static const struct model_how how_drawn = {
    .layers = 2, .tile_px = 40, .length_px = 14, .width_px = 2, .angle_rad = {0.5, 1.5}, .overlap = 0.5};

static void begin_mesh(const struct hatch_bounds *bounds)
{
    model_make(&how_drawn, &frame.args.keep, &frame.args.scratch, &rptam);
    frame_open(&mesh, bounds, NULL, &frame);
    frame.model = &rptam;
}

static void make_shape(enum hatch_shape shape, uint32_t faces)
{
    frame_arenas(&frame);
    mesh = frame_shape(&frame, shape, faces);
}

static void check_places(const struct hatch_view *view, double pixels, uint32_t wrong)
{
    struct zoom_error error = zoom_measure(&frame, view, WIDTH, HEIGHT, 5);
    double scale = view->orthographic ? view->half_height : view->pivot;
    ck_assert_msg(error.largest_px < pixels, "at %g: %g pixels", scale, error.largest_px);
    ck_assert_msg(error.wrong <= wrong, "at %g: %u pixels wrong", scale, error.wrong);
    ck_assert_uint_gt(error.pixels, 20);
}

/* The number of pixels that show the background. */
static uint32_t bare_pixels(const struct hatch_view *view)
{
    static float rgba[4 * WIDTH * HEIGHT];
    uint32_t bare = 0;
    frame_draw_numbers(&frame, "places", view, WIDTH, HEIGHT, rgba);
    for (size_t i = 0; i < WIDTH * HEIGHT; i++)
        bare += rgba[4 * i] < 0;
    return bare;
}

static const struct hatch_bounds odd_bounds = {.center = {0.1, -0.3, 0.7}, .radius = 1.7};

static const struct {
    enum hatch_shape shape;
    uint32_t faces, face;
    const struct hatch_bounds *bounds;
    double share[3], tilt;
} surfaces[] = {
    {HATCH_SHAPE_PLANE, 2, 0, &frame_unit, {0.5, 0.2, 0.3}, 0.7},
    {HATCH_SHAPE_PLANE, 1000, 77, &odd_bounds, {0.1, 0.3, 0.6}, 1.2},
    {HATCH_SHAPE_TORUS, 2000, 640, &frame_unit, {0.3, 0.3, 0.4}, 0.5},
    {HATCH_SHAPE_TEAPOT, 3000, 1000, &odd_bounds, {0.2, 0.5, 0.3}, 0.3},
    {HATCH_SHAPE_TORUS, 2000, 640, &frame_unit, {1, 0, 0}, 0.5},     /* a corner */
    {HATCH_SHAPE_TORUS, 2000, 640, &odd_bounds, {0.5, 0.5, 0}, 0.1}, /* an edge */
};
enum { SURFACES = sizeof surfaces / sizeof *surfaces };

START_TEST(strokes_keep_their_places_over_forty_octaves)
{
    static const int octaves[] = {0, 3, 6, 9, 14, 20, 27, 33, 40, 42};
    double point[3], normal[3], back[3];
    make_shape(surfaces[_i].shape, surfaces[_i].faces);
    begin_mesh(surfaces[_i].bounds);
    zoom_face_point(&mesh, surfaces[_i].face, surfaces[_i].share, point, normal);
    zoom_lean(normal, surfaces[_i].tilt, back);
    for (size_t i = 0; i < sizeof octaves / sizeof *octaves; i++) {
        struct hatch_view view = zoomed_view(&frame, point, back, exp2(1 - octaves[i]), (double)WIDTH / HEIGHT);
        check_places(&view, 0.05, 1);
        if (octaves[i] < 20)
            continue;
        frame.shown.floats_alone = true;
        struct zoom_error error = zoom_measure(&frame, &view, WIDTH, HEIGHT, 5);
        ck_assert_msg(error.largest_px > 1 || error.wrong > 50, "octave %d: floats alone are right", octaves[i]);
        frame.shown.floats_alone = false;
    }
    frame_finish(&frame);
}
END_TEST

/* Texture coordinates far from 0, up to 2^40, with rotated strokes. */
START_TEST(strokes_keep_their_places_at_large_texture_coordinates)
{
    double point[3], normal[3], back[3];
    make_shape(HATCH_SHAPE_PLANE, 200);
    float *texcoord = hatch_mesh_find(&mesh, "TEXCOORD_0", 2);
    for (size_t i = 0; i < 2 * (size_t)mesh.vertex_count; i++)
        texcoord[i] = (texcoord[i] - 0.3f) * (_i ? 0x1p40f : 1000.0f) + (_i ? 0 : 5e4f);
    begin_mesh(&odd_bounds);
    zoom_face_point(&mesh, 90, (const double[3]){0.3, 0.3, 0.4}, point, normal);
    zoom_lean(normal, 0.6, back);
    for (int octave = 0; octave <= 42; octave += 6) {
        struct hatch_view view = zoomed_view(&frame, point, back, exp2(1 - octave), (double)WIDTH / HEIGHT);
        check_places(&view, 0.05, 0);
    }
    frame_finish(&frame);
}
END_TEST

START_TEST(strokes_keep_their_places_in_orthographic_views)
{
    double point[3], normal[3], back[3];
    make_shape(HATCH_SHAPE_TORUS, 1000);
    begin_mesh(&odd_bounds);
    zoom_face_point(&mesh, 300, (const double[3]){0.3, 0.3, 0.4}, point, normal);
    zoom_lean(normal, 0.6, back);
    for (int octave = 0; octave <= 40; octave += 5) {
        struct hatch_view view = zoomed_view(&frame, point, back, 3, (double)WIDTH / HEIGHT);
        view.orthographic = true;
        view.half_height = exp2(-octave);
        view.far = 10;
        check_places(&view, 0.05, 1);
    }
    frame_finish(&frame);
}
END_TEST

/* The eye lies on the surface, on a vertex or on an edge, and looks along the surface, into it and away. */
START_TEST(a_camera_on_the_surface_needs_few_pieces)
{
    static const double shares[][3] = {{0.3, 0.3, 0.4}, {1, 0, 0}, {0.5, 0.5, 0}};
    double point[3], normal[3], back[3];
    make_shape(HATCH_SHAPE_TORUS, 1000);
    begin_mesh(&frame_unit);
    zoom_face_point(&mesh, 300, shares[_i % 3], point, normal);
    for (int turn = 0; turn < 6; turn++) {
        zoom_lean(normal, 0.3 + turn * 3.14159265358979324 / 6, back);
        struct hatch_view view = zoomed_view(&frame, point, back, 1, (double)WIDTH / HEIGHT);
        for (int k = 0; k < 3; k++) {
            view.eye[k] = point[k];
            view.eye_low[k] = _i < 3 ? 0 : 0x1p-70 * normal[k];
        }
        zoom_measure(&frame, &view, WIDTH, HEIGHT, 16);
        ck_assert_ptr_nonnull(frame.shown.near.found.items);
        ck_assert_int_lt(frame.shown.near.found.items[0].surface.count, 3 * 6000);
    }
    frame_finish(&frame);
}
END_TEST

/* A plane that fills the picture, from both sides: every pixel is covered at every distance. */
START_TEST(pieces_leave_no_gaps)
{
    double point[3], normal[3], back[3];
    make_shape(HATCH_SHAPE_PLANE, _i ? 2000 : 50);
    begin_mesh(&odd_bounds);
    zoom_face_point(&mesh, _i ? 1000 : 24, (const double[3]){0.45, 0.45, 0.1}, point, normal);
    for (int side = 0; side < 2; side++) {
        zoom_lean(normal, side ? 3.14159265358979324 - 1.1 : 1.1, back);
        for (double octave = 5; octave <= 42; octave += 2.3) {
            struct hatch_view view = zoomed_view(&frame, point, back, exp2(-octave), (double)WIDTH / HEIGHT);
            ck_assert_uint_eq(bare_pixels(&view), 0);
        }
    }
    frame_finish(&frame);
}
END_TEST

START_TEST(tiled_and_whole_pictures_are_equal)
{
    double point[3], normal[3], back[3];
    make_shape(HATCH_SHAPE_TORUS, 1000);
    begin_mesh(&frame_unit);
    zoom_face_point(&mesh, 300, (const double[3]){0.3, 0.3, 0.4}, point, normal);
    zoom_lean(normal, 0.6, back);
    struct hatch_view view = zoomed_view(&frame, point, back, 0x1p-30, (double)WIDTH / HEIGHT);
    struct hatch_image pictures[2];
    struct canvas canvas;
    struct hatch_err *err = &frame.err;
    frame_draw(&frame, "rptam", &view, WIDTH, HEIGHT, 1, &pictures[0]);
    HATCH_TEST_OK(hatch_image_make(&frame.args.keep, WIDTH, HEIGHT, "RGB", &pictures[1], err), err);
    const struct picture picture = frame_picture(&frame, "rptam");
    HATCH_TEST_OK(picture_canvas(&frame.shown, WIDTH / 2, HEIGHT / 2, 1, &canvas, err), err);
    HATCH_TEST_OK(picture_draw(&picture, &view, &canvas, &pictures[1], err), err);
    ck_assert_double_le(frame_difference(&pictures[0], &pictures[1]), 1 / 255.0);
    canvas_free(&canvas);
    frame_finish(&frame);
}
END_TEST

/* Opens a torus; returns an oblique view of a point of it from a distance. */
static struct hatch_view begin_torus(double distance)
{
    double point[3], normal[3], back[3];
    make_shape(HATCH_SHAPE_TORUS, 1000);
    begin_mesh(&odd_bounds);
    zoom_face_point(&mesh, 300, (const double[3]){0.3, 0.3, 0.4}, point, normal);
    zoom_lean(normal, 0.6, back);
    return zoomed_view(&frame, point, back, distance, (double)WIDTH / HEIGHT);
}

/* Like a user of the window: zooms in by halves, turns around the centre of the picture, and zooms out. */
START_TEST(an_orbit_zooms_in_and_out_over_forty_octaves)
{
    struct hatch_orbit orbit;
    struct hatch_view view = begin_torus(1);
    hatch_orbit_start(&orbit, &view);
    for (int i = 0; i < 42; i++)
        hatch_orbit_zoom(&orbit, 0.5);
    ck_assert_double_le(orbit.distance, 0x1p-42);
    check_places(&orbit.view, 0.05, 1);
    hatch_orbit_turn(&orbit, 0.2, -0.1);
    check_places(&orbit.view, 0.05, 1);
    struct hatch_view low = orbit.view;
    hatch_orbit_set_distance(&orbit, 0.5 * orbit.distance);
    hatch_orbit_zoom(&orbit, 1);
    for (int k = 0; k < 3; k++) /* a new centre on the line of sight does not move the eye */
        ck_assert_double_le(
            fabs(hatch_pair_round(hatch_pair_sub((struct hatch_pair){low.eye[k], low.eye_low[k]},
                                                 (struct hatch_pair){orbit.view.eye[k], orbit.view.eye_low[k]}))),
            1e-14 * orbit.distance);
    while (orbit.distance < 1)
        hatch_orbit_zoom(&orbit, 2);
    check_places(&orbit.view, 0.05, 1);
    frame_finish(&frame);
}
END_TEST

/* The near plane of an orthographic camera must not limit zooming. */
START_TEST(an_orthographic_orbit_zooms_past_the_near_plane)
{
    struct hatch_orbit orbit;
    struct hatch_view view = begin_torus(3);
    view.orthographic = true;
    view.half_height = 1;
    view.near = 1;
    view.far = 10;
    hatch_orbit_start(&orbit, &view);
    for (int i = 0; i < 40; i++)
        hatch_orbit_zoom(&orbit, 0.5);
    ck_assert_double_eq(orbit.view.half_height, 0x1p-40);
    check_places(&orbit.view, 0.05, 1);
    frame_finish(&frame);
}
END_TEST

static Suite *suite(void)
{
    Suite *suite = suite_create("rptam zoom");
    TCase *tests = tcase_create("zoom");
    tcase_add_loop_test(tests, strokes_keep_their_places_over_forty_octaves, 0, SURFACES);
    tcase_add_loop_test(tests, strokes_keep_their_places_at_large_texture_coordinates, 0, 2);
    tcase_add_test(tests, strokes_keep_their_places_in_orthographic_views);
    tcase_add_loop_test(tests, a_camera_on_the_surface_needs_few_pieces, 0, 6);
    tcase_add_loop_test(tests, pieces_leave_no_gaps, 0, 2);
    tcase_add_test(tests, tiled_and_whole_pictures_are_equal);
    tcase_add_test(tests, an_orbit_zooms_in_and_out_over_forty_octaves);
    tcase_add_test(tests, an_orthographic_orbit_zooms_past_the_near_plane);
    suite_add_tcase(suite, tests);
    return suite;
}

HATCH_TEST_MAIN(suite)
