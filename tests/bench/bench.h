/* A measurement drawn with the tests' frames: one test of Check's, without a limit of time, since Check's words
 * fail outside a test of its; it prints its rows itself, and what fails is said on standard error. */
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
