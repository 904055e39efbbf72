/* The main function of a measurement that draws with tests/support/render_frame.h: one Check test without a time limit,
 * because Check's assertions need a running test. It prints its own rows; failures go to standard error. */
#ifndef HATCH_BENCH_H
#define HATCH_BENCH_H

#include <check.h>
#include <stdlib.h>

static inline int hatch_bench_main(const char *name, const TTest *measure)
{
    Suite *suite = suite_create(name);
    TCase *tests = tcase_create(name);
    tcase_set_timeout(tests, 0);
    tcase_add_test(tests, measure);
    suite_add_tcase(suite, tests);
    SRunner *runner = srunner_create(suite);
    srunner_set_log(runner, "/dev/stderr");
    srunner_run_all(runner, CK_SILENT);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed ? EXIT_FAILURE : EXIT_SUCCESS;
}

#define HATCH_BENCH_MAIN(name, measure)                                                                                \
    int main(void)                                                                                                     \
    {                                                                                                                  \
        return hatch_bench_main(name, measure);                                                                        \
    }

#endif
