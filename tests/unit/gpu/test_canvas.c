/* The canvas: the mean of the samples of a pixel, and its colours in a window. */
#include "arenas.h"
#include "render-gl/frame/canvas.h"
#include "render-gl/frame/pass.h"
#include "render-gl/gpu/bindings.h"
#include "render-gl/gpu/context.h"
#include "render-gl/gpu/texture.h"

static struct gpu_context context;
static struct gpu_programs programs;

static void open_canvas(uint32_t width, uint32_t side, struct canvas *canvas)
{
    HATCH_TEST_OK(gpu_context_open_headless(&context, 2, &err), &err);
    programs = (struct gpu_programs){.scratch = &scratch};
    hatch_arena_init(&programs.keep, (size_t)1 << 30);
    HATCH_TEST_OK(canvas_make(width, 1, side, &programs, canvas, &err), &err);
}

static void close_canvas(struct canvas *canvas)
{
    canvas_free(canvas);
    gpu_programs_free(&programs);
    gpu_context_close(&context);
}

/* Sample n of a row of pixels holds n: multiples of 1/8, which half floats hold exactly. */
START_TEST(a_pixel_is_the_mean_of_its_samples)
{
    enum { WIDTH = 3 };
    static float samples[8 * 8 * WIDTH][4], means[WIDTH][4];
    struct canvas canvas;
    const uint32_t side = (uint32_t)_i, row = WIDTH * side;
    open_canvas(WIDTH, side, &canvas);
    double want[WIDTH] = {0};
    for (uint32_t i = 0; i < row * side; i++) {
        samples[i][0] = (float)i / 8;
        samples[i][1] = i % row / side == 1 ? 1 : 0;
        want[i % row / side] += i / 8.0 / (side * side);
    }
    glTextureSubImage2D(canvas.samples.outputs[0], 0, 0, 0, (GLsizei)row, (GLsizei)side, GL_RGBA, GL_FLOAT, samples);
    canvas_resolve(&canvas);
    gpu_target_read(canvas.picture, 0, (struct gpu_rectangle){.width = WIDTH, .height = 1}, GL_RGBA, GL_FLOAT, 0,
                    means);
    for (uint32_t i = 0; i < WIDTH; i++) {
        ck_assert_double_eq_tol((double)means[i][0], want[i], 2e-3 * want[i] + 1e-6);
        ck_assert_float_eq_tol(means[i][1], i == 1 ? 1 : 0, 1e-3f);
    }
    close_canvas(&canvas);
}
END_TEST

/* sRGB: 12.92 times the light in the dark; 0.5 for ((0.5 + 0.055) / 1.055)^2.4; what is no colour is clamped. */
START_TEST(windows_show_srgb)
{
    enum { WIDTH = 8 };
    static const float light[WIDTH] = {-1, 0, 0.001f, 0.003f, 0.005f, 0.2140411f, 1, 3},
                       shown[WIDTH] = {0, 0, 0.01292f, 0.03876f, 0.061008f, 0.5f, 1, 1};
    static float samples[WIDTH][4], found[WIDTH][4];
    const struct gpu_target_form form = {.width = WIDTH, .height = 1, .outputs = {GL_RGBA32F}};
    struct gpu_target window;
    struct canvas canvas;
    open_canvas(WIDTH, 1, &canvas);
    HATCH_TEST_OK(gpu_target_make(&form, &window, &err), &err);
    for (uint32_t i = 0; i < WIDTH; i++)
        samples[i][0] = samples[WIDTH - 1 - i][2] = light[i];
    glTextureSubImage2D(canvas.samples.outputs[0], 0, 0, 0, WIDTH, 1, GL_RGBA, GL_FLOAT, samples);
    gpu_texture_bind(UNIT_TONES, canvas.picture->outputs[0], 0);
    frame_pass_begin(&(struct frame_pass){.target = &window});
    frame_pass_screen(canvas.present);
    gpu_target_read(&window, 0, (struct gpu_rectangle){.width = WIDTH, .height = 1}, GL_RGBA, GL_FLOAT, 0, found);
    for (uint32_t i = 0; i < WIDTH; i++) {
        ck_assert_float_eq_tol(found[i][0], shown[i], 3e-4f);
        ck_assert_float_eq(found[i][1], 0);
        ck_assert_float_eq_tol(found[i][2], shown[WIDTH - 1 - i], 3e-4f);
        ck_assert_float_eq(found[i][3], 1);
    }
    gpu_target_free(&window);
    close_canvas(&canvas);
}
END_TEST

static Suite *suite(void)
{
    Suite *made = suite_create("render canvas");
    TCase *tests = tcase_create("canvas");
    tcase_add_checked_fixture(tests, begin, end);
    tcase_add_loop_test(tests, a_pixel_is_the_mean_of_its_samples, 1, 9);
    tcase_add_test(tests, windows_show_srgb);
    suite_add_tcase(made, tests);
    return made;
}

HATCH_TEST_MAIN(suite)
