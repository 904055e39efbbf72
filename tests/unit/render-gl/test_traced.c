/* Traced strokes on the GPU: shaders/traced/width.glsl computes the widths of curve/width.c, and pictures drawn in
 * tiles are those drawn at once. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "curve/width.h"
#include "field_make.h"
#include "filter/difference.h"
#include "render-gl/gpu/buffer.h"
#include "render-gl/technique/traced/traced.h"
#include "render_frame.h"
#include "gpu/stage.h"
#include "trace/trace.h"

enum { TONES = 21, THRESHOLDS = 41, SCALES = 13, DENSEST = 5, WIDTHS = TONES * THRESHOLDS * SCALES * DENSEST };
#define FACING 4.0f /* scale of a surface that faces the camera */
enum { WIDTH = 300, HEIGHT = 200, TILE = 90, SIDE = 2 };

static struct test_frame frame;

/* Compiles a compute stage that writes the widths of an array of tone, threshold, scale and greatest threshold. */
static GLuint width_program(void)
{
    static const char begin[] = "#version 450 core\n",
                      end[] = "layout(local_size_x = 1) in;\n"
                              "layout(std430, binding = 0) readonly buffer Places { vec4 places[]; };\n"
                              "layout(std430, binding = 1) writeonly buffer Widths { float widths[]; };\n"
                              "layout(location = 0) uniform vec2 pen;\n"
                              "layout(location = 1) uniform float facing;\n"
                              "void main()\n"
                              "{\n"
                              "    vec4 at = places[gl_GlobalInvocationID.x];\n"
                              "    float denser = grazing_factor(at.z, facing, 0.4);\n"
                              "    vec3 law = width_law(pen, at.x, at.y, at.z, vec2(at.w, 1.5), denser, false);\n"
                              "    widths[gl_GlobalInvocationID.x] = law.x * law.y;\n"
                              "}\n";
    const char *const texts[] = {begin, shader_text("traced/width.glsl"), end};
    return compute_program(3, texts);
}

/* Fills in the places: thresholds around the one that the tone asks for with a pen, and densest ones around it, too. */
static void set_places(double width_px, float (*places)[4])
{
    for (int i = 0; i < WIDTHS; i++) {
        const double tone = (double)(i % TONES) / (TONES - 1), scale = pow(4, i / TONES % SCALES - 4);
        const double wanted = fmax(tone, 0.01) * scale / width_px;
        places[i][0] = (float)tone;
        places[i][1] = (float)(wanted * pow(1.1, i / (TONES * SCALES) % THRESHOLDS - 20));
        places[i][2] = (float)scale;
        places[i][3] = (float)(wanted * pow(2, i / (TONES * SCALES * THRESHOLDS) - 2));
    }
}

/* Compares the widths of a pen; returns how many places are drawn, and how many of them thinner than whole strokes. */
static void compare_widths(GLuint program, const struct hatch_stroke_pen *pen, float (*places)[4], uint32_t drawn[2])
{
    static float widths[WIDTHS];
    GLuint buffers[2] = {gpu_buffer_make(places, sizeof *places * WIDTHS), gpu_buffer_make(NULL, sizeof widths)};
    for (GLuint k = 0; k < 2; k++)
        gpu_storage_bind(k, buffers[k]);
    glUseProgram(program);
    glUniform2f(0, pen->width_px, pen->thin);
    glUniform1f(1, FACING);
    glDispatchCompute(WIDTHS, 1, 1);
    glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
    gpu_buffer_read(buffers[1], widths, sizeof widths);
    glDeleteBuffers(2, buffers);
    for (int i = 0; i < WIDTHS; i++) {
        const float *at = places[i];
        const double whole = hatch_stroke_whole_px(pen, (double)at[0]);
        const double scale = (double)at[2], denser = hatch_stroke_grazing(scale, FACING, 0.4);
        const double want = hatch_stroke_width_px(pen, (double)at[0], (double)at[1], scale, (double)at[3], 1.5, denser);
        ck_assert_msg(fabs((double)widths[i] - want) <= 2e-5 * whole,
                      "tone %g, threshold %g, scale %g, densest %g: %.7g on the GPU, %.7g on the processor",
                      (double)at[0], (double)at[1], (double)at[2], (double)at[3], (double)widths[i], want);
        drawn[0] += want > 0;
        drawn[1] += want > 0 && want < whole;
    }
}

START_TEST(both_laws_of_width_are_the_same)
{
    static const struct hatch_stroke_pen pens[] = {
        {.width_px = 2, .thin = 0.5f}, {.width_px = 0.2f, .thin = 1}, {.width_px = 64, .thin = 0.05f}};
    static float places[WIDTHS][4];
    struct gpu_context context;
    struct hatch_err failed;
    HATCH_TEST_OK(gpu_context_open_headless(&context, 2, &failed), &failed);
    GLuint program = width_program();
    for (size_t i = 0; i < sizeof pens / sizeof *pens; i++) {
        uint32_t drawn[2] = {0, 0};
        set_places((double)pens[i].width_px, places);
        compare_widths(program, &pens[i], places, drawn);
        ck_assert_uint_gt(drawn[0], WIDTHS / 4);
        ck_assert_uint_gt(drawn[1], WIDTHS / 16);
        ck_assert_uint_lt(drawn[0], WIDTHS - WIDTHS / 16);
    }
    glDeleteProgram(program);
    gpu_context_close(&context);
}
END_TEST

static void set_width(double px)
{
    for (const struct cmd_option *row = technique_traced.options; row->name; row++)
        if (strcmp(row->name, "stroke-width") == 0)
            *(double *)row->value = px;
}

/* Opens a torus with strokes along its field, and the technique with a pen of width 2. */
static void begin_strokes(void)
{
    static const float angles[] = {0, 1};
    const struct hatch_trace_options how = {
        .family_count = 2, .angle_rad = angles, .gap = 0.2, .levels = 4, .length = 40, .hard_rad = 0.7, .seed = 1};
    struct hatch_curves curves;
    frame_arenas(&frame);
    struct field_case torus = case_of(frame_shape(&frame, HATCH_SHAPE_TORUS, 2000));
    follow_truth(&torus, HATCH_SHAPE_TORUS, 0, 1);
    HATCH_TEST_OK(hatch_trace_make(&torus.surface, &torus.mesh, &torus.frames, torus.direction, &how, NULL, &keep,
                                   &scratch, &curves, &err),
                  &err);
    HATCH_TEST_OK(hatch_scene_of_mesh(&torus.mesh, &frame.args.keep, &frame.scene, &err), &err);
    frame.scene.meshes[0].curves = curves;
    const struct hatch_bounds bounds = {.radius = 1.5};
    frame_open_scene(NULL, &bounds, NULL, &frame);
    set_width(2);
    frame_picture(&frame, "traced");
    struct traced_state *state = frame.instances[0].state;
    state->style.width_px = 2;
    state->style.ink = 1;
    state->style.pen = (struct hatch_stroke_pen){
        .width_px = 2,
        .thin = 0.5f,
        .join = 0.3f,
        .response = {0.12f, 0.24f, 0.36f, 0.48f, 0.58f, 0.66f, 0.74f, 0.8f},
        .taper_px = 6,
        .vary = 0.3f,
        .pressure = 0.2f,
        .grain = 0.6f,
        .wobble_px = 1,
        .turn_rad = 0.05f,
    };
}

START_TEST(tiles_make_the_whole_picture)
{
    struct hatch_image whole, tiled;
    struct hatch_difference difference;
    begin_strokes();
    struct hatch_view view = frame_view(&frame, (double)WIDTH / HEIGHT);
    frame_draw(&frame, "traced", &view, WIDTH, HEIGHT, SIDE, &whole);
    frame.shown.size_max_px = SIDE * TILE;
    frame_draw(&frame, "traced", &view, WIDTH, HEIGHT, SIDE, &tiled);
    ck_assert_double_lt(hatch_image_mean(&whole), 0.9);
    hatch_image_difference(&whole, &tiled, &difference);
    ck_assert_msg(difference.rmse < 0.002 && difference.max < 0.1, "root mean square %g, largest %g", difference.rmse,
                  difference.max);
    frame_finish(&frame);
}
END_TEST

/* Strokes along the side of a face of a plane, which fills the picture: each has its ink, that of the last in the order
 * of drawing, too. Far fewer than are wanted, they have 2.4 widths of the pen; of strokes of one threshold, a share of
 * 1/1.4 - 1/2 is drawn (curve/width.h). */
START_TEST(the_ink_of_each_stroke_is_drawn)
{
    enum { STROKES = 3, SIZE = 200, PEN_PX = 4 };
    for (uint32_t count = 1; count <= STROKES; count++) {
        struct hatch_curve_point points[2 * STROKES];
        struct hatch_curve lines[STROKES];
        struct hatch_curve_set set = {.gap = 0.01f, .count = count};
        double length_px = 0;
        struct hatch_image image;
        for (uint32_t i = 0; i < count; i++) {
            const float at = 0.2f + 0.15f * (float)i, end = 0.9f - at;
            lines[i] = (struct hatch_curve){.first = 2 * i, .count = 2, .id = i};
            points[2 * i] = (struct hatch_curve_point){.share = {0.1f, at}, .threshold = 0.01f};
            points[2 * i + 1] = (struct hatch_curve_point){.share = {end, at}, .threshold = 0.01f};
            length_px += SIZE * ((double)end - 0.1);
        }
        frame_arenas(&frame);
        struct hatch_mesh plane = frame_plane(&frame, 2);
        HATCH_TEST_OK(hatch_scene_of_mesh(&plane, &frame.args.keep, &frame.scene, &err), &err);
        frame.scene.meshes[0].curves = (struct hatch_curves){1, count, 2 * count, &set, lines, points, 0, 0};
        frame_open_scene(NULL, &frame_unit, NULL, &frame);
        frame.shown.style.curve.low = 1;
        set_width(PEN_PX);
        frame_picture(&frame, "traced");
        struct traced_state *state = frame.instances[0].state;
        state->style.width_px = PEN_PX;
        state->style.ink = 1;
        state->style.pen =
            (struct hatch_stroke_pen){.thin = 1, .response = {0.12f, 0.24f, 0.36f, 0.48f, 0.58f, 0.66f, 0.74f, 0.8f}};
        frame_draw(&frame, "traced", &view_facing, SIZE, SIZE, SIDE, &image);
        double got = frame_ink(&image) * SIZE * SIZE,
               want = length_px * PEN_PX * HATCH_STROKE_WIDEST * (1 / HATCH_STROKE_SPARE - 0.5);
        ck_assert_msg(fabs(got - want) < 0.05 * want, "%u strokes: %g, not %g", count, got, want);
        frame_finish(&frame);
    }
}
END_TEST

static Suite *suite(void)
{
    Suite *made = suite_create("render traced");
    TCase *tests = tcase_create("traced");
    tcase_add_checked_fixture(tests, begin, end);
    tcase_add_test(tests, both_laws_of_width_are_the_same);
    tcase_add_test(tests, tiles_make_the_whole_picture);
    tcase_add_test(tests, the_ink_of_each_stroke_is_drawn);
    suite_add_tcase(made, tests);
    return made;
}

HATCH_TEST_MAIN(suite)
