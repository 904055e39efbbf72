/* Pictures drawn with coverage lists equal pictures that try all seed points at every pixel, for all fades, rotations,
 * numbers of layers and of seed points. The cases are an orthogonal array of five levels: any two values of different
 * parameters occur together. */
#include "render_frame.h"
#include "rptam_model.h"

enum { SIZE = 96, LEVELS = 5 };

static const uint32_t seeds[LEVELS] = {2, 16, 37, 64, 250}, layers[LEVELS] = {1, 2, 3, 5, 8};
static const double overlaps[LEVELS] = {0, 0.1, 0.3, 0.7, 1}, turns_rad[LEVELS] = {0, 0.4, 1.5708, 2.3, -1};
static const double tiles_px[LEVELS] = {24, 40, 61, 90, 200}, lengths_px[LEVELS] = {3, 9, 17, 30, 50};
static const double tones[LEVELS] = {0.1, 0.3, 0.5, 0.7, 1};

static struct test_frame frame;
static struct hatch_rptam rptam;

/* Column k of row i = 5 a + b of the array: a + k b modulo 5. */
static int level(int i, int k)
{
    return (i / LEVELS + k * (i % LEVELS)) % LEVELS;
}

static void make_case(int i)
{
    struct model_how how = {.seeds = seeds[level(i, 0)],
                            .layers = layers[level(i, 1)],
                            .tile_px = tiles_px[level(i, 2)],
                            .length_px = lengths_px[level(i, 3)],
                            .width_px = 1 + level(i, 4),
                            .overlap = overlaps[level(i, 4)],
                            .law = (enum hatch_fade_law)((i + 1) % 3),
                            .fade_size = i % 2};
    for (uint32_t k = 0; k < how.layers; k++)
        how.angle_rad[k] = turns_rad[(level(i, 1) + (int)k) % LEVELS] + 0.1 * k;
    model_make(&how, &frame.args.keep, &frame.args.scratch, &rptam);
}

START_TEST(coverage_lists_and_brute_force_give_the_same_picture)
{
    struct hatch_image pictures[2];
    struct hatch_view view = {.half_height = 0.5, .aspect = 1, .near = 0.01, .far = 100, .pivot = 3};
    hatch_view_set_back(&view, (const double[3]){0.4, 0.8, 1});
    for (int k = 0; k < 3; k++)
        view.eye[k] = 3 * view.back[k];
    frame_arenas(&frame);
    make_case(_i);
    struct hatch_mesh mesh = frame_shape(&frame, HATCH_SHAPE_TORUS, 400);
    frame_open(&mesh, &frame_unit, NULL, &frame);
    frame.model = &rptam;
    frame.shown.style.curve.high = tones[level(_i, 2)];
    for (int all = 0; all < 2; all++) {
        frame_reset(&frame);
        rptam_options.loop = all;
        frame_draw(&frame, "rptam", &view, SIZE, SIZE, 1, &pictures[all]);
    }
    double worst = frame_difference(&pictures[0], &pictures[1]);
    ck_assert_msg(worst <= 1 / 255.0, "%.2f/255", 255 * worst);
    ck_assert_double_gt(frame_ink(&pictures[0]), 0);
    frame_finish(&frame);
}
END_TEST

static Suite *suite(void)
{
    Suite *suite = suite_create("render lists");
    TCase *tests = tcase_create("lists");
    tcase_add_loop_test(tests, coverage_lists_and_brute_force_give_the_same_picture, 0, LEVELS * LEVELS);
    suite_add_tcase(suite, tests);
    return suite;
}

HATCH_TEST_MAIN(suite)
