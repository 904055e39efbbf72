/* The look of fitted strokes in pictures: their zigzag is that of curve/stroke_look.h, and so are their colours. */
#include <math.h>
#include <string.h>

#include "render-gl/gpu/bindings.h"
#include "render-gl/gpu/buffer.h"
#include "render-gl/technique/strokes/strokes.h"
#include "render_frame.h"
#include "rptam_model.h"

enum { WIDTH = 480, HEIGHT = 360, STROKES_MAX = 1024 };
static const double length_px = 90, width_px = 3;

static struct test_frame frame;
static struct hatch_rptam rptam;
static struct strokes_slot found[STROKES_MAX];
static float points[STROKES_MAX][RIBBON_POINTS][12];
static uint32_t count;
static struct hatch_image picture;

/* Draws a plane with few horizontal strokes.
 *   turn_rad  of the view about its axis */
static void draw(const struct hatch_stroke_look *look, double turn_rad)
{
    const struct model_how how = {.tile_px = 400,
                                  .length_px = length_px,
                                  .width_px = width_px,
                                  .overlap = 0.05,
                                  .seeds = 64,
                                  .solid = true,
                                  .angle_rad = {0}};
    static const double point[3] = {0, 0, 0};
    frame_arenas(&frame);
    struct hatch_mesh plane = frame_plane(&frame, 2);
    model_make(&how, &frame.args.keep, &frame.args.scratch, &rptam);
    frame_open(&plane, &frame_unit, NULL, &frame);
    frame.model = &rptam;
    frame.shown.style.curve.low = frame.shown.style.curve.high = 0.4 * rptam.darkest;
    rptam_options.stroke_px[0] = length_px;
    rptam_options.stroke_px[1] = width_px;
    rptam_options.ink = 1;
    struct technique_instance *instance = frame.instances;
    HATCH_TEST_OK(technique_open(instance, frame_technique("strokes"), &frame.technique_args, &frame.err), &frame.err);
    struct strokes_state *state = instance->state;
    state->seeds.source.drawing.pen.look = *look;
    struct hatch_view_choice choice = {.kind = HATCH_VIEW_EYE, .fov_rad = 0.5, .has_target = true};
    const struct hatch_framing framing = {.bounds = &frame.on_gpu.unit.bounds, .aspect = (double)WIDTH / HEIGHT};
    struct hatch_view view;
    memcpy(choice.target, point, sizeof point);
    choice.eye[2] = 2;
    HATCH_TEST_OK(hatch_view_make(&choice, &frame.on_gpu.unit.pose, &framing, &frame.args.scratch, &view, &frame.err),
                  &frame.err);
    hatch_view_turn(&view, turn_rad);
    frame_draw(&frame, "strokes", &view, WIDTH, HEIGHT, 1, &picture);
    count = state->found_count;
    ck_assert_uint_gt(count, 20);
    ck_assert_uint_le(count, STROKES_MAX);
    gpu_buffer_read(state->found.name, found, sizeof *found * count);
    gpu_buffer_read(state->points.name, points, sizeof *points * count);
}

/* Returns a pixel of the picture; NULL: there is none. */
static const float *pixel_at(double x, double y)
{
    if (!(x >= 0 && y >= 0 && x < WIDTH && y < HEIGHT))
        return NULL;
    return &picture.pixels[3 * ((size_t)(HEIGHT - 1 - (int)y) * WIDTH + (size_t)x)];
}

/* Returns the ink of a pixel; above 1: there is none. */
static double ink_at(double x, double y)
{
    const float *rgb = pixel_at(x, y);
    return rgb ? 1 - (double)rgb[0] : 2;
}

/* Returns whether another stroke comes near a place. */
static bool is_crowded(uint32_t stroke, double x, double y, double reach_px)
{
    for (uint32_t i = 0; i < count; i++)
        for (uint32_t k = 0; i != stroke && k < RIBBON_POINTS; k++)
            if (hypot((double)points[i][k][0] - x, (double)points[i][k][1] - y) < reach_px)
                return true;
    return false;
}

/* Finds the place of a straight ribbon at a t; returns whether it has one. */
static bool place_at(uint32_t stroke, double t, double at[2])
{
    const float *first = points[stroke][0], *last = points[stroke][RIBBON_POINTS - 1];
    double share = (t - (double)first[9]) / fmax((double)(last[9] - first[9]), 1e-9);
    for (int k = 0; k < 2; k++)
        at[k] = (double)first[k] + share * (double)(last[k] - first[k]);
    return share > 0.1 && share < 0.9;
}

/* There is ink at the corners of a zigzag, and none where it would be if it were mirrored. */
START_TEST(a_straight_stroke_has_a_zigzag)
{
    const struct hatch_stroke_look look = {.zigzag = 3, .zigzag_length = 10};
    const double waves = length_px / (10 * width_px), amplitude_px = 3 * width_px;
    uint32_t corners = 0;
    draw(&look, 0);
    for (uint32_t i = 0; i < count; i++)
        for (double wave = 0.25; wave < waves; wave += 0.5) {
            double at[2], beside = (amplitude_px - 0.5) * hatch_zigzag_beside(wave, 0);
            if (!place_at(i, wave / waves, at) || is_crowded(i, at[0], at[1], 24))
                continue;
            double ink = ink_at(at[0], at[1] + beside), other = ink_at(at[0], at[1] - beside);
            if (ink > 1 || other > 1)
                continue;
            ck_assert_msg(ink > 0.3, "stroke %u, wave %g: ink %g", i, wave, ink);
            ck_assert_msg(other < 0.05, "stroke %u, wave %g: ink %g on the other side", i, wave, other);
            ck_assert_double_lt(ink_at(at[0], at[1]), 0.05);
            corners++;
        }
    ck_assert_uint_gt(corners, 10);
    frame_finish(&frame);
}
END_TEST

/* The colour of a stroke follows from its id alone: it is that of curve/stroke_look.h in each frame. */
START_TEST(strokes_have_their_colours)
{
    static const struct hatch_stroke_look looks[] = {
        {.color_count = 3, .colors = {{0.8f, 0, 0}, {0, 0.6f, 0}, {0, 0, 0.7f}}},
        {.color_count = 3, .mixes = true, .colors = {{0.8f, 0, 0}, {0, 0.6f, 0}, {0, 0, 0.7f}}}};
    uint32_t seen = 0;
    draw(&looks[_i / 3], _i % 3 * 0.2);
    for (uint32_t i = 0; i < count; i++) {
        const float *middle = points[i][RIBBON_POINTS / 2], *rgb = pixel_at((double)middle[0], (double)middle[1]);
        float wanted[3];
        if (!rgb || middle[3] < 1.2f || is_crowded(i, (double)middle[0], (double)middle[1], 12))
            continue;
        hatch_stroke_color(&looks[_i / 3], found[i].id[0] >> STROKES_ID_HASH_SHIFT, wanted);
        for (int k = 0; k < 3; k++)
            ck_assert_float_eq_tol(rgb[k], wanted[k], 0.05f);
        seen++;
    }
    ck_assert_uint_gt(seen, 10);
    frame_finish(&frame);
}
END_TEST

/* The widths of a stroke follow the profile, and their mean stays. */
START_TEST(widths_follow_their_profile)
{
    static const struct hatch_stroke_look looks[] = {{.color_count = 0},
                                                     {.width = {.count = 3, .values = {0.25f, 1, 0.25f}}}};
    double sums[2] = {0, 0}, ends = 0;
    for (int profiled = 0; profiled < 2; profiled++) {
        draw(&looks[profiled], 0);
        for (uint32_t i = 0; i < count; i++) {
            for (uint32_t k = 0; k < RIBBON_POINTS; k++)
                sums[profiled] += (double)points[i][k][3];
            if (profiled)
                ends += (double)points[i][1][3];
        }
        frame_finish(&frame);
    }
    ck_assert_double_eq_tol(sums[1] / sums[0], 1, 0.1);
    ck_assert_double_lt(ends * RIBBON_POINTS / sums[1], 0.75);
}
END_TEST

/* The ink follows the profile of pressure, and strokes are wider by as much as they are lighter in the mean. */
START_TEST(pressure_follows_its_profile)
{
    static const struct hatch_stroke_look looks[] = {{.color_count = 0},
                                                     {.pressure = {.count = 2, .values = {1, 0.5f}}}};
    double widths[2] = {0, 0};
    for (int profiled = 0; profiled < 2; profiled++) {
        draw(&looks[profiled], 0);
        for (uint32_t i = 0; i < count; i++)
            for (uint32_t k = 0; k < RIBBON_POINTS; k++) {
                const float *point = points[i][k];
                double wanted = hatch_profile_at(&looks[profiled].pressure, (double)point[9]);
                ck_assert_double_eq_tol((double)point[4], wanted, 1e-4);
                widths[profiled] += (double)point[3];
            }
        frame_finish(&frame);
    }
    ck_assert_double_eq_tol(widths[1] / widths[0], 1 / 0.75, 0.1);
}
END_TEST

static Suite *suite(void)
{
    Suite *made = suite_create("strokes look");
    TCase *tests = tcase_create("look");
    tcase_add_test(tests, a_straight_stroke_has_a_zigzag);
    tcase_add_loop_test(tests, strokes_have_their_colours, 0, 6);
    tcase_add_test(tests, widths_follow_their_profile);
    tcase_add_test(tests, pressure_follows_its_profile);
    suite_add_tcase(made, tests);
    return made;
}

HATCH_TEST_MAIN(suite)
