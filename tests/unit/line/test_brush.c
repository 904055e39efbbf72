#include "arenas.h"

#include <math.h>
#include <string.h>

#include "line/brush/brush.h"

#define PIECES 200

static const struct hatch_line_brush brush = {.taper_px = 20, .vary = 0.5f, .wobble_px = 0.75f, .pressure = 0.25f};
static struct hatch_line_piece pieces[PIECES];
static struct hatch_line_strip strip;
static uint8_t visible[PIECES], seen[PIECES];
static struct hatch_item item = {.to_unit = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}};
static double size = 1; /* of its mesh */

/* A line of pieces of a pixel each, from a place of the unit scene on, in which a pixel is 1/500. */
static void make_line(double from)
{
    for (uint32_t i = 0; i < PIECES; i++) {
        pieces[i] = (struct hatch_line_piece){.a = {(float)i, 0},
                                              .b = {(float)(i + 1), 0},
                                              .place = {(float)(from + i / 500.0), 0.3f},
                                              .pixel = 1 / 500.0f};
        visible[i] = HATCH_LINE_VISIBLE;
        seen[i] = HATCH_LINE_VISIBLE | 6 << HATCH_LINE_WEIGHT_SHIFT;
    }
    strip = (struct hatch_line_strip){.count = PIECES};
}

static struct hatch_line_touch *touch(const struct hatch_line_brush *with)
{
    const struct hatch_line_strips strips = {1, PIECES, &strip, pieces, NULL};
    struct hatch_line_touch *touches;
    HATCH_TEST_OK(hatch_line_brush_touch(with, &item, size, &strips, visible, seen, &keep, &touches, &err), &err);
    return touches;
}

START_TEST(free_ends_are_pointed_and_others_are_not)
{
    const struct hatch_line_brush pointed = {.taper_px = 20};
    const float whole = HATCH_LINE_WEIGHT_LEAST + 6 * HATCH_LINE_WEIGHT_STEP;
    make_line(0);
    strip.joined[1] = true;
    visible[100] = 0;
    const struct hatch_line_touch *touches = touch(&pointed);
    ck_assert_float_lt(touches[0].width[0], 0.2f * whole);
    ck_assert_float_lt(touches[99].width[1], 0.2f * whole);
    ck_assert_float_lt(touches[101].width[0], 0.2f * whole);
    ck_assert_float_eq_tol(touches[50].width[0], whole, 1e-5f);
    ck_assert_float_eq_tol(touches[PIECES - 1].width[1], whole, 1e-5f);
    for (int i = 0; i < 20; i++)
        ck_assert_float_lt(touches[i].width[0], touches[i].width[1]);
    strip.closed = true;
    visible[100] = HATCH_LINE_VISIBLE;
    ck_assert_float_eq_tol(touch(&pointed)[0].width[0], whole, 1e-5f);
}
END_TEST

START_TEST(lines_vary_within_their_limits)
{
    float least = 2, most = 0;
    make_line(0);
    strip.joined[0] = strip.joined[1] = true;
    const struct hatch_line_touch *touches = touch(&brush);
    for (uint32_t i = 0; i < PIECES; i++) {
        least = fminf(least, touches[i].width[0]);
        most = fmaxf(most, touches[i].width[0]);
        ck_assert(touches[i].ink[0] >= 0.75f && touches[i].ink[0] <= 1);
        for (int k = 0; k < 2; k++)
            ck_assert_float_le(fabsf(touches[i].beside[0][k]), 0.75f);
        if (i > 0) {
            ck_assert_float_eq_tol(touches[i].width[0], touches[i - 1].width[1], 1e-6f);
            ck_assert_float_eq_tol(touches[i].beside[0][1], touches[i - 1].beside[1][1], 1e-6f);
            ck_assert_float_le(fabsf(touches[i].width[0] - touches[i].width[1]), 0.08f);
        }
    }
    ck_assert_float_gt(most - least, 0.15f);
}
END_TEST

/* A line is the same at a place of the item however it is cut, wherever the item is, and in any units of its mesh. */
START_TEST(lines_are_steady)
{
    struct hatch_line_touch before[PIECES];
    make_line(0);
    strip.joined[0] = strip.joined[1] = true;
    memcpy(before, touch(&brush), sizeof before);
    make_line(13 / 500.0);
    strip.joined[0] = strip.joined[1] = true;
    const struct hatch_line_touch *after = touch(&brush);
    for (uint32_t i = 0; i + 14 < PIECES; i++)
        ck_assert_float_eq_tol(after[i].width[0], before[i + 13].width[0], 0.02f);
    make_line(2);
    strip.joined[0] = strip.joined[1] = true;
    item.to_unit[12] = 2;
    after = touch(&brush);
    item.to_unit[12] = 0;
    for (uint32_t i = 0; i < PIECES; i++)
        ck_assert_float_eq_tol(after[i].width[0], before[i].width[0], 0.001f);
    make_line(0);
    strip.joined[0] = strip.joined[1] = true;
    item.to_unit[0] = item.to_unit[5] = item.to_unit[10] = 0x1p-50f;
    size = 0x1p50;
    after = touch(&brush);
    ck_assert_mem_eq(after, before, sizeof before);
}
END_TEST

START_TEST(weights_are_averaged)
{
    const struct hatch_line_brush heavy = {.depth = 1};
    make_line(0);
    for (uint32_t i = PIECES / 2; i < PIECES; i++)
        seen[i] = HATCH_LINE_VISIBLE | 12 << HATCH_LINE_WEIGHT_SHIFT;
    const struct hatch_line_touch *touches = touch(&heavy);
    for (uint32_t i = 0; i < PIECES; i++)
        ck_assert_float_le(fabsf(touches[i].width[1] - touches[i].width[0]), HATCH_LINE_WEIGHT_STEP);
    ck_assert_float_eq_tol(touches[PIECES - 1].width[1] - touches[0].width[0], 6 * HATCH_LINE_WEIGHT_STEP, 1e-5f);
}
END_TEST

static Suite *suite(void)
{
    Suite *made = suite_create("line brush");
    TCase *tests = tcase_create("brush");
    tcase_add_checked_fixture(tests, begin, end);
    tcase_add_test(tests, free_ends_are_pointed_and_others_are_not);
    tcase_add_test(tests, lines_vary_within_their_limits);
    tcase_add_test(tests, lines_are_steady);
    tcase_add_test(tests, weights_are_averaged);
    suite_add_tcase(made, tests);
    return made;
}

HATCH_TEST_MAIN(suite)
