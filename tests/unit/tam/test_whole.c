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

START_TEST(thresholds_of_few_bins_are_the_same_in_two_layers)
{
    struct hatch_tam tam = made_map(64, 24, 1, "Y", ramp);
    const struct hatch_threshold_options how = {.bins = 4, .seed = 1};
    struct hatch_thresholds made, got;
    const char *const keys[] = {HATCH_TAM_ATTR_LEVELS, "1", HATCH_THRESHOLD_KEY_BORDERS, "0 0.2 0.4 0.6 1", NULL};
    const char *const more[] = {HATCH_TAM_ATTR_LEVELS, "1", HATCH_THRESHOLD_KEY_BORDERS, "0 0.2 0.4 0.6 0.8 1", NULL};
    float before[11];
    HATCH_TEST_OK(hatch_thresholds_make(&tam, &how, NULL, &map_arena, &map_scratch, &made, &map_err), &map_err);
    for (int i = 0; i <= 10; i++)
        before[i] = hatch_thresholds_sample(&made, 0.37f, 0.81f, (float)i / 10, 0.4f);
    hatch_thresholds_pack(&made);
    ck_assert_uint_eq(made.texels.layers, 2);
    HATCH_TEST_OK(hatch_thresholds_from_texels(&made.texels, keys, &got, &map_err), &map_err);
    for (int i = 0; i <= 10; i++)
        ck_assert_float_eq_tol(hatch_thresholds_sample(&got, 0.37f, 0.81f, (float)i / 10, 0.4f), before[i], 1e-6f);
    ck_assert_int_eq(hatch_thresholds_from_texels(&made.texels, more, &got, &map_err), HATCH_BAD_INPUT);
}
END_TEST

static Suite *suite(void)
{
    Suite *suite = suite_create("tam whole");
    TCase *tests = tcase_create("whole");
    tcase_add_checked_fixture(tests, map_begin, map_end);
    tcase_add_test(tests, a_cut_map_names_the_whole);
    tcase_add_test(tests, its_keys_are_read_as_they_were_printed);
    tcase_add_loop_test(tests, a_volume_of_a_cut_map_has_the_first_slices_of_the_whole, 0, 2);
    tcase_add_test(tests, thresholds_of_few_bins_are_the_same_in_two_layers);
    suite_add_tcase(suite, tests);
    return suite;
}
HATCH_TEST_MAIN(suite)
