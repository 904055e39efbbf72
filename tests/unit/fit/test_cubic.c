#include "run.h"

#include "fit/strokes.h"

enum { STEPS = 64, MOST = 1 << 20 };

static struct hatch_fragment many[MOST];
static struct fit_stroke stroke;

/* A cubic in powers of t, 300 pixels long. */
static const double known[2][HATCH_CUBIC_TERMS] = {{30, 280, -90, 60}, {200, -150, 240, -110}};

static void known_at(double t, double place[2])
{
    for (int axis = 0; axis < 2; axis++)
        place[axis] = known[axis][0] + t * (known[axis][1] + t * (known[axis][2] + t * known[axis][3]));
}

/* Samples the known cubic over a range of t.
 *   dense  1: evenly; 2: most densely at the beginning */
static void sample(size_t count, float begin, float end, double dense)
{
    for (size_t i = 0; i < count; i++) {
        double place[2];
        many[i].t = begin + (end - begin) * (float)pow((double)i / (double)(count - 1), dense);
        known_at((double)many[i].t, place);
        many[i].x = (float)place[0];
        many[i].y = (float)place[1];
        many[i].weight = 1;
    }
}

/* Returns the largest distance of a curve from the known one, over its range. */
static double off_known(const struct hatch_cubic *cubic)
{
    double worst = 0, range = (double)(cubic->t[1] - cubic->t[0]);
    for (int i = 0; i <= STEPS; i++) {
        double t = (double)cubic->t[0] + range * i / STEPS, here[2], there[2];
        fit_curve_at(cubic, t, here);
        known_at((double)(float)t, there);
        worst = fmax(worst, hypot(here[0] - there[0], here[1] - there[1]));
    }
    return worst;
}

START_TEST(a_known_cubic_comes_back)
{
    static const float ranges[] = {1, 0.25f, 1.0f / 16, 1.0f / 64};
    static const struct {
        size_t count;
        double within;
        double dense;
    } rows[] = {{1000, 0.001, 1}, {300, 0.01, 1}, {60, 0.1, 1}, {4000, 0.001, 2}};
    for (size_t r = 0; r < 4; r++)
        for (size_t i = 0; i < 4; i++)
            for (float begin = 0; begin + ranges[i] <= 1; begin += 0.24f) {
                struct hatch_cubic cubic;
                sample(rows[r].count, begin, begin + ranges[i], rows[r].dense);
                hatch_cubic_fit(many, rows[r].count, &cubic);
                ck_assert_float_eq(cubic.t[0], begin);
                ck_assert_float_eq(cubic.t[1], many[rows[r].count - 1].t);
                ck_assert_double_lt(off_known(&cubic), rows[r].within);
            }
}
END_TEST

START_TEST(a_line_comes_back_however_few_its_fragments)
{
    for (size_t count = 2; count < 40; count++) {
        struct hatch_cubic cubic;
        for (size_t i = 0; i < count; i++)
            many[i] = (struct hatch_fragment){
                .t = 0.25f + (float)i / 64, .x = 1000.5f + 3 * (float)i, .y = 2000.5f - (float)i, .weight = 0.25f};
        hatch_cubic_fit(many, count, &cubic);
        for (int i = -STEPS; i <= 2 * STEPS; i++) { /* beyond its ends, too */
            double along = (double)(count - 1) * i / STEPS, place[2];
            fit_curve_at(&cubic, 0.25 + along / 64, place);
            ck_assert_double_lt(hypot(place[0] - 1000.5 - 3 * along, place[1] - 2000.5 + along), 0.002);
        }
        ck_assert_float_eq(cubic.weight, 0.25f * (float)count);
    }
}
END_TEST

START_TEST(beyond_its_ends_a_curve_goes_along_its_tangents)
{
    struct hatch_cubic cubic;
    sample(1000, 0.25f, 0.75f, 1);
    hatch_cubic_fit(many, 1000, &cubic);
    for (int end = -1; end <= 1; end += 2) {
        double t = 0.5 + 0.25 * end, at[2];
        known_at(t, at);
        for (double beyond = 0; beyond < 0.3; beyond += 0.05) {
            double place[2], by = end * beyond;
            fit_curve_at(&cubic, t + by, place);
            for (int axis = 0; axis < 2; axis++) {
                const double *f = known[axis], slope = f[1] + t * (2 * f[2] + t * 3 * f[3]);
                ck_assert_double_eq_tol(place[axis], at[axis] + by * slope, 0.02);
            }
        }
    }
}
END_TEST

static void shuffle(struct hatch_fragment *fragments, size_t count, uint64_t seed)
{
    for (size_t i = count; i > 1; i--) {
        size_t other = (size_t)(hatch_random_u64(seed, 5, i) % i);
        struct hatch_fragment last = fragments[i - 1];
        fragments[i - 1] = fragments[other];
        fragments[other] = last;
    }
}

static bool same_bits(const struct hatch_cubic *a, const struct hatch_cubic *b)
{
    return memcmp(a, b, sizeof *a) == 0;
}

START_TEST(the_order_of_fragments_changes_no_bit)
{
    for (uint64_t index = 0; index < 200; index++) {
        const struct fit_way way = fit_draw_way((enum fit_kind)(index % FIT_KINDS), index, index % 3 > 0 ? 0.8 : 0);
        struct hatch_cubic cubic, again;
        fit_fragments(&way, &stroke);
        if (stroke.count == 0)
            continue;
        hatch_cubic_fit(stroke.fragments, stroke.count, &cubic);
        for (uint64_t time = 0; time < 3; time++) {
            shuffle(stroke.fragments, stroke.count, index * 3 + time);
            hatch_cubic_fit(stroke.fragments, stroke.count, &again);
            ck_assert(same_bits(&cubic, &again));
        }
    }
}
END_TEST

/* The most fragments, as far away from one another as they may be. */
START_TEST(the_order_of_a_million_fragments_changes_no_bit)
{
    struct hatch_cubic cubic, again;
    for (size_t i = 0; i < MOST; i++)
        many[i] = (struct hatch_fragment){.t = 0.75f + 0.25f * hatch_random_unit(1, 0, i),
                                          .x = 16383.5f,
                                          .y = 16383.5f - (float)(i % 2),
                                          .weight = hatch_random_unit(1, 1, i)};
    many[0] = (struct hatch_fragment){.t = 0, .x = 0.5f, .y = 0.5f, .weight = 1};
    hatch_cubic_fit(many, MOST, &cubic);
    for (uint64_t time = 0; time < 3; time++) {
        shuffle(many, MOST, time);
        hatch_cubic_fit(many, MOST, &again);
        ck_assert(same_bits(&cubic, &again));
    }
}
END_TEST

START_TEST(a_stroke_that_moves_by_whole_pixels_keeps_its_curve)
{
    for (uint64_t index = 0; index < 100; index++) {
        const struct fit_way way = fit_draw_way((enum fit_kind)(index % FIT_KINDS), index, 0.8);
        struct hatch_cubic cubic, moved;
        fit_fragments(&way, &stroke);
        if (stroke.count == 0)
            continue;
        hatch_cubic_fit(stroke.fragments, stroke.count, &cubic);
        for (size_t i = 0; i < stroke.count; i++) {
            stroke.fragments[i].x += 15000;
            stroke.fragments[i].y += 333;
        }
        hatch_cubic_fit(stroke.fragments, stroke.count, &moved);
        cubic.origin[0] += 15000;
        cubic.origin[1] += 333;
        ck_assert(same_bits(&cubic, &moved));
    }
}
END_TEST

/* Beginning and end are exchanged, and left and right. */
START_TEST(a_reversed_and_mirrored_stroke_has_the_same_curve)
{
    for (uint64_t index = 0; index < 200; index++) {
        const struct fit_way way = fit_draw_way((enum fit_kind)(index % FIT_KINDS), index, 0.8);
        struct hatch_cubic cubic, back;
        fit_fragments(&way, &stroke);
        if (stroke.count == 0)
            continue;
        hatch_cubic_fit(stroke.fragments, stroke.count, &cubic);
        for (size_t i = 0; i < stroke.count; i++) {
            stroke.fragments[i].t = 1 - stroke.fragments[i].t;
            stroke.fragments[i].x = 1024 - stroke.fragments[i].x;
        }
        hatch_cubic_fit(stroke.fragments, stroke.count, &back);
        for (int i = -STEPS; i <= STEPS; i++) {
            float here[2], there[2];
            hatch_cubic_at(&cubic, (float)i / STEPS, here);
            hatch_cubic_at(&back, -(float)i / STEPS, there);
            ck_assert_double_lt(hypot((double)(here[0] + there[0] - 1024), (double)(here[1] - there[1])), 0.02);
        }
    }
}
END_TEST

START_TEST(the_weight_is_the_area)
{
    for (uint64_t index = 0; index < 100; index++) {
        const struct fit_way way = fit_draw_way(FIT_WHOLE, index, 0.3);
        struct hatch_cubic cubic;
        double length = 0, before[3][2], at[3][2];
        fit_fragments(&way, &stroke);
        hatch_cubic_fit(stroke.fragments, stroke.count, &cubic);
        fit_bezier_at(&stroke.middle, 0, before);
        for (int i = 1; i <= STEPS; i++) {
            fit_bezier_at(&stroke.middle, (double)i / STEPS, at);
            length += hypot(at[0][0] - before[0][0], at[0][1] - before[0][1]);
            memcpy(before, at, sizeof at);
        }
        ck_assert_double_eq_tol((double)cubic.weight, length * way.width_px, 0.05 * length * way.width_px + 2);
    }
}
END_TEST

/* Straight strokes along the pixels, in sixteenths of a pixel: the curve stays in their middle, as well as the middles
 * of their pixels tell where it is. */
START_TEST(a_stroke_that_moves_by_parts_of_a_pixel_moves_evenly)
{
    static const double widths[] = {1, 1.5, 2, 2.7, 4};
    for (int w = 0; w < 5; w++)
        for (int i = 0; i < 16; i++)
            for (int turned = 0; turned < 2; turned++) {
                struct fit_way way = {.length_px = 60, .width_px = widths[w], .direction_rad = turned * 1.5707963};
                struct hatch_cubic cubic;
                double at[3][2];
                float place[2];
                way.offset[!turned] = i / 16.0;
                fit_fragments(&way, &stroke);
                hatch_cubic_fit(stroke.fragments, stroke.count, &cubic);
                hatch_cubic_at(&cubic, 0, place);
                fit_bezier_at(&stroke.middle, 0.5, at);
                ck_assert_double_lt(fabs((double)place[!turned] - at[0][!turned]), 0.09);
            }
}
END_TEST

static Suite *suite(void)
{
    Suite *made = suite_create("cubic");
    TCase *tests = tcase_create("cubic");
    tcase_add_test(tests, a_known_cubic_comes_back);
    tcase_add_test(tests, a_line_comes_back_however_few_its_fragments);
    tcase_add_test(tests, beyond_its_ends_a_curve_goes_along_its_tangents);
    tcase_add_test(tests, the_order_of_fragments_changes_no_bit);
    tcase_add_test(tests, the_order_of_a_million_fragments_changes_no_bit);
    tcase_add_test(tests, a_stroke_that_moves_by_whole_pixels_keeps_its_curve);
    tcase_add_test(tests, a_reversed_and_mirrored_stroke_has_the_same_curve);
    tcase_add_test(tests, the_weight_is_the_area);
    tcase_add_test(tests, a_stroke_that_moves_by_parts_of_a_pixel_moves_evenly);
    suite_add_tcase(made, tests);
    return made;
}

HATCH_TEST_MAIN(suite)
