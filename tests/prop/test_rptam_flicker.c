/* Flicker in a zoom by one octave in 120 frames, in doubles: no more than that of a fixed texture plus that of the
 * strokes that must appear to keep their density. */
#include "arenas.h"
#include "rptam_ink.h"
#include "rptam_model.h"

enum { SIZE = 90, FRAMES = 120, SHOWN = 48 };

static struct hatch_rptam rptam;
static double frames[3][SIZE * SIZE];

/* Draws frame t of the zoom towards a position that is no corner of a tile; returns the mean ink.
 *   fixed  the strokes of the middle frame scale with the surface */
static double draw(int t, bool fixed, double amount, double *picture)
{
    double depth = 0.2 - (double)t / FRAMES, span = SIZE / rptam.layers[0].style.tile_px * exp2(depth), sum = 0;
    for (int i = 0; i < SIZE * SIZE; i++) {
        double x = (i % SIZE + 0.5) / SIZE - 0.5, y = (i / SIZE + 0.5) / SIZE - 0.5;
        const double uv[2] = {0.37 + span * x, 0.71 + span * y};
        picture[i] = rptam_layer_ink(&rptam, 0, uv, fixed ? 0.2 - 0.5 * SHOWN / FRAMES : depth, amount, false);
        sum += picture[i];
    }
    return sum / (SIZE * SIZE);
}

/* Returns the flicker as hatchstat frames defines it: the mean of |I(t - 1) - 2 I(t) + I(t + 1)|. */
static double pop(bool fixed, double amount, double *tone)
{
    double sum = 0;
    *tone = 0;
    for (int t = 0; t < SHOWN; t++) {
        double *now = frames[t % 3], *before = frames[(t + 2) % 3], *first = frames[(t + 1) % 3];
        *tone += draw(t, fixed, amount, now) / SHOWN;
        for (int i = 0; t > 1 && i < SIZE * SIZE; i++)
            sum += fabs(first[i] - 2 * before[i] + now[i]);
    }
    return sum / (SHOWN - 2) / (SIZE * SIZE);
}

static const struct {
    enum hatch_fade_law law;
    bool size;
    double overlap;
} fades[] = {{HATCH_FADE_EVEN, false, 0},   {HATCH_FADE_EVEN, false, 0.3}, {HATCH_FADE_EVEN, false, 1},
             {HATCH_FADE_EVEN, true, 0.3},  {HATCH_FADE_PAPER, false, 1},  {HATCH_FADE_WEIGHTED, false, 0.3},
             {HATCH_FADE_WEIGHTED, true, 1}};
enum { FADES = sizeof fades / sizeof *fades };

static const double amounts[] = {1, 0.5, 0.2};
enum { AMOUNTS = sizeof amounts / sizeof *amounts };

START_TEST(a_zoom_flickers_no_more_than_a_texture_plus_new_strokes)
{
    struct model_how how = {.seeds = 64, .tile_px = 60, .length_px = 14, .width_px = 2, .angle_rad = {0.5}};
    double tone, fixed_tone, amount = amounts[_i / FADES];
    how.law = fades[_i % FADES].law;
    how.fade_size = fades[_i % FADES].size;
    how.overlap = fades[_i % FADES].overlap;
    model_make(&how, &keep, &scratch, &rptam);
    double texture = pop(true, amount, &fixed_tone), strokes = pop(false, amount, &tone);
    /* Each frame adds 4^(1/120) - 1 of the ink, and a sudden change counts twice. The number of strokes that appear in
     * the measured frames is random: allow two standard deviations. */
    double share = exp2(2.0 / FRAMES) - 1, tiles = SIZE / rptam.layers[0].style.tile_px;
    double coming = SHOWN * share * how.seeds * amount * tiles * tiles;
    double must = 2 * tone * share * (1 + 2 / sqrt(coming));
    ck_assert_double_gt(tone, 0.02);
    ck_assert_double_gt(texture, 0.001);
    ck_assert_msg(strokes <= texture + must, "%.5f, a texture %.5f, what must come %.5f", strokes, texture, must);
}
END_TEST

static Suite *suite(void)
{
    Suite *suite = suite_create("rptam flicker");
    TCase *tests = tcase_create("flicker");
    tcase_add_checked_fixture(tests, begin, end);
    tcase_add_loop_test(tests, a_zoom_flickers_no_more_than_a_texture_plus_new_strokes, 0, FADES * AMOUNTS);
    suite_add_tcase(suite, tests);
    return suite;
}

HATCH_TEST_MAIN(suite)
