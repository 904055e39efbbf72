/* layers(5). */
#include "arenas.h"

#include <string.h>

#include "seed/layers.h"

static struct hatch_layers layers;

static enum hatch_status read(const char *text)
{
    return hatch_layers_read((struct hatch_bytes){(const uint8_t *)text, strlen(text)}, &keep, &layers, &err);
}

START_TEST(each_line_defines_a_layer)
{
    HATCH_TEST_OK(read("# a comment\n\n"
                       "tone 0.2..0.6 turn -90 length 40 width 3 ink 0.8 tile 128 stroke my pencil.png \r\n"
                       "  width 2 # the rest is left to the caller\n"),
                  &err);
    const struct hatch_layer_line *line = layers.lines;
    ck_assert_uint_eq(layers.count, 2);
    ck_assert(line->tone_given && line->turn_given);
    ck_assert_double_eq(line->low, 0.2);
    ck_assert_double_eq(line->high, 0.6);
    ck_assert_double_eq_tol(line->turn_rad, -1.5707963267948966, 1e-15);
    ck_assert_double_eq(line->length_px, 40);
    ck_assert_double_eq(line->width_px, 3);
    ck_assert_double_eq(line->ink, 0.8);
    ck_assert_double_eq(line->tile_px, 128);
    ck_assert_str_eq(line->stroke, "my pencil.png");
    line++;
    ck_assert(!line->tone_given && !line->turn_given && !line->stroke);
    ck_assert_double_eq(line->width_px, 2);
    ck_assert_double_eq(line->length_px, 0);
}
END_TEST

static const struct {
    const char *text, *message;
} wrong[] = {
    {"", "the file has no layer"},
    {"# only words\n", "the file has no layer"},
    {"turn 1\nnib 3\n", "line 2: no such key 'nib': want length, width, ink, tile, tone, turn or stroke"},
    {"turn\n", "line 1: turn: a value is missing"},
    {"turn x\n", "line 1: turn: 'x' is not a number"},
    {"turn nan\n", "line 1: turn: 'nan' is not a number"},
    {"turn 361\n", "line 1: turn: 361, want -360 to 360"},
    {"length 0\n", "line 1: length: 0, want 0.5 to 4096"},
    {"ink 1.5\n", "line 1: ink: 1.5, want 0.01 to 1"},
    {"tile 4\n", "line 1: tile: 4, want 8 to 8192"},
    {"tone 0.5\n", "line 1: tone: '0.5', want FROM..TO, like 0.2..0.6"},
    {"tone 0.5..\n", "line 1: tone: '0.5..', want FROM..TO, like 0.2..0.6"},
    {"tone ..1\n", "line 1: tone: '' is not a number"},
    {"tone 0.5..2\n", "line 1: tone: 2, want 0 to 1"},
    {"tone 0.5..0.5\n", "line 1: tone: the range from 0.5 to 0.5 is empty"},
    {"width 1 width 2\n", "line 1: width is repeated"},
    {"tone 0..1 tone 0..1\n", "line 1: tone is repeated"},
    {"stroke  \n", "line 1: stroke: want the name of a brush or a file"},
};

START_TEST(a_bad_line_is_reported)
{
    ck_assert_int_eq(read(wrong[_i].text), HATCH_BAD_INPUT);
    ck_assert_str_eq(err.text, wrong[_i].message);
}
END_TEST

START_TEST(too_many_layers_are_rejected)
{
    char text[9 * (HATCH_RPTAM_LAYERS_MAX + 1) + 1] = "";
    for (uint32_t i = 0; i <= HATCH_RPTAM_LAYERS_MAX; i++) {
        ck_assert_uint_eq(strlen(text), 9 * i);
        if (i == HATCH_RPTAM_LAYERS_MAX)
            HATCH_TEST_OK(read(text), &err);
        strcat(text, "width 10\n");
    }
    ck_assert_int_eq(read(text), HATCH_LIMIT);
    ck_assert_str_eq(err.text, "line 65: more than 64 layers");
}
END_TEST

static Suite *suite(void)
{
    Suite *suite = suite_create("seed layers");
    TCase *tests = tcase_create("layers");
    tcase_add_checked_fixture(tests, begin, end);
    tcase_add_test(tests, each_line_defines_a_layer);
    tcase_add_loop_test(tests, a_bad_line_is_reported, 0, sizeof wrong / sizeof *wrong);
    tcase_add_test(tests, too_many_layers_are_rejected);
    suite_add_tcase(suite, tests);
    return suite;
}

HATCH_TEST_MAIN(suite)
