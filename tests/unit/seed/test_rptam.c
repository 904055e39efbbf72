/* The model of recursive maps and its coverage lists when memory runs out, and the variants of strokes. Tones are
 * measured in tests/prop/test_rptam_tone.c. */
#include "arenas.h"
#include "fail_alloc.h"
#include "rptam_ink.h"
#include "rptam_model.h"

static struct hatch_seeds seeds;
static struct hatch_image stroke;

static void begin_seeds(void)
{
    const struct hatch_seeds_options how = {.cycle = {.count = 16, .seed = 1}, .layers = 2, .candidates = 2};
    uint64_t steps;
    begin();
    HATCH_TEST_OK(hatch_seeds_make(&how, &keep, &scratch, &seeds, &steps, &err), &err);
    HATCH_TEST_OK(hatch_image_make(&keep, 16, 4, "A", &stroke, &err), &err);
    for (uint32_t i = 0; i < 16 * 4; i++)
        stroke.pixels[i] = 1;
}

/* Two layers, the second of which begins where the first is complete or later. */
static struct hatch_rptam_style style_of(double second)
{
    struct hatch_rptam_style style = {.overlap = 0.3, .layer_count = 2};
    for (int i = 0; i < 2; i++)
        style.layers[i] = (struct hatch_rptam_layer_style){.low = second * i,
                                                           .high = i ? 1 : 0.5,
                                                           .angle_rad = 0.3 + 1.5 * i,
                                                           .length_px = 10,
                                                           .width_px = 2,
                                                           .tile_px = 32,
                                                           .ink = 1,
                                                           .stroke = &stroke};
    return style;
}

static enum hatch_status make_model(void *context, struct hatch_arena *to, struct hatch_arena *temporary,
                                    struct hatch_err *error)
{
    struct hatch_rptam_style style = style_of(0.5);
    return hatch_rptam_make(&seeds, &style, to, temporary, context, error);
}

static enum hatch_status make_coverage(void *context, struct hatch_arena *to, struct hatch_arena *temporary,
                                       struct hatch_err *error)
{
    static const struct hatch_coverage_stroke shape = {0.3, 0.05, 0.8, 0.6};
    struct hatch_seed_point *points = HATCH_NEW(to, struct hatch_seed_point, 16, error);
    if (!points)
        return HATCH_LIMIT;
    (void)temporary;
    return hatch_coverage_make(points, 16, &shape, 8, to, context, error);
}

START_TEST(every_failed_allocation_is_a_status)
{
    struct hatch_rptam rptam = {.layer_count = 7};
    struct hatch_coverage coverage = {.side = 7};
    ck_assert_uint_gt(hatch_test_fail_alloc(make_model, &rptam, &rptam, sizeof rptam), 4);
    ck_assert_uint_eq(rptam.layer_count, 2);
    hatch_test_fail_alloc(make_coverage, &coverage, &coverage, sizeof coverage);
    ck_assert_uint_eq(coverage.side, 8);
}
END_TEST

/* Nothing is drawn between the end of the first layer and the beginning of the second: no tone lies there. */
START_TEST(tones_lie_within_layers)
{
    struct hatch_rptam_style style = style_of(0.75);
    struct hatch_rptam rptam;
    uint32_t in_first = 0;
    HATCH_TEST_OK(hatch_rptam_make(&seeds, &style, &keep, &scratch, &rptam, &err), &err);
    for (uint32_t step = 0; step <= HATCH_RPTAM_TONE_STEPS; step++) {
        bool first = rptam.progress[step] <= 0.5 + 1e-9;
        ck_assert(first || rptam.progress[step] >= 0.75 - 1e-9);
        in_first += first;
    }
    ck_assert(in_first > HATCH_RPTAM_TONE_STEPS / 4 && in_first < HATCH_RPTAM_TONE_STEPS);
}
END_TEST

/* Strokes do not change at a nesting level, where the seed points are renumbered. */
START_TEST(a_stroke_keeps_its_variant_over_levels)
{
    const struct model_how how = {.tile_px = 50, .length_px = 20, .width_px = 8, .varied = true, .seeds = (uint32_t)_i};
    struct hatch_rptam rptam;
    double worst = 0;
    model_make(&how, &keep, &scratch, &rptam);
    for (int level = -3; level <= 3; level++)
        for (uint32_t i = 0; i < 2000; i++) {
            const double uv[2] = {(double)hatch_random_unit(1, 0, i), (double)hatch_random_unit(1, 1, i)};
            double before = rptam_layer_ink(&rptam, 0, uv, level - 1e-9, 1, false);
            worst = fmax(worst, fabs(before - rptam_layer_ink(&rptam, 0, uv, level + 1e-9, 1, false)));
        }
    ck_assert_double_lt(worst, 1e-3);
}
END_TEST

/* Of 64 separate strokes in one tile only a few look the same. */
START_TEST(strokes_differ)
{
    enum { POSITIONS = 15 };
    const struct model_how how = {.tile_px = 4000, .length_px = 20, .width_px = 8, .varied = true};
    struct hatch_rptam rptam;
    double ink[64][POSITIONS];
    model_make(&how, &keep, &scratch, &rptam);
    for (uint32_t seed = 0; seed < 64; seed++)
        for (int i = 0; i < POSITIONS; i++) {
            const double uv[2] = {rptam.layers[0].positions[seed][0] + (i % 5 - 2) * 0.0007,
                                  rptam.layers[0].positions[seed][1] + (i / 5 - 1) * 0.0005};
            ink[seed][i] = rptam_layer_ink(&rptam, 0, uv, 0, 1, false);
        }
    for (uint32_t seed = 0; seed < 64; seed++) {
        uint32_t alike = 0;
        for (uint32_t other = 0; other < 64; other++) {
            double worst = 0;
            for (int i = 0; i < POSITIONS; i++)
                worst = fmax(worst, fabs(ink[seed][i] - ink[other][i]));
            alike += worst < 0.02;
        }
        ck_assert_uint_le(alike, 6);
    }
}
END_TEST

/* Without grain all strokes share one image. Each texel is the mean of the texels under it, here two by two, and the
 * border is paper. */
START_TEST(images_of_strokes_are_box_filtered)
{
    float pixels[32];
    for (int i = 0; i < 32; i++)
        pixels[i] = (float)(i * i % 32) / 31;
    const struct hatch_image from = {.width = 8, .height = 4, .channel_count = 1, .pixels = pixels};
    const struct hatch_rptam_layer_style style = {.stroke = &from, .length_px = 2, .width_px = 1, .varied = true};
    struct hatch_image made;
    uint32_t images;
    HATCH_TEST_OK(hatch_rptam_stroke_images(&style, &keep, &scratch, &made, &images, &err), &err);
    ck_assert(images == 1 && made.width == 6 && made.height == 4);
    for (int y = -1; y < 3; y++)
        for (int x = -1; x < 5; x++) {
            double sum = 0;
            for (int i = 0; i < 4 && y >= 0 && y < 2 && x >= 0 && x < 4; i++)
                sum += (double)pixels[8 * (2 * y + i / 2) + 2 * x + i % 2];
            ck_assert_double_eq_tol((double)made.pixels[6 * (y + 1) + x + 1], sum / 4, 0.5001 / 255);
        }
}
END_TEST

static Suite *suite(void)
{
    Suite *suite = suite_create("recursive maps");
    TCase *tests = tcase_create("memory");
    tcase_add_checked_fixture(tests, begin_seeds, end);
    tcase_add_test(tests, every_failed_allocation_is_a_status);
    tcase_add_test(tests, tones_lie_within_layers);
    tcase_add_test(tests, images_of_strokes_are_box_filtered);
    tcase_add_loop_test(tests, a_stroke_keeps_its_variant_over_levels, 2, 40);
    tcase_add_test(tests, strokes_differ);
    suite_add_tcase(suite, tests);
    return suite;
}

HATCH_TEST_MAIN(suite)
