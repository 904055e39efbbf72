#include "run.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "placement/style.h"

static struct hatch_style style;
static struct hatch_err err;

static void begin(void)
{
    hatch_style_default(&style);
}

static enum hatch_status parse(const char *text)
{
    return hatch_style_parse((struct hatch_bytes){(const uint8_t *)text, strlen(text)}, &style, &err);
}

START_TEST(a_file_without_a_key_is_refused_and_changes_nothing)
{
    struct hatch_style before = style;
    ck_assert_int_eq(parse(""), HATCH_BAD_INPUT);
    ck_assert_int_eq(parse("\xef\xbb\xbf# marked\r\n"), HATCH_BAD_INPUT);
    ck_assert_int_eq(parse("\n   \n# nothing\n\t# more\r\n"), HATCH_BAD_INPUT);
    ck_assert_ptr_nonnull(strstr(err.text, "empty"));
    ck_assert_mem_eq(&before, &style, sizeof style);
    ck_assert_str_eq(style.name, "ink");
}
END_TEST

START_TEST(every_key_sets_its_member)
{
    HATCH_TEST_OK(parse("name chalk\n"
                        "brush charcoal\n"
                        "width 2.5\n"
                        "length 0.25 1.5\n"
                        "jitter 90\n"
                        "ink 0.5\n"
                        "darkest 0.75\n"
                        "gamma 2\n"
                        "overlap flat\n"
                        "bend 45 180\n"
                        "color 0.25 ff8000\n"
                        "color 0.75 000\n"
                        "direction 45 0.25 0.5\n"
                        "direction -90 0 1\n"
                        "thin 0.5\njoin 0.25\ntaper 3\nvary 0.125\npressure 0.75\ngrain 1\nwobble 4\nturn 30\n"
                        "response .1 .2 .3 .4 .5 .6 .7 .75\n"
                        "candidates 5e2 7"),
                  &err);
    ck_assert_str_eq(style.name, "chalk");
    ck_assert_int_eq(style.brush, HATCH_BRUSH_CHARCOAL);
    ck_assert_float_eq(style.width_px, 2.5f);
    ck_assert_float_eq(style.length_min, 0.25f);
    ck_assert_float_eq(style.length_max, 1.5f);
    ck_assert_float_eq_tol(style.jitter_rad, 1.57079633f, 1e-6f);
    ck_assert_float_eq(style.ink, 0.5f);
    ck_assert_float_eq(style.tone_max, 0.75f);
    ck_assert_float_eq(style.tone_gamma, 2);
    ck_assert_int_eq(style.overlap, HATCH_OVERLAP_FLAT);
    ck_assert(style.tone_max_given);
    ck_assert_float_eq_tol(style.bend_min_rad, 0.785398163f, 1e-6f);
    ck_assert_float_eq_tol(style.bend_max_rad, 3.14159265f, 1e-6f);
    ck_assert_uint_eq(style.color_count, 2);
    ck_assert_float_eq(style.colors[0].at, 0.25f);
    ck_assert_float_eq(style.colors[0].rgb[1], hatch_srgb_to_linear(128 / 255.0f));
    ck_assert_uint_eq(style.direction_count, 2); /* those of the default are replaced */
    ck_assert_float_eq_tol(style.directions[0].angle_rad, 0.785398163f, 1e-6f);
    ck_assert_float_eq(style.directions[0].from, 0.25f);
    ck_assert_float_eq(style.directions[0].to, 0.5f);
    ck_assert_float_eq_tol(style.directions[1].angle_rad, -1.57079633f, 1e-6f);
    ck_assert_float_eq(style.pen.thin, 0.5f);
    ck_assert_float_eq(style.pen.join, 0.25f);
    ck_assert_float_eq(style.pen.taper_px, 3);
    ck_assert_float_eq(style.pen.vary, 0.125f);
    ck_assert_float_eq(style.pen.pressure, 0.75f);
    ck_assert_float_eq(style.pen.grain, 1);
    ck_assert_float_eq(style.pen.wobble_px, 4);
    ck_assert_float_eq_tol(style.pen.turn_rad, 0.523598776f, 1e-6f);
    ck_assert_float_eq(style.pen.response[7], 0.75f);
    ck_assert_uint_eq(style.candidates_light, 500);
    ck_assert_uint_eq(style.candidates_dark, 7);
    HATCH_TEST_OK(parse("overlap darkens"), &err);
    ck_assert_int_eq(style.overlap, HATCH_OVERLAP_DARKENS);
}
END_TEST

START_TEST(marks_and_lines_have_their_keys)
{
    HATCH_TEST_OK(parse("marks 80 -40\nscatter 0.5\n"
                        "line-taper 12\nline-vary 0.5\nline-wobble 1\nline-depth 0.25\nline-tone 0.75\n"),
                  &err);
    ck_assert_float_eq(style.pen.mark_px, 80);
    ck_assert_float_eq(style.pen.gap_px, -40);
    ck_assert_float_eq(style.pen.scatter, 0.5f);
    ck_assert_float_eq(style.line_brush.taper_px, 12);
    ck_assert_float_eq(style.line_brush.vary, 0.5f);
    ck_assert_float_eq(style.line_brush.wobble_px, 1);
    ck_assert_float_eq(style.line_brush.depth, 0.25f);
    ck_assert_float_eq(style.line_brush.tone, 0.75f);
}
END_TEST

START_TEST(later_lines_win_and_comments_tabs_and_crlf_are_ignored)
{
    HATCH_TEST_OK(parse("\twidth\t3 # wide\r\nwidth 4#x\r\n"), &err);
    ck_assert_float_eq(style.width_px, 4);
}
END_TEST

START_TEST(every_brush_has_a_name)
{
    for (int kind = 0; kind < HATCH_BRUSH_IMAGE; kind++) {
        char line[64];
        snprintf(line, sizeof line, "brush %s", hatch_brush_name((enum hatch_brush_kind)kind));
        HATCH_TEST_OK(parse(line), &err);
        ck_assert_int_eq((int)style.brush, kind);
    }
}
END_TEST

START_TEST(a_brush_file_may_contain_spaces)
{
    HATCH_TEST_OK(parse("brush image \t my stroke.png \t # drawn by hand\n"), &err);
    ck_assert_int_eq(style.brush, HATCH_BRUSH_IMAGE);
    ck_assert_str_eq(style.brush_file, "my stroke.png");
    HATCH_TEST_OK(parse("brush image b.png"), &err); /* the longer name is overwritten */
    ck_assert_str_eq(style.brush_file, "b.png");
}
END_TEST

START_TEST(the_limits_themselves_are_allowed)
{
    char line[sizeof style.brush_file + 20], name[sizeof style.brush_file + 1] = "";
    HATCH_TEST_OK(parse("direction 30 0.5 0.5"), &err);
    HATCH_TEST_OK(parse("marks 0 1"), &err);
    HATCH_TEST_OK(parse("marks 0.5 -0.25"), &err);
    memset(name, 'a', sizeof style.brush_file - 1);
    snprintf(line, sizeof line, "brush image %s", name);
    HATCH_TEST_OK(parse(line), &err);
    ck_assert_str_eq(style.brush_file, name);
    snprintf(line, sizeof line, "brush image %sa", name);
    ck_assert_int_eq(parse(line), HATCH_BAD_INPUT);
}
END_TEST

static const struct {
    const char *text, *message;
} bad[] = {
    {"colour red", "line 1: no such key 'colour', perhaps color"},
    {"widht 3", "line 1: no such key 'widht', perhaps width"},
    {"candidate 30 3", "line 1: no such key 'candidate', perhaps candidates"},
    {"wide 3", "line 1: no such key 'wide'"},
    {"# one\n\nwidth", "line 3: width: a value is missing"},
    {"width wide\r\n", "line 1: width: 'wide' is not a number"},
    {"width 3 4", "line 1: width: too many values"},
    {"width 0.4", "line 1: width: 0.4, want 0.5 to 64"},
    {"width 65", "line 1: width: 65"},
    {"width nan", "line 1: width: 'nan'"},
    {"width -inf", "line 1: width: '-inf'"},
    {"width 12x", "line 1: width: '12x'"},
    {"marks 0.4 1", "line 1: marks: 0.4, want 0 or 0.5 to 1000"},
    {"marks 8 -5", "line 1: marks: -5, want -4 to 1000"},
    {"marks 8", "line 1: marks: a value is missing"},
    {"zigzag 21 8", "line 1: zigzag: 21, want 0 to 20"},
    {"zigzag 2", "line 1: zigzag: a value is missing"},
    {"zigzag 2 0", "line 1: zigzag: a wave of 0 widths, want 0.5 to 1000"},
    {"zigzag 2 8 1", "line 1: zigzag: too many values"},
    {"width-profile 1", "line 1: width-profile: one value, want 2 to 8 along the stroke"},
    {"width-profile", "line 1: width-profile: a value is missing"},
    {"width-profile 0 .05", "line 1: width-profile: no value of 0.1 or more"},
    {"pressure-profile 1 1.5", "line 1: pressure-profile: 1.5, want 0 to 1"},
    {"pressure-profile 1 1 1 1 1 1 1 1 1", "line 1: pressure-profile: too many values"},
    {"stroke-colors", "line 1: stroke-colors: want list or range, and colours"},
    {"stroke-colors f00 0f0", "line 1: stroke-colors: want list or range, and colours"},
    {"stroke-colors list", "line 1: stroke-colors: 0 colours, want at least 1"},
    {"stroke-colors range f00", "line 1: stroke-colors: 1 colours, want at least 2"},
    {"stroke-colors list red", "line 1: stroke-colors: 'red', want three or six hexadecimal digits"},
    {"stroke-colors list 0 1 2 3 4 5 6 7 8 9 a b c d e f 0", "line 1: stroke-colors: '0', want three or six"},
    {"stroke-colors list 000 111 222 333 444 555 666 777 888 999 aaa bbb ccc ddd eee fff 000",
     "line 1: stroke-colors: more than 16 colours"},
    {"response 0", "line 1: response: 0 does not exceed 0"},
    {"response 0.2 0.2", "line 1: response: 0.2 does not exceed 0.2"},
    {"scatter 2", "line 1: scatter: 2, want 0 to 1"},
    {"length 0.5", "line 1: length: a value is missing"},
    {"length 0 4.5", "line 1: length: 4.5"},
    {"length -1 1", "line 1: length: -1"},
    {"width 2\nlength 1 0.5\nwidth 3", "line 2: length: the minimum 1 exceeds the maximum 0.5"},
    {"bend 5", "line 1: bend: a value is missing"},
    {"bend 5 359", "line 1: bend: 359"},
    {"bend 90 45", "line 1: bend: the minimum 90 exceeds the maximum 45"},
    {"color ff0000", "line 1: color: 'ff0000' is not a number"},
    {"color 0.5 red", "line 1: color: want a tone and three or six"},
    {"color 1.5 ff0000", "line 1: color: 1.5"},
    {"color 0.5 ff0000\ncolor 0.5 000000", "line 2: color: tone 0.5 does not exceed"},
    {"jitter 91", "line 1: jitter: 91"},
    {"jitter -1", "line 1: jitter: -1"},
    {"ink 0", "line 1: ink: 0"},
    {"ink 1.1", "line 1: ink: 1.1"},
    {"darkest 0", "line 1: darkest: 0"},
    {"darkest 1.01", "line 1: darkest: 1.01"},
    {"gamma 0.05", "line 1: gamma: 0.05"},
    {"gamma 11", "line 1: gamma: 11"},
    {"overlap", "line 1: overlap: want darkens, flat or covers"},
    {"overlap both", "line 1: overlap: want darkens, flat or covers"},
    {"overlap flat flat", "line 1: overlap: too many values"},
    {"direction 0 0", "line 1: direction: a value is missing"},
    {"direction 361 0 1", "line 1: direction: 361"},
    {"direction 0 -0.1 1", "line 1: direction: -0.1"},
    {"direction 0 0 1.1", "line 1: direction: 1.1"},
    {"direction 0 0.6 0.5", "line 1: direction: the range from tone 0.6 to tone 0.5 is empty"},
    {"direction 0 0 1\ndirection 1 0 1\ndirection 2 0 1\ndirection 3 0 1\ndirection 4 0 "
     "1\ndirection 5 0 1\n"
     "direction 6 0 1\ndirection 7 0 1\ndirection 8 0 1",
     "line 9: more than 8 direction lines"},
    {"candidates 100", "line 1: candidates: a value is missing"},
    {"candidates 0 1", "line 1: candidates: 0"},
    {"candidates 1 1e7", "line 1: candidates: 10000000, want 1 to 1000000"},
    {"candidates 1.5 1", "line 1: candidates: 1.5 1, want whole numbers"},
    {"brush", "line 1: brush: a value is missing"},
    {"brush quill", "line 1: brush: 'quill', want ink"},
    {"brush ink ink", "line 1: brush: too many values"},
    {"brush image", "line 1: brush: image needs a file name"},
    {"brush image  # none", "line 1: brush: image needs a file name"},
    {"name", "line 1: name: want one word"},
    {"name two words", "line 1: name: too many values"},
    {"name aaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaa", "line 1: name: want one word"},
};

START_TEST(strokes_have_a_look)
{
    HATCH_TEST_OK(parse("zigzag 2.5 12\nwidth-profile 0.25 1 0.5\npressure-profile 1 0\n"
                        "stroke-colors list f00 0000ff 00ff00\nstroke-colors range 000 fff"),
                  &err);
    const struct hatch_stroke_look *look = &style.pen.look;
    ck_assert_float_eq(look->zigzag, 2.5f);
    ck_assert_float_eq(look->zigzag_length, 12);
    ck_assert_uint_eq(look->width.count, 3);
    ck_assert_float_eq(look->width.values[0], 0.25f);
    ck_assert_float_eq(look->width.values[2], 0.5f);
    ck_assert_uint_eq(look->pressure.count, 2);
    ck_assert_float_eq(look->pressure.values[1], 0);
    ck_assert_uint_eq(look->color_count, 2);
    ck_assert(look->mixes);
    ck_assert_float_eq(look->colors[1][2], 1);
    HATCH_TEST_OK(parse("zigzag 0 0\nstroke-colors list f00"), &err);
    ck_assert_float_eq(look->zigzag, 0);
    ck_assert_uint_eq(look->color_count, 1);
    ck_assert(!look->mixes);
    ck_assert_float_eq(look->colors[0][1], 0);
}
END_TEST

START_TEST(a_bad_line_is_reported_and_changes_nothing)
{
    struct hatch_style before = style;
    ck_assert_int_eq(parse(bad[_i].text), HATCH_BAD_INPUT);
    ck_assert_msg(strncmp(err.text, bad[_i].message, strlen(bad[_i].message)) == 0, "'%s', want '%s'", err.text,
                  bad[_i].message);
    ck_assert_mem_eq(&before, &style, sizeof style);
}
END_TEST

/* Linear between the colours, clamped beyond them, black without any; the first new color line replaces old ones. */
START_TEST(colors_are_interpolated)
{
    float rgb[3] = {1, 1, 1};
    hatch_ramp_color(style.colors, style.color_count, 0.5f, rgb);
    ck_assert(rgb[0] == 0 && rgb[1] == 0 && rgb[2] == 0);
    HATCH_TEST_OK(parse("color 0.2 ff0000\ncolor 0.4 0000ff\ncolor 0.8 000000"), &err);
    static const float want[][4] = {{0, 1, 0, 0},    {0.2f, 1, 0, 0},    {0.25f, 0.75f, 0, 0.25f},
                                    {0.4f, 0, 0, 1}, {0.6f, 0, 0, 0.5f}, {0.9f, 0, 0, 0}};
    for (int i = 0; i < 6; i++) {
        hatch_ramp_color(style.colors, style.color_count, want[i][0], rgb);
        for (int c = 0; c < 3; c++)
            ck_assert_float_eq_tol(rgb[c], want[i][1 + c], 1e-6f);
    }
    HATCH_TEST_OK(parse("color 0 00ff00"), &err);
    ck_assert_uint_eq(style.color_count, 1);
}
END_TEST

START_TEST(targets_rise_to_the_darkest)
{
    float target[HATCH_TAM_TONES_MAX];
    HATCH_TEST_OK(parse("darkest 0.9"), &err);
    hatch_style_targets(&style, 6, target);
    for (int i = 0; i < 6; i++)
        ck_assert_float_eq_tol(target[i], 0.15f * (float)(i + 1), 1e-6f);
    HATCH_TEST_OK(parse("darkest 1\ngamma 2"), &err);
    hatch_style_targets(&style, 4, target);
    ck_assert_float_eq(target[0], 0.0625f);
    ck_assert_float_eq(target[3], 1);
    HATCH_TEST_OK(parse("gamma 10"), &err);
    hatch_style_targets(&style, 256, target);
    for (int i = 1; i < 256; i++)
        ck_assert(target[i - 1] >= 0 && target[i] > target[i - 1] && target[i] <= 1);
    hatch_style_targets(&style, 1, target);
    ck_assert_float_eq(target[0], 1);
}
END_TEST

static Suite *suite(void)
{
    Suite *suite = suite_create("tam style");
    TCase *tests = tcase_create("style");
    tcase_add_checked_fixture(tests, begin, NULL);
    tcase_add_test(tests, a_file_without_a_key_is_refused_and_changes_nothing);
    tcase_add_test(tests, every_key_sets_its_member);
    tcase_add_test(tests, marks_and_lines_have_their_keys);
    tcase_add_test(tests, later_lines_win_and_comments_tabs_and_crlf_are_ignored);
    tcase_add_test(tests, every_brush_has_a_name);
    tcase_add_test(tests, the_limits_themselves_are_allowed);
    tcase_add_test(tests, a_brush_file_may_contain_spaces);
    tcase_add_test(tests, strokes_have_a_look);
    tcase_add_loop_test(tests, a_bad_line_is_reported_and_changes_nothing, 0, sizeof bad / sizeof *bad);
    tcase_add_test(tests, colors_are_interpolated);
    tcase_add_test(tests, targets_rise_to_the_darkest);
    suite_add_tcase(suite, tests);
    return suite;
}
HATCH_TEST_MAIN(suite)
