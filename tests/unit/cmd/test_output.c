#include "run.h"

#include <dirent.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "shared/private.h"

static const struct cmd_program program = {.name = "tested", .operands = "", .summary = "is tested"};
static char folder[4096];

/* Counts the files of the working folder: those that are hidden, or the others. */
static int count_files(bool hidden)
{
    int count = 0;
    const struct dirent *entry;
    DIR *files = opendir(".");
    ck_assert_ptr_nonnull(files);
    while ((entry = readdir(files)))
        count += hidden ? strncmp(entry->d_name, ".hatch-", 7) == 0 : entry->d_name[0] != '.';
    closedir(files);
    return count;
}

static void set_up(void)
{
    static struct cmd_args args;
    const char *parent = getenv("TMPDIR");
    snprintf(folder, sizeof folder, "%s/hatch-output-XXXXXX", parent ? parent : "/tmp");
    ck_assert_ptr_nonnull(mkdtemp(folder));
    ck_assert_int_eq(chdir(folder), 0);
    cmd_begin(&program, 1, (char *[]){"tested", NULL}, &args);
}

static void tear_down(void)
{
    unlink("a.tsv");
    ck_assert_int_eq(rmdir(folder), 0);
}

/* Whichever of two outputs is written, the hidden file of the other one is removed at the end, and it alone. */
START_TEST(outputs_that_are_not_written_are_removed)
{
    struct cmd_output *outputs[2];
    for (int i = 0; i < 2; i++)
        outputs[i] = cmd_open_output(i == _i ? "a.tsv" : "b.tsv", "tsv", false);
    ck_assert_int_eq(count_files(true), 2);
    ck_assert_int_eq(count_files(false), 0);
    cmd_write(outputs[_i], "1\n", 2);
    ck_assert_int_eq(count_files(true), 1);
    ck_assert_int_eq(count_files(false), 1);
    cmd_discard_outputs();
    ck_assert_int_eq(count_files(true), 0);
    ck_assert_int_eq(count_files(false), 1);
    ck_assert_int_eq(access("a.tsv", R_OK), 0);
}
END_TEST

static Suite *suite(void)
{
    Suite *suite = suite_create("cmd output");
    TCase *tests = tcase_create("output");
    tcase_add_checked_fixture(tests, set_up, tear_down);
    tcase_add_loop_test(tests, outputs_that_are_not_written_are_removed, 0, 2);
    suite_add_tcase(suite, tests);
    return suite;
}
HATCH_TEST_MAIN(suite)
