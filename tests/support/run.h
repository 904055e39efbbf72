/* The main function of a unit test program: runs each test of a Check suite in a process of its own and reports as TAP.
 *
 *     #include "run.h"
 *
 *     START_TEST(arena_stops_at_its_limit) { ... ck_assert_uint_eq(...); } END_TEST
 *
 *     static Suite *suite(void)
 *     {
 *         Suite *suite = suite_create("base arena");
 *         TCase *tests = tcase_create("arena");
 *         tcase_add_test(tests, arena_stops_at_its_limit);
 *         suite_add_tcase(suite, tests);
 *         return suite;
 *     }
 *     HATCH_TEST_MAIN(suite)
 *
 * For a single test: CK_RUN_CASE=name; for a debugger: CK_FORK=no.
 */
#ifndef HATCH_TEST_RUN_H
#define HATCH_TEST_RUN_H

#include <check.h>
#include <stdlib.h>

#include "base/status.h"

/* Check writes down where each assertion is that holds, to tell after which one a test crashed. Here a place is written
 * down when it is reached for the first time, since loops reach millions. */
static inline void hatch_mark_point(const char *file, int line)
{
    static const char *files[256];
    static int lines[256];
    int at = line & 255;
    if (files[at] == file && lines[at] == line)
        return;
    files[at] = file;
    lines[at] = line;
    _mark_point(file, line);
}
#define _mark_point(file, line) hatch_mark_point(file, line)

/* Fails the test with the library's message. */
#define HATCH_TEST_OK(call, err) ck_assert_msg((call) == HATCH_OK, "%s failed: %s", #call, (err)->text)

static inline int hatch_test_main(Suite *(*suite)(void))
{
    /* Seconds; long enough for a busy machine, so that only tests that hang are ended. */
    setenv("CK_DEFAULT_TIMEOUT", "600", 0);
    SRunner *runner = srunner_create(suite());
    srunner_set_tap(runner, "-");
    srunner_run_all(runner, CK_SILENT);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed ? EXIT_FAILURE : EXIT_SUCCESS;
}

#define HATCH_TEST_MAIN(suite)                                                                                         \
    int main(void)                                                                                                     \
    {                                                                                                                  \
        return hatch_test_main(suite);                                                                                 \
    }

#endif
