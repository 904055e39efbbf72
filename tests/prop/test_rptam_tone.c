/* The tone of recursive procedural tonal art maps over an octave of zoom, in doubles. */
#include "arenas.h"
#include "rptam_ink.h"

#include <math.h>

#include "seed/rptam.h"
#include "seed/seeds_make.h"

static struct hatch_rptam rptam;

/* Makes a model of four layers.
 *   px  length and width of strokes, and side of a tile */
static void make_strokes(const struct hatch_rptam_style *like, const double px[3])
{
    static const double angles_rad[4] = {0, 1.5, 0.4, 2};
    const struct hatch_seeds_options how = {.cycle = {.count = 64, .seed = 1}, .layers = 4, .candidates = 50};
    struct hatch_rptam_style style = *like;
    struct hatch_seeds seeds;
    struct hatch_image stroke;
    uint64_t steps;
    HATCH_TEST_OK(hatch_seeds_make(&how, &keep, &scratch, &seeds, &steps, &err), &err);
    HATCH_TEST_OK(hatch_image_make(&keep, 1, 1, "A", &stroke, &err), &err);
    stroke.pixels[0] = 1;
    for (uint32_t i = 0; i < 4; i++)
        style.layers[i] = (struct hatch_rptam_layer_style){.low = i / 4.0,
                                                           .high = (i + 1) / 4.0,
                                                           .angle_rad = angles_rad[i],
                                                           .length_px = px[0],
                                                           .width_px = px[1],
                                                           .tile_px = px[2],
                                                           .ink = 1,
                                                           .stroke = &stroke};
    HATCH_TEST_OK(hatch_rptam_make(&seeds, &style, &keep, &scratch, &rptam, &err), &err);
}

static void make_model(enum hatch_fade_law law, bool fade_size, double overlap)
{
    const struct hatch_rptam_style style = {.law = law, .fade_size = fade_size, .overlap = overlap, .layer_count = 4};
    make_strokes(&style, (const double[]){80, 3, 256});
}

static double mean_ink(double depth, double tone)
{
    enum { POINTS = 121393, STRIDE = 75025 }; /* Fibonacci lattice: no rows that strokes could fall between */
    double amounts[HATCH_RPTAM_LAYERS_MAX], sum = 0;
    struct hatch_rptam_pattern patterns[4];
    rptam_amounts(&rptam, tone, amounts);
    for (uint32_t k = 0; k < 4; k++)
        hatch_rptam_pattern_make(&rptam, k, depth, amounts[k], false, &patterns[k]);
    for (uint64_t i = 0; i < POINTS; i++) { /* four dense tiles each way */
        const double uv[2] = {4 * ((double)i + 0.5) / POINTS, 4 * (double)(i * STRIDE % POINTS) / POINTS};
        double left = 1;
        for (uint32_t k = 0; k < 4; k++)
            left *= hatch_rptam_transmittance(&patterns[k], uv);
        sum += 1 - left;
    }
    return sum / POINTS;
}

/* The largest difference from the tone at depth 0 over an octave. */
static double drift(double tone)
{
    double begin = mean_ink(0, tone), most = 0;
    for (int i = 1; i <= 4; i++)
        most = fmax(most, fabs(mean_ink(i / 4.0, tone) - begin));
    return most;
}

static const struct {
    enum hatch_fade_law law;
    bool size;
    double overlap;
} modes[] = {{HATCH_FADE_EVEN, false, 1},      {HATCH_FADE_EVEN, true, 1},      {HATCH_FADE_EVEN, false, 0.3},
             {HATCH_FADE_EVEN, true, 0.3},     {HATCH_FADE_EVEN, false, 0},     {HATCH_FADE_WEIGHTED, false, 0.3},
             {HATCH_FADE_WEIGHTED, true, 0.3}, {HATCH_FADE_WEIGHTED, false, 1}, {HATCH_FADE_WEIGHTED, true, 0}};
enum { MODES = sizeof modes / sizeof *modes };

START_TEST(zooming_keeps_the_tone_in_every_fade_mode)
{
    make_model(modes[_i].law, modes[_i].size, modes[_i].overlap);
    for (int tone = 1; tone <= 5; tone += 2) {
        double most = drift(0.1 * tone);
        ck_assert_msg(most <= 0.01, "tone %.1f: %.4f", 0.1 * tone, most);
        ck_assert_double_eq_tol(mean_ink(0, 0.1 * tone), fmin(0.1 * tone, rptam.darkest), 0.01);
    }
}
END_TEST

START_TEST(zooming_changes_the_tone_with_the_fade_law_paper)
{
    make_model(HATCH_FADE_PAPER, false, 1);
    ck_assert_double_gt(drift(0.4), 0.05);
}
END_TEST

/* Each layer of such strokes would cover a point 64 times, so that the first one nearly makes all tones. */
START_TEST(strokes_that_overlap_much_have_their_tones)
{
    const struct hatch_rptam_style style = {.overlap = 1, .layer_count = 4};
    make_strokes(&style, (const double[]){8, 8, 8});
    for (double tone = 0.1; tone < 0.95; tone += 0.1)
        ck_assert_double_eq_tol(mean_ink(0, tone), tone, 0.03);
}
END_TEST

/* While zooming out and towards lighter tones, the ink at the centres of strokes never increases. */
START_TEST(no_stroke_appears_while_zooming_out)
{
    make_model(modes[_i].law, modes[_i].size, modes[_i].overlap);
    const struct hatch_rptam_layer *layer = &rptam.layers[0];
    rptam.layers[0].style.length_px = rptam.layers[0].style.width_px = 0.5; /* too small to overlap */
    uint32_t gone = 0, stayed = 0;
    for (uint32_t i = 0; i < 16 * layer->count; i++) {
        const double uv[2] = {(double)layer->points[i / 16].u * 0x1p-64 + i % 4,
                              (double)layer->points[i / 16].v * 0x1p-64 + i / 4 % 4};
        double last = 1, ink = 1;
        for (int step = 0; step <= 40; step++, last = ink) {
            ink = rptam_layer_ink(&rptam, 0, uv, step / 20.0, exp2(-step / 40.0), true);
            ck_assert_msg(ink <= last + 1e-9, "stroke %u, step %d: %g after %g", i, step, ink, last);
        }
        gone += ink < 0.01;
        stayed += ink > 0.99;
    }
    ck_assert_uint_gt(gone, 10 * layer->count);
    ck_assert_uint_gt(stayed, 0);
}
END_TEST

/* Scaling texture coordinates by 2^n and adding n to the depth changes nothing, over 40 octaves each way. */
START_TEST(patterns_repeat_over_forty_octaves)
{
    double amounts[HATCH_RPTAM_LAYERS_MAX] = {1, 1, 0.5, 0};
    make_model(HATCH_FADE_EVEN, false, 0.3);
    for (int i = 0; i < 50; i++)
        for (int octave = -40; octave <= 40; octave += 5) {
            const double at[2] = {0.013 * i, 0.7 - 0.009 * i};
            const double uv[2] = {ldexp(at[0], octave), ldexp(at[1], octave)};
            ck_assert_double_eq_tol(rptam_ink(&rptam, uv, octave + 0.4, amounts, false),
                                    rptam_ink(&rptam, at, 0.4, amounts, true), 1e-9);
        }
}
END_TEST

static Suite *suite(void)
{
    Suite *suite = suite_create("rptam tone");
    TCase *tests = tcase_create("tone");
    tcase_add_checked_fixture(tests, begin, end);
    tcase_add_loop_test(tests, zooming_keeps_the_tone_in_every_fade_mode, 0, MODES);
    tcase_add_test(tests, zooming_changes_the_tone_with_the_fade_law_paper);
    tcase_add_test(tests, strokes_that_overlap_much_have_their_tones);
    tcase_add_loop_test(tests, no_stroke_appears_while_zooming_out, 0, MODES);
    tcase_add_test(tests, patterns_repeat_over_forty_octaves);
    suite_add_tcase(suite, tests);
    return suite;
}

HATCH_TEST_MAIN(suite)
