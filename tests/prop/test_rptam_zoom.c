/* Zooming in through forty octaves: where strokes lie, against a reference in pairs of doubles, and the tone. */
#include "run.h"

#include "zoom_reference.h"

enum { WIDTH = 64, HEIGHT = 48 };

static struct test_frame frame;
static struct hatch_rptam rptam;
static struct hatch_mesh mesh;

static const struct hatch_rptam_style style = {.tile_px = 40,
                                               .length_px = 14,
                                               .width_px = 2,
                                               .angle_rad = {0.5, 1.5},
                                               .ink = 1,
                                               .overlap = 0.5,
                                               .tone_overlap = 0.3};

static void begin_mesh(const struct bounds *bounds)
{
    zoom_seeds(&frame, &style, 2, &rptam);
    frame_begin(&mesh, bounds, NULL, &frame);
    frame.renderer.rptam = &rptam;
}

static void make_shape(enum hatch_shape shape, uint32_t faces)
{
    struct hatch_shape_options how = {.faces = faces, .seed = 1};
    frame_arenas(&frame);
    HATCH_TEST_OK(hatch_shape_make(shape, &how, &frame.arena, &frame.scratch, &mesh, &frame.err), &frame.err);
}

/* A place on a face by its corners' shares, and the face's normal. */
static void face_point(uint32_t face, const double share[3], double point[3], double normal[3])
{
    double corner[3][3];
    ck_assert(hatch_mesh_corners(&mesh, face, corner));
    for (int k = 0; k < 3; k++)
        point[k] = share[0] * corner[0][k] + share[1] * corner[1][k] + share[2] * corner[2][k];
    hatch_vec_triangle(corner[0], corner[1], corner[2], normal);
    hatch_vec_normalize(normal);
}

/* Towards the eye: off the normal by a tilt. */
static void lean(const double normal[3], double tilt, double back[3])
{
    double side[3];
    hatch_vec_any_orthogonal(normal, side);
    for (int k = 0; k < 3; k++)
        back[k] = cos(tilt) * normal[k] + sin(tilt) * side[k];
}

static const struct bounds odd_bounds = {.center = {0.1, -0.3, 0.7}, .radius = 1.7};

static const struct {
    enum hatch_shape shape;
    uint32_t faces, face;
    const struct bounds *bounds;
    double share[3], tilt;
} surfaces[] = {
    {HATCH_SHAPE_PLANE, 2, 0, &frame_unit, {0.5, 0.2, 0.3}, 0.7},
    {HATCH_SHAPE_PLANE, 1000, 77, &odd_bounds, {0.1, 0.3, 0.6}, 1.2},
    {HATCH_SHAPE_TORUS, 2000, 640, &frame_unit, {0.3, 0.3, 0.4}, 0.5},
    {HATCH_SHAPE_TEAPOT, 3000, 1000, &odd_bounds, {0.2, 0.5, 0.3}, 0.3},
    {HATCH_SHAPE_TORUS, 2000, 640, &frame_unit, {1, 0, 0}, 0.5},   /* a corner */
    {HATCH_SHAPE_TORUS, 2000, 640, &odd_bounds, {0.5, 0.5, 0}, 0.1}, /* an edge */
};
enum { SURFACES = sizeof surfaces / sizeof *surfaces };

START_TEST(strokes_keep_their_place_through_forty_octaves)
{
    static const int octaves[] = {0, 3, 6, 9, 14, 20, 27, 33, 40, 42};
    double point[3], normal[3], back[3];
    make_shape(surfaces[_i].shape, surfaces[_i].faces);
    begin_mesh(surfaces[_i].bounds);
    face_point(surfaces[_i].face, surfaces[_i].share, point, normal);
    lean(normal, surfaces[_i].tilt, back);
    for (size_t i = 0; i < sizeof octaves / sizeof *octaves; i++) {
        struct view view = zoom_view(&frame, point, back, exp2(1 - octaves[i]), (double)WIDTH / HEIGHT);
        struct zoom_error error = zoom_measure(&frame, &view, WIDTH, HEIGHT, 5);
        ck_assert_msg(error.largest_px < 0.05, "octave %d: %g pixels", octaves[i], error.largest_px);
        ck_assert_msg(error.wrong <= 1, "octave %d: %u pixels wrong", octaves[i], error.wrong);
        ck_assert_uint_gt(error.pixels, 20);
        if (octaves[i] < 20)
            continue;
        frame.renderer.floats_alone = true;
        error = zoom_measure(&frame, &view, WIDTH, HEIGHT, 5);
        ck_assert_msg(error.largest_px > 1 || error.wrong > 50, "octave %d: floats alone are right", octaves[i]);
        frame.renderer.floats_alone = false;
    }
    frame_end(&frame);
}
END_TEST

static Suite *suite(void)
{
    Suite *suite = suite_create("rptam zoom");
    TCase *tests = tcase_create("zoom");
    tcase_add_loop_test(tests, strokes_keep_their_place_through_forty_octaves, 0, SURFACES);
    suite_add_tcase(suite, tests);
    return suite;
}

HATCH_TEST_MAIN(suite)
