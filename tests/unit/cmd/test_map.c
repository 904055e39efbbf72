/* The check whether the images of a map nest. */
#include <fcntl.h>
#include <unistd.h>

#include "render_map.h"
#include "shared/map.h"

/* Checks a map of random texels, whose images do not nest.
 *   memory  limit of the memory for the check, bytes */
static void check_nesting(size_t memory)
{
    static const struct cmd_option options[] = {{0}};
    static const struct cmd_program program = {.name = "tested", .summary = "is tested", .options = options};
    char *words[] = {(char[]){"tested"}, NULL};
    struct cmd_args args;
    struct hatch_tam map;
    dup2(open("/dev/null", O_WRONLY), STDERR_FILENO);
    cmd_begin(&program, 1, words, &args);
    hatch_arena_init(&args.scratch, memory);
    random_map(64, 2, &args.keep, &map);
    cmd_warn_nesting(&args, "random.exr", &map);
    hatch_arena_free(&args.scratch);
    hatch_arena_free(&args.keep);
}

START_TEST(images_that_do_not_nest_are_only_warned_of)
{
    check_nesting((size_t)1 << 24);
}
END_TEST

START_TEST(a_check_without_memory_ends_the_command)
{
    check_nesting(1);
}
END_TEST

static Suite *suite(void)
{
    Suite *suite = suite_create("cmd map");
    TCase *tests = tcase_create("map");
    tcase_add_test(tests, images_that_do_not_nest_are_only_warned_of);
    tcase_add_exit_test(tests, a_check_without_memory_ends_the_command, HATCH_LIMIT);
    suite_add_tcase(suite, tests);
    return suite;
}
HATCH_TEST_MAIN(suite)
