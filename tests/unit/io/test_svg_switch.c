/* Elements of drawings that depend on the program and the language of its user. */
#include "svg/drawing.h"

/* Each draws only the path from (10, 20) to (50, 60). */
static const char *const switches[] = {
    "<switch><path d='M10 20 50 60'/><path d='M1 1 2 2'/></switch>",
    "<switch><path requiredExtensions='x' d='M1 1 2 2'/><path d='M10 20 50 60'/><path d='M3 3 4 4'/></switch>",
    "<switch><g requiredExtensions=''><path d='M1 1 2 2'/></g><g><path d='M10 20 50 60'/></g></switch>",
    "<switch><path systemLanguage='de, fr' d='M1 1 2 2'/><path systemLanguage='de, en' d='M10 20 50 60'/>"
    "<path d='M3 3 4 4'/></switch>",
    "<switch><path systemLanguage='end' d='M1 1 2 2'/><path systemLanguage='EN-GB' d='M10 20 50 60'/></switch>",
    "<switch><path systemLanguage='' d='M1 1 2 2'/><path d='M10 20 50 60'/></switch>",
    "<switch><title>a</title><desc>b</desc><i:pgf xmlns:i='i'/><path d='M10 20 50 60'/><path d='M1 1 2 2'/></switch>",
    "<switch><foreignObject requiredExtensions='x'/><g><switch><path d='M10 20 50 60'/><text>a</text></switch></g>"
    "</switch>",
    "<path d='M10 20 50 60'/><switch><path systemLanguage='de' d='M1 1 2 2'/></switch>",
    "<path d='M10 20 50 60'/><path systemLanguage='de' d='M1 1 2 2'/><g requiredExtensions='x'><path d='M1 1'/></g>",
};

START_TEST(one_alternative_of_a_switch_is_drawn)
{
    check_stroke(switches[_i]);
    ck_assert_uint_eq(notes.texts, 0);
}
END_TEST

static Suite *suite(void)
{
    Suite *suite = suite_create("io svg switch");
    TCase *tests = tcase_create("svg_switch");
    tcase_add_checked_fixture(tests, begin, end);
    tcase_add_loop_test(tests, one_alternative_of_a_switch_is_drawn, 0, sizeof switches / sizeof *switches);
    suite_add_tcase(suite, tests);
    return suite;
}
HATCH_TEST_MAIN(suite)
