#include <stdio.h>
#include <string.h>

#include "image/ramp.h"
#include "run.h"

static void check_color(const struct hatch_ramp_stop *stops, uint32_t count, float at, float r, float g, float b)
{
    float rgb[3];
    hatch_ramp_color(stops, count, at, rgb);
    ck_assert_float_eq_tol(rgb[0], r, 1e-6f);
    ck_assert_float_eq_tol(rgb[1], g, 1e-6f);
    ck_assert_float_eq_tol(rgb[2], b, 1e-6f);
}

START_TEST(colours_are_linear_between_stops)
{
    static const struct hatch_ramp_stop stops[] = {
        {0.25f, {1, 0, 0.5f}}, {0.5f, {0, 0.5f, 0.75f}}, {0.75f, {0.5f, 0.25f, 1}}};
    check_color(stops, 3, 0, 1, 0, 0.5f);
    check_color(stops, 3, 0.25f, 1, 0, 0.5f);
    check_color(stops, 3, 0.3125f, 0.75f, 0.125f, 0.5625f);
    check_color(stops, 3, 0.5f, 0, 0.5f, 0.75f);
    check_color(stops, 3, 0.6875f, 0.375f, 0.3125f, 0.9375f);
    check_color(stops, 3, 0.75f, 0.5f, 0.25f, 1);
    check_color(stops, 3, 1, 0.5f, 0.25f, 1);
    check_color(stops, 1, 0.1f, 1, 0, 0.5f);
    check_color(stops, 1, 0.9f, 1, 0, 0.5f);
    check_color(stops, 0, 0.5f, 0, 0, 0);
}
END_TEST

static struct hatch_ramp_stop read[HATCH_RAMP_STOPS_MAX];
static uint32_t read_count;
static struct hatch_err err;

static enum hatch_status read_stop(const char *line)
{
    struct hatch_text rest = hatch_text_of((struct hatch_bytes){(const uint8_t *)line, strlen(line)});
    return hatch_ramp_read(&rest, "tone", read, &read_count, &err);
}

START_TEST(stops_are_read_in_rising_order)
{
    read_count = 0;
    HATCH_TEST_OK(read_stop("0 f00"), &err);
    HATCH_TEST_OK(read_stop("0.5 ffffff"), &err);
    ck_assert_uint_eq(read_count, 2);
    ck_assert_float_eq(read[1].at, 0.5f);
    check_color(read, 2, 0.25f, 1, 0.5f, 0.5f);
    ck_assert_int_eq(read_stop("0.5 000"), HATCH_BAD_INPUT);
    ck_assert_str_eq(err.text, "color: tone 0.5 does not exceed that of the color line before");
    ck_assert_int_eq(read_stop("0.6 red"), HATCH_BAD_INPUT);
    ck_assert_str_eq(err.text, "color: want a tone and three or six hexadecimal digits");
    ck_assert_int_eq(read_stop("0.6"), HATCH_BAD_INPUT);
    ck_assert_int_eq(read_stop("1.1 000"), HATCH_BAD_INPUT);
    ck_assert_uint_eq(read_count, 2);
}
END_TEST

START_TEST(there_is_room_for_32_stops)
{
    char line[32];
    read_count = 0;
    for (uint32_t i = 0; i < HATCH_RAMP_STOPS_MAX; i++) {
        snprintf(line, sizeof line, "%g 000", i / 64.0);
        HATCH_TEST_OK(read_stop(line), &err);
    }
    ck_assert_int_eq(read_stop("1 000"), HATCH_BAD_INPUT);
    ck_assert_str_eq(err.text, "more than 32 color lines");
    ck_assert_uint_eq(read_count, HATCH_RAMP_STOPS_MAX);
}
END_TEST

static Suite *suite(void)
{
    Suite *made = suite_create("image ramp");
    TCase *tests = tcase_create("ramp");
    tcase_add_test(tests, colours_are_linear_between_stops);
    tcase_add_test(tests, stops_are_read_in_rising_order);
    tcase_add_test(tests, there_is_room_for_32_stops);
    suite_add_tcase(made, tests);
    return made;
}

HATCH_TEST_MAIN(suite)
