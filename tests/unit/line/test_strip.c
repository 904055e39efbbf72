/* Chains in a picture: clipping, pieces, clean-up of their visibility. */
#include "fail_alloc.h"
#include "lines.h"
#include "line/strip.h"

static const struct hatch_tile whole = {0, 0, 400, 400, 400, 400};

/* Makes a polyline through points; it is closed when the last point is the first one. */
static struct hatch_line_trace polyline(const double *points, uint32_t count)
{
    bool closed = hatch_vec_distance(points, points + 3 * (count - 1)) == 0;
    struct hatch_line_trace trace = {.node_count = count - closed, .segment_count = count - 1};
    trace.nodes = HATCH_NEW(&keep, double, 3 * (size_t)count, &err);
    trace.ends = HATCH_NEW(&keep, uint32_t, 2 * (size_t)count, &err);
    trace.slack_px = HATCH_NEW(&keep, float, count, &err);
    memcpy(trace.nodes, points, 24 * (size_t)trace.node_count);
    for (uint32_t s = 0; s < trace.segment_count; s++) {
        trace.ends[2 * s] = s;
        trace.ends[2 * s + 1] = (s + 1) % trace.node_count;
    }
    return trace;
}

static struct hatch_line_strips strips_of(const struct hatch_line_trace *trace, const struct hatch_view *view,
                                          const struct hatch_tile *tile)
{
    struct hatch_line_chains chains = chains_of(trace);
    struct hatch_line_strips strips = {.strip_count = 0};
    const struct hatch_line_picture picture = {view, tile, 4};
    HATCH_TEST_OK(hatch_line_strips_make(trace, &chains, &picture, &keep, &strips, &err), &err);
    return strips;
}

START_TEST(a_segment_becomes_pieces_of_its_projection)
{
    static const double points[6] = {-1, 0.5, 0, 1, 0.5, 0};
    struct hatch_line_trace trace = polyline(points, 2);
    struct hatch_view view = view_from(0, 0, 4, true);
    struct hatch_line_strips strips = strips_of(&trace, &view, &whole);
    ck_assert_uint_eq(strips.strip_count, 1);
    ck_assert_uint_eq(strips.piece_count, 134); /* 200 pixels, at most 1.5 per piece */
    ck_assert_float_eq_tol(strips.pieces[0].a[0], 100, 1e-3f);
    ck_assert_float_eq_tol(strips.pieces[133].b[0], 300, 1e-3f);
    ck_assert_float_eq_tol(strips.pieces[70].a[1], 250, 1e-3f);
    ck_assert_float_eq_tol(strips.samples[0].limit, 0.96f, 1e-3f); /* at depth 4 of 100 */
}
END_TEST

/* A line from distance 2 to distance 8, which a view that ends at 5 shows up to there. */
START_TEST(lines_beyond_the_far_plane_are_clipped)
{
    static const double points[6] = {1, 0, 2, 1, 0, -4};
    for (int finite = 0; finite < 2; finite++) {
        struct hatch_view view = view_from(0, 0, 4, false);
        struct hatch_line_trace trace = polyline(points, 2);
        view.far = 5;
        view.finite = finite != 0;
        struct hatch_line_strips strips = strips_of(&trace, &view, &whole);
        const struct hatch_line_piece *last = &strips.pieces[strips.piece_count - 1];
        const double end = finite ? 5 : 8;
        ck_assert_float_eq_tol(last->b[0], (float)(200 + 200 / (end * view.half_height)), 1e-2f);
    }
}
END_TEST

START_TEST(lines_behind_the_eye_are_clipped)
{
    static const double points[6] = {0.1, 0.1, -3, 0.2, 0.3, 9};
    static const double behind[6] = {0.1, 0.1, 5, 0.2, 0.3, 9};
    struct hatch_view view = view_from(0, 0, 4, false);
    struct hatch_line_trace trace = polyline(points, 2), unseen = polyline(behind, 2);
    struct hatch_line_strips strips = strips_of(&trace, &view, &whole);
    ck_assert_uint_gt(strips.piece_count, 10);
    for (uint32_t i = 0; i < strips.piece_count; i++) {
        ck_assert(isfinite(strips.pieces[i].a[0] + strips.pieces[i].b[1] + strips.samples[i].limit));
        ck_assert_float_ge(strips.pieces[i].b[0], 190);
        ck_assert_float_le(strips.pieces[i].a[0], 406);
    }
    ck_assert(strips.strips[0].joined[1]);
    ck_assert_uint_eq(strips_of(&unseen, &view, &whole).piece_count, 0);
}
END_TEST

/* The pieces of a tile are those of the whole picture, translated, so that lines of neighbouring tiles meet. */
START_TEST(tiles_cut_lines_alike)
{
    static const double points[9] = {-1.7, -1.1, 0, 0.4, 0.9, 0.5, 1.8, -1.6, 0.2};
    struct hatch_line_trace trace = polyline(points, 3);
    struct hatch_view view = view_from(0.3, 0.2, 5, false);
    struct hatch_tile tile = {150, 90, 120, 160, 400, 400};
    struct hatch_line_strips all = strips_of(&trace, &view, &whole);
    struct hatch_line_strips part = strips_of(&trace, &view, &tile);
    uint32_t found = 0;
    for (uint32_t i = 0; i < part.piece_count; i++)
        for (uint32_t j = 0; j < all.piece_count; j++)
            found += part.pieces[i].segment == all.pieces[j].segment &&
                     hypotf(part.pieces[i].a[0] + 150 - all.pieces[j].a[0],
                            part.pieces[i].a[1] + 90 - all.pieces[j].a[1]) < 1e-3f;
    ck_assert_uint_gt(part.piece_count, 40);
    ck_assert_uint_lt(part.piece_count, all.piece_count / 2);
    ck_assert_uint_eq(found, part.piece_count);
}
END_TEST

/* Makes a closed square with sides of 100 pixels. */
static struct hatch_line_strips square(void)
{
    static const double points[15] = {-.5, -.5, 0, .5, -.5, 0, .5, .5, 0, -.5, .5, 0, -.5, -.5, 0};
    struct hatch_line_trace trace = polyline(points, 5);
    struct hatch_view view = view_from(0, 0, 4, true);
    struct hatch_line_strips strips = strips_of(&trace, &view, &whole);
    ck_assert_uint_eq(strips.strip_count, 1);
    ck_assert(strips.strips[0].closed);
    ck_assert_uint_eq(strips.piece_count, 268);
    return strips;
}

static uint32_t sum(const uint8_t *visible, uint32_t count)
{
    uint32_t total = 0;
    for (uint32_t i = 0; i < count; i++)
        total += visible[i];
    return total;
}

/* Cleans up visibility without haloes.
 *   visible  in and out: per piece */
static void smooth(const struct hatch_line_strips *strips, double gap_px, double speck_px, double trim_px,
                   uint8_t *visible)
{
    uint8_t seen[268];
    memcpy(seen, visible, sizeof seen);
    hatch_line_strips_smooth(strips, gap_px, speck_px, trim_px, seen, visible);
}

START_TEST(gaps_are_closed_and_specks_are_hidden)
{
    struct hatch_line_strips strips = square();
    uint8_t visible[268];
    memset(visible, 1, sizeof visible);
    visible[0] = visible[267] = visible[50] = 0; /* the gap at the corner has two pieces */
    memset(visible + 100, 0, 40);
    smooth(&strips, 4, 8, 0, visible);
    ck_assert_uint_eq(sum(visible, 268), 228);
    memset(visible, 0, sizeof visible);
    memset(visible + 20, 1, 5);
    memset(visible + 200, 1, 30);
    visible[0] = visible[267] = 1;
    smooth(&strips, 4, 8, 0, visible);
    ck_assert_uint_eq(sum(visible, 268), 30);
    ck_assert_uint_eq(visible[215], 1);
    memset(visible, 0, sizeof visible);
    smooth(&strips, 1e9, 8, 0, visible);
    ck_assert_uint_eq(sum(visible, 268), 0);
}
END_TEST

START_TEST(ends_at_hidden_parts_are_trimmed)
{
    struct hatch_line_strips strips = square();
    uint8_t visible[268];
    memset(visible, 1, sizeof visible);
    memset(visible + 100, 0, 40);
    smooth(&strips, 4, 8, 2, visible); /* pieces are 1.49 long: two on each side */
    ck_assert_uint_eq(sum(visible, 268), 224);
    ck_assert_uint_eq(visible[97] + visible[142], 2);
    ck_assert_uint_eq(visible[98] + visible[141], 0);
    memset(visible, 1, sizeof visible);
    memset(visible, 0, 40);
    smooth(&strips, 4, 8, 2, visible);
    ck_assert_uint_eq(visible[267] + visible[41], 0);
    strips.strips[0].closed = false;
    memset(visible, 1, sizeof visible);
    smooth(&strips, 4, 8, 2, visible);
    ck_assert_uint_eq(sum(visible, 268), 268);
}
END_TEST

START_TEST(parts_joined_by_a_line_are_no_specks)
{
    struct hatch_line_strips strips = square();
    uint8_t visible[268] = {1, 1};
    strips.strips[0].closed = false;
    strips.strips[0].joined[0] = true;
    strips.strips[0].joined[1] = false;
    visible[266] = visible[267] = 1;
    smooth(&strips, 4, 8, 0, visible);
    ck_assert_uint_eq(visible[0], 1);
    ck_assert_uint_eq(visible[267], 0);
}
END_TEST

START_TEST(pieces_of_a_straight_line_are_drawn_as_one)
{
    struct hatch_line_strips strips = square();
    uint8_t visible[268];
    struct hatch_line_segment segments[268];
    memset(visible, 1, sizeof visible);
    visible[30] = 0;
    ck_assert_uint_eq(hatch_line_strips_visible(&strips, visible, visible, NULL, segments), 5);
    ck_assert_float_eq_tol(segments[0].a[0], strips.pieces[31].a[0], 1e-6f); /* the path begins after the gap */
    ck_assert_float_eq_tol(segments[0].b[0], strips.pieces[66].b[0], 1e-6f);
    ck_assert_float_eq_tol(segments[4].b[0], strips.pieces[29].b[0], 1e-6f);
}
END_TEST

/* A cube that a node scales to nothing, or to a twelfth of a pixel, is no dot; one of two pixels is. */
START_TEST(objects_without_size_have_no_lines)
{
    static const double scales[] = {0, 1e-9, 4e-4, 1e-2};
    struct hatch_mesh mesh = cube(-1, 1);
    struct hatch_line_mesh lines = lines_of(&mesh, HATCH_LINES_ALL, 0.7);
    for (int i = 0; i < 8; i++) {
        struct hatch_view view = view_from(0, 0, 4, i / 4 == 0);
        const struct hatch_line_eye eye = {&view, 200 / view.half_height};
        const struct hatch_line_picture picture = {&view, &whole, 4};
        struct hatch_line_shape shape = shape_in_place(&lines);
        struct hatch_line_strips strips;
        struct hatch_line_trace trace;
        for (int k = 0; k < 3; k++)
            shape.to_unit[5 * k] = scales[i % 4];
        HATCH_TEST_OK(hatch_line_trace_features(&shape, &eye, &keep, &trace, &err), &err);
        HATCH_TEST_OK(hatch_line_strips_make(&trace, &lines.chains, &picture, &keep, &strips, &err), &err);
        ck_assert_uint_eq(strips.piece_count > 0, i % 4 == 3);
        ck_assert_uint_eq(strips.strip_count > 0, i % 4 == 3);
    }
}
END_TEST

/* Haloes split a line into parts; short uncovered parts are hidden, independent of the length under the halo. */
START_TEST(specks_between_haloes_are_hidden)
{
    struct hatch_line_strips strips = square();
    uint8_t seen[268], visible[268];
    memset(seen, HATCH_LINE_VISIBLE, sizeof seen);
    memset(seen + 100, HATCH_LINE_VISIBLE | HATCH_LINE_TOUCHED | HATCH_LINE_COVERED, 20);
    memset(seen + 103, HATCH_LINE_VISIBLE, 3);
    memset(seen + 110, HATCH_LINE_VISIBLE, 7);
    hatch_line_strips_smooth(&strips, 4, 8, 2, seen, visible);
    ck_assert_uint_eq(sum(visible + 101, 8), 0); /* 4.5 pixels are hidden */
    ck_assert_uint_eq(sum(visible + 109, 9), 9); /* 10.4 pixels stay, with a covered piece on either side */
    ck_assert_uint_eq(visible[108] + visible[118], 0);
    ck_assert_uint_eq(sum(visible, 101), 101); /* not trimmed: the line ends at the halo */
    ck_assert_uint_eq(sum(visible + 119, 149), 149);
    memset(seen + 110, HATCH_LINE_TOUCHED | HATCH_LINE_COVERED, 7);
    hatch_line_strips_smooth(&strips, 4, 8, 0, seen, visible);
    ck_assert_uint_eq(sum(visible + 101, 18), 0);
}
END_TEST

/* The first and the last piece of a closed line are neighbours. */
START_TEST(haloes_reach_over_the_start_of_a_closed_line)
{
    struct hatch_line_strips strips = square();
    uint8_t seen[268], visible[268];
    struct hatch_line_segment segments[268];
    memset(visible, 1, sizeof visible);
    for (uint32_t touched = 267; touched <= 268; touched++) {
        memset(seen, HATCH_LINE_VISIBLE, sizeof seen);
        seen[touched % 268] |= HATCH_LINE_TOUCHED;
        uint32_t count = hatch_line_strips_visible(&strips, visible, seen, NULL, segments);
        double length = 0;
        for (uint32_t i = 0; i < count; i++)
            if (segments[i].in_halo > 0)
                length += hypot((double)segments[i].b[0] - (double)segments[i].a[0],
                                (double)segments[i].b[1] - (double)segments[i].a[1]);
        double piece = hypot((double)strips.pieces[0].b[0] - (double)strips.pieces[0].a[0],
                             (double)strips.pieces[0].b[1] - (double)strips.pieces[0].a[1]);
        ck_assert_double_eq_tol(length, 3 * piece, 1e-3);
    }
}
END_TEST

START_TEST(only_pieces_near_haloes_are_tested_again)
{
    struct hatch_line_strips strips = square();
    uint8_t seen[268], visible[268];
    struct hatch_line_segment segments[268];
    memset(seen, HATCH_LINE_VISIBLE, sizeof seen);
    memset(visible, 1, sizeof visible);
    seen[30] |= HATCH_LINE_TOUCHED;
    ck_assert_uint_eq(hatch_line_strips_visible(&strips, visible, seen, NULL, segments), 6);
    for (uint32_t i = 0; i < 6; i++)
        ck_assert_uint_eq(segments[i].in_halo > 0, i == 1);
    ck_assert_float_eq_tol(segments[1].a[0], strips.pieces[29].a[0], 1e-6f);
    ck_assert_float_eq_tol(segments[1].b[0], strips.pieces[31].b[0], 1e-6f);
}
END_TEST

/* Two lines that cross at a node are straight chains; a third one that ends there is joined. */
START_TEST(chains_go_straight_on)
{
    static const double nodes[18] = {0, 0, 0, -1, 0, 0, 1, 0.1, 0, 0, -1, 0, 0.1, 1, 0, 0.7, 0.7, 0};
    static const uint32_t ends[10] = {1, 0, 0, 2, 3, 0, 4, 0, 5, 0};
    const struct hatch_line_graph graph = {6, 5, nodes, ends};
    struct hatch_line_chains chains;
    HATCH_TEST_OK(hatch_line_chains_make(&graph, &keep, &scratch, &chains, &err), &err);
    ck_assert_uint_eq(chains.count, 3);
    uint32_t twos = 0, joined = 0;
    for (uint32_t i = 0; i < 3; i++) {
        twos += chains.chains[i].segment_count == 2;
        joined += chains.chains[i].joined[0] + chains.chains[i].joined[1];
    }
    ck_assert_uint_eq(twos, 2);
    ck_assert_uint_eq(joined, 1);
}
END_TEST

/* Pieces that only lack a step in depth do not interrupt a line for 12 pixels, hidden ones do after 4. */
START_TEST(longer_gaps_are_closed_where_nothing_hides_the_line)
{
    struct hatch_line_strips strips = square();
    uint8_t seen[268], visible[268];
    memset(seen, HATCH_LINE_VISIBLE, sizeof seen);
    memset(seen + 20, HATCH_LINE_FLAT, 7);
    memset(seen + 90, HATCH_LINE_FLAT, 9);
    memset(seen + 150, 0, 7);
    hatch_line_strips_smooth(&strips, 4, 8, 0, seen, visible);
    ck_assert_uint_eq(sum(visible, 90), 90);
    ck_assert_uint_eq(sum(visible + 90, 9), 0);
    ck_assert_uint_eq(sum(visible + 150, 7), 0);
}
END_TEST

/* Turns points in the plane of the picture by a part of a full turn. */
static void rotate_all(double *points, uint32_t count, double part)
{
    double c = cos(2 * PI * part), s = sin(2 * PI * part);
    for (uint32_t i = 0; i < count; i++) {
        double x = points[3 * i], y = points[3 * i + 1];
        points[3 * i] = c * x - s * y;
        points[3 * i + 1] = s * x + c * y;
    }
}

/* A line hides in a fold, which goes back and forth by 6 pixels: the visible parts are joined by one short segment. */
START_TEST(folds_are_bridged)
{
    double points[18] = {-.5, 0, 0, 0, 0, 0, -.06, .002, 0, -.005, .004, 0, .5, 0, 0, .6, 0, 0};
    rotate_all(points, 6, _i / 12.0);
    struct hatch_line_trace trace = polyline(points, 6);
    struct hatch_view view = view_from(0, 0, 4, true);
    struct hatch_line_strips strips = strips_of(&trace, &view, &whole);
    uint8_t seen[300], visible[300];
    struct hatch_line_segment segments[300];
    ck_assert_uint_eq(strips.strip_count, 1);
    ck_assert_uint_lt(strips.piece_count, 300);
    for (uint32_t i = 0; i < strips.piece_count; i++)
        seen[i] = strips.pieces[i].segment == 1 || strips.pieces[i].segment == 2 ? 0 : HATCH_LINE_VISIBLE;
    hatch_line_strips_smooth(&strips, 4, 8, 1, seen, visible);
    for (uint32_t i = 0; i < strips.piece_count; i++)
        ck_assert_uint_eq(visible[i], seen[i] ? HATCH_LINE_VISIBLE : HATCH_LINE_BRIDGED);
    ck_assert_uint_eq(hatch_line_strips_visible(&strips, visible, seen, NULL, segments), 4);
    ck_assert_float_eq_tol(hypotf(segments[1].a[0] - 200, segments[1].a[1] - 200), 0, 1e-3f);
    ck_assert_float_eq_tol(hypotf(segments[1].b[0] - 200, segments[1].b[1] - 200), hypotf(.5f, .4f), 1e-3f);
    for (uint32_t i = 1; i < 4; i++)
        ck_assert_float_eq(segments[i].a[0], segments[i - 1].b[0]);
}
END_TEST

/* On a straight line the ends of a gap are as far apart as it is long: one of 12 pixels stays open, one of 3 is closed,
 * in whatever direction the line runs. */
START_TEST(gaps_have_the_same_length_in_all_directions)
{
    double points[6] = {-1, 0, 0, 1, 0, 0};
    rotate_all(points, 2, _i / 12.0);
    struct hatch_line_trace trace = polyline(points, 2);
    struct hatch_view view = view_from(0, 0, 4, true);
    struct hatch_line_strips strips = strips_of(&trace, &view, &whole);
    uint8_t visible[268];
    ck_assert_uint_eq(strips.piece_count, 134);
    memset(visible, 1, sizeof visible);
    memset(visible + 60, 0, 8);
    visible[100] = visible[101] = 0;
    smooth(&strips, 4, 8, 0, visible);
    ck_assert_uint_eq(sum(visible, 134), 126);
    ck_assert_uint_eq(sum(visible + 60, 8), 0);
}
END_TEST

/* Of a line that is a million pixels long only what the tile shows has pieces. */
START_TEST(pieces_outside_the_tile_need_no_memory)
{
    static const double points[6] = {-5000, 0, 0, 5000, 0, 0};
    struct hatch_line_trace trace = polyline(points, 2);
    struct hatch_line_chains chains = chains_of(&trace);
    struct hatch_view view = view_from(0, 0, 4, true);
    const struct hatch_line_picture picture = {&view, &whole, 4};
    struct hatch_line_strips strips;
    struct hatch_arena small;
    hatch_arena_init(&small, (size_t)1 << 20);
    HATCH_TEST_OK(hatch_line_strips_make(&trace, &chains, &picture, &small, &strips, &err), &err);
    ck_assert_uint_ge(strips.piece_count, 266);
    ck_assert_uint_le(strips.piece_count, 280);
    hatch_arena_free(&small);
}
END_TEST

/* Of two lines a pixel apart the one of 12 pixels is hidden; a line of 12 pixels across the long one stays, and so do
 * two long ones. */
START_TEST(short_lines_along_longer_ones_are_hidden)
{
    static const double beside[2][2][3] = {{{0, .01, 0}, {.12, .01, 0}}, {{-.2, -.06, 0}, {-.2, .06, 0}}};
    struct hatch_line_trace trace = {.node_count = 8, .segment_count = 4};
    struct hatch_view view = view_from(0, 0, 4, true);
    trace.nodes = HATCH_NEW(&keep, double, 24, &err);
    trace.ends = HATCH_NEW(&keep, uint32_t, 8, &err);
    trace.slack_px = HATCH_NEW(&keep, float, 4, &err);
    memcpy(trace.nodes, beside, sizeof beside);
    for (uint32_t i = 4; i < 8; i++) {
        trace.nodes[3 * i] = i % 2 ? 1 : -1;
        trace.nodes[3 * i + 1] = i / 6 * -.01;
    }
    for (uint32_t i = 0; i < 8; i++)
        trace.ends[i] = i;
    struct hatch_line_strips strips = strips_of(&trace, &view, &whole);
    uint8_t visible[400];
    ck_assert_uint_lt(strips.piece_count, 400);
    memset(visible, 1, sizeof visible);
    HATCH_TEST_OK(hatch_line_strips_drop_doubles(&strips, visible, &scratch, &err), &err);
    for (uint32_t i = 0; i < strips.piece_count; i++)
        ck_assert_uint_eq(visible[i], strips.pieces[i].segment != 0);
}
END_TEST

static enum hatch_status make(void *context, struct hatch_arena *arena, struct hatch_arena *temporary,
                              struct hatch_err *error)
{
    const struct hatch_line_trace *trace = context;
    const struct hatch_line_graph graph = {trace->node_count, trace->segment_count, trace->nodes, trace->ends};
    struct hatch_view view = view_from(0, 0, 4, true);
    const struct hatch_line_picture picture = {&view, &whole, 4};
    struct hatch_line_chains chains;
    struct hatch_line_strips strips;
    HATCH_TRY(hatch_line_chains_make(&graph, arena, temporary, &chains, error));
    HATCH_TRY(hatch_line_strips_make(trace, &chains, &picture, arena, &strips, error));
    uint8_t visible[400] = {1, 1, 0, 1};
    ck_assert_uint_le(strips.piece_count, 400);
    return hatch_line_strips_drop_doubles(&strips, visible, arena, error);
}

START_TEST(strips_survive_every_failed_allocation)
{
    static const double points[9] = {-1.7, -1.1, 0, 0.4, 0.9, 0.5, 1.8, -1.6, 0.2};
    struct hatch_line_trace trace = polyline(points, 3);
    ck_assert_uint_ge(hatch_test_fail_alloc(make, &trace, NULL, 0), 7);
}
END_TEST

static Suite *suite(void)
{
    Suite *suite = suite_create("render lines strip");
    TCase *tests = tcase_create("strips");
    tcase_add_checked_fixture(tests, begin, end);
    tcase_add_test(tests, a_segment_becomes_pieces_of_its_projection);
    tcase_add_test(tests, lines_beyond_the_far_plane_are_clipped);
    tcase_add_test(tests, lines_behind_the_eye_are_clipped);
    tcase_add_test(tests, tiles_cut_lines_alike);
    tcase_add_test(tests, gaps_are_closed_and_specks_are_hidden);
    tcase_add_test(tests, ends_at_hidden_parts_are_trimmed);
    tcase_add_test(tests, parts_joined_by_a_line_are_no_specks);
    tcase_add_test(tests, pieces_of_a_straight_line_are_drawn_as_one);
    tcase_add_test(tests, objects_without_size_have_no_lines);
    tcase_add_test(tests, specks_between_haloes_are_hidden);
    tcase_add_test(tests, haloes_reach_over_the_start_of_a_closed_line);
    tcase_add_test(tests, only_pieces_near_haloes_are_tested_again);
    tcase_add_test(tests, longer_gaps_are_closed_where_nothing_hides_the_line);
    tcase_add_loop_test(tests, folds_are_bridged, 0, 12);
    tcase_add_loop_test(tests, gaps_have_the_same_length_in_all_directions, 0, 12);
    tcase_add_test(tests, pieces_outside_the_tile_need_no_memory);
    tcase_add_test(tests, short_lines_along_longer_ones_are_hidden);
    tcase_add_test(tests, chains_go_straight_on);
    tcase_add_test(tests, strips_survive_every_failed_allocation);
    suite_add_tcase(suite, tests);
    return suite;
}
HATCH_TEST_MAIN(suite)
