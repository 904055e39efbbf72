/* The limits of drawings: of their page, and of clones, dashes and rules, which would take too long or too much memory.
 */
#include "svg/drawing.h"

/* Each side is then the unit of its own axis. */
START_TEST(a_page_is_a_square_to_within_a_thousandth)
{
    static const char *const pages[2] = {"<svg viewBox='0 0 999.2 1000'><path stroke='red' d='M0 0 499.6 500'/></svg>",
                                         "<svg viewBox='0 0 1000 999.2'><path stroke='red' d='M0 0 500 499.6'/></svg>"};
    for (int i = 0; i < 2; i++) {
        HATCH_TEST_OK(read_text(pages[i]), &err);
        ck_assert_uint_eq(list.count, 1);
        check_ends(0, 0, 0, 50, 50);
    }
    ck_assert_int_eq(read_text("<svg viewBox='0 0 998.8 1000'/>"), HATCH_BAD_INPUT);
    ck_assert_int_eq(read_text("<svg viewBox='0 0 1000 998.8'/>"), HATCH_BAD_INPUT);
}
END_TEST

/* Lines of width 2 along the sides of a page of 128: one that touches its side is drawn, one beyond that is not. */
START_TEST(a_stroke_that_touches_the_page_is_inside)
{
    static const char *const lines[4] = {"M%g 9V20", "M%g 9V20", "M9 %gH20", "M9 %gH20"};
    for (int i = 0; i < 8; i++) {
        char path[20], text[200];
        double beyond = i < 4 ? 1 : 1.125;
        snprintf(path, sizeof path, lines[i % 4], i % 2 ? 128 + beyond : -beyond);
        snprintf(text, sizeof text, "<svg viewBox='0 0 128 128'><path stroke='red' stroke-width='2' d='%s'/></svg>",
                 path);
        HATCH_TEST_OK(read_text(text), &err);
        ck_assert_uint_eq(list.count, i < 4);
        ck_assert_uint_eq(notes.outside, i >= 4);
    }
}
END_TEST

START_TEST(exponential_and_deep_clones_are_refused)
{
    static char text[200000];
    size_t at = (size_t)snprintf(text, sizeof text, "<svg viewBox='0 0 9 9'><g id='a0'><path d='M0 0 1 1'/></g>");
    for (int i = 1; i < 12; i++) {
        at += (size_t)snprintf(text + at, sizeof text - at, "<g id='a%d'>", i);
        for (int k = 0; k < 10; k++)
            at += (size_t)snprintf(text + at, sizeof text - at, "<use href='#a%d'/>", i - 1);
        at += (size_t)snprintf(text + at, sizeof text - at, "</g>");
    }
    snprintf(text + at, sizeof text - at, "</svg>");
    ck_assert_int_eq(read_text(text), HATCH_LIMIT);
    ck_assert_str_eq(err.text, "line 1: <use> elements draw more than 1000000 elements");
    for (int deeper = 0; deeper < 2; deeper++) { /* 127 groups with a clone each, a group, the path; or one more */
        at = (size_t)snprintf(text, sizeof text, "<svg viewBox='0 0 9 9'>");
        for (int i = 0; i < 127; i++)
            at += (size_t)snprintf(text + at, sizeof text - at, "<g id='a%d'><use href='#a%d'/></g>", i, i + 1);
        snprintf(text + at, sizeof text - at, "<g id='a127'>%s</g></svg>", deeper ? "<g><path/></g>" : "<path/>");
        ck_assert_int_eq(read_text(text), deeper ? HATCH_BAD_INPUT : HATCH_OK);
    }
    ck_assert_str_eq(err.text, "line 1: elements nested deeper than 256");
}
END_TEST

/* A group of 1000 elements, cloned 1000 times, and one more element. Nothing of it is drawn. */
START_TEST(a_million_cloned_elements_are_accepted)
{
    static char text[50000];
    for (int more = 0; more < 2; more++) {
        size_t at = (size_t)snprintf(text, sizeof text, "<svg viewBox='0 0 9 9'><defs><g id='a'><g id='b'/>");
        for (int i = 0; i < 998; i++)
            at += (size_t)snprintf(text + at, sizeof text - at, "<g/>");
        at += (size_t)snprintf(text + at, sizeof text - at, "</g>");
        for (int i = 0; i < 1000; i++)
            at += (size_t)snprintf(text + at, sizeof text - at, "<use href='#a'/>");
        snprintf(text + at, sizeof text - at, "%s</defs></svg>", more ? "<use href='#b'/>" : "");
        ck_assert_int_eq(read_text(text), more ? HATCH_LIMIT : HATCH_OK);
    }
    ck_assert_str_eq(err.text, "line 1: <use> elements draw more than 1000000 elements");
}
END_TEST

/* Dashes and gaps of 2^-13 user units along a line of 999,999 and of a million of them: all numbers are exact. */
START_TEST(dashes_and_gaps_are_fewer_than_a_million)
{
    static const char *const ends[] = {"122.0701904296875", "122.0703125"};
    char text[300];
    for (int more = 0; more < 2; more++) {
        snprintf(text, sizeof text,
                 "<svg viewBox='0 0 128 128'><path stroke='red' stroke-dasharray='0.0001220703125' d='M0 0H%s'/></svg>",
                 ends[more]);
        ck_assert_int_eq(read_text(text), more ? HATCH_LIMIT : HATCH_OK);
    }
    ck_assert_uint_eq(list.count, 500000);
    ck_assert_str_eq(err.text, "line 1: more than 1000000 dashes");
}
END_TEST

START_TEST(rules_are_limited)
{
    static char text[200000];
    for (int more = 0; more < 2; more++) {
        size_t at = (size_t)snprintf(text, sizeof text, "<svg viewBox='0 0 9 9'><style>");
        for (int i = 0; i < 4096 + more; i++)
            at += (size_t)snprintf(text + at, sizeof text - at, ".a%d{stroke:red}", i);
        snprintf(text + at, sizeof text - at, "</style></svg>");
        ck_assert_int_eq(read_text(text), more ? HATCH_LIMIT : HATCH_OK);
    }
    ck_assert_str_eq(err.text, "more than 4096 CSS rules");
}
END_TEST

static Suite *suite(void)
{
    Suite *suite = suite_create("io svg limits");
    TCase *tests = tcase_create("svg_limits");
    tcase_add_checked_fixture(tests, begin, end);
    tcase_add_test(tests, a_page_is_a_square_to_within_a_thousandth);
    tcase_add_test(tests, a_stroke_that_touches_the_page_is_inside);
    tcase_add_test(tests, exponential_and_deep_clones_are_refused);
    tcase_add_test(tests, a_million_cloned_elements_are_accepted);
    tcase_add_test(tests, dashes_and_gaps_are_fewer_than_a_million);
    tcase_add_test(tests, rules_are_limited);
    suite_add_tcase(suite, tests);
    return suite;
}
HATCH_TEST_MAIN(suite)
