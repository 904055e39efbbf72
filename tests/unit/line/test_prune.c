/* Creases that noise makes: short, crooked and small ones with a free end, and what hangs on them. */
#include "arenas.h"
#include "line/prune.h"

#include <math.h>
#include <string.h>

enum { NODES_MAX = 200, SEGMENTS_MAX = 200 };

static struct {
    double nodes[3 * NODES_MAX];
    uint32_t ends[2 * SEGMENTS_MAX];
    uint8_t bounds[SEGMENTS_MAX], flat[SEGMENTS_MAX], pruned[SEGMENTS_MAX];
    struct hatch_line_graph graph;
} of;

static void begin_graph(void)
{
    begin();
    memset(&of, 0, sizeof of);
    of.graph.nodes = of.nodes;
    of.graph.ends = of.ends;
}

static uint32_t add_node(double x, double y)
{
    ck_assert_uint_lt(of.graph.node_count, NODES_MAX);
    of.nodes[3 * of.graph.node_count] = x;
    of.nodes[3 * of.graph.node_count + 1] = y;
    return of.graph.node_count++;
}

static uint32_t add_segment(uint32_t a, uint32_t b)
{
    ck_assert_uint_lt(of.graph.segment_count, SEGMENTS_MAX);
    of.ends[2 * of.graph.segment_count] = a;
    of.ends[2 * of.graph.segment_count + 1] = b;
    return of.graph.segment_count++;
}

/* Adds a line of unit segments from a node along x; returns its last node. */
static uint32_t add_line(uint32_t from, uint32_t segments)
{
    double x = of.nodes[3 * from], y = of.nodes[3 * from + 1];
    for (uint32_t i = 1; i <= segments; i++) {
        uint32_t next = add_node(x + i, y);
        add_segment(from, next);
        from = next;
    }
    return from;
}

/* Prunes the graph of a mesh of a size, and returns the number of segments removed. */
static uint32_t prune(double size)
{
    uint32_t count = 0;
    memset(of.pruned, 0, sizeof of.pruned);
    HATCH_TEST_OK(hatch_line_prune(&of.graph, of.bounds, of.flat, size, &keep, &scratch, of.pruned, &err), &err);
    for (uint32_t s = 0; s < of.graph.segment_count; s++)
        count += of.pruned[s];
    return count;
}

START_TEST(chains_with_a_free_end_need_four_segments_and_a_length)
{
    add_line(add_node(0, 0), 3);
    add_line(add_node(0, 5), 4);
    ck_assert_uint_eq(prune(100), 3);
    ck_assert(of.pruned[0] && of.pruned[1] && of.pruned[2]);
    ck_assert_uint_eq(prune(4 / 0.0301), 3);
    ck_assert_uint_eq(prune(4 / 0.0299), 7);
    of.bounds[1] = of.bounds[5] = 1;
    ck_assert_uint_eq(prune(4 / 0.0299), 5);
}
END_TEST

/* Edges between planes may have few segments, but neither be short nor be part of a chain with others. */
START_TEST(flat_chains_need_a_length_alone)
{
    add_line(add_node(0, 0), 1);
    add_line(add_node(0, 5), 3);
    of.flat[0] = 1;
    ck_assert_uint_eq(prune(1 / 0.0301), 3);
    ck_assert_uint_eq(of.pruned[0], 0);
    ck_assert_uint_eq(prune(1 / 0.0299), 4);
    of.flat[1] = of.flat[2] = 1;
    ck_assert_uint_eq(prune(1 / 0.0301), 3);
    of.flat[3] = 1;
    ck_assert_uint_eq(prune(1 / 0.0301), 0);
}
END_TEST

/* Zigzags of eight segments that turn by 2 * 0.3 and 2 * 0.4 at each node. */
START_TEST(crooked_chains_are_removed)
{
    for (uint32_t crooked = 0; crooked < 2; crooked++) {
        double angle = crooked ? 0.4 : 0.3, x = 0;
        uint32_t from = add_node(0, 20 * crooked);
        for (uint32_t i = 1; i <= 8; i++) {
            x += cos(angle);
            uint32_t next = add_node(x, 20 * crooked + (i % 2 ? sin(angle) : 0));
            add_segment(from, next);
            from = next;
        }
    }
    ck_assert_uint_eq(prune(100), 8);
    ck_assert(!of.pruned[0] && of.pruned[15]);
}
END_TEST

/* Loops around nothing: of three and four segments, and a large one of three. */
START_TEST(small_loops_are_removed)
{
    static const uint32_t sides[3] = {3, 4, 3};
    for (uint32_t l = 0; l < 3; l++) {
        uint32_t first = add_node(20.0 * l, 0), from = first;
        for (uint32_t i = 1; i < sides[l]; i++) {
            uint32_t next = add_node(20.0 * l + (l == 2 ? 9 : 0.5) * (i == 1), (l == 2 ? 9 : 0.5) * i);
            add_segment(from, next);
            from = next;
        }
        add_segment(from, first);
    }
    ck_assert_uint_eq(prune(100), 3);
    ck_assert(of.pruned[0] && of.pruned[1] && of.pruned[2]);
}
END_TEST

/* Two twigs at the end of a short piece, which hangs on a long line: the twigs go first, then the piece. They are
 * listed before the line, so that the numbers of the segments that remain change. */
START_TEST(what_hangs_on_noise_is_removed_with_it)
{
    uint32_t fork = add_node(10, 2), half_way = add_node(10, 1), base = add_node(10, 0);
    add_segment(fork, add_node(9, 3));
    add_segment(fork, add_node(11, 3));
    add_segment(fork, half_way);
    add_segment(half_way, base);
    add_line(base, 10);
    uint32_t before = add_node(0, 0), end = add_line(before, 9);
    add_segment(end, base);
    ck_assert_uint_eq(prune(30), 4);
    for (uint32_t s = 0; s < of.graph.segment_count; s++)
        ck_assert_uint_eq(of.pruned[s], s < 4);
}
END_TEST

/* A piece between two long lines has no free end. */
START_TEST(short_pieces_between_lines_stay)
{
    uint32_t low = add_node(10, 0), high = add_node(10, 1);
    add_segment(low, high);
    add_line(low, 10);
    add_line(high, 10);
    add_segment(add_line(add_node(0, 0), 9), low);
    add_segment(add_line(add_node(0, 1), 9), high);
    ck_assert_uint_eq(prune(30), 0);
}
END_TEST

static Suite *suite(void)
{
    Suite *suite = suite_create("line prune");
    TCase *tests = tcase_create("prune");
    tcase_add_checked_fixture(tests, begin_graph, end);
    tcase_add_test(tests, chains_with_a_free_end_need_four_segments_and_a_length);
    tcase_add_test(tests, flat_chains_need_a_length_alone);
    tcase_add_test(tests, crooked_chains_are_removed);
    tcase_add_test(tests, small_loops_are_removed);
    tcase_add_test(tests, what_hangs_on_noise_is_removed_with_it);
    tcase_add_test(tests, short_pieces_between_lines_stay);
    suite_add_tcase(suite, tests);
    return suite;
}
HATCH_TEST_MAIN(suite)
