/* Dashes of drawings, whose ends are known in closed form. */
#define _XOPEN_SOURCE 700 /* M_PI */
#include "svg/drawing.h"

/* A line of a whole number of pairs of a dash and a gap ends with a gap, in any direction and of any length. */
START_TEST(a_whole_number_of_periods_ends_with_a_gap)
{
    read_page("<path d='M10 10L70 90' stroke='#000' stroke-width='8' stroke-dasharray='10'/>");
    ck_assert_uint_eq(list.count, 5);
    for (uint32_t i = 0; i < 5; i++)
        check_ends(i, 10 + 12 * i, 10 + 16 * i, 16 + 12 * i, 18 + 16 * i);
    static const int legs[][3] = {{3, 4, 5}, {5, 12, 13}, {8, 15, 17}, {7, 24, 25}, {1, 0, 1}, {0, 1, 1}};
    for (size_t leg = 0; leg < sizeof legs / sizeof *legs; leg++)
        for (uint32_t periods = 1; periods <= 60; periods++) {
            char text[200];
            double scale = 60.0 / 25, period = scale * legs[leg][2] / periods;
            snprintf(text, sizeof text, "<path d='M7.7 3.1l%.17g %.17g' stroke='red' stroke-dasharray='%.17g %.17g'/>",
                     scale * legs[leg][0], scale * legs[leg][1], period / 3, period * 2 / 3);
            read_page(text);
            ck_assert_uint_eq(list.count, periods);
            for (uint32_t i = 0; i < periods; i++)
                ck_assert_double_eq_tol(100 * (double)list.items[i].length, period / 3, 1e-4);
        }
}
END_TEST

/* The same of lines with caps, on which a dash of length 0 would be seen. */
START_TEST(dots_end_before_the_line_does)
{
    for (uint32_t dots = 1; dots <= 60; dots++) {
        char text[200];
        snprintf(text, sizeof text,
                 "<path d='M10 10L70 90' stroke='red' stroke-linecap='round' stroke-dasharray='0 %.17g'/>",
                 100.0 / dots);
        read_page(text);
        ck_assert_uint_eq(list.count, dots);
    }
}
END_TEST

/* A dash that ends within a line shorter than the tolerance of a longer one. */
START_TEST(short_lines_have_short_dashes)
{
    read_page("<path d='M10 10h1e-4' stroke='red' stroke-dasharray='6e-5 1e-5'/>");
    ck_assert_uint_eq(list.count, 2);
    ck_assert_float_eq_tol(list.items[0].length, 6e-7f, 1e-8f);
    ck_assert_float_eq_tol(list.items[1].length, 3e-7f, 1e-8f);
}
END_TEST

/* Dashes are measured in the units of the element, before its transform: in closed form for scales, mirrors, turns and
 * skews. The circle has four dashes and gaps of 1/8 of it each, which become unequal in the picture. */
START_TEST(dashes_are_measured_before_the_transform)
{
    read_page("<path transform='scale(4,1)' d='M0 10H20M5 0V40' stroke='#000' stroke-dasharray='5'/>");
    ck_assert_uint_eq(list.count, 2 + 4);
    check_ends(0, 0, 10, 20, 10);
    check_ends(1, 40, 10, 60, 10);
    for (uint32_t i = 0; i < 4; i++)
        check_ends(2 + i, 20, 10 * i, 20, 10 * i + 5);
    read_page("<g transform='translate(10 90) scale(2,-1)'><path transform='rotate(90)' d='M0 0H40' stroke='red' "
              "stroke-dasharray='10 20' stroke-dashoffset='-5'/></g>");
    ck_assert_uint_eq(list.count, 2); /* the element's x axis points up in the picture, at scale 1 */
    check_ends(0, 10, 85, 10, 75);
    check_ends(1, 10, 55, 10, 50);
    read_page("<path transform='skewX(45)' d='M0 0V40' stroke='red' stroke-dasharray='10'/>");
    ck_assert_uint_eq(list.count, 2);
    check_ends(0, 0, 0, 10, 10);
    check_ends(1, 20, 20, 30, 30);
    read_page("<circle transform='translate(50 50) scale(4,1)' r='10' stroke='red' stroke-dasharray='7.853981634'/>");
    ck_assert_uint_eq(list.count, 4);
    for (uint32_t i = 0; i < 4; i++) {
        double xy[2], angle = M_PI / 4 * (2 * i + 1);
        point(i, -1, xy);
        ck_assert_double_eq_tol(xy[0], 50 + 40 * cos(angle), 0.03); /* curves are flattened to 1/20 pixel */
        ck_assert_double_eq_tol(xy[1], 50 + 10 * sin(angle), 0.03);
    }
}
END_TEST

START_TEST(a_flat_transform_draws_nothing)
{
    read_page("<path transform='scale(4,0)' d='M0 10H20' stroke='#000' stroke-dasharray='5'/>");
    ck_assert_uint_eq(list.count, 0);
}
END_TEST

static Suite *suite(void)
{
    Suite *suite = suite_create("io svg dash");
    TCase *tests = tcase_create("svg_dash");
    tcase_add_checked_fixture(tests, begin, end);
    tcase_add_test(tests, a_whole_number_of_periods_ends_with_a_gap);
    tcase_add_test(tests, dots_end_before_the_line_does);
    tcase_add_test(tests, short_lines_have_short_dashes);
    tcase_add_test(tests, dashes_are_measured_before_the_transform);
    tcase_add_test(tests, a_flat_transform_draws_nothing);
    suite_add_tcase(suite, tests);
    return suite;
}
HATCH_TEST_MAIN(suite)
