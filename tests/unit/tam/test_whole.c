/* Maps of which a part was made, and the textures made from them. */
#include "tam_made.h"

#include <math.h>
#include <stdio.h>

#include "tam/thresholds.h"
#include "tam/volume.h"
#include "tam/whole.h"

static float ramp(float u, float v, uint32_t level, float tone, uint32_t channel)
{
    (void)channel;
    return 1 - tone * (0.5f + 0.5f * u) * (0.5f + 0.5f * v) / (1 + 0.01f * (float)level);
}

static struct hatch_volume make(const struct hatch_tam *tam, enum hatch_volume_layout layout)
{
    struct hatch_volume volume;
    struct hatch_volume_figures figures;
    const struct hatch_volume_options how = {32, layout, false};
    HATCH_TEST_OK(hatch_volume_make(tam, &how, NULL, &map_arena, &volume, &figures, &map_err), &map_err);
    return volume;
}

START_TEST(a_cut_map_names_the_whole)
{
    struct hatch_tam tam = made_map(256, 16, 1, "Y", ramp);
    tam.whole = (struct hatch_tam_whole){256, 16, tam.target[15], 0};
    ck_assert(hatch_tam_is_whole(&tam));
    hatch_tam_cut(&tam, 5, 2, 0.02);
    ck_assert(!hatch_tam_is_whole(&tam));
    ck_assert_uint_eq(tam.tones, 5);
    ck_assert_uint_eq(tam.size_px, 64);
    ck_assert_uint_eq(tam.levels, 2);
    ck_assert_uint_eq(tam.columns[4].levels[0].width, 64);
    ck_assert_uint_eq(tam.whole.size_px, 256);
    ck_assert_float_eq_tol(tam.whole.darkest, tam.target[15], 1e-6f);
}
END_TEST

START_TEST(its_keys_are_read_as_they_were_printed)
{
    struct hatch_tam tam = made_map(256, 16, 1, "Y", ramp);
    struct hatch_tam_whole_keys keys;
    struct hatch_tam_whole whole;
    float last = -1;
    tam.whole = (struct hatch_tam_whole){256, 16, tam.target[15], 0};
    hatch_tam_whole_print(&tam, &keys);
    ck_assert_ptr_null(keys.pairs[0]);
    HATCH_TEST_OK(hatch_tam_whole_read(keys.pairs, 256, &whole, &last, &map_err), &map_err);
    ck_assert(whole.tolerance <= 0 && last < 0);
    ck_assert_uint_eq(whole.size_px, 256);
    hatch_tam_cut(&tam, 5, 1, 0.02);
    hatch_tam_whole_print(&tam, &keys);
    HATCH_TEST_OK(hatch_tam_whole_read(keys.pairs, 128, &whole, &last, &map_err), &map_err);
    ck_assert_uint_eq(whole.size_px, 256);
    ck_assert_float_eq_tol(whole.tolerance, 0.02f, 1e-9f);
    ck_assert_float_eq_tol(whole.darkest, tam.target[15], 1e-6f);
    ck_assert_float_eq_tol(last, tam.target[4], 1e-6f);
    ck_assert_int_eq(hatch_tam_whole_read(keys.pairs, 512, &whole, &last, &map_err), HATCH_BAD_INPUT);
    for (int i = 1; i < 8; i += 2) {
        const char *good = keys.pairs[i];
        keys.pairs[i] = "nan";
        ck_assert_int_eq(hatch_tam_whole_read(keys.pairs, 128, &whole, &last, &map_err), HATCH_BAD_INPUT);
        keys.pairs[i] = good;
    }
}
END_TEST

/* Up to the last column's tone, less half a slice, both volumes are the same. */
START_TEST(a_volume_of_a_cut_map_has_the_first_slices_of_the_whole)
{
    const enum hatch_volume_layout layout = _i ? HATCH_VOLUME_ARRAY : HATCH_VOLUME_3D;
    struct hatch_tam tam = made_map(64, 64, 1, "Y", ramp), part;
    tam.whole = (struct hatch_tam_whole){64, 64, tam.target[63], 0};
    part = tam;
    hatch_tam_cut(&part, 20, 0, 0.02);
    struct hatch_volume whole = make(&tam, layout), cut = make(&part, layout);
    uint32_t all = _i ? whole.texels.layers : whole.texels.depth, few = _i ? cut.texels.layers : cut.texels.depth;
    ck_assert_uint_eq(all, 32);
    ck_assert_uint_eq(few, _i ? 11 : 12); /* of 20 of 64 tones; in three dimensions for two drawn levels */
    ck_assert_float_eq_tol(cut.top, (float)few / 32, 1e-6f);
    for (float tone = 0; tone < 0.28f; tone += 0.03f)
        for (float lod = 0; lod < 1.1f; lod += 0.5f) {
            float value[2];
            hatch_volume_sample(&whole, 0.3f, 0.7f, tone, lod, true, &value[0]);
            hatch_volume_sample(&cut, 0.3f, 0.7f, tone, lod, true, &value[1]);
            ck_assert_float_eq_tol(value[0], value[1], 0.0021f);
        }
}
END_TEST

static const char *const few_keys[] = {HATCH_TAM_ATTR_LEVELS, "1", HATCH_THRESHOLD_KEY_BORDERS, "0 0.2 0.4 0.6 1",
                                       NULL};

START_TEST(thresholds_of_few_bins_are_the_same_in_two_layers)
{
    struct hatch_tam tam = made_map(64, 24, 1, "Y", ramp);
    const struct hatch_threshold_options how = {.bins = 4, .seed = 1};
    struct hatch_thresholds made, got;
    const char *const more[] = {HATCH_TAM_ATTR_LEVELS, "1", HATCH_THRESHOLD_KEY_BORDERS, "0 0.2 0.4 0.6 0.8 1", NULL};
    float before[11];
    HATCH_TEST_OK(hatch_thresholds_make(&tam, &how, NULL, &map_arena, &map_scratch, &made, &map_err), &map_err);
    for (int i = 0; i <= 10; i++)
        before[i] = hatch_thresholds_sample(&made, 0.37f, 0.81f, (float)i / 10, 0.4f);
    hatch_thresholds_pack(&made);
    ck_assert_uint_eq(made.texels.layers, 2);
    HATCH_TEST_OK(hatch_thresholds_from_texels(&made.texels, few_keys, &got, &map_err), &map_err);
    for (int i = 0; i <= 10; i++)
        ck_assert_float_eq_tol(hatch_thresholds_sample(&got, 0.37f, 0.81f, (float)i / 10, 0.4f), before[i], 1e-6f);
    ck_assert_int_eq(hatch_thresholds_from_texels(&made.texels, more, &got, &map_err), HATCH_BAD_INPUT);
}
END_TEST

/* Blocks hold two values exactly, and of more the least and the greatest. */
START_TEST(compressed_thresholds_are_the_same_but_for_their_blocks)
{
    struct hatch_tam tam = made_map(64, 24, 1, "Y", ramp);
    const struct hatch_threshold_options how = {.bins = 4, .seed = 1};
    struct hatch_thresholds made, got;
    struct hatch_texels packed, texels;
    struct hatch_block_figures figures;
    HATCH_TEST_OK(hatch_thresholds_make(&tam, &how, NULL, &map_arena, &map_scratch, &made, &map_err), &map_err);
    hatch_thresholds_pack(&made);
    HATCH_TEST_OK(hatch_thresholds_compress(&made, NULL, &map_arena, &packed, &figures, &map_err), &map_err);
    ck_assert_uint_eq(packed.layers, 8);
    ck_assert_uint_eq(2 * hatch_texels_level_size(&packed, 0), hatch_texels_level_size(&made.texels, 0));
    HATCH_TEST_OK(hatch_thresholds_decompress(&packed, &map_arena, &texels, &map_err), &map_err);
    HATCH_TEST_OK(hatch_thresholds_from_texels(&texels, few_keys, &got, &map_err), &map_err);
    int most = 0;
    for (size_t i = 0; i < hatch_texels_level_size(&texels, 0); i++) {
        int off = abs(texels.texels[0][i] - made.texels.texels[0][i]);
        most = off > most ? off : most;
    }
    ck_assert_int_eq(most, (int)lround(figures.error_max * 255));
    ck_assert_int_gt(most, 0);
    for (size_t i = 0; i < 4 * (size_t)64 * 64; i++) /* x stays in its bin */
        ck_assert_int_ge(texels.texels[0][i], (int)ceilf(made.border[i % 4] * 255 - 1e-3f));
    HATCH_TEST_OK(hatch_thresholds_decompress(&made.texels, &map_arena, &texels, &map_err), &map_err);
    ck_assert_ptr_eq(texels.texels[0], made.texels.texels[0]);
    packed.layers = 4;
    ck_assert_int_eq(hatch_thresholds_decompress(&packed, &map_arena, &texels, &map_err), HATCH_BAD_INPUT);
}
END_TEST

/* Each channel keeps its place: channel c of the eight is c everywhere. */
START_TEST(channels_of_compressed_thresholds_keep_their_places)
{
    struct hatch_thresholds made = {.texels = {.width = 8, .height = 8, .layers = 2, .channels = 4, .level_count = 4},
                                    .bins = 4};
    struct hatch_texels packed, texels;
    struct hatch_block_figures figures;
    HATCH_TEST_OK(hatch_texels_make(&map_arena, &made.texels, &map_err), &map_err);
    for (uint32_t level = 0; level < 4; level++)
        for (size_t i = 0, count = (size_t)(8 >> level) * (8 >> level); i < 8 * count; i++)
            made.texels.texels[level][i] = (uint8_t)(10 * level + i / (4 * count) * 4 + i % 4);
    HATCH_TEST_OK(hatch_thresholds_compress(&made, NULL, &map_arena, &packed, &figures, &map_err), &map_err);
    ck_assert(figures.error_max <= 0);
    HATCH_TEST_OK(hatch_thresholds_decompress(&packed, &map_arena, &texels, &map_err), &map_err);
    for (uint32_t level = 0; level < 4; level++)
        ck_assert_mem_eq(texels.texels[level], made.texels.texels[level], hatch_texels_level_size(&texels, level));
}
END_TEST

/* Makes a white column of the size of another. */
static struct hatch_mipmap paper_like(const struct hatch_mipmap *column)
{
    struct hatch_mipmap paper = *column;
    paper.levels = HATCH_NEW(&map_arena, struct hatch_image, paper.level_count, &map_err);
    for (uint32_t level = 0; level < paper.level_count; level++) {
        const struct hatch_image *from = &column->levels[level];
        size_t floats = (size_t)from->width * from->height * from->channel_count;
        paper.levels[level] = *from;
        paper.levels[level].pixels = HATCH_NEW(&map_arena, float, floats, &map_err);
        for (size_t i = 0; i < floats; i++)
            paper.levels[level].pixels[i] = 1;
    }
    return paper;
}

/* Values of all sizes in every block of pixels. */
static float mixed(float u, float v, uint32_t level, float tone, uint32_t channel)
{
    double x = 256 * (double)u * 0.75487766625 + 256 * (double)v * 0.56984029099;
    (void)level, (void)tone, (void)channel;
    return (float)(x - floor(x));
}

/* Where all values occur, means stay: the steps are as large as the tolerance allows. */
START_TEST(reflectance_is_rounded_to_steps)
{
    static const struct {
        double tolerance;
        float step;
    } steps[] = {{0.1, 0.125f}, {0.02, 0.125f}, {0.01, 0.125f}, {0.003, 0.03125f}, {1e-5, 0}};
    struct hatch_tam map = made_map(256, 1, 1, "Y", mixed);
    for (size_t k = 0; k < sizeof steps / sizeof *steps; k++) {
        struct hatch_mipmap rounded = paper_like(&map.columns[0]);
        hatch_tam_round(&map.columns[0], 2, steps[k].tolerance, &rounded);
        for (uint32_t level = 0; level < 3; level++) {
            const struct hatch_image *from = &map.columns[0].levels[level], *to = &rounded.levels[level];
            float step = level < 2 ? steps[k].step : 0; /* what is not drawn stays */
            for (size_t i = 0; i < (size_t)from->width * from->height; i++) {
                ck_assert_float_eq_tol(to->pixels[i], from->pixels[i], step / 2 + 1e-6f);
                ck_assert(step <= 0 || fmodf(to->pixels[i], step) <= 0);
            }
        }
    }
}
END_TEST

START_TEST(no_step_exceeds_the_largest)
{
    static const double steps[][2] = {
        {1, 0.125}, {0.0078125, 0.125}, {0.0078, 0.0625}, {0.001, 0x1p-6}, {0x1p-15, 0x1p-11}, {3e-5, 0}, {0, 0}};
    for (size_t k = 0; k < sizeof steps / sizeof *steps; k++)
        ck_assert_double_eq((double)hatch_tam_step_max(steps[k][0]), steps[k][1]);
}
END_TEST

/* Of one grey, rounding changes the mean: its steps are finer. */
START_TEST(one_grey_keeps_its_tone)
{
    struct hatch_tam greys = made_map(64, 13, 1, "Y", made_ramp);
    for (uint32_t column = 0; column < 13; column++) {
        struct hatch_mipmap rounded = paper_like(&greys.columns[column]);
        hatch_tam_round(&greys.columns[column], 1, 0.01, &rounded);
        ck_assert_float_eq_tol(rounded.levels[0].pixels[7], greys.columns[column].levels[0].pixels[7], 0.005f);
    }
}
END_TEST

/* Steps of 8ths, then steps that are finer: 0.91 becomes 0.875, and stays it though 0.91 is nearer to 0.914. */
START_TEST(darker_columns_are_nowhere_lighter)
{
    struct hatch_tam ramps = made_map(64, 1, 1, "RGB", ramp);
    struct hatch_mipmap rounded = paper_like(&ramps.columns[0]);
    float before[3 * 64 * 64];
    hatch_tam_round(&ramps.columns[0], 1, 0.01, &rounded);
    memcpy(before, rounded.levels[0].pixels, sizeof before);
    hatch_tam_round(&ramps.columns[0], 1, 0.001, &rounded);
    uint32_t lower = 0;
    for (size_t i = 0; i < 3 * 64 * 64; i++) {
        float now = rounded.levels[0].pixels[i];
        ck_assert_float_le(now, before[i]);
        lower += now < before[i];
    }
    ck_assert_uint_gt(lower, 64 * 64);
}
END_TEST

static Suite *suite(void)
{
    Suite *suite = suite_create("tam whole");
    TCase *tests = tcase_create("whole");
    tcase_add_checked_fixture(tests, map_begin, map_end);
    tcase_add_test(tests, a_cut_map_names_the_whole);
    tcase_add_test(tests, its_keys_are_read_as_they_were_printed);
    tcase_add_test(tests, reflectance_is_rounded_to_steps);
    tcase_add_test(tests, no_step_exceeds_the_largest);
    tcase_add_test(tests, one_grey_keeps_its_tone);
    tcase_add_test(tests, darker_columns_are_nowhere_lighter);
    tcase_add_loop_test(tests, a_volume_of_a_cut_map_has_the_first_slices_of_the_whole, 0, 2);
    tcase_add_test(tests, thresholds_of_few_bins_are_the_same_in_two_layers);
    tcase_add_test(tests, compressed_thresholds_are_the_same_but_for_their_blocks);
    tcase_add_test(tests, channels_of_compressed_thresholds_keep_their_places);
    suite_add_tcase(suite, tests);
    return suite;
}
HATCH_TEST_MAIN(suite)
