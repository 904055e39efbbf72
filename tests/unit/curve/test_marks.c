#include "arenas.h"

#include <math.h>

#include "curve/marks.h"

#define LENGTH_PX 20000.0 /* of the stroke where its scale is 1 */

static const struct hatch_stroke_pen dots = {.width_px = 2, .thin = 1, .mark_px = 2, .gap_px = 1, .scatter = 0.5f};
static const struct hatch_stroke_pen dashes = {.width_px = 2, .thin = 1, .mark_px = 40, .gap_px = 10, .scatter = 0.1f};

/* Lists the marks of a straight stroke; returns their number.
 *   scale  pixels per mesh unit
 *   tone   of the strokes */
static size_t list(const struct hatch_stroke_pen *pen, double scale, double tone, double share,
                   const struct hatch_mark **marks)
{
    struct hatch_buffer buffer = {.arena = &keep};
    double period = hatch_mark_period_px(pen, tone);
    struct hatch_mark_point points[3];
    for (int i = 0; i < 3; i++)
        points[i] = (struct hatch_mark_point){.at = (float)(LENGTH_PX * i / 2),
                                              .scale = (float)scale,
                                              .level = (float)log2(scale / period),
                                              .share = (float)share,
                                              .scatter = pen->scatter * (float)period};
    HATCH_TEST_OK(hatch_marks_list(pen, 12345, points, 3, &buffer, &err), &err);
    *marks = (const void *)buffer.data;
    return buffer.size / sizeof **marks;
}

static double middle(const struct hatch_mark *mark)
{
    return 0.5 * (double)(mark->from + mark->to);
}

START_TEST(as_many_dots_as_wanted_are_drawn_at_any_scale)
{
    const struct hatch_mark *marks;
    for (double scale = 0.5; scale < 4; scale *= 1.1)
        for (double share = 0.25; share <= 1; share += 0.25) {
            double wanted = share * LENGTH_PX * scale / hatch_mark_period_px(&dots, 0.5);
            ck_assert_double_eq_tol((double)list(&dots, scale, 0.5, share, &marks) / wanted, 1, 0.06);
        }
}
END_TEST

/* The line of a dot is as much shorter than the dot as its pen is wide, whose round ends make the rest; a dot that is
 * no longer than wide has a line of a tenth of a pixel. None reaches over an end of the stroke, or is farther beside it
 * than dots scatter. */
START_TEST(lines_of_dots_are_as_long_as_their_pen_leaves)
{
    static const float lengths_px[] = {1, 2, 3, 4};
    static const double wanted_px[] = {0.1, 0.1, 1, 2};
    for (int i = 0; i < 4; i++)
        for (double scale = 0.5; scale < 4; scale *= 3) {
            struct hatch_stroke_pen pen = dots;
            const struct hatch_mark *marks;
            pen.mark_px = lengths_px[i];
            const double half = 0.5 * (double)pen.mark_px / scale;
            size_t count = list(&pen, scale, 0.5, 1, &marks);
            double farthest = 0, reach = (double)pen.scatter * hatch_mark_period_px(&pen, 0.5);
            for (size_t m = 0; m < count; m++) {
                ck_assert_double_eq_tol((double)(marks[m].to - marks[m].from) * scale, wanted_px[i], 0.01);
                ck_assert(middle(&marks[m]) >= half && middle(&marks[m]) <= LENGTH_PX - half);
                ck_assert(m == 0 || middle(&marks[m]) > middle(&marks[m - 1]));
                ck_assert_float_eq(marks[m].beside[0], marks[m].beside[1]);
                farthest = fmax(farthest, fabs((double)marks[m].beside[0]));
            }
            ck_assert_double_le(farthest, reach * (1 + 1e-6));
            ck_assert_double_gt(farthest, 0.95 * reach);
        }
}
END_TEST

/* Dots make the share of whole strokes that has their tone, HATCH_DOT_LAYERS times, as far apart along strokes as
 * across where the gap is sqrt(2) - 1 of their length. */
START_TEST(dots_have_their_tone)
{
    struct hatch_stroke_pen pen = dots;
    pen.gap_px = (float)(2 * (sqrt(2) - 1));
    for (double tone = 0.1; tone <= 1; tone += 0.1) {
        double period = hatch_mark_period_px(&pen, tone), strokes = hatch_mark_stroke_tone(&pen, tone);
        ck_assert_double_eq_tol(strokes * (double)pen.mark_px / period, HATCH_DOT_LAYERS * tone, 1e-6);
        ck_assert_double_eq_tol((double)pen.width_px / strokes, period, 1e-6);
    }
    ck_assert_double_eq(hatch_mark_stroke_tone(&dashes, 0.3), 0.3);
    ck_assert_double_eq(hatch_mark_period_px(&dashes, 0.3), 50);
}
END_TEST

/* Marks stay where they are when the scale grows; others come between them. */
START_TEST(marks_stay_while_the_scale_changes)
{
    const struct hatch_stroke_pen *pens[] = {&dots, &dashes};
    for (int p = 0; p < 2; p++) {
        const struct hatch_mark *before, *after;
        size_t count = list(pens[p], 1, 0.5, 1, &before), more = list(pens[p], 1.9, 0.5, 1, &after), kept = 0;
        double near = 0.07 * hatch_mark_period_px(pens[p], 0.5);
        for (size_t i = 0, k = 0; i < count; i++) {
            double at = p == 0 ? middle(&before[i]) : (double)before[i].from - 0.25 * (double)pens[p]->gap_px;
            while (k < more && (double)after[k].from < at - near - (double)pens[p]->gap_px)
                k++;
            for (size_t m = k; m < more && m < k + 4; m++) {
                double other = p == 0 ? middle(&after[m]) : (double)after[m].from;
                if (fabs(other - at) < near + (p == 0 ? 0 : 0.75 * (double)pens[p]->gap_px)) {
                    kept++;
                    break;
                }
            }
        }
        ck_assert_uint_gt(more, count * 3 / 2);
        ck_assert_uint_ge(kept, count * 97 / 100);
    }
}
END_TEST

/* Longer marks leave the gaps between them, of which none is like the next, and overlap where gaps are below 0. */
START_TEST(gaps_are_as_long_as_wanted_and_vary)
{
    for (int over = 0; over < 2; over++) {
        struct hatch_stroke_pen pen = dashes;
        pen.mark_px = over ? 60 : 40;
        pen.gap_px = over ? -10 : 10;
        const struct hatch_mark *marks;
        size_t count = list(&pen, 1, 0.5, 1, &marks);
        double gaps = 0, squares = 0, lengths = 0, reach = (double)pen.scatter * 50 + 1e-4;
        ck_assert_double_eq_tol((double)count * 50 / LENGTH_PX, 1.08, 0.05); /* a tenth of the marks are growing */
        ck_assert_double_eq((double)marks[0].from, 0);
        ck_assert_double_eq((double)marks[count - 1].to, LENGTH_PX);
        for (size_t i = 0; i < count; i++) {
            double length = (double)(marks[i].to - marks[i].from);
            lengths += length;
            squares += length * length;
            for (int k = 0; k < 2; k++)
                ck_assert_double_le(fabs((double)marks[i].beside[k]), reach);
            gaps += i > 0 ? (double)(marks[i].from - marks[i - 1].to) : 0;
        }
        ck_assert_double_eq_tol(gaps * 50 / LENGTH_PX, (double)pen.gap_px, 0.6);
        lengths /= (double)count;
        ck_assert_double_gt(sqrt(squares / (double)count - lengths * lengths), 0.2 * lengths);
    }
}
END_TEST

START_TEST(two_strokes_have_their_marks_at_different_places)
{
    struct hatch_buffer marks[2] = {{.arena = &keep}, {.arena = &keep}};
    const struct hatch_mark_point points[2] = {{0, 1, -5, 1, 0}, {(float)LENGTH_PX, 1, -5, 1, 0}};
    size_t same = 0, count;
    for (uint32_t i = 0; i < 2; i++)
        HATCH_TEST_OK(hatch_marks_list(&dots, i, points, 2, &marks[i], &err), &err);
    count = (marks[0].size < marks[1].size ? marks[0].size : marks[1].size) / sizeof(struct hatch_mark);
    for (size_t i = 0; i < count; i++)
        same += fabs(middle((struct hatch_mark *)(void *)marks[0].data + i) -
                     middle((struct hatch_mark *)(void *)marks[1].data + i)) < 2;
    ck_assert_uint_gt(count, 500);
    ck_assert_uint_lt(same, count / 3);
}
END_TEST

static Suite *suite(void)
{
    Suite *made = suite_create("marks");
    TCase *tests = tcase_create("marks");
    tcase_add_checked_fixture(tests, begin, end);
    tcase_add_test(tests, as_many_dots_as_wanted_are_drawn_at_any_scale);
    tcase_add_test(tests, lines_of_dots_are_as_long_as_their_pen_leaves);
    tcase_add_test(tests, dots_have_their_tone);
    tcase_add_test(tests, marks_stay_while_the_scale_changes);
    tcase_add_test(tests, gaps_are_as_long_as_wanted_and_vary);
    tcase_add_test(tests, two_strokes_have_their_marks_at_different_places);
    suite_add_tcase(made, tests);
    return made;
}

HATCH_TEST_MAIN(suite)
