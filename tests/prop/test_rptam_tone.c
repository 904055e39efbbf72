/* The tone of recursive procedural tonal art maps over an octave of zoom, in doubles. */
#include "arenas.h"

#include <math.h>

#include "seed/rptam.h"
#include "seed/spread.h"

static struct hatch_rptam rptam;

static void make_model(enum hatch_fade_law law, bool fade_size, double overlap)
{
    const struct hatch_seeds_options how = {
        .cycle = {.count = 64, .seed = 1}, .layers = 4, .candidates = 50};
    const struct hatch_rptam_style style = {.tile_px = 256,
                                            .length_px = 80,
                                            .width_px = 3,
                                            .angle_rad = {0, 1.5, 0.4, 2},
                                            .ink = 1,
                                            .law = law,
                                            .fade_size = fade_size,
                                            .overlap = overlap,
                                            .tone_overlap = 0.3};
    struct hatch_seeds seeds;
    struct hatch_image stroke;
    uint64_t steps;
    HATCH_TEST_OK(hatch_seeds_make(&how, &keep, &scratch, &seeds, &steps, &err), &err);
    HATCH_TEST_OK(hatch_image_make(&keep, 1, 1, "A", &stroke, &err), &err);
    stroke.pixels[0] = 1;
    HATCH_TEST_OK(hatch_rptam_make(&seeds, &style, &stroke, &keep, &scratch, &rptam, &err), &err);
}

static double mean_ink(double depth, double tone)
{
    enum { SIDE = 400 };
    double amounts[HATCH_RPTAM_LAYERS_MAX], sum = 0;
    hatch_rptam_amounts(&rptam, tone, amounts);
    for (int i = 0; i < SIDE * SIDE; i++) { /* two dense tiles each way: one sparse one */
        const double uv[2] = {2 * (i % SIDE + 0.5) / SIDE, 2 * (i / SIDE + 0.5) / SIDE};
        sum += hatch_rptam_ink(&rptam, uv, depth, amounts, false);
    }
    return sum / (SIDE * SIDE);
}

/* The largest difference from the tone at depth 0 over the octave. */
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
} modes[] = {{HATCH_FADE_EVEN, false, 1},   {HATCH_FADE_EVEN, true, 1}, {HATCH_FADE_EVEN, false, 0.3},
             {HATCH_FADE_EVEN, true, 0.3}, {HATCH_FADE_EVEN, false, 0}};

START_TEST(the_even_law_holds_the_tone_in_every_mode)
{
    make_model(modes[_i].law, modes[_i].size, modes[_i].overlap);
    for (int tone = 1; tone <= 5; tone += 2) {
        double most = drift(0.1 * tone);
        ck_assert_msg(most <= 0.01, "tone %.1f: %.4f", 0.1 * tone, most);
        ck_assert_double_eq_tol(mean_ink(0, 0.1 * tone), 0.1 * tone, 0.01);
    }
}
END_TEST

START_TEST(the_linear_law_does_not)
{
    make_model(HATCH_FADE_PAPER, false, 1);
    ck_assert_double_gt(drift(0.4), 0.05);
}
END_TEST

/* Over a one-way zoom out no stroke comes: ink at the middle of every seed's stroke never rises while
 * the pattern keeps its place. */
START_TEST(strokes_only_go_while_the_view_goes_out)
{
    double amounts[HATCH_RPTAM_LAYERS_MAX] = {1};
    make_model(HATCH_FADE_EVEN, false, 0.3);
    rptam.layer_count = 1;
    const struct hatch_rptam_layer *layer = &rptam.layers[0];
    uint32_t gone = 0;
    for (uint32_t i = 0; i < layer->count; i++) {
        const double uv[2] = {(double)layer->places[i].u * 0x1p-64, (double)layer->places[i].v * 0x1p-64};
        uint8_t tile = 0; /* the pattern around the origin */
        double begin = hatch_rptam_ink(&rptam, uv, 0, amounts, true);
        double end = hatch_rptam_ink(&rptam, uv, 0.999999, amounts, true);
        ck_assert_double_gt(begin, 0.999);
        if (layer->stays_in[i] == tile)
            ck_assert_double_gt(end, 0.999);
        gone += end < 0.5;
    }
    ck_assert_uint_gt(gone, layer->count / 3);
}
END_TEST

/* Zooming by 2^n changes nothing where the place is at the origin's image, through 40 octaves. */
START_TEST(forty_octaves_look_alike)
{
    double amounts[HATCH_RPTAM_LAYERS_MAX] = {1, 1, 0.5, 0};
    make_model(HATCH_FADE_EVEN, false, 0.3);
    for (int i = 0; i < 50; i++)
        for (int octave = -40; octave <= 40; octave += 5) {
            const double at[2] = {0.013 * i, 0.7 - 0.009 * i};
            const double uv[2] = {ldexp(at[0], octave), ldexp(at[1], octave)};
            ck_assert_double_eq_tol(hatch_rptam_ink(&rptam, uv, octave + 0.4, amounts, false),
                                    hatch_rptam_ink(&rptam, at, 0.4, amounts, true), 1e-9);
        }
}
END_TEST

static Suite *suite(void)
{
    Suite *suite = suite_create("rptam tone");
    TCase *tests = tcase_create("tone");
    tcase_add_checked_fixture(tests, begin, end);
    tcase_add_loop_test(tests, the_even_law_holds_the_tone_in_every_mode, 0, 5);
    tcase_add_test(tests, the_linear_law_does_not);
    tcase_add_test(tests, strokes_only_go_while_the_view_goes_out);
    tcase_add_test(tests, forty_octaves_look_alike);
    suite_add_tcase(suite, tests);
    return suite;
}

HATCH_TEST_MAIN(suite)
