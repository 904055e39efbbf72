/* Colours and properties of drawings in the syntaxes of CSS. */
#include "svg/drawing.h"
#include "image/image.h"

static const struct {
    const char *attributes;
    float rgb[3], tone; /* sRGB */
} strokes[] = {
    {"stroke='#00000080'", {0, 0, 0}, 128 / 255.0f},
    {"stroke='#F80A'", {1, 136 / 255.0f, 0}, 170 / 255.0f},
    {"stroke='rgba(0,0,0,0.1)'", {0, 0, 0}, .1f},
    {"stroke='rgb(0 51 255 / 25%)' stroke-opacity='.5' opacity='.5'", {0, .2f, 1}, .0625f},
    {"stroke='rgb(0%,20%,100%,1)'", {0, .2f, 1}, 1},
    {"stroke='hsl(0,0%,50%)'", {.5f, .5f, .5f}, 1},
    {"stroke='hsl(0,100%,50%)'", {1, 0, 0}, 1},
    {"stroke='hsl(120deg 100% 25%)'", {0, .5f, 0}, 1},
    {"stroke='HSLA(.5turn, 50%, 50%, 50%)'", {.25f, .75f, .75f}, .5f},
    {"stroke='hsl(-120 100% 75% / .25)'", {.5f, .5f, 1}, .25f},
    {"stroke='hsl(420 60% 40%)'", {.64f, .64f, .16f}, 1},
    {"color='hsl(0 0% 0% / .5)' stroke='currentColor'", {0, 0, 0}, .5f},
    {"color='blue' style='color:oklch(40% 0.2 30);stroke:currentColor'", {0, 0, 1}, 1},
    {"stroke='currentColor' color='#0000ff80'", {0, 0, 1}, 128 / 255.0f},
    {"style='stroke:currentcolor;color:lime'", {0, 1, 0}, 1},
    {"stroke='lime' style='stroke:unset'", {0, 1, 0}, 1},
    {"style='/* ink: */stroke:/*;*/lime'", {0, 1, 0}, 1},
    {"style='stroke:lime!important;stroke:red'", {0, 1, 0}, 1},
    {"style='stroke:lime ! important; stroke:red'", {0, 1, 0}, 1},
};

START_TEST(strokes_have_the_colour_and_the_alpha)
{
    char text[300];
    snprintf(text, sizeof text, "<path d='M0 0 9 9' %s/>", strokes[_i].attributes);
    read_page(text);
    ck_assert_uint_eq(list.count, 1);
    for (int c = 0; c < 3; c++)
        ck_assert_float_eq_tol(hatch_linear_to_srgb(list.items[0].rgb[c]), strokes[_i].rgb[c], 1e-4f);
    ck_assert_float_eq_tol(list.items[0].tone, strokes[_i].tone, 1e-6f);
}
END_TEST

/* Each draws its path in lime. */
static const char *const sheets[] = {
    "path{stroke:lime}*{stroke:red}",
    "*{stroke:lime}",
    ".a{stroke:lime!important}#b{stroke:red}",
    ".a{stroke:lime!important}path.a{stroke:red!important}*.a{stroke:lime}path.a{stroke:lime!important}",
    "@import url('https://a.example/css?family=R:wght@400;700');.a{stroke:lime}",
    "@import 'a;b{';.a{stroke:lime}",
    "@media (min-width:1px){.a{stroke:red}i:before{content:'}'}}.a{stroke:lime}",
};

START_TEST(sheets_cascade)
{
    char text[300];
    snprintf(text, sizeof text, "<style>%s</style><path id='b' class='a' d='M0 0 9 9'/>", sheets[_i]);
    read_page(text);
    ck_assert_uint_eq(list.count, 1);
    ck_assert_msg(list.items[0].rgb[0] == 0 && list.items[0].rgb[1] == 1, "%s", sheets[_i]);
}
END_TEST

/* CSS 2.1, section 4.2: a declaration with an unknown value is ignored. */
START_TEST(unknown_values_in_css_are_ignored_and_counted)
{
    static const char *const values[] = {
        "stroke:light-dark(red, blue)", "stroke:var(--ink)", "stroke-width:1rem", "stroke-width:-1", "opacity:calc(1)",
        "stroke-dashoffset:1rem"};
    for (size_t i = 0; i < sizeof values / sizeof *values; i++) {
        char text[300];
        snprintf(text, sizeof text, "<path stroke='lime' stroke-width='2' style='%s' d='M0 0 9 9'/>", values[i]);
        read_page(text);
        ck_assert_msg(list.count == 1 && list.items[0].rgb[1] == 1 && notes.others == 1, "%s", values[i]);
        snprintf(text, sizeof text, "<style>.a{stroke:lime}path.a{%s}</style><path class='a' d='M0 0 9 9'/>",
                 values[i]);
        read_page(text);
        ck_assert_msg(list.count == 1 && list.items[0].rgb[1] == 1 && notes.others == 1, "%s", values[i]);
    }
}
END_TEST

START_TEST(widths_do_not_scale_where_it_is_said)
{
    read_page("<g stroke='red' transform='scale(10)'><path stroke-width='.2' d='M1 1 2 2'/>"
              "<path stroke-width='2' vector-effect='non-scaling-stroke' d='M1 1 2 2'/>"
              "<g vector-effect='non-scaling-stroke'><path stroke-width='.2' d='M1 1 2 2'/></g></g>");
    ck_assert_uint_eq(list.count, 3);
    for (uint32_t i = 1; i < 3; i++)
        ck_assert_float_eq_tol(list.items[i].width_px, list.items[0].width_px, 1e-5f);
}
END_TEST

/* Dashes in other units than the page's are left out: the idiom of drawings that draw themselves is one long dash. */
START_TEST(dashes_in_units_of_the_path_are_left_out)
{
    read_page("<path stroke='red' pathLength='1' stroke-dasharray='1' d='M10 50H90'/>");
    ck_assert_uint_eq(list.count, 1);
    ck_assert_uint_eq(notes.others, 1);
    read_page("<path stroke='red' pathLength='1' d='M10 50H90'/>");
    ck_assert_uint_eq(notes.others, 0);
}
END_TEST

START_TEST(transparent_strokes_are_not_drawn)
{
    read_page("<path d='M0 0 9 9' stroke='#0000'/><path d='M0 0 9 9' stroke='rgba(9,9,9,0)'/>"
              "<path d='M0 0 9 9' stroke='transparent'/><path d='M0 0 9 9' stroke='red' style='stroke:initial'/>");
    ck_assert_uint_eq(list.count, 0);
}
END_TEST

START_TEST(malformed_strokes_are_refused)
{
    static const char *const colors[] = {"#12345",   "#1234567", "#00000g00",     "rgb(1,2)",        "rgb(1 2 3 4 5)",
                                         "hsl(0 0)", "hsl(0,0",  "rgb(1 2 3 / )", "hsl(9miles 0 0)", "hsl 0 0 0"};
    for (size_t i = 0; i < sizeof colors / sizeof *colors; i++) {
        char text[200];
        snprintf(text, sizeof text, "<path d='M0 0 9 9' stroke='%s'/>", colors[i]);
        ck_assert_int_eq(read_text(page(text)), HATCH_BAD_INPUT);
    }
}
END_TEST

START_TEST(fills_in_any_syntax_are_counted)
{
    static const char *const fills[] = {
        "fill='hsl(0,0%,50%)'", "style='fill:initial'",   "fill='color(srgb 1 0 0)'", "fill='#12345678'",
        "fill='#1234'",         "fill='url(#a) none'",    "fill='context-stroke'",    "",
        "style='fill:unset'",   "fill='var(--ink, red)'", "fill='currentColor'"};
    static const char *const empty[] = {"fill='none'",
                                        "fill='#00000000'",
                                        "fill='#abc0'",
                                        "fill='transparent'",
                                        "fill='rgba(9,9,9,0)'",
                                        "fill='hsl(0 0% 0% / 0%)'",
                                        "style='fill:none'",
                                        "fill='none' style='fill:unset'",
                                        "color='#0000' fill='currentColor'",
                                        "fill='currentColor' color='#0000'",
                                        "fill='red' fill-opacity='0'"};
    char text[200];
    for (size_t i = 0; i < sizeof fills / sizeof *fills; i++) {
        snprintf(text, sizeof text, "<path d='M0 0 9 9' stroke='red' %s/>", fills[i]);
        read_page(text);
        ck_assert_msg(notes.fills == 1 && list.count == 1, "%s", fills[i]);
    }
    for (size_t i = 0; i < sizeof empty / sizeof *empty; i++) {
        snprintf(text, sizeof text, "<path d='M0 0 9 9' stroke='red' %s/>", empty[i]);
        read_page(text);
        ck_assert_msg(notes.fills == 0 && list.count == 1, "%s", empty[i]);
    }
}
END_TEST

/* Each is one stroke from (10, 20) to (50, 60). */
static const char *const transforms[] = {
    "<path style='transform:translate(10px,20px)' d='M0 0 40 40'/>",
    "<style>.a{transform:translate(10px,20px)}</style><path class='a' transform='scale(9)' d='M0 0 40 40'/>",
    "<style>.b{transform:translateX(10%) translateY( 20px )}</style><g class='b'><path d='M0 0 40 40'/></g>",
    "<path transform='scale(9)' style='transform:none' d='M10 20 50 60'/>",
    "<path transform='rotate(90deg)' d='M20-10 60-50'/>",
    "<path style='transform:rotate(.25turn)' d='M20-10 60-50'/>",
    "<path style='transform:rotate(100grad)' d='M20-10 60-50'/>",
    "<path style='transform:rotate(1.5707963267948966rad)' d='M20-10 60-50'/>",
    "<path style='transform:scaleX(2) scaleY(.5)' stroke-width='.1' d='M5 40 25 120'/>",
    "<path style='transform:skew(45deg) translate(-20px)' d='M10 20 10 60'/>",
    "<path style='transform:skew(0,45deg)' d='M10 10 50 10'/>",
    "<path style='transform:rotate(90deg);transform-origin:30px 40px' d='M10 60 50 20'/>",
    "<path transform='scale(.5)' transform-origin='30 40' d='M-10 0 70 80'/>",
    "<path style='transform-origin:center' d='M10 20 50 60'/>",
    "<path style='transform:translate(10px,20px);transform-origin:center' d='M0 0 40 40'/>",
};

START_TEST(transforms_in_css_are_applied)
{
    check_stroke(transforms[_i]);
    ck_assert_uint_eq(notes.others, 0);
}
END_TEST

/* Shapes whose place is another one are drawn without that part of their transform, and counted. */
START_TEST(transforms_that_are_not_applied_are_counted)
{
    static const char *const styles[] = {"transform:translate3d(1px,2px,3px)",
                                         "transform:rotate(5px)",
                                         "transform:translate(5deg)",
                                         "transform:rotate(90deg);transform-origin:center",
                                         "transform:rotate(90deg);transform-box:fill-box",
                                         "translate:5px",
                                         "rotate:90deg",
                                         "scale:2"};
    for (size_t i = 0; i < sizeof styles / sizeof *styles; i++) {
        char text[300];
        snprintf(text, sizeof text, "<g style='%s' stroke='red' fill='none'><path d='M10 20 50 60'/></g>", styles[i]);
        read_page(text);
        check_ends(0, 10, 20, 50, 60);
        ck_assert_msg(notes.others == 1, "%s", styles[i]);
    }
    read_page("<path style='translate:none;rotate:none;scale:none;transform-box:view-box' d='M1 1 2 2'/>");
    ck_assert_uint_eq(notes.others, 0);
}
END_TEST

static Suite *suite(void)
{
    Suite *suite = suite_create("io svg css");
    TCase *tests = tcase_create("svg_css");
    tcase_add_checked_fixture(tests, begin, end);
    tcase_add_loop_test(tests, strokes_have_the_colour_and_the_alpha, 0, sizeof strokes / sizeof *strokes);
    tcase_add_loop_test(tests, sheets_cascade, 0, sizeof sheets / sizeof *sheets);
    tcase_add_test(tests, unknown_values_in_css_are_ignored_and_counted);
    tcase_add_test(tests, widths_do_not_scale_where_it_is_said);
    tcase_add_test(tests, dashes_in_units_of_the_path_are_left_out);
    tcase_add_test(tests, transparent_strokes_are_not_drawn);
    tcase_add_test(tests, malformed_strokes_are_refused);
    tcase_add_test(tests, fills_in_any_syntax_are_counted);
    tcase_add_loop_test(tests, transforms_in_css_are_applied, 0, sizeof transforms / sizeof *transforms);
    tcase_add_test(tests, transforms_that_are_not_applied_are_counted);
    suite_add_tcase(suite, tests);
    return suite;
}
HATCH_TEST_MAIN(suite)
