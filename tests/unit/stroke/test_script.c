#include "run.h"

#include <stdio.h>
#include <string.h>

#include "base/random.h"
#include "fail_alloc.h"
#include "stroke/path.h"
#include "stroke/script.h"

#define HEADER "x\ty\tlength\tangle\twidth\ttone\tr\tg\tb"
#define ROW "0.5\t0.25\t0.5\t1\t0.01\t1\t0\t0\t0"

static struct hatch_arena keep;
static struct hatch_err err;
static struct hatch_stroke_list list;

static void begin(void)
{
    hatch_arena_init(&keep, (size_t)64 << 20);
    list = (struct hatch_stroke_list){0};
}

static void end(void)
{
    hatch_arena_free(&keep);
}

static enum hatch_status parse(const char *text)
{
    struct hatch_bytes bytes = {(const uint8_t *)text, strlen(text)};
    return hatch_script_parse(bytes, 256, &keep, &list, &err);
}

static struct hatch_stroke random_stroke(uint64_t i)
{
    float u[10];
    for (uint64_t k = 0; k < 10; k++)
        u[k] = hatch_random_unit(9, i, k);
    return (struct hatch_stroke){.x = u[0],
                                 .y = u[1],
                                 .length = 4 * u[2],
                                 .angle_rad = 12 * u[3] - 6,
                                 .width_px = 0.01f + 64 * u[4],
                                 .tone = u[5],
                                 .rgb = {u[6], u[7], u[8]},
                                 .id = (uint32_t)i + 1,
                                 .column = (uint32_t)(u[9] * 256),
                                 .level = i % 8,
                                 .texture_seed = (uint32_t)hatch_random_u64(9, i, 11)};
}

START_TEST(printed_strokes_are_read_back_exactly)
{
    static struct hatch_stroke strokes[5000];
    static const uint32_t sizes[] = {256, 4096, 100, 333};
    for (uint64_t i = 0; i < 5000; i++)
        strokes[i] = random_stroke(i);
    for (int s = 0; s < 4; s++) {
        struct hatch_buffer text = {.arena = &keep};
        HATCH_TEST_OK(hatch_script_print(strokes, 5000, sizes[s], "seed 1", &text, &err), &err);
        struct hatch_bytes bytes = {text.data, text.size};
        HATCH_TEST_OK(hatch_script_parse(bytes, sizes[s], &keep, &list, &err), &err);
        ck_assert_uint_eq(list.count, 5000);
        for (uint32_t i = 0; i < 5000; i++)
            ck_assert_msg(memcmp(&strokes[i], &list.items[i], sizeof *strokes) == 0, "size %u, stroke %u", sizes[s], i);
    }
}
END_TEST

START_TEST(columns_come_in_any_order_and_comments_and_empty_lines_are_ignored)
{
    HATCH_TEST_OK(parse("# made by hand\r\n\r\nb\tg\tr\ttone\twidth\tangle\tlength\ty\tx\tnote\r\n"
                        "0.1\t0.2\t0.3\t0.4\t0.5\t0.6\t0.7\t0.8\t0.9\thello\r\n"
                        "# end\n"),
                  &err);
    ck_assert_uint_eq(list.count, 1);
    const struct hatch_stroke *s = list.items;
    ck_assert_float_eq(s->x, 0.9f);
    ck_assert_float_eq(s->y, 0.8f);
    ck_assert_float_eq(s->length, 0.7f);
    ck_assert_float_eq(s->angle_rad, 0.6f);
    ck_assert_float_eq(s->width_px, 128);
    ck_assert_float_eq(s->tone, 0.4f);
    ck_assert_float_eq(s->rgb[0], 0.3f);
    ck_assert_float_eq(s->rgb[2], 0.1f);
    ck_assert_uint_eq(s->id + s->column + s->level + s->texture_seed, 0);
}
END_TEST

START_TEST(a_header_alone_is_an_empty_drawing)
{
    HATCH_TEST_OK(parse(HEADER "\n"), &err);
    ck_assert_uint_eq(list.count, 0);
}
END_TEST

START_TEST(centres_are_wrapped_into_the_tile)
{
    HATCH_TEST_OK(parse(HEADER "\n"
                               "1.25\t-0.25\t0\t0\t0.1\t1\t0\t0\t0\n"
                               "1000000\t-1e-30\t0\t0\t0.1\t1\t0\t0\t0\n"),
                  &err);
    ck_assert_float_eq(list.items[0].x, 0.25f);
    ck_assert_float_eq(list.items[0].y, 0.75f);
    ck_assert_float_eq(list.items[1].x, 0);
    ck_assert_float_eq(list.items[1].y, 0); /* the fraction of a tiny negative number rounds to 1, which wraps to 0 */
}
END_TEST

static const struct {
    const char *text, *message;
} bad[] = {
    {"", "no header"},
    {"# only a comment\n", "no header"},
    {"x\ty\tlength\tangle\twidth\ttone\tr\tg\n", "no column 'b'"},
    {"x\t" HEADER "\n", "column 'x' is repeated"},
    {HEADER "\n" ROW "\n0.5\t0.5\n", "line 3: 2 fields, want 9"},
    {HEADER "\n" ROW "\t1\n", "line 2: 10 fields, want 9"},
    {"# c\n\n" HEADER "\n0.5\t0.5\t0.5\tabc\t0.01\t1\t0\t0\t0\n", "line 4: angle 'abc' is not a number"},
    {HEADER "\n0.5\t0.5\t0.5\tnan\t0.01\t1\t0\t0\t0\n", "line 2: angle 'nan' is not a number"},
    {HEADER "\n0.5\t0.5\t0.5\tinf\t0.01\t1\t0\t0\t0\n", "line 2: angle 'inf' is not a number"},
    {HEADER "\n0.5\t0.5\t0.5\t\t0.01\t1\t0\t0\t0\n", "line 2: angle '' is not a number"},
    {HEADER "\n0.5\t0.5\t-1\t0\t0.01\t1\t0\t0\t0\n", "line 2: length -1"},
    {HEADER "\n0.5\t0.5\t17\t0\t0.01\t1\t0\t0\t0\n", "line 2: length 17"},
    {HEADER "\n0.5\t0.5\t1\t0\t-0.01\t1\t0\t0\t0\n", "line 2: width -0.01"},
    {HEADER "\n0.5\t0.5\t1\t0\t0\t1\t0\t0\t0\n", "line 2: width 0"},
    {HEADER "\n0.5\t0.5\t1\t0\t0.01\t1.5\t0\t0\t0\n", "line 2: tone 1.5"},
    {HEADER "\n0.5\t0.5\t1\t0\t0.01\t1\t0\t2\t0\n", "line 2: g 2"},
    {HEADER "\tid\n" ROW "\t1.5\n", "line 2: id 1.5, want a whole number"},
    {HEADER "\tcolumn\n" ROW "\t256\n", "line 2: column 256"},
    {HEADER "\tlevel\n" ROW "\t-1\n", "line 2: level -1"},
    {HEADER "\tgrain\n" ROW "\t4294967296\n", "line 2: grain"},
};

START_TEST(a_bad_line_is_reported)
{
    list.count = 7;
    ck_assert_int_eq(parse(bad[_i].text), HATCH_BAD_INPUT);
    ck_assert_msg(strstr(err.text, bad[_i].message) != NULL, "'%s', want '%s'", err.text, bad[_i].message);
    ck_assert_uint_eq(list.count, 7);
}
END_TEST

static const char *const fields[] = {"0", "0", "0", "0", "0.1", "1", "0", "0", "0", "0", "0", "0", "0", "0", ""};
#define FIELDS (sizeof fields / sizeof *fields)

/* Parses a stroke whose field has another text. */
static enum hatch_status parse_field(size_t field, const char *text, const char *path)
{
    char row[400] = HEADER "\tbend\tid\tcolumn\tlevel\tgrain\tpath\n";
    for (size_t i = 0; i < FIELDS; i++) {
        strcat(row, i == field ? text : i == FIELDS - 1 ? path : fields[i]);
        strcat(row, i + 1 < FIELDS ? "\t" : "\n");
    }
    return parse(row);
}

/* The limits of script(5), and the nearest numbers beyond them. */
START_TEST(numbers_reach_their_limits)
{
    static const struct {
        const char *low, *below, *high, *above;
    } limits[FIELDS - 1] = {
        {"-1000000", "-1000000.1", "1000000", "1000000.1"},
        {"-1000000", "-1000000.1", "1000000", "1000000.1"},
        {"0", "-1e-9", "16", "16.000001"},
        {"-1000", "-1000.001", "1000", "1000.001"},
        {"1e-30", "0.9e-30", "4", "4.000001"},
        {"0", "-1e-9", "1", "1.000001"},
        {"0", "-1e-9", "1", "1.000001"},
        {"0", "-1e-9", "1", "1.000001"},
        {"0", "-1e-9", "1", "1.000001"},
        {"-6.25", "-6.250001", "6.25", "6.250001"},
        {"0", "-1", "16777216", "16777217"},
        {"0", "-1", "255", "256"},
        {"0", "-1", "31", "32"},
        {"0", "-1", "4294967295", "4294967296"},
    };
    for (size_t i = 0; i < FIELDS - 1; i++) {
        HATCH_TEST_OK(parse_field(i, limits[i].low, ""), &err);
        HATCH_TEST_OK(parse_field(i, limits[i].high, ""), &err);
        ck_assert_msg(parse_field(i, limits[i].below, "") == HATCH_BAD_INPUT, "field %zu: %s", i, limits[i].below);
        ck_assert_msg(parse_field(i, limits[i].above, "") == HATCH_BAD_INPUT, "field %zu: %s", i, limits[i].above);
    }
    HATCH_TEST_OK(parse_field(2, "65536", "0,0 1,1"), &err); /* the length follows from the path */
    ck_assert_int_eq(parse_field(2, "65536.1", "0,0 1,1"), HATCH_BAD_INPUT);
}
END_TEST

START_TEST(a_path_has_two_points_to_a_million)
{
    static const char head[] = HEADER "\tpath\n" ROW "\t0,0";
    for (uint32_t more = 0; more < 2; more++) {
        struct hatch_buffer text = {.arena = &keep};
        HATCH_TEST_OK(hatch_buffer_add(&text, head, sizeof head - 1, &err), &err);
        for (uint32_t i = 1; i < HATCH_PATH_POINTS_MAX + more; i++)
            HATCH_TEST_OK(hatch_buffer_add(&text, " 0,0", 4, &err), &err);
        ck_assert_int_eq(hatch_script_parse((struct hatch_bytes){text.data, text.size}, 256, &keep, &list, &err),
                         more ? HATCH_BAD_INPUT : HATCH_OK);
    }
    ck_assert_uint_eq(list.items[0].path->count, HATCH_PATH_POINTS_MAX);
    ck_assert_str_eq(err.text, "line 2: path: 1048577 points, want 2 to 1048576");
}
END_TEST

START_TEST(too_many_columns_are_rejected)
{
    char text[1000] = "";
    for (int i = 0; i < 65; i++)
        strcat(text, "a\t");
    ck_assert_int_eq(parse(text), HATCH_BAD_INPUT);
    ck_assert_ptr_nonnull(strstr(err.text, "more than 64"));
}
END_TEST

/* Points at x = -64 and 64 in turn: each but the first adds 128 tiles. */
START_TEST(the_longest_path_is_accepted_and_a_longer_one_is_not)
{
    char text[6000];
    int size = snprintf(text, sizeof text, HEADER "\tpath\n" ROW "\t-64,0");
    for (int i = 1; i <= 512; i++)
        size += snprintf(text + size, sizeof text - (size_t)size, i % 2 ? " 64,0" : " -64,0");
    HATCH_TEST_OK(parse(text), &err);
    ck_assert_float_eq(list.items[0].length, HATCH_PATH_LENGTH_MAX);
    snprintf(text + size, sizeof text - (size_t)size, " -63,0");
    ck_assert_int_eq(parse(text), HATCH_BAD_INPUT);
    ck_assert_str_eq(err.text, "line 2: path: 65537 tiles long, want 65536 at most");
}
END_TEST

static enum hatch_status read_again(void *context, struct hatch_arena *to, struct hatch_arena *scratch,
                                    struct hatch_err *error)
{
    (void)scratch;
    struct hatch_buffer *text = context;
    struct hatch_stroke_list made = {0};
    return hatch_script_parse((struct hatch_bytes){text->data, text->size}, 256, to, &made, error);
}

static enum hatch_status print_again(void *context, struct hatch_arena *to, struct hatch_arena *scratch,
                                     struct hatch_err *error)
{
    (void)scratch;
    struct hatch_buffer text = {.arena = to};
    return hatch_script_print(context, 2000, 256, "seed 1", &text, error);
}

START_TEST(every_failed_allocation_is_a_status)
{
    static struct hatch_stroke strokes[2000];
    for (uint64_t i = 0; i < 2000; i++)
        strokes[i] = random_stroke(i);
    struct hatch_buffer text = {.arena = &keep};
    HATCH_TEST_OK(hatch_script_print(strokes, 2000, 256, NULL, &text, &err), &err);
    ck_assert_uint_ge(hatch_test_fail_alloc(print_again, strokes, NULL, 0), 3);
    ck_assert_uint_ge(hatch_test_fail_alloc(read_again, &text, NULL, 0), 2);
}
END_TEST

static Suite *suite(void)
{
    Suite *suite = suite_create("stroke script");
    TCase *tests = tcase_create("script");
    tcase_add_checked_fixture(tests, begin, end);
    tcase_add_test(tests, printed_strokes_are_read_back_exactly);
    tcase_add_test(tests, columns_come_in_any_order_and_comments_and_empty_lines_are_ignored);
    tcase_add_test(tests, a_header_alone_is_an_empty_drawing);
    tcase_add_test(tests, centres_are_wrapped_into_the_tile);
    tcase_add_loop_test(tests, a_bad_line_is_reported, 0, sizeof bad / sizeof *bad);
    tcase_add_test(tests, numbers_reach_their_limits);
    tcase_add_test(tests, a_path_has_two_points_to_a_million);
    tcase_add_test(tests, too_many_columns_are_rejected);
    tcase_add_test(tests, the_longest_path_is_accepted_and_a_longer_one_is_not);
    tcase_add_test(tests, every_failed_allocation_is_a_status);
    suite_add_tcase(suite, tests);
    return suite;
}
HATCH_TEST_MAIN(suite)
