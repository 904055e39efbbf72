/* Compares recursive procedural tonal art maps on the GPU with their definition in doubles, on a plane parallel to the
 * screen, and coverage lists with trying all seed points. */
#include <fcntl.h>
#include <math.h>
#include <sys/wait.h>
#include <unistd.h>

#include "render_frame.h"
#include "rptam_ink.h"
#include "rptam_model.h"

enum { SIZE = 96 };

static struct test_frame frame;
static struct hatch_rptam rptam;

static void begin_plane(void)
{
    struct hatch_mesh mesh = frame_plane(&frame, 200);
    frame_open(&mesh, &frame_unit, NULL, &frame);
    frame.model = &rptam;
}

/* A view from the front of `span` x `span` in texture coordinates around the middle. */
static struct hatch_view view_of(double span)
{
    return (struct hatch_view){.eye = {0, 0, 5},
                               .right = {1, 0, 0},
                               .up = {0, 1, 0},
                               .back = {0, 0, 1},
                               .orthographic = true,
                               .half_height = span,
                               .aspect = 1,
                               .near = 0.1,
                               .far = 10,
                               .pivot = 5};
}

/* Ink of the model.
 *   unit_px  size in the picture of one unit of texture coordinates */
static double model_ink(const double uv[2], double unit_px, const double *amounts)
{
    double left = 1;
    for (uint32_t i = 0; i < rptam.layer_count; i++) {
        double depth = log2(rptam.layers[i].style.tile_px / unit_px);
        left *= 1 - rptam_layer_ink(&rptam, i, uv, depth, amounts[i], true);
    }
    return 1 - left;
}

/* The largest difference of ink between a picture and the model. */
static double compare(double span, double tone)
{
    struct hatch_image picture;
    struct hatch_view view = view_of(span);
    double amounts[HATCH_RPTAM_LAYERS_MAX], worst = 0;
    frame.shown.style.curve.low = frame.shown.style.curve.high = tone;
    frame_draw(&frame, "rptam", &view, SIZE, SIZE, 1, &picture);
    rptam_amounts(&rptam, tone, amounts);
    for (uint32_t y = 0; y < SIZE; y++)
        for (uint32_t x = 0; x < SIZE; x++) {
            const double uv[2] = {0.5 + span * ((x + 0.5) / SIZE - 0.5), 0.5 + span * ((y + 0.5) / SIZE - 0.5)};
            double want = 1 - model_ink(uv, SIZE / span, amounts);
            worst = fmax(worst, fabs((double)picture.pixels[3 * (y * SIZE + x)] - want));
        }
    return worst;
}

enum { LOOKS = 7 };
static const struct model_how looks[LOOKS] = {
    {.tile_px = 60, .length_px = 20, .width_px = 2, .angle_rad = {0, 1.5, 0.4}, .layers = 3, .overlap = 1},
    {.tile_px = 40,
     .length_px = 14,
     .width_px = 3,
     .angle_rad = {0.7, -1, 2},
     .ink = 0.8,
     .overlap = 0.2,
     .fade_size = true,
     .layers = 3,
     .seeds = 37},
    {.tile_px = 77,
     .length_px = 30,
     .width_px = 1.5,
     .angle_rad = {0.1, 1.2, 3},
     .layers = 3,
     .law = HATCH_FADE_PAPER,
     .overlap = 0.5},
    {.tile_px = 64,
     .length_px = 25,
     .width_px = 2.5,
     .angle_rad = {0, 1.3, 2},
     .ink = 0.9,
     .law = HATCH_FADE_WEIGHTED,
     .overlap = 0.3,
     .layers = 3,
     .seeds = 25},
    {.tile_px = 24,
     .length_px = 60,
     .width_px = 2,
     .angle_rad = {0.2, 1, 2},
     .ink = 0.7, /* strokes longer than the tile */
     .law = HATCH_FADE_WEIGHTED,
     .overlap = 0.8,
     .fade_size = true,
     .layers = 3,
     .seeds = 2},
    {.tile_px = 70,
     .length_px = 30,
     .width_px = 5,
     .angle_rad = {0.3, 1.6},
     .layers = 2,
     .varied = true,
     .overlap = 0.3},
    {.tile_px = 52,
     .length_px = 22,
     .width_px = 1.3,
     .angle_rad = {0.3, 1.6},
     .ink = 0.9,
     .layers = 2,
     .varied = true,
     .law = HATCH_FADE_WEIGHTED,
     .overlap = 0.5,
     .fade_size = true,
     .seeds = 37},
};

START_TEST(pictures_of_a_plane_match_the_model)
{
    static const double spans[] = {1, 0.7, 0.31, 0.11};
    frame_arenas(&frame);
    model_make(&looks[_i], &frame.args.keep, &frame.args.scratch, &rptam);
    begin_plane();
    for (int i = 0; i < 4; i++)
        for (int tone = 1; tone <= 3; tone++) {
            double worst = compare(spans[i], 0.13 * tone);
            ck_assert_msg(worst <= 1 / 255.0, "span %g, tone %d: %g", spans[i], tone, worst);
        }
    frame_finish(&frame);
}
END_TEST

/* Draws a torus with coverage lists and with all seed points. */
START_TEST(coverage_lists_hold_every_visible_stroke)
{
    struct hatch_image pictures[2];
    struct hatch_view view = view_of(0.8);
    view.half_height = 1.5;
    frame_arenas(&frame);
    model_make(&looks[_i], &frame.args.keep, &frame.args.scratch, &rptam);
    struct hatch_mesh mesh = frame_shape(&frame, HATCH_SHAPE_TORUS, 800);
    frame_open(&mesh, &frame_unit, NULL, &frame);
    frame.model = &rptam;
    frame.shown.style.curve.exposure = 1;
    for (int all = 0; all < 2; all++) {
        frame_reset(&frame);
        rptam_options.loop = all;
        frame_draw(&frame, "rptam", &view, SIZE, SIZE, 2, &pictures[all]);
    }
    ck_assert_double_le(frame_difference(&pictures[0], &pictures[1]), 1 / 255.0);
    ck_assert_double_gt(frame_ink(&pictures[0]), 0.02);
    frame_finish(&frame);
}
END_TEST

/* Every stroke of the view from twice the distance is in the nearer view. */
START_TEST(strokes_of_a_distant_view_are_in_the_nearer_one)
{
    struct hatch_image near_picture, far_picture;
    /* dots: present or absent */
    const struct model_how how = {.seeds = 16, .tile_px = SIZE, .length_px = 4, .width_px = 4, .overlap = 1};
    frame_arenas(&frame);
    model_make(&how, &frame.args.keep, &frame.args.scratch, &rptam);
    begin_plane();
    frame.shown.style.curve.low = frame.shown.style.curve.high = 1;
    struct hatch_view view = view_of(1); /* depth 0 */
    frame_draw(&frame, "rptam", &view, SIZE, SIZE, 1, &near_picture);
    view = view_of(2);
    frame_draw(&frame, "rptam", &view, SIZE, SIZE, 1, &far_picture);
    /* A pixel with ink in the distant view needs ink among the 8 x 8 pixels around it in the nearer view. */
    uint32_t dots = 0, lost = 0;
    for (uint32_t y = SIZE / 4 + 2; y < 3 * SIZE / 4 - 2; y++)
        for (uint32_t x = SIZE / 4 + 2; x < 3 * SIZE / 4 - 2; x++) {
            float ink = 0;
            for (uint32_t k = 0; k < 64; k++) {
                uint32_t row = 2 * y - SIZE / 2 - 3 + k / 8, column = 2 * x - SIZE / 2 - 3 + k % 8;
                ink = fmaxf(ink, 1 - near_picture.pixels[3 * (row * SIZE + column)]);
            }
            bool dot = far_picture.pixels[3 * (y * SIZE + x)] < 0.3f;
            dots += dot;
            lost += dot && ink < 0.5f;
        }
    ck_assert_uint_gt(dots, 20);
    ck_assert_uint_eq(lost, 0);
    frame_finish(&frame);
}
END_TEST

/* Layers have different strokes, sizes, tiles and seed sets; their tone intervals overlap and are in no order. */
START_TEST(layers_may_differ_in_every_parameter)
{
    frame_arenas(&frame);
    struct hatch_rptam_style style;
    struct hatch_image dot, brush, grain;
    model_style(&looks[3], &frame.args.keep, &brush, &style);
    HATCH_TEST_OK(hatch_image_make(&frame.args.keep, 3, 3, "A", &dot, &frame.err), &frame.err);
    dot.pixels[4] = 1;
    HATCH_TEST_OK(hatch_image_make(&frame.args.keep, 2, 2, "A", &grain, &frame.err), &frame.err);
    grain.pixels[1] = grain.pixels[2] = 1;
    style.layers[0] = (struct hatch_rptam_layer_style){0.4, 1, 2.5, 7, 7, 33, 0.6, &dot, NULL, false};
    style.layers[1].high = 0.9;
    style.layers[2] = (struct hatch_rptam_layer_style){0, 0.5, 0, 12, 2, 50, 1, &brush, &grain, true};
    model_of_style(&looks[3], &style, &frame.args.keep, &frame.args.scratch, &rptam);
    begin_plane();
    for (int tone = 1; tone <= 4; tone++) {
        double worst = compare(0.45, rptam.darkest * tone / 4);
        ck_assert_msg(worst <= 1 / 255.0, "tone %d: %g", tone, worst);
    }
    frame_finish(&frame);
}
END_TEST

/* Each layer has a narrow tone interval, so a light tone has strokes of few layers only. */
START_TEST(the_largest_number_of_layers_matches_the_model)
{
    struct model_how how = looks[0];
    double amounts[HATCH_RPTAM_LAYERS_MAX];
    frame_arenas(&frame);
    how.layers = HATCH_RPTAM_LAYERS_MAX;
    how.seeds = 4;
    how.ink = 0.5;
    for (uint32_t i = 0; i < how.layers; i++)
        how.angle_rad[i] = i;
    model_make(&how, &frame.args.keep, &frame.args.scratch, &rptam);
    begin_plane();
    rptam_amounts(&rptam, rptam.darkest / 8, amounts);
    ck_assert_double_gt(amounts[0], 0.99);
    ck_assert_double_eq(amounts[HATCH_RPTAM_LAYERS_MAX / 2], 0);
    for (int tone = 1; tone <= 8; tone += 7) {
        double worst = compare(0.7, rptam.darkest * tone / 8);
        ck_assert_msg(worst <= 1 / 255.0, "tone %d: %g", tone, worst);
    }
    frame_finish(&frame);
}
END_TEST

START_TEST(no_layers_give_blank_paper)
{
    struct hatch_image picture;
    struct hatch_view view = view_of(1);
    const struct hatch_rptam_style none = {.overlap = 0.5};
    const struct hatch_seeds no_sets = {0};
    frame_arenas(&frame);
    HATCH_TEST_OK(hatch_rptam_make(&no_sets, &none, &frame.args.keep, &frame.args.scratch, &rptam, &frame.err),
                  &frame.err);
    begin_plane();
    frame_draw(&frame, "rptam", &view, SIZE, SIZE, 1, &picture);
    for (uint32_t i = 0; i < 3 * SIZE * SIZE; i++)
        ck_assert_float_eq(picture.pixels[i], 1);
    ck_assert_double_eq(rptam.darkest, 0);
    frame_finish(&frame);
}
END_TEST

/* Reads a file of layers, and then one of seed sets that does not exist, in a process of its own with an arena of some
 * bytes. Returns its exit status. */
static int read_within(const char *layers, size_t limit_bytes)
{
    static const struct cmd_option options[] = {{0}};
    static const struct cmd_program program = {.name = "tested", .summary = "is tested", .options = options};
    struct rptam_state state = {.model = NULL};
    struct technique_instance instance = {.technique = &technique_rptam_places, .state = &state};
    struct technique_context context = {.args = &frame.args};
    char *words[] = {(char[]){"tested"}, NULL};
    int status;
    pid_t child = fork();
    ck_assert_int_ge(child, 0);
    if (child == 0) {
        dup2(open("/dev/null", O_WRONLY), STDERR_FILENO);
        cmd_begin(&program, 1, words, &frame.args);
        rptam_options.layers = layers;
        rptam_options.seeds = "/none/a.seeds";
        hatch_arena_init(&frame.args.keep, limit_bytes);
        rptam_read(&context, &instance);
    }
    ck_assert_int_eq(waitpid(child, &status, 0), child);
    ck_assert_msg(WIFEXITED(status), "%zu bytes: signal %d", limit_bytes, WTERMSIG(status));
    return WEXITSTATUS(status);
}

/* The strokes of many layers need more memory than the file, and than the image of a single one. */
START_TEST(layers_without_memory_end_the_command)
{
    char path[] = "/tmp/layersXXXXXX";
    int file = mkstemp(path), status = HATCH_LIMIT;
    for (uint32_t i = 0; i < HATCH_RPTAM_LAYERS_MAX; i++)
        ck_assert_int_eq(write(file, "stroke round\n", 13), 13);
    close(file);
    for (size_t limit_bytes = 1; status == HATCH_LIMIT; limit_bytes += 8192)
        status = read_within(path, limit_bytes);
    unlink(path);
    ck_assert_int_eq(status, HATCH_IO);
}
END_TEST

static Suite *suite(void)
{
    Suite *suite = suite_create("render rptam");
    TCase *tests = tcase_create("rptam");
    tcase_add_loop_test(tests, pictures_of_a_plane_match_the_model, 0, LOOKS);
    tcase_add_loop_test(tests, coverage_lists_hold_every_visible_stroke, 0, LOOKS);
    tcase_add_test(tests, layers_may_differ_in_every_parameter);
    tcase_add_test(tests, the_largest_number_of_layers_matches_the_model);
    tcase_add_test(tests, no_layers_give_blank_paper);
    tcase_add_test(tests, strokes_of_a_distant_view_are_in_the_nearer_one);
    tcase_add_test(tests, layers_without_memory_end_the_command);
    suite_add_tcase(suite, tests);
    return suite;
}

HATCH_TEST_MAIN(suite)
