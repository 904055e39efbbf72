#include "run.h"

#include <string.h>

#include "base/status.h"

START_TEST(messages_are_formatted_and_the_status_is_returned)
{
    struct hatch_err err;
    ck_assert_int_eq(hatch_fail(&err, HATCH_BAD_INPUT, "row %d: %d fields, want %d", 12, 3, 4), HATCH_BAD_INPUT);
    ck_assert_int_eq(err.status, HATCH_BAD_INPUT);
    ck_assert_str_eq(err.text, "row 12: 3 fields, want 4");
    ck_assert_int_eq(hatch_fail(NULL, HATCH_IO, "no message"), HATCH_IO);
}
END_TEST

START_TEST(control_characters_are_replaced)
{
    struct hatch_err err;
    hatch_fail(&err, HATCH_BAD_INPUT, "key '%s'", "\033[2J\n\x7f\xc3\xa4");
    ck_assert_str_eq(err.text, "key '?[2J??\xc3\xa4'");
    hatch_fail_at(&err, "part\t%s: ", "a\rb");
    ck_assert_str_eq(err.text, "part?a?b: key '?[2J??\xc3\xa4'");
    ck_assert_int_eq(err.status, HATCH_BAD_INPUT);
    /* U+0080 and U+009F, and their codes in Latin-1, among characters that have such bytes, too */
    hatch_fail(&err, HATCH_BAD_INPUT, "\xc2\x80\xc2\x9f\xc2\xa0 \x80\x9f\xa0 \xe2\x80\x93\xc3\x9f \xc2");
    ck_assert_str_eq(err.text, "????\xc2\xa0 ??\xa0 \xe2\x80\x93\xc3\x9f \xc2");
}
END_TEST

START_TEST(messages_of_libraries_are_quoted_in_one_clear_line)
{
    static const char *const cases[][2] = {
        {"Corrupt tile.\nSee the log.", "the file is damaged: corrupt tile"},
        {"IHDR: CRC error", "the file is damaged: IHDR: CRC error"},
        {"mismatched tag. ", "the file is damaged: mismatched tag"},
        {"", "the file is damaged"},
        {NULL, "the file is damaged"},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        struct hatch_err err;
        ck_assert_int_eq(hatch_fail_quoting(&err, HATCH_LIMIT, cases[i][0], "the %s is damaged", "file"), HATCH_LIMIT);
        ck_assert_str_eq(err.text, cases[i][1]);
    }
}
END_TEST

START_TEST(long_messages_are_cut)
{
    char text[2 * HATCH_ERR_TEXT_MAX];
    struct hatch_err err;
    memset(text, 'y', sizeof text - 1);
    text[sizeof text - 1] = 0;
    hatch_fail(&err, HATCH_LIMIT, "%s", text);
    ck_assert_uint_eq(strlen(err.text), HATCH_ERR_TEXT_MAX - 1);
    hatch_fail_at(&err, "place: ");
    ck_assert_uint_eq(strlen(err.text), HATCH_ERR_TEXT_MAX - 1);
    ck_assert_int_eq(strncmp(err.text, "place: yyy", 10), 0);
    hatch_fail_at(&err, "%s", text);
    ck_assert_uint_eq(strlen(err.text), HATCH_ERR_TEXT_MAX - 1);
}
END_TEST

static enum hatch_status try(enum hatch_status status, int *reached)
{
    HATCH_TRY(status);
    *reached = 1;
    return HATCH_OK;
}

START_TEST(try_returns_at_once)
{
    int reached = 0;
    ck_assert_int_eq(try(HATCH_DIFFERS, &reached), HATCH_DIFFERS);
    ck_assert_int_eq(reached, 0);
    ck_assert_int_eq(try(HATCH_OK, &reached), HATCH_OK);
    ck_assert_int_eq(reached, 1);
}
END_TEST

static Suite *suite(void)
{
    Suite *suite = suite_create("base status");
    TCase *tests = tcase_create("status");
    tcase_add_test(tests, messages_are_formatted_and_the_status_is_returned);
    tcase_add_test(tests, control_characters_are_replaced);
    tcase_add_test(tests, messages_of_libraries_are_quoted_in_one_clear_line);
    tcase_add_test(tests, long_messages_are_cut);
    tcase_add_test(tests, try_returns_at_once);
    suite_add_tcase(suite, tests);
    return suite;
}
HATCH_TEST_MAIN(suite)
