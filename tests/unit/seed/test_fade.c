#include "run.h"

#include <math.h>

#include "seed/fade.h"

/* 4^m (1 + 3 f) / 4 is 1 for every m; with the law of the paper it is 5/4 at m = 1/2. */
START_TEST(the_even_law_keeps_the_ink)
{
    double most = 0;
    for (int i = 0; i <= 100; i++) {
        double m = i / 100.0;
        double even = pow(4, m) * (1 + 3 * hatch_fade_share(HATCH_FADE_EVEN, m)) / 4;
        ck_assert_double_eq_tol(even, 1, 1e-12);
        most = fmax(most, pow(4, m) * (1 + 3 * hatch_fade_share(HATCH_FADE_PAPER, m)) / 4);
    }
    double half = pow(4, 0.5) * (1 + 3 * hatch_fade_share(HATCH_FADE_PAPER, 0.5)) / 4;
    ck_assert_double_eq_tol(half, 1.25, 1e-12);
    ck_assert_double_eq_tol(most, 1.2640, 1e-3);
}
END_TEST

/* The weight of a stroke of a rank when the share f is left. */
static double weight_at(double f, double rank, double overlap)
{
    double m = 1 - log2(1 + 3 * f) / 2;
    struct hatch_fade fade = hatch_fade_at(HATCH_FADE_EVEN, m, overlap);
    return hatch_fade_weight(&fade, 1 - rank, 0);
}

/* The mean of the weights over ranks is f for every overlap; weights are within 0 .. 1 and fall with rank. */
START_TEST(weights_have_the_given_mean)
{
    enum { RANKS = 20000 };
    for (int overlap = 0; overlap <= 10; overlap++)
        for (int step = 0; step <= 20; step++) {
            double f = step / 20.0, sum = 0, last = 1;
            for (int r = 0; r < RANKS; r++) {
                double weight = weight_at(f, (r + 0.5) / RANKS, overlap / 10.0);
                if (!(weight >= 0 && weight <= last))
                    ck_abort_msg("rank %d: %g after %g", r, weight, last);
                last = weight;
                sum += weight;
            }
            ck_assert_double_eq_tol(sum / RANKS, f, 1e-4);
        }
}
END_TEST

START_TEST(strokes_fade_together_or_one_after_the_other)
{
    for (int r = 0; r < 10; r++) {
        double rank = (r + 0.5) / 10;
        ck_assert_double_eq_tol(weight_at(0.37, rank, 1), 0.37, 1e-12);
        ck_assert_double_eq_tol(weight_at(0.4, rank, 0), r < 4 ? 1 : 0, 1e-12);
    }
}
END_TEST

/* At f = 1/2 a share overlap / (1 - overlap) of the ranks is fading. */
START_TEST(overlap_determines_the_share_that_is_fading)
{
    enum { RANKS = 10000 };
    int moving = 0;
    for (int r = 0; r < RANKS; r++) {
        double weight = weight_at(0.5, (r + 0.5) / RANKS, 0.2);
        moving += weight > 0 && weight < 1;
    }
    ck_assert_double_eq_tol(moving / (double)RANKS, 0.25, 0.001); /* 0.2 / (1 - 0.2) of the ranks */
}
END_TEST

static Suite *suite(void)
{
    Suite *suite = suite_create("seed fade");
    TCase *tests = tcase_create("fade");
    tcase_add_test(tests, the_even_law_keeps_the_ink);
    tcase_add_test(tests, weights_have_the_given_mean);
    tcase_add_test(tests, strokes_fade_together_or_one_after_the_other);
    tcase_add_test(tests, overlap_determines_the_share_that_is_fading);
    suite_add_tcase(suite, tests);
    return suite;
}

HATCH_TEST_MAIN(suite)
