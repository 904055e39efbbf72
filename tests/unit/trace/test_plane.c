/* Strokes on planes with a constant field are straight lines, so that their places can be measured another way than
 * they were found: by lines across the plane. */
#include "trace_make.h"

#define STROKES_MAX 8000u

/* A stroke as an interval along the strokes' direction, at a place across it. */
struct line {
    double begin, end, across;
    uint32_t level;
    const struct hatch_curve *curve;
};

struct lines {
    struct field_case plane;
    struct hatch_curves curves;
    struct hatch_trace_options options;
    double angle;
    uint32_t count;
    struct line list[STROKES_MAX];
};

static struct lines made;

/* Returns how far a point lies along the strokes and across them. */
static void turned(const struct hatch_curve_point *point, double at[2])
{
    float place[3];
    hatch_curve_position(&made.plane.mesh, point, place);
    ck_assert(fabsf(place[0]) <= 1.00001f && fabsf(place[1]) <= 1.00001f && place[2] == 0);
    at[0] = (double)place[0] * cos(made.angle) + (double)place[1] * sin(made.angle);
    at[1] = (double)place[1] * cos(made.angle) - (double)place[0] * sin(made.angle);
}

/* Lists a stroke, each point of which lies on one line. Its thresholds are those of gaps of 0.35 to 1.5 to both sides,
 * with a sixth of an octave to spare. */
static void add_line(const struct hatch_curve *curve, uint32_t level)
{
    double ends[2][2], at[2];
    ck_assert_uint_lt(made.count, STROKES_MAX);
    turned(&made.curves.points[curve->first], ends[0]);
    turned(&made.curves.points[curve->first + curve->count - 1], ends[1]);
    for (uint32_t i = 1; i < curve->count; i++) {
        turned(&made.curves.points[curve->first + i], at);
        ck_assert_msg(fabs(at[1] - ends[0][1]) < 1e-4, "a stroke is %g aside of its line", at[1] - ends[0][1]);
        double per_gap = (double)made.curves.points[curve->first + i].threshold * ldexp(made.options.gap, -(int)level);
        ck_assert_msg(per_gap > 0.44 && per_gap < 2.4, "a threshold of %g per gap", per_gap);
    }
    made.list[made.count++] =
        (struct line){fmin(ends[0][0], ends[1][0]), fmax(ends[0][0], ends[1][0]), ends[0][1], level, curve};
}

/* Traces the strokes of a plane, which a constant field makes straight. */
static void make_lines(struct field_case plane, double angle, struct hatch_trace_options options)
{
    const float turn = (float)angle;
    options.angle_rad = &turn;
    made.plane = plane;
    made.options = options;
    made.angle = angle;
    made.count = 0;
    made.curves = trace_with(&made.plane, &options, NULL);
    for (uint32_t s = 0; s < made.curves.set_count; s++)
        for (uint32_t c = 0; c < made.curves.sets[s].count; c++)
            add_line(&made.curves.curves[made.curves.sets[s].first + c], made.curves.sets[s].level);
}

/* Angles of any sign and size, on two faces and on many. */
START_TEST(strokes_are_straight_lines_at_the_angle)
{
    static const double degrees[] = {0, 30, 45, 90, -20, 170, 360};
    for (size_t i = 0; i < sizeof degrees / sizeof *degrees; i++)
        for (uint32_t faces = 2; faces <= 2000; faces *= 1000) {
            make_lines(trace_plane(faces, 1), degrees[i] * PI / 180, with_gap(0.2, 3));
            ck_assert_uint_gt(made.count, 90);
        }
}
END_TEST

static int by_across(const void *a, const void *b)
{
    const struct line *x = *(const struct line *const *)a, *y = *(const struct line *const *)b;
    return x->across < y->across ? -1 : x->across > y->across;
}

/* Finds the strokes up to a level that pass a line across, but for their ends, in the order of their places.
 *   trim  length of the ends that do not count, in gaps of the stroke's level */
static uint32_t pass_at(double along, uint32_t level, double trim, const struct line *found[STROKES_MAX])
{
    uint32_t count = 0;
    for (uint32_t i = 0; i < made.count; i++) {
        const struct line *line = &made.list[i];
        double end = trim * ldexp(made.options.gap, -(int)line->level);
        if (line->level <= level && line->begin + end < along && along < line->end - end)
            found[count++] = line;
    }
    qsort(found, count, sizeof *found, by_across);
    return count;
}

/* Gaps between neighbours, in gaps of the level. */
struct figures {
    uint32_t count, wide;
    double sum, least;
};

/* Measures the gaps at lines across the whole plane.
 *   trim  length of the strokes' ends that do not count, in gaps of their level */
static struct figures measure(uint32_t level, double trim)
{
    const double gap = ldexp(made.options.gap, -(int)level);
    const struct line *found[STROKES_MAX];
    struct figures figures = {.least = HUGE_VAL};
    for (int k = -40; k <= 40; k++) {
        uint32_t count = pass_at(k * 0.02 + 0.003, level, trim, found);
        for (uint32_t i = 1; i < count; i++) {
            double wide = (found[i]->across - found[i - 1]->across) / gap;
            figures.count++;
            figures.sum += wide;
            figures.wide += wide > 2;
            figures.least = fmin(figures.least, wide);
        }
    }
    return figures;
}

/* Level by level, the mean gap is that of the level, few are wider than twice that, and where strokes do not end they
 * are nowhere nearer than 0.45 gaps. An end may pass another for the half gap that both grow at once. */
START_TEST(gaps_halve_from_level_to_level)
{
    for (int i = 0; i < 4; i++) {
        make_lines(trace_plane(i % 2 ? 3000 : 2, 1), i / 2 ? 0.5 : 0, with_gap(0.1, 3));
        for (uint32_t level = 0; level < 3; level++) {
            struct figures all = measure(level, 0), inner = measure(level, 0.51);
            double mean = all.sum / all.count;
            ck_assert_uint_gt(all.count, 1000u << level);
            ck_assert_msg(mean > 0.85 && mean < 1.1, "level %u: mean gap %g", level, mean);
            ck_assert_msg(all.wide * 100 < all.count, "level %u: %u of %u gaps are wide", level, all.wide, all.count);
            ck_assert_msg(inner.least > 0.449, "level %u: a gap of %g", level, inner.least);
        }
    }
}
END_TEST

/* Returns the sum of the gaps beside a stroke, at most 1.5 of its level to each side; 0 where there is no neighbour as
 * near as that. */
static double room_at(const struct line *line, double along)
{
    const struct line *found[STROKES_MAX];
    double gap = ldexp(made.options.gap, -(int)line->level), room = 0;
    uint32_t count = pass_at(along, line->level, 0, found);
    for (uint32_t i = 1; i + 1 < count; i++)
        if (found[i] == line) {
            double left = line->across - found[i - 1]->across, right = found[i + 1]->across - line->across;
            room = left < 1.5 * gap && right < 1.5 * gap ? left + right : 0;
        }
    return room;
}

/* Returns the room beside a point if it stays the same for 2.5 gaps before and behind it, over which thresholds are
 * smoothed; else 0. */
static double even_room_at(const struct line *line, double along)
{
    double gap = ldexp(made.options.gap, -(int)line->level), room = room_at(line, along);
    for (double way = -2.5; way <= 2.5; way += 0.25)
        if (fabs(room_at(line, along + way * gap) - room) > 1e-3 * gap)
            return 0;
    return room;
}

/* Thresholds are 0.75 strokes per mean gap of both sides, times a rank of the stroke within a sixth of an octave to
 * either side. */
START_TEST(thresholds_follow_the_gaps)
{
    double least = 9, most = 0;
    uint32_t count = 0;
    make_lines(trace_plane(400, 1), 0.3, with_gap(0.05, 3));
    for (uint32_t i = 0; i < made.count; i++) {
        double of_stroke[2] = {9, 0};
        for (uint32_t p = 0; p < made.list[i].curve->count; p++) {
            const struct hatch_curve_point *point = &made.curves.points[made.list[i].curve->first + p];
            double at[2];
            turned(point, at);
            double rank = (double)point->threshold * even_room_at(&made.list[i], at[0]) / 1.5;
            if (rank == 0)
                continue;
            of_stroke[0] = fmin(of_stroke[0], rank);
            of_stroke[1] = fmax(of_stroke[1], rank);
            count++;
        }
        if (of_stroke[1] > 0)
            ck_assert_double_eq_tol(of_stroke[0], of_stroke[1], 0.01);
        least = fmin(least, of_stroke[0]);
        most = fmax(most, of_stroke[1]);
    }
    ck_assert_uint_gt(count, 60);
    ck_assert_msg(least > exp2(-1 / 6.0) - 0.01 && least < 0.95, "least rank %g", least);
    ck_assert_msg(most < exp2(1 / 6.0) + 0.01 && most > 1.05, "greatest rank %g", most);
}
END_TEST

static Suite *suite(void)
{
    Suite *suite = suite_create("trace plane");
    TCase *tests = tcase_create("plane");
    tcase_add_checked_fixture(tests, begin, end);
    tcase_add_test(tests, strokes_are_straight_lines_at_the_angle);
    tcase_add_test(tests, gaps_halve_from_level_to_level);
    tcase_add_test(tests, thresholds_follow_the_gaps);
    suite_add_tcase(suite, tests);
    return suite;
}

HATCH_TEST_MAIN(suite)
