#include "run.h"

#include <math.h>
#include <string.h>

#include "base/random.h"
#include "fail_alloc.h"
#include "stroke/footprint.h"

#define SIZE 128u

static struct hatch_arena keep;
static struct hatch_err err;
static struct hatch_footprint print, other;
static struct hatch_brush solid; /* alpha 1 everywhere */

static void begin(void)
{
    hatch_arena_init(&keep, (size_t)64 << 20);
    struct hatch_image pixel;
    HATCH_TEST_OK(hatch_image_make(&keep, 1, 1, "Y", &pixel, &err), &err);
    HATCH_TEST_OK(hatch_brush_from_image(&pixel, &keep, &solid, &err), &err);
    HATCH_TEST_OK(hatch_footprint_make(&keep, SIZE, 3, 32, &print, &err), &err);
    HATCH_TEST_OK(hatch_footprint_make(&keep, SIZE, 3, 32, &other, &err), &err);
}

static void end(void)
{
    hatch_arena_free(&keep);
}

static struct hatch_stroke stroke_at(float x, float y, float length_px, float width_px, float angle_rad)
{
    return (struct hatch_stroke){
        .x = x, .y = y, .length = length_px / (float)SIZE, .angle_rad = angle_rad, .width_px = width_px, .tone = 1};
}

static double ink_of(const struct hatch_footprint *f)
{
    double sum = 0;
    for (uint32_t i = 0; i < f->count; i++)
        sum += (double)f->alpha[i];
    return sum;
}

static double draw(struct hatch_stroke stroke, struct hatch_footprint *f)
{
    hatch_footprint_draw(&stroke, &solid, SIZE, 1, 1, f);
    return ink_of(f);
}

/* Along the axes the box filter is exact: the ink is length × width × opacity up to rounding. */
START_TEST(ink_is_length_times_width_times_opacity_along_the_axes)
{
    static const float widths[] = {0.1f, 0.5f, 1, 1.8f, 3.3f, 10};
    for (uint32_t w = 0; w < sizeof widths / sizeof *widths; w++)
        for (uint64_t i = 0; i < 40; i++) {
            float length = 10.5f + (float)i, x = hatch_random_unit(1, 1, i), y = hatch_random_unit(1, 2, i);
            struct hatch_stroke stroke = stroke_at(x, y, length, widths[w], i % 2 ? 0 : 1.57079633f);
            stroke.tone = 0.25f + 0.75f * hatch_random_unit(1, 3, i);
            double want = (double)(length * widths[w] * stroke.tone);
            ck_assert_double_eq_tol(draw(stroke, &print) / want, 1, 1e-4);
        }
}
END_TEST

/* At other angles the box of the filter is rotated against the pixels: within 2 % for a single stroke, and within 0.2 %
 * in the mean over 50 positions. */
START_TEST(ink_is_length_times_width_at_any_angle)
{
    static const float widths[] = {0.2f, 0.7f, 1, 1.8f, 3.3f, 10};
    for (uint32_t w = 0; w < sizeof widths / sizeof *widths; w++)
        for (int angle = 0; angle < 36; angle++) {
            double mean = 0;
            for (uint64_t i = 0; i < 50; i++) {
                float x = hatch_random_unit(2, 1, i), y = hatch_random_unit(2, 2, i);
                double ink = draw(stroke_at(x, y, 60, widths[w], (float)angle * 0.1745329f), &print);
                ck_assert_double_eq_tol(ink / (double)(60 * widths[w]), 1, 0.02);
                mean += ink / (double)(60 * widths[w]) / 50;
            }
            ck_assert_double_eq_tol(mean, 1, 0.002);
        }
}
END_TEST

/* Sampling at pixel centres would keep all ink of a thin stroke or lose all of it. */
START_TEST(a_stroke_thinner_than_a_pixel_keeps_its_ink)
{
    uint32_t hit = 0;
    for (uint32_t i = 0; i < 64; i++) {
        float y = 0.5f + (float)i / 64 / (float)SIZE;
        float centre = y * (float)SIZE, nearest = floorf(centre) + 0.5f;
        hit += fabsf(nearest - centre) < 0.15f; /* the stroke covers a pixel centre */
        ck_assert_double_eq_tol(draw(stroke_at(0.5f, y, 40, 0.3f, 0), &print), 12, 0.01);
    }
    ck_assert_uint_lt(hit, 32);
}
END_TEST

START_TEST(a_dot_is_as_long_as_it_is_wide)
{
    ck_assert_double_eq_tol(draw(stroke_at(0.3f, 0.6f, 0, 5, 0), &print), 25, 0.01);
    ck_assert_double_eq_tol(draw(stroke_at(0.3f, 0.6f, 0, 0.5f, 0), &print), 0.25, 0.001);
}
END_TEST

static void to_picture(const struct hatch_footprint *f, float *picture)
{
    memset(picture, 0, SIZE * SIZE * sizeof *picture);
    for (uint32_t i = 0; i < f->count; i++) {
        ck_assert_float_eq(picture[f->at[i]], 0); /* no pixel twice */
        ck_assert(f->alpha[i] > 0 && f->alpha[i] <= 1 && f->along[i] >= 0 && f->along[i] <= 1);
        picture[f->at[i]] = f->alpha[i];
    }
}

/* A torus has no borders: moving a stroke by whole pixels moves its pixels, to the last bit. */
START_TEST(moving_by_whole_pixels_moves_the_pixels)
{
    static float a[SIZE * SIZE], b[SIZE * SIZE];
    for (uint64_t i = 0; i < 50; i++) {
        float x = floorf(hatch_random_unit(3, 1, i) * 1024) / 1024, y = 0.5f + (float)i / 1024;
        uint32_t dx = (uint32_t)i * 37 % SIZE, dy = (uint32_t)i * 91 % SIZE;
        struct hatch_stroke stroke = stroke_at(x, y, 5 + 3 * (float)i, 2.5f, (float)i);
        ck_assert_double_gt(draw(stroke, &print), 10);
        to_picture(&print, a);
        stroke.x = fmodf(x + (float)dx / (float)SIZE, 1);
        stroke.y = fmodf(y + (float)dy / (float)SIZE, 1);
        draw(stroke, &print);
        to_picture(&print, b);
        for (uint32_t at = 0; at < SIZE * SIZE; at++) {
            uint32_t moved = (at / SIZE + dy) % SIZE * SIZE + (at % SIZE + dx) % SIZE;
            ck_assert_float_eq(a[at], b[moved]);
        }
        stroke.x += 1;
        draw(stroke, &print);
        to_picture(&print, a);
        ck_assert_mem_eq(a, b, sizeof a);
    }
}
END_TEST

/* A stroke around the tile two and a half times: a plain list of its pixels would hold most of them three times. */
START_TEST(a_stroke_around_the_tile_counts_each_pixel_once)
{
    double ink = draw(stroke_at(0.3f, 0.5f, 2.5f * (float)SIZE, 4, 0), &print);
    ck_assert_double_eq_tol(ink, 4.0 * SIZE, 0.01);
    ck_assert_uint_eq(print.count, 4 * SIZE);
    static float picture[SIZE * SIZE];
    draw(stroke_at(0.3f, 0.5f, 2.9f * (float)SIZE, 7, 0.7f), &print);
    to_picture(&print, picture);
    draw(stroke_at(0.3f, 0.5f, 20, 7, 0.7f), &print); /* entry_of was cleared */
    ck_assert_double_eq_tol(ink_of(&print), 140, 2);
}
END_TEST

START_TEST(the_largest_alpha_wins_where_a_stroke_overlaps_itself)
{
    static float picture[SIZE * SIZE];
    /* The ends of a stroke 1.25 tiles long overlap by a quarter; its brush is light in the first half. */
    struct hatch_image image;
    struct hatch_brush brush;
    HATCH_TEST_OK(hatch_image_make(&keep, 2, 1, "Y", &image, &err), &err);
    image.pixels[0] = 0.75f;
    HATCH_TEST_OK(hatch_brush_from_image(&image, &keep, &brush, &err), &err);
    struct hatch_stroke stroke = stroke_at(0.5f, 0.5f, 1.25f * (float)SIZE, 4, 0);
    hatch_footprint_draw(&stroke, &brush, SIZE, 1, 1, &print);
    to_picture(&print, picture);
    const float *row = picture + SIZE / 2 * SIZE;
    for (uint32_t x = 1; x < SIZE / 8 - 1; x++)
        ck_assert_float_eq(row[x], 1); /* the dark end overlaps the light start */
    for (uint32_t x = SIZE / 8 + 1; x < SIZE / 2 - 1; x++)
        ck_assert_float_eq_tol(row[x], 0.25f, 1e-6f);
}
END_TEST

/* Compositing the difference over `before` gives `now`. */
START_TEST(the_difference_over_the_previous_footprint_gives_the_new_one)
{
    static float before[SIZE * SIZE], now[SIZE * SIZE], rest[SIZE * SIZE];
    for (uint64_t i = 0; i < 30; i++) {
        struct hatch_stroke stroke = stroke_at(0.9f, 0.1f, 20 + 10 * (float)i, 6, (float)i);
        stroke.tone = 0.9f;
        hatch_footprint_draw(&stroke, &solid, SIZE, 0.5f, 0.75f, &other);
        to_picture(&other, before);
        draw(stroke, &print);
        to_picture(&print, now);
        hatch_footprint_subtract(&print, &other);
        memset(rest, 0, sizeof rest);
        for (uint32_t k = 0; k < print.count; k++)
            rest[print.at[k]] = print.alpha[k];
        for (uint32_t at = 0; at < SIZE * SIZE; at++) {
            float darkest = now[at] > before[at] ? now[at] : before[at];
            ck_assert_float_ge(rest[at], 0);
            ck_assert_float_eq_tol(1 - (1 - before[at]) * (1 - rest[at]), darkest, 1e-5f);
        }
        draw(stroke, &print);
        draw(stroke, &other);
        hatch_footprint_subtract(&print, &other);
        ck_assert_double_eq_tol(ink_of(&print), 0, 1e-3);
    }
}
END_TEST

START_TEST(growing_strokes_are_shorter_and_thinner)
{
    struct hatch_stroke stroke = stroke_at(0.5f, 0.5f, 60, 4, 0);
    hatch_footprint_draw(&stroke, &solid, SIZE, 0.5f, 0.75f, &print);
    ck_assert_double_eq_tol(ink_of(&print), 90, 0.01);
    hatch_footprint_draw(&stroke, &solid, SIZE, 1, 0, &print);
    ck_assert_uint_eq(print.count, 0);
}
END_TEST

START_TEST(along_runs_from_start_to_end)
{
    struct hatch_stroke stroke = stroke_at(0.5f, 0.5f, 64, 2, 0);
    draw(stroke, &print);
    ck_assert_uint_eq(print.count, 2 * 64); /* two rows of whole pixels, from 32 to 95 */
    for (uint32_t i = 0; i < print.count; i++) {
        float x = (float)(print.at[i] % SIZE) + 0.5f;
        float want = (x - ((float)SIZE / 2 - 32)) / 64;
        ck_assert_float_eq_tol(print.along[i], want < 0 ? 0 : want > 1 ? 1 : want, 1e-5f);
    }
}
END_TEST

/* A brush image whose alpha varies along the stroke gives the same mean ink at every length. */
START_TEST(a_striped_brush_keeps_its_mean_when_it_is_drawn_small)
{
    struct hatch_image image;
    struct hatch_brush brush;
    HATCH_TEST_OK(hatch_image_make(&keep, 512, 4, "Y", &image, &err), &err);
    for (uint32_t i = 0; i < 512 * 4; i++)
        image.pixels[i] = i % 512 % 16 ? 1 : 0; /* one column of 16 is black */
    HATCH_TEST_OK(hatch_brush_from_image(&image, &keep, &brush, &err), &err);
    for (uint64_t i = 0; i < 40; i++) {
        struct hatch_stroke stroke =
            stroke_at(hatch_random_unit(5, 1, i), hatch_random_unit(5, 2, i), 32, 4, 0.1f * (float)i);
        hatch_footprint_draw(&stroke, &brush, SIZE, 1, 1, &print);
        ck_assert_double_eq_tol(ink_of(&print) / (32 * 4 / 16.0), 1, 0.05);
    }
}
END_TEST

/* The offset of a long arc from its chord is the difference of two large numbers. A pixel, which is box-filtered,
 * changes by no more than the centre line moves there, at most by the sagitta, and at the ends by what the edges turn:
 * about bend. */
START_TEST(a_slightly_bent_stroke_is_nearly_a_straight_one)
{
    static const float bends[] = {1e-42f, 1e-20f, 1e-7f, 1e-6f, 1e-5f, 2e-5f, 1e-4f, 1e-3f, 1.2e-3f, 2e-3f, 0.01f};
    static float straight[SIZE * SIZE], bent[SIZE * SIZE];
    for (uint32_t b = 0; b < 2 * sizeof bends / sizeof *bends; b++)
        for (uint64_t i = 0; i < 10; i++) {
            struct hatch_stroke stroke = stroke_at(0.5f, 0.5f, 0.9f * (float)SIZE, 2.5f, (float)i * 0.7f);
            draw(stroke, &print);
            to_picture(&print, straight);
            stroke.bend_rad = b % 2 ? bends[b / 2] : -bends[b / 2];
            float sagitta = stroke.length * (float)SIZE * bends[b / 2] / 8, most = 0;
            ck_assert_double_eq_tol(draw(stroke, &print), 0.9 * SIZE * 2.5, 4);
            to_picture(&print, bent);
            for (uint32_t at = 0; at < SIZE * SIZE; at++)
                most = fmaxf(most, fabsf(bent[at] - straight[at]));
            ck_assert_float_le(most, sagitta + bends[b / 2] + 1e-4f);
            if (sagitta < 1.0f / 64)
                ck_assert_float_le(most, 0);
        }
}
END_TEST

/* The centre of gravity of a column of pixels under a level arc is that of the arc, x^2 / (2 radius) below its middle,
 * where the width is a whole number of pixels. */
START_TEST(a_slightly_bent_stroke_lies_on_its_arc)
{
    static const float bends[] = {2e-3f, 0.01f, 0.03f, -2e-3f, -0.03f};
    for (uint32_t b = 0; b < sizeof bends / sizeof *bends; b++) {
        struct hatch_stroke stroke = stroke_at(0.5f, 0.5f, 0.9f * (float)SIZE, 2, 0);
        double ink[SIZE] = {0}, moment[SIZE] = {0};
        stroke.bend_rad = bends[b];
        draw(stroke, &print);
        for (uint32_t i = 0; i < print.count; i++) {
            ink[print.at[i] % SIZE] += (double)print.alpha[i];
            moment[print.at[i] % SIZE] += (double)print.alpha[i] * (print.at[i] / SIZE + 0.5 - SIZE / 2);
        }
        for (uint32_t x = 8; x < SIZE - 8; x++) {
            double from_middle = x + 0.5 - SIZE / 2, radius = 0.9 * SIZE / (double)bends[b];
            ck_assert_double_eq_tol(ink[x], 2, 1e-3);
            ck_assert_double_eq_tol(moment[x] / ink[x], from_middle * from_middle / (2 * radius), 1e-3);
        }
    }
}
END_TEST

START_TEST(a_stroke_that_is_too_large_is_rejected)
{
    struct hatch_footprint huge;
    ck_assert_int_eq(hatch_footprint_make(&keep, 4096, 16, 16384, &huge, &err), HATCH_LIMIT);
    ck_assert_ptr_nonnull(strstr(err.text, "too large"));
    ck_assert_int_eq(hatch_footprint_make(&keep, 64, 1, NAN, &huge, &err), HATCH_LIMIT);
}
END_TEST

static enum hatch_status make(void *context, struct hatch_arena *to, struct hatch_arena *scratch,
                              struct hatch_err *error)
{
    (void)scratch;
    return hatch_footprint_make(to, 64, 1, 4, context, error);
}

START_TEST(every_failed_allocation_is_a_status)
{
    struct hatch_footprint made = {0};
    ck_assert_uint_ge(hatch_test_fail_alloc(make, &made, &made, sizeof made), 4);
}
END_TEST

static Suite *suite(void)
{
    Suite *suite = suite_create("stroke footprint");
    TCase *tests = tcase_create("footprint");
    tcase_add_checked_fixture(tests, begin, end);
    tcase_add_test(tests, ink_is_length_times_width_times_opacity_along_the_axes);
    tcase_add_test(tests, ink_is_length_times_width_at_any_angle);
    tcase_add_test(tests, a_stroke_thinner_than_a_pixel_keeps_its_ink);
    tcase_add_test(tests, a_dot_is_as_long_as_it_is_wide);
    tcase_add_test(tests, moving_by_whole_pixels_moves_the_pixels);
    tcase_add_test(tests, a_stroke_around_the_tile_counts_each_pixel_once);
    tcase_add_test(tests, the_largest_alpha_wins_where_a_stroke_overlaps_itself);
    tcase_add_test(tests, the_difference_over_the_previous_footprint_gives_the_new_one);
    tcase_add_test(tests, growing_strokes_are_shorter_and_thinner);
    tcase_add_test(tests, along_runs_from_start_to_end);
    tcase_add_test(tests, a_striped_brush_keeps_its_mean_when_it_is_drawn_small);
    tcase_add_test(tests, a_slightly_bent_stroke_is_nearly_a_straight_one);
    tcase_add_test(tests, a_slightly_bent_stroke_lies_on_its_arc);
    tcase_add_test(tests, a_stroke_that_is_too_large_is_rejected);
    tcase_add_test(tests, every_failed_allocation_is_a_status);
    suite_add_tcase(suite, tests);
    return suite;
}
HATCH_TEST_MAIN(suite)
