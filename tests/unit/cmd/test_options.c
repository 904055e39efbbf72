#include "run.h"

#include <fcntl.h>
#include <getopt.h>
#include <string.h>
#include <unistd.h>

#include "shared/cmd.h"

static const char *const kinds[] = {"soft", "hard", NULL};
static bool flag, real_given;
static int64_t whole;
static double real, pair[2], pixels[2];
static uint64_t size, bytes;
static const char *text;
static struct cmd_texts texts;
static int kind;

static const struct cmd_option options[] = {
    {'f', "flag", CMD_FLAG, 0, 0, NULL, "a flag", &flag, NULL, NULL},
    {'w', "whole", CMD_INT, -10, 10, "N", "a whole number (0)", &whole, NULL, NULL},
    {'r', "real", CMD_REAL, -1, 1e30, "X", "a number (0)", &real, NULL, &real_given},
    {0, "size", CMD_SIZE, 1, 0x1p40, "BYTES", "a size", &size, NULL, NULL},
    {0, "bytes", CMD_SIZE, 0, 0x1p63, "BYTES", "a size without limits", &bytes, NULL, NULL},
    {'t', "text", CMD_TEXT, 0, 0, "TEXT", "a text", &text, NULL, NULL},
    {0, "texts", CMD_TEXTS, 0, 0, "TEXT", "texts", &texts, NULL, NULL},
    {'k', "kind", CMD_CHOICE, 0, 0, "KIND", "soft or hard (soft)", &kind, kinds, NULL},
    {'p', "pair", CMD_PAIR, 0, 100, "A:B", "two numbers", pair, NULL, NULL},
    {0, "pixels", CMD_WHOLES, 1, 100, "WxH", "two whole numbers", pixels, NULL, NULL},
    {0},
};

static const struct cmd_program program = {
    .name = "tested",
    .operands = "[FILE ...]",
    .summary = "is tested",
    .options = options,
    .operands_max = -1,
    .seeded = true,
    .reports = true,
};

/* Parses the words; standard error is discarded. */
#define PARSE(args, ...) parse(args, (char *[]){"tested", __VA_ARGS__, NULL})
static void parse(struct cmd_args *args, char **words)
{
    int count = 0;
    while (words[count])
        count++;
    optind = 1;
    dup2(open("/dev/null", O_WRONLY), STDERR_FILENO);
    cmd_begin(&program, count, words, args);
}

START_TEST(an_option_may_be_repeated)
{
    struct cmd_args args;
    PARSE(&args, "--texts=a", "file", "--texts", "--b", "--texts", "");
    ck_assert_int_eq(texts.count, 3);
    ck_assert_str_eq(texts.at[0], "a");
    ck_assert_str_eq(texts.at[1], "--b");
    ck_assert_str_eq(texts.at[2], "");
    ck_assert_int_eq(args.operand_count, 1);
}
END_TEST

static void repeat(int times)
{
    struct cmd_args args;
    char *words[CMD_TEXTS_MAX + 3] = {"tested"};
    for (int i = 1; i <= times; i++)
        words[i] = "--texts=a";
    parse(&args, words);
}

START_TEST(an_option_may_be_repeated_64_times)
{
    repeat(64);
    ck_assert_int_eq(texts.count, 64);
    ck_assert_str_eq(texts.at[63], "a");
}
END_TEST

START_TEST(but_not_more_often)
{
    repeat(65);
}
END_TEST

START_TEST(values_of_every_type_are_parsed)
{
    struct cmd_args args;
    PARSE(&args, "-fw-3", "--real=2.5e3", "--size", "3M", "--text", "--x", "-k", "hard", "--pair=4:.5",
          "--pixels=2x3.0");
    ck_assert(flag && real_given);
    ck_assert_int_eq(whole, -3);
    ck_assert(real == 2500 && pair[0] == 4 && pair[1] == 0.5);
    ck_assert(pixels[0] == 2 && pixels[1] == 3);
    ck_assert_uint_eq(size, 3u << 20);
    ck_assert_str_eq(text, "--x");
    ck_assert_int_eq(kind, 1);
    ck_assert_int_eq(args.operand_count, 0);
}
END_TEST

START_TEST(common_options_have_defaults)
{
    struct cmd_args args;
    PARSE(&args, "--");
    ck_assert_uint_eq(args.seed, 1);
    ck_assert_uint_eq(args.max_memory, (uint64_t)4 << 30);
    ck_assert_uint_ge(args.threads, 1);
    ck_assert_ptr_null(args.output);
    ck_assert(!args.json && !args.quiet && !args.verbose && !real_given);
    PARSE(&args, "-qvj3", "-s", "0", "--json", "-o", "out", "--max-memory=64M");
    ck_assert_uint_eq(args.seed, 0);
    ck_assert_uint_eq(args.threads, 3);
    ck_assert_uint_eq(args.max_memory, 64u << 20);
    ck_assert_uint_eq(args.keep.limit_bytes, 64u << 20);
    ck_assert_str_eq(args.output, "out");
    ck_assert(args.json && args.quiet && args.verbose);
}
END_TEST

START_TEST(operands_keep_their_order)
{
    setenv("POSIXLY_CORRECT", "1", 1);
    struct cmd_args args;
    PARSE(&args, "a", "-w", "1", "-", "-f", "b", "--", "-w", "--", "9");
    static const char *const want[] = {"a", "-", "b", "-w", "--", "9"};
    ck_assert_int_eq(args.operand_count, 6);
    for (int i = 0; i < 6; i++)
        ck_assert_str_eq(args.operands[i], want[i]);
    ck_assert_int_eq(whole, 1);
}
END_TEST

START_TEST(bounds_are_inclusive)
{
    struct cmd_args args;
    PARSE(&args, "-w10", "-r-1", "--size=1024G", "-p0:100");
    ck_assert_int_eq(whole, 10);
    ck_assert(real == -1 && pair[1] == 100);
    ck_assert_uint_eq(size, (uint64_t)1 << 40);
    PARSE(&args, "-w-10", "-r1e30", "-w", "+3");
    ck_assert_int_eq(whole, 3);
    PARSE(&args, "--bytes=9223372036854775807", "-w0000000000000000000000000000010"); /* 31 digits */
    ck_assert_uint_eq(bytes, INT64_MAX);
    ck_assert_int_eq(whole, 10);
    PARSE(&args, "--bytes=8589934591G");
    ck_assert_uint_eq(bytes, 8589934591ull << 30);
    PARSE(&args, "--bytes=0");
    ck_assert_uint_eq(bytes, 0);
}
END_TEST

static char *const wrong[] = {
    "-w11",
    "-w-11",
    "-w1.5",
    "-w1e1",
    "-w0x1",
    "-w 1",
    "-w1 ",
    "-w",
    "-w99999999999999999999",
    "-rnan",
    "-r-nan",
    "-rinf",
    "-r1e31",
    "-r1,5",
    "-r0x1",
    "-r.",
    "-r1e",
    "-r--1",
    "-r1e999",
    "--size=0",
    "--size=-1",
    "--size=1T",
    "--size=K",
    "--size=1.5M",
    "--size=2000G",
    "--size=17179869185G",
    "--bytes=8589934592G",
    "--bytes=9223372036854775808",
    "-w00000000000000000000000000000010",
    "--text=",
    "--kind=har",
    "--kind=",
    "-p1",
    "-p1:",
    "-p:1",
    "-p1:101",
    "-p1:2:3",
    "-pnan:1",
    "--pixels=1.5x2",
    "--pixels=2x1.5",
    "--pixels=2:2",
    "--pixels=0x2",
    "--pixels=nanx2",
    "--flag=1",
    "--fla",
    "--wholes=1",
    "-x",
    "-j0",
    "-j257",
    "-s-1",
    "--max-memory=1",
    "--seed=1.0",
    "--seed=9007199254740993", /* 2^53 + 1, which as a double is 2^53 */
};

START_TEST(wrong_values_exit_2)
{
    struct cmd_args args;
    PARSE(&args, wrong[_i]);
}
END_TEST

static Suite *suite(void)
{
    Suite *suite = suite_create("cmd options");
    TCase *tests = tcase_create("options");
    tcase_add_test(tests, an_option_may_be_repeated);
    tcase_add_test(tests, an_option_may_be_repeated_64_times);
    tcase_add_exit_test(tests, but_not_more_often, HATCH_USAGE);
    tcase_add_test(tests, values_of_every_type_are_parsed);
    tcase_add_test(tests, common_options_have_defaults);
    tcase_add_test(tests, operands_keep_their_order);
    tcase_add_test(tests, bounds_are_inclusive);
    tcase_add_loop_exit_test(tests, wrong_values_exit_2, HATCH_USAGE, 0, (int)(sizeof wrong / sizeof *wrong));
    suite_add_tcase(suite, tests);
    return suite;
}
HATCH_TEST_MAIN(suite)
