#include "run.h"

#include <math.h>

#include "curve/width.h"

static const struct hatch_stroke_pen pen = {
    .width_px = 2, .thin = 0.5f, .join = 0.4f, .response = {0.12f, 0.24f, 0.36f, 0.48f, 0.58f, 0.66f, 0.74f, 0.8f}};

/* Returns the ink of one family at a tone, as the response says. */
static double response(double tone)
{
    double at = tone * HATCH_STROKE_RESPONSES;
    int low = at < 8 ? (int)at : 7;
    double below = low > 0 ? (double)pen.response[low - 1] : 0;
    return below + (at - low) * ((double)pen.response[low] - below);
}

START_TEST(families_make_the_ink_together)
{
    for (uint32_t families = 1; families <= 4; families++) {
        float tones[4][HATCH_STROKE_TONES];
        double darkest = hatch_stroke_darkest(&pen, families);
        for (uint32_t f = 0; f < families; f++)
            hatch_stroke_tones(&pen, families, f, tones[f]);
        for (uint32_t i = 0; i < HATCH_STROKE_TONES; i++) {
            double ink = (double)i / (HATCH_STROKE_TONES - 1), paper = 1;
            for (uint32_t f = 0; f < families; f++)
                paper *= 1 - response((double)tones[f][i]);
            ck_assert_double_eq_tol(1 - paper, fmin(ink, darkest), 1e-5);
            ck_assert(families == 1 || ink > 0.4 || tones[1][i] <= 0);
        }
    }
}
END_TEST

/* The strokes that a plane of evenly spread thresholds shows have the tone together: one per unit of threshold. */
START_TEST(strokes_of_all_thresholds_cover_the_tone)
{
    const double scale = 500;
    for (double tone = 0.125; tone <= 1; tone += 0.125) {
        double covered = 0;
        for (double threshold = 0.05; threshold < 2000; threshold += 0.1)
            covered += 0.1 * hatch_stroke_width_px(&pen, tone, threshold, scale, 1e6, HUGE_VAL, 1) / scale;
        ck_assert_double_eq_tol(covered, tone, 0.002);
    }
}
END_TEST

/* Where each level halves the gaps, strokes of any gap make the same ink at any tone. */
START_TEST(levels_that_halve_gaps_cover_the_tone_evenly)
{
    const double scale = 500, step = pow(2, 1.0 / 16);
    double least = HUGE_VAL, most = 0;
    for (double threshold = 1; threshold < 2; threshold *= step) {
        double covered = 0;
        for (int level = -20; level < 20; level++)
            covered += ldexp(threshold, level) *
                       hatch_stroke_width_px(&pen, 0.5, ldexp(threshold, level), scale, 1e6, HUGE_VAL, 1);
        least = fmin(least, covered);
        most = fmax(most, covered);
    }
    ck_assert_double_le(most - least, 1e-4 * most);
}
END_TEST

/* So they have where none are denser than wanted, or few are: the others are wider. */
START_TEST(wider_strokes_make_up_for_those_that_lack)
{
    const double scale = 500, densest = 100;
    for (double raised = 1; raised < 100; raised *= 1.7)
        for (double tone = 0.125; tone <= 0.5; tone += 0.125) {
            double covered = 0;
            for (double threshold = 0.05; threshold < 4000; threshold += 0.1)
                covered += 0.1 *
                           hatch_stroke_width_px(&pen, tone, threshold < densest ? threshold : raised * threshold,
                                                 scale, densest, raised, 1) /
                           scale;
            ck_assert_double_eq_tol(covered, tone, 0.002);
        }
}
END_TEST

START_TEST(a_stroke_gets_wider_with_the_tone_and_ends_below_its_threshold)
{
    double before = 0;
    for (double tone = 0; tone <= 1; tone += 0.01) {
        double width = hatch_stroke_width_px(&pen, tone, 50, 300, 1e6, HUGE_VAL, 1);
        ck_assert_double_ge(width, before);
        ck_assert_double_le(width, hatch_stroke_whole_px(&pen, tone) + 1e-12);
        before = width;
    }
    ck_assert(hatch_stroke_width_px(&pen, 0.1, 1000, 300, 1e6, HUGE_VAL, 1) <= 0);
    ck_assert_double_eq_tol(hatch_stroke_width_px(&pen, 0.5, 1, 300, 1e6, HUGE_VAL, 1), 2, 1e-12);
    ck_assert_double_eq_tol(hatch_stroke_width_px(&pen, 0.5, 1, 300, 30, HUGE_VAL, 1), 2 * HATCH_STROKE_WIDEST, 1e-12);
}
END_TEST

/* When a hundredth more strokes are wanted, no stroke gets wider by more than a hundredth of its whole width, so that
 * strokes do not flicker where the scale changes fast. */
START_TEST(no_width_changes_faster_than_what_is_wanted)
{
    const double step = 1.01;
    for (double ratio = 0.3; ratio < 3; ratio *= 1.003) {
        double change = hatch_stroke_share(step * ratio) - hatch_stroke_share(ratio);
        ck_assert_double_ge(change, 0);
        ck_assert_double_le(change, step * log(step));
    }
}
END_TEST

START_TEST(strokes_at_grazing_angles_are_denser)
{
    const double grazing = HATCH_STROKE_GRAZING, facing = 300;
    double before = 0;
    for (double scale = 1e-3; scale <= facing; scale *= 1.01) {
        double dense = scale * hatch_stroke_grazing(scale, facing, grazing);
        ck_assert_double_ge(dense, before * (1 - 1e-12)); /* they never get fewer where more are in sight */
        ck_assert_double_ge(dense * (1 + 1e-12), fmax(scale, grazing * facing)); /* the fourth powers add up: */
        ck_assert_double_eq_tol(pow(dense, 4), pow(scale, 4) + pow(grazing * facing, 4), 1e-9 * pow(facing, 4));
        before = dense;
    }
    ck_assert_double_eq_tol(hatch_stroke_grazing(facing, facing, grazing), 1, 0.011);
    ck_assert_double_eq_tol(hatch_stroke_grazing(5, facing, 0), 1, 1e-15);
    ck_assert(isfinite(hatch_stroke_grazing(0, facing, grazing)));
}
END_TEST

static Suite *suite(void)
{
    Suite *made = suite_create("width");
    TCase *tests = tcase_create("width");
    tcase_add_test(tests, families_make_the_ink_together);
    tcase_add_test(tests, strokes_of_all_thresholds_cover_the_tone);
    tcase_add_test(tests, levels_that_halve_gaps_cover_the_tone_evenly);
    tcase_add_test(tests, wider_strokes_make_up_for_those_that_lack);
    tcase_add_test(tests, a_stroke_gets_wider_with_the_tone_and_ends_below_its_threshold);
    tcase_add_test(tests, no_width_changes_faster_than_what_is_wanted);
    tcase_add_test(tests, strokes_at_grazing_angles_are_denser);
    suite_add_tcase(made, tests);
    return made;
}

HATCH_TEST_MAIN(suite)
