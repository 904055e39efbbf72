/* Shared objects that cannot be opened. */
#include <dlfcn.h>
#include <string.h>

#include "run.h"
#include "base/load.h"

/* Leaves a pattern where the frames of later calls will lie. */
static void fill_stack(int byte)
{
    char room[4096];
    memset(room, byte, sizeof room);
    __asm__ volatile("" : : "r"(room) : "memory");
}

START_TEST(a_missing_object_is_an_error_of_the_system)
{
    struct hatch_err err;
    void *object = &err;
    fill_stack(_i ? 0xff : 0);
    ck_assert_int_eq(hatch_load("libhatch-is-nowhere.so.7", &object, &err), HATCH_IO);
    ck_assert_ptr_null(object);
    ck_assert_msg(strstr(err.text, "libhatch-is-nowhere.so.7"), "%s", err.text);
}
END_TEST

START_TEST(a_library_of_the_system_is_opened)
{
    struct hatch_err err;
    void *object = NULL;
    HATCH_TEST_OK(hatch_load("libm.so.6", &object, &err), &err);
    ck_assert_ptr_nonnull(dlsym(object, "cos"));
    dlclose(object);
}
END_TEST

static Suite *suite(void)
{
    Suite *suite = suite_create("base load");
    TCase *tests = tcase_create("load");
    tcase_add_loop_test(tests, a_missing_object_is_an_error_of_the_system, 0, 2);
    tcase_add_test(tests, a_library_of_the_system_is_opened);
    suite_add_tcase(suite, tests);
    return suite;
}
HATCH_TEST_MAIN(suite)
