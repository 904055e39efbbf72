#include "run.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "shared/cmd.h"

#define HELD_BYTES (1 << 16) /* of warnings that wait */
#define LINE_BYTES 64

static const struct cmd_program program = {.name = "tested", .operands = "", .summary = "is tested"};

/* Begins the command; standard error goes to a file from here on. */
#define BEGIN(args, ...) begin(args, (char *[]){"tested", __VA_ARGS__, NULL})
static void begin(struct cmd_args *args, char **words)
{
    int count = 0;
    while (words[count])
        count++;
    cmd_begin(&program, count, words, args);
    FILE *file = tmpfile();
    ck_assert_ptr_nonnull(file);
    ck_assert_int_eq(dup2(fileno(file), STDERR_FILENO), STDERR_FILENO);
}

/* Returns the bytes that were printed, and how many. */
static const char *printed(size_t *size)
{
    static char text[2 * HELD_BYTES];
    ssize_t got = pread(STDERR_FILENO, text, sizeof text - 1, 0);
    ck_assert_int_ge(got, 0);
    text[got] = '\0';
    *size = (size_t)got;
    return text;
}

START_TEST(warnings_wait_and_are_printed_once)
{
    static const char first[] = "tested: FILE: warning: 2 faces\n", second[] = "tested: warning: no?name\n";
    struct cmd_args args;
    size_t size;
    BEGIN(&args, "--threads=1");
    cmd_warn("FILE", "%d faces", 2);
    cmd_warn(NULL, "no\tname");
    ck_assert_str_eq(printed(&size), "");
    cmd_show_warnings();
    ck_assert_uint_eq(strlen(printed(&size)), strlen(first) + strlen(second));
    ck_assert(strncmp(printed(&size), first, strlen(first)) == 0);
    ck_assert_str_eq(printed(&size) + strlen(first), second);
    cmd_show_warnings();
    ck_assert_uint_eq(strlen(printed(&size)), strlen(first) + strlen(second));
    cmd_warn("FILE", "%d faces", 2);
    cmd_show_warnings();
    ck_assert_str_eq(printed(&size) + strlen(first) + strlen(second), first);
}
END_TEST

START_TEST(quiet_commands_have_no_warnings)
{
    struct cmd_args args;
    size_t size;
    BEGIN(&args, "-q");
    cmd_warn("FILE", "%d faces", 2);
    cmd_show_warnings();
    ck_assert_str_eq(printed(&size), "");
}
END_TEST

/* As many lines as there is room for wait; the next one is printed at once, before them. */
START_TEST(warnings_without_room_are_printed_at_once)
{
    struct cmd_args args;
    size_t size;
    const int width = LINE_BYTES - (int)strlen("tested: warning: \n"), lines = HELD_BYTES / LINE_BYTES;
    BEGIN(&args, "--threads=1");
    for (int i = 0; i < lines; i++)
        cmd_warn(NULL, "%0*d", width, i);
    ck_assert_str_eq(printed(&size), "");
    cmd_warn(NULL, "%0*d", width, lines);
    for (int shown = 0; shown < 2; shown++) {
        const char *text = printed(&size);
        ck_assert_uint_eq(size, LINE_BYTES + (size_t)shown * HELD_BYTES);
        for (int i = 0; (size_t)i < size / LINE_BYTES; i++)
            ck_assert_int_eq(atoi(text + LINE_BYTES * i + strlen("tested: warning: ")), i == 0 ? lines : i - 1);
        cmd_show_warnings();
    }
}
END_TEST

static Suite *suite(void)
{
    Suite *suite = suite_create("cmd warnings");
    TCase *tests = tcase_create("warnings");
    tcase_add_test(tests, warnings_wait_and_are_printed_once);
    tcase_add_test(tests, quiet_commands_have_no_warnings);
    tcase_add_test(tests, warnings_without_room_are_printed_at_once);
    suite_add_tcase(suite, tests);
    return suite;
}
HATCH_TEST_MAIN(suite)
