/* The frame of a unit test program: Check's tests, each in a process of its own, reported as TAP.
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
 * CK_FORK=no and a debugger, or CK_RUN_CASE=name, when one test is looked at.
 */
#ifndef HATCH_TEST_RUN_H
#define HATCH_TEST_RUN_H

#include <check.h>
#include <stdlib.h>

#include "base/status.h"

/* Fails with the library's own sentence. */
#define HATCH_TEST_OK(call, err) ck_assert_msg((call) == HATCH_OK, "%s failed: %s", #call, (err)->text)

static inline int hatch_test_main(Suite *(*suite)(void))
{
    setenv("CK_DEFAULT_TIMEOUT", "600", 0); /* seconds: against a hang alone, on the busiest machine */
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
