#include "run.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/random.h"
#include "base/text.h"

static struct hatch_text text_of(const char *from)
{
    return (struct hatch_text){from, strlen(from)};
}

START_TEST(lines_end_with_lf_or_cr_lf_and_the_last_one_needs_none)
{
    static const char *const want[] = {"one", "", "two \r x", "three"};
    struct hatch_text rest = text_of("one\n\r\ntwo \r x\r\nthree"), line;
    for (int i = 0; i < 4; i++) {
        ck_assert(hatch_text_line(&rest, &line));
        ck_assert_msg(hatch_text_is(line, want[i]), "line %d: '%.*s'", i, (int)line.length, line.at);
    }
    ck_assert(!hatch_text_line(&rest, &line));
    rest = text_of("a\n");
    ck_assert(hatch_text_line(&rest, &line) && !hatch_text_line(&rest, &line));
    rest = (struct hatch_text){NULL, 0};
    ck_assert(!hatch_text_line(&rest, &line));
}
END_TEST

START_TEST(byte_order_marks_are_skipped)
{
    static const char *const files[] = {"", "\xef\xbb\xbf", "\xef\xbb", "\xef\xbb\xbf\x61\x62", "ab\xef\xbb\xbf"};
    static const char *const want[] = {"", "", "\xef\xbb", "ab", "ab\xef\xbb\xbf"};
    for (size_t i = 0; i < sizeof files / sizeof *files; i++)
        ck_assert(
            hatch_text_is(hatch_text_of((struct hatch_bytes){(const uint8_t *)files[i], strlen(files[i])}), want[i]));
    ck_assert_uint_eq(hatch_text_of((struct hatch_bytes){NULL, 0}).length, 0);
}
END_TEST

START_TEST(words_are_separated_by_spaces_and_tabs)
{
    struct hatch_text rest = text_of(" \t one\ttwo  three "), word;
    ck_assert(hatch_text_word(&rest, &word) && hatch_text_is(word, "one"));
    ck_assert(hatch_text_word(&rest, &word) && hatch_text_is(word, "two"));
    ck_assert(hatch_text_word(&rest, &word) && hatch_text_is(word, "three"));
    ck_assert(!hatch_text_word(&rest, &word));
    ck_assert_uint_eq(rest.length, 0);
}
END_TEST

START_TEST(fields_may_be_empty)
{
    static const char *const want[] = {"", "a", "", "b c", ""};
    struct hatch_text rest = text_of("\ta\t\tb c\t"), field;
    for (int i = 0; i < 5; i++) {
        ck_assert(hatch_text_field(&rest, &field));
        ck_assert_msg(hatch_text_is(field, want[i]), "field %d: '%.*s'", i, (int)field.length, field.at);
    }
    ck_assert(!hatch_text_field(&rest, &field));
    rest = text_of("");
    ck_assert(hatch_text_field(&rest, &field) && field.length == 0);
    ck_assert(!hatch_text_field(&rest, &field));
}
END_TEST

START_TEST(is_compares_whole_texts)
{
    ck_assert(hatch_text_is(text_of("ink"), "ink"));
    ck_assert(!hatch_text_is(text_of("ink"), "in"));
    ck_assert(!hatch_text_is(text_of("in"), "ink"));
    ck_assert(!hatch_text_is((struct hatch_text){"ink\0", 4}, "ink"));
}
END_TEST

START_TEST(one_typing_error_is_near)
{
    static const char *const near[] = {"width",  "widht",  "iwdth",  "wdth",  "idth", "widt",
                                       "wwidth", "widths", "wiXdth", "Width", "widtX"};
    static const char *const far[] = {"", "w", "wid", "wdithh", "thwid", "widththx", "dwith", "WIdth", "wi"};
    for (size_t i = 0; i < sizeof near / sizeof *near; i++)
        ck_assert_msg(hatch_text_is_near(text_of(near[i]), "width"), "%s is far", near[i]);
    for (size_t i = 0; i < sizeof far / sizeof *far; i++)
        ck_assert_msg(!hatch_text_is_near(text_of(far[i]), "width"), "%s is near", far[i]);
    ck_assert(!hatch_text_is_near((struct hatch_text){"width\0\0\0", 8}, "width"));
    ck_assert(hatch_text_is_near((struct hatch_text){"", 0}, "x"));
}
END_TEST

START_TEST(decimal_numbers_are_parsed)
{
    static const struct {
        const char *text;
        double value;
    } good[] = {{"1", 1},      {"-0.5", -0.5}, {"+2", 2},    {"1e-3", 1e-3}, {".25", 0.25},         {"3.", 3},
                {"1E+2", 100}, {"1e-400", 0},  {"0.1", 0.1}, {"-0", 0},      {"16777216", 16777216}};
    for (size_t i = 0; i < sizeof good / sizeof *good; i++) {
        double value = -7;
        ck_assert_msg(hatch_text_number(text_of(good[i].text), &value), "%s", good[i].text);
        ck_assert_double_eq(value, good[i].value);
    }
    char longest[300];
    double value;
    memset(longest, '1', sizeof longest);
    ck_assert(hatch_text_number((struct hatch_text){longest, sizeof longest}, &value));
    ck_assert_double_eq(value, 1e300 / 9);
}
END_TEST

START_TEST(other_texts_are_no_numbers)
{
    static const char *const bad[] = {"",      " 1",  "1 ",    "12x", "1,5", "0x10",     "inf", "-inf",
                                      "nan",   "NaN", "1e400", "--1", "1e",  "e5",       ".",   "-",
                                      "1.2.3", "1_0", "½",     "1e+", "1f",  "infinity", "+-1"};
    double value = -7;
    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++)
        ck_assert_msg(!hatch_text_number(text_of(bad[i]), &value), "'%s'", bad[i]);
    ck_assert(!hatch_text_number((struct hatch_text){"1\0", 2}, &value));
    ck_assert_double_eq(value, -7);
}
END_TEST

START_TEST(numbers_equal_those_of_strtod)
{
    static const char *const formats[] = {"%.9g", "%.17g", "%.6f", "%e", "%.0f", "%+.3E"};
    for (uint64_t i = 0; i < 60000; i++) {
        char word[512];
        double exponent = ((double)hatch_random_unit(1, 1, i) - 0.5) * 60;
        double value = ((double)hatch_random_unit(1, 2, i) - 0.5) * pow(10, exponent), read;
        snprintf(word, sizeof word, formats[i % 6], value);
        ck_assert(hatch_text_decimal((struct hatch_text){word, strlen(word)}, &read));
        double want = strtod(word, NULL);
        double slack = i % 6 == 4 ? 1e-15 * fabs(want) : 0; /* more than nineteen digits */
        ck_assert_msg(fabs(read - want) <= slack, "%s: %.17g", word, read);
        ck_assert_float_eq((float)read, (float)want);
    }
    double number;
    static const char *const huge[] = {"1e999999999999", "-1e400"}, *const tiny[] = {"1e-999999999", "0e999999999"};
    for (int i = 0; i < 2; i++) {
        ck_assert(hatch_text_decimal((struct hatch_text){huge[i], strlen(huge[i])}, &number));
        ck_assert(isinf(number));
        ck_assert(hatch_text_decimal((struct hatch_text){tiny[i], strlen(tiny[i])}, &number));
        ck_assert_double_eq(number, 0);
    }
}
END_TEST

static Suite *suite(void)
{
    Suite *suite = suite_create("base text");
    TCase *tests = tcase_create("text");
    tcase_add_test(tests, lines_end_with_lf_or_cr_lf_and_the_last_one_needs_none);
    tcase_add_test(tests, byte_order_marks_are_skipped);
    tcase_add_test(tests, words_are_separated_by_spaces_and_tabs);
    tcase_add_test(tests, fields_may_be_empty);
    tcase_add_test(tests, is_compares_whole_texts);
    tcase_add_test(tests, one_typing_error_is_near);
    tcase_add_test(tests, decimal_numbers_are_parsed);
    tcase_add_test(tests, numbers_equal_those_of_strtod);
    tcase_add_test(tests, other_texts_are_no_numbers);
    suite_add_tcase(suite, tests);
    return suite;
}
HATCH_TEST_MAIN(suite)
