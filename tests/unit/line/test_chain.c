/* Chains of segments at nodes where several meet. */
#include "arenas.h"
#include "line/chain.h"

#include <math.h>

#define PI 3.14159265358979323846

/* A node in the middle, and `lines` straight lines through it, each of two segments. The segments are listed in an
 * order, and begin at either end. */
struct star {
    double nodes[3 * 41];
    uint32_t ends[2 * 40];
    struct hatch_line_graph graph;
};

static void make_star(struct star *star, uint32_t lines, const uint32_t *order, uint64_t turned)
{
    *star = (struct star){.graph = {.node_count = 2 * lines + 1, .segment_count = 2 * lines}};
    star->graph.nodes = star->nodes;
    star->graph.ends = star->ends;
    for (uint32_t ray = 0; ray < 2 * lines; ray++) {
        double angle = PI * (ray / 2) / lines + 0.1 * (ray / 2) * (ray / 2) / lines / lines;
        double *at = &star->nodes[3 * (size_t)(ray + 1)], sign = ray % 2 ? -1 : 1;
        at[0] = sign * cos(angle);
        at[1] = sign * sin(angle);
    }
    for (uint32_t s = 0; s < 2 * lines; s++) {
        uint32_t turn = (uint32_t)(turned >> s & 1);
        star->ends[2 * s + turn] = 0;
        star->ends[2 * s + 1 - turn] = order[s] + 1;
    }
}

static struct hatch_line_chains chains_of(const struct star *star)
{
    struct hatch_line_chains made;
    HATCH_TEST_OK(hatch_line_chains_make(&star->graph, &keep, &scratch, &made, &err), &err);
    return made;
}

/* Checks that each chain is one of the lines. */
static void check_lines(const struct star *star, uint32_t lines)
{
    struct hatch_line_chains made = chains_of(star);
    ck_assert_uint_eq(made.count, lines);
    for (uint32_t i = 0; i < made.count; i++) {
        const struct hatch_line_chain *chain = &made.chains[i];
        const uint32_t *nodes = &made.nodes[chain->first + i];
        ck_assert_uint_eq(chain->segment_count, 2);
        ck_assert_uint_eq(nodes[1], 0);
        ck_assert_uint_eq((nodes[0] - 1) / 2, (nodes[2] - 1) / 2);
        ck_assert(!chain->closed && !chain->joined[0] && !chain->joined[1]);
    }
}

START_TEST(crossing_lines_go_straight_on_in_any_order)
{
    struct star star;
    for (uint32_t k = 0; k < 256; k++) {
        uint32_t order[4], left[4] = {0, 1, 2, 3};
        const uint32_t picks[4] = {k % 4, k / 4 % 3, k / 12 % 2, 0};
        for (uint32_t s = 0; s < 4; s++) {
            order[s] = left[picks[s]];
            for (uint32_t i = picks[s]; i + 1 < 4; i++)
                left[i] = left[i + 1];
        }
        make_star(&star, 2, order, k);
        check_lines(&star, 2);
    }
}
END_TEST

/* Of 16 ends all are paired, of 18 none. */
START_TEST(too_many_ends_are_not_paired)
{
    struct star star;
    uint32_t order[40];
    for (uint32_t lines = 2; lines <= 20; lines++) {
        for (uint32_t s = 0; s < 2 * lines; s++)
            order[s] = s < lines ? 2 * s : 2 * (s - lines) + 1;
        make_star(&star, lines, order, 0);
        if (lines <= 8)
            check_lines(&star, lines);
        else
            ck_assert_uint_eq(chains_of(&star).count, 2 * lines);
    }
}
END_TEST

/* Three ends at 0, 100 and 175 degrees: the first and the last are nearest to a straight line. */
START_TEST(the_end_that_is_left_over_is_joined)
{
    static const double nodes[12] = {0, 0, 0, 1, 0, 0, -0.17, 0.98, 0, -0.996, 0.087, 0};
    static const uint32_t ends[6] = {0, 1, 0, 2, 0, 3};
    const struct hatch_line_graph graph = {4, 3, nodes, ends};
    struct hatch_line_chains made;
    HATCH_TEST_OK(hatch_line_chains_make(&graph, &keep, &scratch, &made, &err), &err);
    ck_assert_uint_eq(made.count, 2);
    for (uint32_t i = 0; i < 2; i++) {
        const struct hatch_line_chain *chain = &made.chains[i];
        const uint32_t *at = &made.nodes[chain->first + i];
        if (chain->segment_count == 2) {
            ck_assert(at[0] + at[2] == 4 && at[1] == 0 && !chain->joined[0] && !chain->joined[1]);
        } else {
            ck_assert_uint_eq(at[0] + at[1], 2);
            ck_assert(chain->joined[at[1] == 0] && !chain->joined[at[0] == 0]);
        }
    }
}
END_TEST

static Suite *suite(void)
{
    Suite *suite = suite_create("line chains");
    TCase *tests = tcase_create("chains");
    tcase_add_checked_fixture(tests, begin, end);
    tcase_add_test(tests, crossing_lines_go_straight_on_in_any_order);
    tcase_add_test(tests, too_many_ends_are_not_paired);
    tcase_add_test(tests, the_end_that_is_left_over_is_joined);
    suite_add_tcase(suite, tests);
    return suite;
}
HATCH_TEST_MAIN(suite)
