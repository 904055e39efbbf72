#include "run.h"

#include "fit/stated.h"
#include "fit/strokes.h"
#include "math/percentile.h"

enum { STEPS = 64, MOST = 1 << 20, COMPARED = 4000 };

/* Least singular value of a cubic that its fragments determine. */
#define DETERMINED 0.1

static struct hatch_fragment many[MOST];
static struct fit_stroke stroke;

/* Largest distances of strokes from the curves that they should have, in pixels. */
struct distances {
    size_t count;
    struct hatch_weighted of[COMPARED];
};

static void note(struct distances *distances, double largest)
{
    distances->of[distances->count++] = (struct hatch_weighted){largest, 1};
}

static void check_distances(struct distances *distances, double median, double most)
{
    static const double shares[] = {0.5, 1};
    double found[2];
    hatch_percentiles(distances->of, distances->count, shares, 2, found);
    ck_assert_uint_gt(distances->count, 500);
    ck_assert_double_lt(found[0], median);
    ck_assert_double_lt(found[1], most);
}

/* How a curve lies to its fragments, in pixels. */
struct manner {
    double out;   /* largest distance of the curve from the box of the fragments, over its range */
    double apart; /* largest distance of a fragment from the curve */
};

static struct manner manner_of(const struct hatch_cubic *cubic, const struct hatch_fragment *fragments, size_t count)
{
    struct manner manner = {0, 0};
    double curve[2 * STEPS + 1][2], most[2] = {-1, -1};
    for (size_t i = 0; i < count; i++) {
        most[0] = fmax(most[0], (double)fragments[i].x);
        most[1] = fmax(most[1], (double)fragments[i].y);
    }
    for (int i = 0; i <= 2 * STEPS; i++) {
        float at[2];
        hatch_cubic_at(cubic, (float)(i - STEPS) / STEPS, at);
        for (int axis = 0; axis < 2; axis++) {
            curve[i][axis] = (double)at[axis];
            ck_assert(isfinite(at[axis]));
            manner.out = fmax(manner.out, (double)(cubic->origin[axis] - at[axis]));
            manner.out = fmax(manner.out, (double)at[axis] - most[axis]);
        }
    }
    size_t stride = count / 5000 + 1;
    for (size_t k = 0; k < count; k += stride) {
        double nearest = INFINITY;
        for (int i = 0; i <= 2 * STEPS; i++)
            nearest = fmin(nearest, hypot(curve[i][0] - (double)fragments[k].x, curve[i][1] - (double)fragments[k].y));
        manner.apart = fmax(manner.apart, nearest);
    }
    return manner;
}

static void check_manner(const struct hatch_fragment *fragments, size_t count, double out, double apart)
{
    struct hatch_cubic cubic;
    hatch_cubic_fit(fragments, count, &cubic);
    struct manner manner = manner_of(&cubic, fragments, count);
    ck_assert_double_le(manner.out, out);
    ck_assert_double_le(manner.apart, apart);
}

START_TEST(one_parameter_makes_a_point)
{
    for (size_t count = 1; count <= 1000; count = 3 * count + 2) {
        struct hatch_cubic cubic;
        for (size_t i = 0; i < count; i++)
            many[i] = (struct hatch_fragment){.t = 0.3f, .x = 7.5f, .y = 9.5f + (float)i};
        hatch_cubic_fit(many, count, &cubic);
        ck_assert_float_eq(hatch_cubic_u(&cubic, 0.9f), 0);
        for (float u = -3; u <= 3; u++) {
            float at[2];
            hatch_cubic_at(&cubic, u, at);
            ck_assert_float_eq(at[0], 7.5f);
            ck_assert_float_eq(at[1], 9.5f + 0.5f * (float)(count - 1));
        }
    }
}
END_TEST

/* Adds a number of fragments that are all alike. */
static void add(size_t *count, size_t times, float t, float x, float y)
{
    for (size_t i = 0; i < times; i++)
        many[(*count)++] = (struct hatch_fragment){.t = t, .x = x, .y = y, .weight = 1};
}

START_TEST(two_or_three_parameters_make_a_line_or_an_arc)
{
    static const size_t times[] = {1, 2, 50, 1000};
    for (size_t i = 0; i < 4; i++)
        for (size_t j = 0; j < 4; j++) {
            size_t count = 0;
            add(&count, times[i], 0.3f, 7.5f, 9.5f);
            add(&count, times[j], 0.3f + 0x1p-16f, 70.5f, 61.5f);
            check_manner(many, count, 1, 0.001);
            count = 0;
            add(&count, times[i], 0.3f, 7.5f, 9.5f);
            add(&count, times[j], 0.55f, 40.5f, 21.5f);
            add(&count, times[i], 0.8f, 70.5f, 61.5f);
            check_manner(many, count, 1, i < 2 || j < 2 ? 14 : 0.1);
        }
    for (size_t i = 1; i < 5; i++) { /* two places side by side at one end, nearly at one parameter */
        size_t count = 0;
        add(&count, i, 0.3f, 7.5f, 9.5f);
        add(&count, i, 0.799f, 70.5f, 61.5f);
        add(&count, i, 0.8f, 72.5f, 57.5f);
        check_manner(many, count, 1, 3);
    }
}
END_TEST

/* A curved stroke bulges in a gap, as it should; a line may bulge by a hundredth of its length in a large one. */
START_TEST(no_curve_has_a_spike)
{
    for (uint64_t index = 0; index < 2000; index++) {
        const enum fit_kind kind = (enum fit_kind)(index % FIT_KINDS);
        const bool half = kind == FIT_GAP && index % 2 == 0;
        struct fit_way way = fit_draw_way(kind, index, kind == FIT_GAP ? 0 : kind == FIT_HOLES ? 0.2 : 0.8);
        if (half) {
            way.hidden[0][0] = 0.25;
            way.hidden[0][1] = 0.75;
        }
        fit_fragments(&way, &stroke);
        if (stroke.count > 0)
            check_manner(stroke.fragments, stroke.count, kind == FIT_GAP && !half ? fmax(1, 0.01 * way.length_px) : 1,
                         0.5 * way.width_px + 1.5);
    }
}
END_TEST

/* A twentieth at each end determines a cubic well enough to follow it in between. */
START_TEST(a_hidden_middle_is_where_the_ends_point)
{
    static struct distances off;
    for (uint64_t index = 0; index < 1000; index++) {
        struct fit_way way = fit_draw_way(FIT_WHOLE, index, 0.8);
        double most = 0;
        way.length_px = fit_between(index, 6, 0, 100, 400);
        way.hidden[0][0] = 0.05;
        way.hidden[0][1] = 0.95;
        fit_fragments(&way, &stroke);
        struct hatch_cubic cubic;
        hatch_cubic_fit(stroke.fragments, stroke.count, &cubic);
        for (int i = 0; i <= STEPS; i++) {
            double t = (double)i / STEPS, place[2], at[3][2];
            fit_curve_at(&cubic, t, place);
            fit_bezier_at(&stroke.middle, t, at);
            most = fmax(most, hypot(place[0] - at[0][0], place[1] - at[0][1]));
        }
        note(&off, most);
    }
    check_distances(&off, 1, 8);
}
END_TEST

START_TEST(a_million_fragments_have_a_curve)
{
    const struct fit_bezier middle = {{{10, 900, 1500, 3000}, {40, 1500, 200, 1500}}};
    struct hatch_cubic cubic;
    for (size_t i = 0; i < MOST; i++) {
        double t = (double)(i % 65536) / 65535, at[3][2], across = (double)(i / 65536) - 7.5;
        fit_bezier_at(&middle, t, at);
        across /= hypot(at[1][0], at[1][1]);
        many[i] = (struct hatch_fragment){.t = (float)t,
                                          .x = (float)(floor(at[0][0] - across * at[1][1]) + 0.5),
                                          .y = (float)(floor(at[0][1] + across * at[1][0]) + 0.5),
                                          .weight = 1};
    }
    hatch_cubic_fit(many, MOST, &cubic);
    ck_assert_float_eq(cubic.weight, (float)MOST);
    for (int i = 0; i <= STEPS; i++) {
        double t = (double)i / STEPS, at[3][2], place[2];
        fit_bezier_at(&middle, t, at);
        fit_curve_at(&cubic, t, place);
        ck_assert_double_lt(hypot(place[0] - at[0][0], place[1] - at[0][1]), 0.05);
    }
}
END_TEST

static double off_reference(const struct hatch_cubic *cubic, const struct fit_reference *reference, double t)
{
    double here[2], there[2];
    fit_curve_at(cubic, t, here);
    fit_reference_at(reference, t, there);
    return hypot(here[0] - there[0], here[1] - there[1]);
}

/* At the fragments of strokes with gaps or slivers, the curve may differ by about half a width: the reference goes
 * through single pixels of a piece that is shorter than wide. */
START_TEST(curves_agree_with_the_pseudo_inverse)
{
    static struct distances at_fragments, at_few, over_range, regular;
    for (uint64_t index = 0; index < COMPARED; index++) {
        const enum fit_kind kind = (enum fit_kind)(index % FIT_KINDS);
        const struct fit_way way = fit_draw_way(kind, 10000 + index, 0.8);
        struct fit_reference reference;
        struct hatch_cubic cubic;
        double here = 0, range = 0;
        fit_fragments(&way, &stroke);
        if (stroke.count == 0)
            continue;
        hatch_cubic_fit(stroke.fragments, stroke.count, &cubic);
        fit_reference_find(stroke.fragments, stroke.count, &reference);
        for (size_t i = 0; i < stroke.count; i++)
            here = fmax(here, off_reference(&cubic, &reference, (double)stroke.fragments[i].t));
        for (int i = 0; i <= STEPS; i++) {
            double share = (double)i / STEPS, t = reference.t[0] + share * (reference.t[1] - reference.t[0]);
            range = fmax(range, off_reference(&cubic, &reference, (double)(float)t));
        }
        note(kind == FIT_GAP || kind == FIT_SLIVER ? &at_few : &at_fragments, here);
        if (fit_reference_least(&reference) > DETERMINED)
            note(&over_range, range);
        if (fit_reference_determined(stroke.fragments, stroke.count) > 1)
            note(&regular, here);
    }
    check_distances(&at_fragments, 0.01, 1);
    check_distances(&at_few, 0.5, 4.5);
    check_distances(&over_range, 0.01, 1);
    check_distances(&regular, 0.01, 0.25);
}
END_TEST

/* All strokes are where the problem that the header states has its solution, those too that no cubic is determined by,
 * and that cover their pixels by a few hundredths. */
START_TEST(curves_solve_the_stated_problem)
{
    static struct distances at_fragments;
    for (uint64_t index = 0; index < COMPARED; index++) {
        const struct fit_way way = fit_draw_way((enum fit_kind)(index % FIT_KINDS), 20000 + index, 0.8);
        struct fit_stated stated;
        struct hatch_cubic cubic;
        double largest = 0;
        fit_fragments(&way, &stroke);
        if (stroke.count == 0)
            continue;
        for (size_t i = 0; i < stroke.count; i++)
            stroke.fragments[i].weight *= 0.02f + 0.98f * (float)fit_between(way.seed, 2, i, 0, 1);
        hatch_cubic_fit(stroke.fragments, stroke.count, &cubic);
        fit_stated_find(stroke.fragments, stroke.count, &stated);
        for (size_t i = 0; i < stroke.count; i++) {
            double here[2], there[2];
            fit_curve_at(&cubic, (double)stroke.fragments[i].t, here);
            fit_stated_at(&stated, (double)stroke.fragments[i].t, there);
            largest = fmax(largest, hypot(here[0] - there[0], here[1] - there[1]));
        }
        note(&at_fragments, largest);
    }
    check_distances(&at_fragments, 0.001, 0.1);
}
END_TEST

static Suite *suite(void)
{
    Suite *made = suite_create("singular");
    TCase *tests = tcase_create("singular");
    tcase_add_test(tests, one_parameter_makes_a_point);
    tcase_add_test(tests, two_or_three_parameters_make_a_line_or_an_arc);
    tcase_add_test(tests, no_curve_has_a_spike);
    tcase_add_test(tests, a_hidden_middle_is_where_the_ends_point);
    tcase_add_test(tests, a_million_fragments_have_a_curve);
    tcase_add_test(tests, curves_agree_with_the_pseudo_inverse);
    tcase_add_test(tests, curves_solve_the_stated_problem);
    suite_add_tcase(made, tests);
    return made;
}

HATCH_TEST_MAIN(suite)
