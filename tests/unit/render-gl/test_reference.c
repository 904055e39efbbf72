/* Compares pictures of recursive procedural tonal art maps in perspective with Algorithm 2 in doubles. */
#include "render_frame.h"
#include "rptam_model.h"
#include "rptam_raster.h"

enum { SIZE = 160 };

static const struct model_how models[] = {
    {.layers = 3, .tile_px = 60, .length_px = 20, .width_px = 2, .angle_rad = {0, 1.5, 0.4}, .overlap = 1},
    {.layers = 4,
     .tile_px = 40,
     .length_px = 14,
     .width_px = 3,
     .angle_rad = {0.7, -1, 2, 0},
     .ink = 0.8,
     .overlap = 0.2,
     .fade_size = true,
     .seeds = 37},
    {.layers = 2,
     .tile_px = 77,
     .length_px = 30,
     .width_px = 1.5,
     .angle_rad = {0.1, 1.2},
     .seeds = 16,
     .law = HATCH_FADE_PAPER,
     .overlap = 0.5},
    {.layers = 4,
     .tile_px = 50,
     .length_px = 25,
     .width_px = 2,
     .angle_rad = {0, 1.5, 0.5, 2},
     .ink = 0.9,
     .law = HATCH_FADE_WEIGHTED,
     .overlap = 0.3},
};

static const struct {
    enum hatch_shape shape;
    uint32_t faces;
    double back[3], distance, half_height;
} scenes[] = {
    {HATCH_SHAPE_PLANE, 200, {0.5, 0.6, 1}, 3, 0.4},
    {HATCH_SHAPE_CYLINDER, 1000, {0.3, 0.4, 1}, 4, 0.35},
    {HATCH_SHAPE_TEAPOT, 4000, {0.6, 0.5, 1}, 5, 0.4},
    {HATCH_SHAPE_TEAPOT, 4000, {-0.4, 0.2, 1}, 2.2, 0.1},
};
enum { MODELS = sizeof models / sizeof *models, SCENES = sizeof scenes / sizeof *scenes };

static struct test_frame frame;
static struct hatch_rptam rptam;

static void set_view(int scene, struct hatch_view *view)
{
    *view = (struct hatch_view){.half_height = scenes[scene].half_height,
                                .aspect = 1,
                                .near = 0.01,
                                .far = 100,
                                .pivot = scenes[scene].distance};
    hatch_view_set_back(view, scenes[scene].back);
    for (int k = 0; k < 3; k++)
        view->eye[k] = scenes[scene].distance * view->back[k];
}

static void draw_both(int scene, double low, double high, struct raster *raster, struct hatch_image *picture)
{
    static struct hatch_mesh mesh;
    static struct hatch_view view;
    set_view(scene, &view);
    mesh = frame_shape(&frame, scenes[scene].shape, scenes[scene].faces);
    frame_open(&mesh, &frame_unit, NULL, &frame);
    frame.model = &rptam;
    frame.shown.style.curve.low = low;
    frame.shown.style.curve.high = high;
    frame.shown.style.light = (struct hatch_key_light){true, -0.7, 0.7};
    frame_draw(&frame, "rptam", &view, SIZE, SIZE, 1, picture);
    *raster = (struct raster){.mesh = &mesh, .view = &view, .size = SIZE};
    for (int k = 0; k < 3; k++)
        raster->to_light[k] =
            cos(0.7) * sin(-0.7) * view.right[k] + sin(0.7) * view.up[k] + cos(0.7) * cos(-0.7) * view.back[k];
    raster_draw(raster, &frame.args.keep);
}

START_TEST(pictures_match_algorithm_2)
{
    struct raster raster;
    struct hatch_image picture;
    double worst = 0, ink = 0;
    uint32_t inside = 0, at = 0, shown = 0;
    frame_arenas(&frame);
    model_make(&models[_i % MODELS], &frame.args.keep, &frame.args.scratch, &rptam);
    draw_both(_i / MODELS, 0.05, 0.7, &raster, &picture);
    for (uint32_t i = 0; i < SIZE * SIZE; i++) {
        shown += isfinite(raster.pixels[i].w) ? 1 : 0;
        if (!isfinite(raster.pixels[i].w) || !raster_is_inside(&raster, i % SIZE, i / SIZE))
            continue;
        double want = raster_ink(&raster, &raster.pixels[i], &rptam, 0.05, 0.7);
        double error = fabs(1 - (double)picture.pixels[3 * i] - want);
        inside++;
        ink += want;
        if (error > worst) {
            worst = error;
            at = i;
        }
    }
    ck_assert_msg(worst <= 1 / 255.0, "%.2f/255 at %u %u", 255 * worst, at % SIZE, at / SIZE);
    ck_assert_double_gt(ink / inside, 0.05);
    ck_assert_uint_gt(inside, shown * 3 / 4);
    ck_assert_uint_gt(shown, SIZE * SIZE / 8);
    frame_finish(&frame);
}
END_TEST

static Suite *suite(void)
{
    Suite *suite = suite_create("render reference");
    TCase *tests = tcase_create("reference");
    tcase_add_loop_test(tests, pictures_match_algorithm_2, 0, MODELS * SCENES);
    suite_add_tcase(suite, tests);
    return suite;
}

HATCH_TEST_MAIN(suite)
