#include "run.h"

#include <math.h>
#include <string.h>

#include "arenas.h"
#include "fail_alloc.h"
#include "fit/split.h"

#define MOST 4096u
#define REACH_PX 4.0

static struct hatch_fragment fragments[MOST];
static uint32_t count;
static struct hatch_stroke_part parts[HATCH_FIT_PARTS_MAX];
static uint32_t part_count;

static void add(double t, double x, double y)
{
    ck_assert_uint_lt(count, MOST);
    fragments[count++] = (struct hatch_fragment){(float)t, floorf((float)x) + 0.5f, floorf((float)y) + 0.5f, 1};
}

/* Adds a horizontal line of a stroke, three pixels wide. */
static void add_line(double from, double to, double x, double y, uint32_t length_px)
{
    for (uint32_t i = 0; i < length_px; i++)
        for (int across = -1; across <= 1; across++)
            add(from + (to - from) * i / length_px, x + i, y + across);
}

static void split(void)
{
    HATCH_TEST_OK(hatch_fragments_split(fragments, count, REACH_PX, &scratch, parts, &part_count, &err), &err);
    ck_assert_uint_eq(parts[part_count - 1].end, count);
}

/* Returns the share of the weight that the curves of all parts miss. */
static double missed(void)
{
    double sum = 0;
    for (uint32_t i = 0, first = 0; i < part_count; first = parts[i++].end) {
        struct hatch_cubic cubic;
        hatch_cubic_fit(fragments + first, parts[i].end - first, &cubic);
        sum += (parts[i].end - first) * hatch_cubic_missed(&cubic, fragments + first, parts[i].end - first, REACH_PX);
    }
    return sum / count;
}

START_TEST(a_line_stays_whole)
{
    add_line(0.2, 0.7, 100, 50, 80);
    split();
    ck_assert_uint_eq(part_count, 1);
    ck_assert(!parts[0].goes_on);
}
END_TEST

START_TEST(parts_that_lie_apart_are_told_apart)
{
    add_line(0, 1, 100, 50, 80);
    add_line(0.3, 0.6, 300, 90, 30);
    split();
    ck_assert_uint_eq(part_count, 2);
    ck_assert_uint_eq(parts[0].end, 240);
    ck_assert(!parts[0].goes_on && !parts[1].goes_on);
    ck_assert_double_le(missed(), 0);
}
END_TEST

/* Where two lines touch, but their parameters jump, they are two. */
START_TEST(parameters_that_jump_divide)
{
    add_line(0, 0.3, 100, 50, 40);
    add_line(0.7, 1, 140, 50, 40);
    split();
    ck_assert_uint_eq(part_count, 2);
    ck_assert_uint_eq(parts[0].end, 120);
}
END_TEST

/* The parameters of a sliver run across it, from row to row. */
START_TEST(a_sliver_gets_parameters_along_itself)
{
    for (uint32_t x = 0; x < 60; x++)
        for (int y = 0; y < 3; y++)
            add(0.3 + 0.15 * y, 100 + x, 50 + y);
    split();
    ck_assert_uint_eq(part_count, 1);
    for (uint32_t i = 0; i < count; i++) {
        double along = 0.1 + 0.8 * ((double)fragments[i].x - 100.5) / 59;
        ck_assert_double_eq_tol(fmin(fabs((double)fragments[i].t - along), fabs(1 - (double)fragments[i].t - along)), 0,
                                0.02);
    }
    ck_assert_double_le(missed(), 0);
}
END_TEST

START_TEST(a_ring_is_halved_until_cubics_follow)
{
    const double radius = 40;
    for (uint32_t i = 0; i < 400; i++) {
        double angle = 6 * i / 400.0;
        add(i / 400.0, 100 + radius * cos(angle), 100 + radius * sin(angle));
    }
    part_count = 1;
    parts[0] = (struct hatch_stroke_part){.end = count};
    ck_assert_double_gt(missed(), 0.3);
    split();
    ck_assert_uint_gt(part_count, 1);
    ck_assert_uint_le(part_count, 8);
    for (uint32_t i = 0; i < part_count; i++)
        ck_assert(parts[i].goes_on == (i + 1 < part_count));
    ck_assert_double_le(missed(), 0.01);
}
END_TEST

START_TEST(the_order_of_fragments_does_not_matter)
{
    static struct hatch_fragment first[MOST];
    add_line(0, 1, 100, 50, 80);
    add_line(0.3, 0.6, 300, 90, 30);
    for (uint32_t i = 0; i + 1 < count; i++) {
        uint32_t other = i + (i * 2654435761u >> 8) % (count - i);
        struct hatch_fragment swap = fragments[i];
        fragments[i] = fragments[other];
        fragments[other] = swap;
    }
    split();
    memcpy(first, fragments, sizeof first);
    for (uint32_t i = 0; i < count / 2; i++) {
        struct hatch_fragment swap = fragments[i];
        fragments[i] = fragments[count - 1 - i];
        fragments[count - 1 - i] = swap;
    }
    split();
    ck_assert_mem_eq(first, fragments, sizeof *first * count);
    ck_assert_uint_eq(part_count, 2);
}
END_TEST

/* However many pieces there are, all fragments belong to one. */
START_TEST(there_are_at_most_so_many_parts)
{
    for (uint32_t i = 0; i < 100; i++)
        add_line(i / 100.0, (i + 1) / 100.0, 20 + 10 * (i % 10), 20 + 10 * (i / 10), 4);
    split();
    ck_assert_uint_eq(part_count, HATCH_FIT_PARTS_MAX);
    for (uint32_t i = 1; i < part_count; i++)
        ck_assert_uint_gt(parts[i].end, parts[i - 1].end);
}
END_TEST

static enum hatch_status split_line(void *context, struct hatch_arena *keeping, struct hatch_arena *working,
                                    struct hatch_err *error)
{
    (void)context;
    (void)keeping;
    return hatch_fragments_split(fragments, count, REACH_PX, working, parts, &part_count, error);
}

START_TEST(every_failed_allocation_is_a_limit)
{
    add_line(0, 1, 100, 50, 80);
    hatch_test_fail_alloc(split_line, NULL, NULL, 0);
}
END_TEST

static Suite *suite(void)
{
    Suite *suite = suite_create("fit");
    TCase *tests = tcase_create("split");
    tcase_add_checked_fixture(tests, begin, end);
    tcase_add_test(tests, a_line_stays_whole);
    tcase_add_test(tests, parts_that_lie_apart_are_told_apart);
    tcase_add_test(tests, parameters_that_jump_divide);
    tcase_add_test(tests, a_sliver_gets_parameters_along_itself);
    tcase_add_test(tests, a_ring_is_halved_until_cubics_follow);
    tcase_add_test(tests, the_order_of_fragments_does_not_matter);
    tcase_add_test(tests, there_are_at_most_so_many_parts);
    tcase_add_test(tests, every_failed_allocation_is_a_limit);
    suite_add_tcase(suite, tests);
    return suite;
}

HATCH_TEST_MAIN(suite)
