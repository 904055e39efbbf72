/* Tone, edges and tiles of pictures of the teapot. tests/cli/render-gl/tone.t checks the tone of every technique. */
#include <math.h>

#include "filter/difference.h"
#include "render-gl/scene/attributes.h"
#include "render_frame.h"
#include "tam_map.h"

enum { WIDTH = 640, HEIGHT = 480 };

static struct test_frame frame;
static struct test_map map;
static struct hatch_mesh mesh;
static const struct hatch_bounds teapot_bounds = {.center = {0.2, 1.5, 0}, .radius = 3.5};

/* Fills a map of 256 texels in the default style and opens the teapot. */
static void begin(void)
{
    map_begin();
    map_style(NULL, NULL, &map);
    map.options.size_px = 256;
    map.options.levels = 4;
    map_fill(&map);
    frame_arenas(&frame);
    mesh = frame_shape(&frame, HATCH_SHAPE_TEAPOT, 10000);
    frame_open(&mesh, &teapot_bounds, &map.tam, &frame);
    frame.shown.style.light = (struct hatch_key_light){.azimuth_rad = -0.7, .elevation_rad = 0.7};
}

static void end(void)
{
    frame_finish(&frame);
    map_end();
}

/* A view of the teapot.
 *   distance  in multiples of the distance that frames it */
static struct hatch_view view_from(double distance)
{
    struct hatch_view view = frame_view(&frame, (double)WIDTH / HEIGHT);
    for (int k = 0; k < 3; k++)
        view.eye[k] *= distance;
    return view;
}

static void set_repeat(const struct hatch_view *view)
{
    const struct hatch_uv_repeat how = {.view = view, .height_px = HEIGHT, .size_px = 256, .levels = 4};
    HATCH_TEST_OK(scene_set_repeats(&frame.on_gpu, &how, &frame.args.keep, &frame.args.scratch, &frame.err),
                  &frame.err);
}

/* The low pass is a box half as wide as the map, about what the eye blends at reading distance. */
START_TEST(strokes_reproduce_the_tone_of_the_light)
{
    static const double distances[] = {0.5, 1, 2};
    struct hatch_view framed;
    begin();
    framed = view_from(1);
    set_repeat(&framed);
    for (int i = 0; i < 3; i++) {
        struct hatch_view view = view_from(distances[i]);
        struct hatch_image strokes, tone;
        double low, ink = 1 - 0.99;
        frame_draw(&frame, "tam", &view, WIDTH, HEIGHT, 2, &strokes);
        frame_draw(&frame, "gouraud", &view, WIDTH, HEIGHT, 2, &tone);
        HATCH_TEST_OK(hatch_image_low_difference(&strokes, &tone, 128, &frame.args.scratch, &low, &frame.err),
                      &frame.err);
        ck_assert_msg(low <= 0.03, "at %g: %g", distances[i], low);
        ck_assert_double_lt(hatch_image_mean(&tone), 1 - ink);
    }
    end();
}
END_TEST

static double threshold_error(uint32_t side, const struct hatch_view *view, const struct hatch_image *reference)
{
    struct hatch_image image;
    struct hatch_difference difference;
    frame_draw(&frame, "tam-threshold", view, WIDTH, HEIGHT, side, &image);
    hatch_image_difference(&image, reference, &difference);
    return difference.rmse;
}

/* Aliasing is measured as the root mean square difference from a picture of 64 samples per pixel. */
START_TEST(thresholded_strokes_have_smooth_edges)
{
    struct hatch_image reference;
    begin();
    struct hatch_view view = view_from(1);
    set_repeat(&view);
    frame_draw(&frame, "tam-threshold", &view, WIDTH, HEIGHT, 8, &reference);
    ck_assert_double_gt(threshold_error(1, &view, &reference), 0.05); /* one sample, as in the paper */
    ck_assert_double_le(threshold_error(4, &view, &reference), 0.008);
    end();
}
END_TEST

START_TEST(tiles_join_without_a_seam)
{
    static const char *const drawn[] = {"gouraud", "tam", "tam-triple"};
    begin();
    struct hatch_view view = view_from(1);
    set_repeat(&view);
    for (int i = 0; i < 3; i++) {
        struct hatch_image whole, tiled;
        struct hatch_difference difference;
        frame_draw(&frame, drawn[i], &view, WIDTH, HEIGHT, 2, &whole);
        frame.shown.size_max_px = 300; /* draws in tiles of 150 pixels */
        frame_draw(&frame, drawn[i], &view, WIDTH, HEIGHT, 2, &tiled);
        frame.shown.size_max_px = frame.context.size_max_px;
        hatch_image_difference(&whole, &tiled, &difference);
        ck_assert_msg(difference.rmse < 0.002, "%s: %g", drawn[i], difference.rmse);
    }
    end();
}
END_TEST

static uint32_t live_textures(void)
{
    uint32_t live = 0;
    for (GLuint name = 1; name < 1000; name++)
        live += glIsTexture(name);
    return live;
}

/* The first picture also makes what later ones of its size share. */
START_TEST(pictures_give_their_textures_back)
{
    uint32_t live = 0;
    begin();
    struct hatch_view view = view_from(1);
    frame.shown.style.halo_px = 3;
    for (int i = 0; i < 3; i++) {
        struct hatch_image image;
        frame_draw(&frame, "gouraud", &view, WIDTH, HEIGHT, 2, &image);
        ck_assert(i == 0 || live_textures() == live);
        live = live_textures();
    }
    ck_assert_uint_gt(live, 0);
    end();
}
END_TEST

static Suite *suite(void)
{
    Suite *made = suite_create("render tone");
    TCase *tests = tcase_create("tone");
    tcase_add_test(tests, strokes_reproduce_the_tone_of_the_light);
    tcase_add_test(tests, thresholded_strokes_have_smooth_edges);
    tcase_add_test(tests, tiles_join_without_a_seam);
    tcase_add_test(tests, pictures_give_their_textures_back);
    suite_add_tcase(made, tests);
    return made;
}

HATCH_TEST_MAIN(suite)
