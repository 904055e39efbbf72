/* Solid textures while the camera comes nearer: the size of the texture on the screen, its mean, and changes from frame
 * to frame. */
#include "run.h"

#include "solid/facing.h"

enum { TEXELS = 32, PERIODS = 6, PERIOD_PX = 64 };

static struct test_frame frame;
static struct hatch_mesh mesh;
static struct hatch_solid solid;
static double values[2][FACING_SIZE * FACING_SIZE];

static void begin(void)
{
    facing_open(&frame, &mesh);
    solid = solid_of_waves(&frame.args.keep, TEXELS, PERIODS);
}

static void end(void)
{
    frame_finish(&frame);
}

/* Over forty octaves, in steps that meet a cycle at all its places. A cycle's dominant octave gives way to the next
 * one, of half its frequency. */
START_TEST(the_dominant_frequency_stays_within_an_octave)
{
    double power[SPECTRUM_SIZE / 2], low = SPECTRUM_SIZE, high = 0;
    solid_use(&frame, &solid, (enum hatch_zoom_blend)_i, PERIOD_PX);
    for (double octave = 0; octave <= 40; octave += 0.57) {
        facing_draw(&frame, 0, octave, values[0]);
        spectrum_of(values[0], power);
        double peak = spectrum_peak(power);
        low = fmin(low, peak);
        high = fmax(high, peak);
    }
    ck_assert_double_ge(low, 0.65 * PERIODS * FACING_SIZE / PERIOD_PX);
    ck_assert_double_le(high, 2.1 * low);
}
END_TEST

START_TEST(the_mean_stays)
{
    double low = 1, high = 0;
    solid_use(&frame, &solid, (enum hatch_zoom_blend)_i, 24);
    for (int step = 0; step <= 16; step++) {
        double mean = 0;
        for (int place = 0; place < 4; place++) {
            facing_draw(&frame, place, 5 + step / 16.0, values[0]);
            mean += facing_mean(values[0]) / 4;
        }
        low = fmin(low, mean);
        high = fmax(high, mean);
    }
    ck_assert_double_le(high - low, 1 / 255.0);
    ck_assert_double_eq_tol(low, 0.5, 1 / 255.0);
}
END_TEST

/* Two octaves of 64 frames each: nothing jumps, neither where a cycle ends nor elsewhere. */
START_TEST(a_cycles_end_is_not_seen)
{
    enum { FRAMES = 128 };
    double change[FRAMES];
    solid_use(&frame, &solid, (enum hatch_zoom_blend)_i, PERIOD_PX);
    facing_draw(&frame, 0, 7.3, values[0]);
    for (int t = 0; t < FRAMES; t++) {
        facing_draw(&frame, 0, 7.3 + (t + 1) / 64.0, values[(t + 1) % 2]);
        change[t] = facing_change(values[0], values[1]);
    }
    for (int t = 1; t + 1 < FRAMES; t++)
        ck_assert_double_le(change[t], 1.12 * fmax(change[t - 1], change[t + 1]));
}
END_TEST

/* The camera moves sideways by eight pixels and nearer by a 64th of an octave. Pixels are moved as the surface is; a
 * paper that stays with the screen, with the same values, does not follow. */
START_TEST(the_texture_moves_with_the_surface)
{
    double textured = 0, papered = 0, point[3] = {0.1, 0.2, 0};
    solid_use(&frame, &solid, (enum hatch_zoom_blend)_i, PERIOD_PX);
    for (int t = 0; t < 8; t++) {
        double octave = 6.15 + t / 8.0;
        double pixel = facing_draw_at(&frame, point, octave, values[0]);
        const double moved[3] = {point[0] + 8 * pixel, point[1] + 3 * pixel, 0};
        double scale = facing_draw_at(&frame, moved, octave + 1 / 64.0, values[1]) / pixel;
        double middle = 0.5 * (FACING_SIZE - 1) * (1 - scale);
        const double shift[2] = {8 + middle, 3 + middle};
        textured += facing_moved_change(values[0], values[1], scale, shift);
        papered += facing_moved_change(values[0], values[0], scale, shift);
    }
    ck_assert_double_lt(5 * textured, papered);
}
END_TEST

static Suite *suite(void)
{
    Suite *suite = suite_create("solid zoom");
    TCase *tests = tcase_create("zoom");
    tcase_add_checked_fixture(tests, begin, end);
    tcase_add_loop_test(tests, the_dominant_frequency_stays_within_an_octave, 0, 3);
    tcase_add_loop_test(tests, the_mean_stays, 0, 3);
    tcase_add_loop_test(tests, a_cycles_end_is_not_seen, 0, 3);
    tcase_add_loop_test(tests, the_texture_moves_with_the_surface, 0, 3);
    suite_add_tcase(suite, tests);
    return suite;
}

HATCH_TEST_MAIN(suite)
