#include "tam_made.h"

#include <math.h>

#include "base/random.h"
#include "fail_alloc.h"
#include "tam/volume.h"
#include "tam/whole.h"

static struct hatch_volume volume;
static struct hatch_volume_figures figures;

static void make(const struct hatch_tam *tam, uint32_t tones, enum hatch_volume_layout layout, bool alpha)
{
    const struct hatch_volume_options how = {tones, layout, alpha};
    HATCH_TEST_OK(hatch_volume_make(tam, &how, NULL, &map_arena, &volume, &figures, &map_err), &map_err);
}

/* The first byte of a slice. */
static uint8_t slice(uint32_t level, uint32_t index)
{
    size_t side = hatch_mip_size(volume.texels.width, level);
    return volume.texels.texels[level][index * side * side * volume.texels.channels];
}

static float by_level(float u, float v, uint32_t level, float tone, uint32_t channel)
{
    (void)u, (void)v;
    float value = 1 - tone - 0.02f * (float)level - 0.01f * (float)channel;
    return value > 0 ? value : 0;
}

static float colors(float u, float v, uint32_t level, float tone, uint32_t channel)
{
    (void)level;
    return (1 - tone) * (channel == 0 ? 1 : channel == 1 ? u : v);
}

static float constant(float u, float v, uint32_t level, float tone, uint32_t channel)
{
    (void)u, (void)v, (void)level, (void)tone, (void)channel;
    return 0.6f;
}

static float one_stroke(float u, float v, uint32_t level, float tone, uint32_t channel)
{
    (void)v, (void)level, (void)channel;
    return tone > 0.499f && u > 0.25f && u < 0.5f ? 0 : 1;
}

/* Webb et al. 2002, §3.1: the tones are odd multiples of half the slice spacing, and each is on one level only. */
START_TEST(tones_are_those_of_the_paper)
{
    struct hatch_tam tam = made_map(256, 128, 1, "Y", by_level);
    bool taken[129] = {false};
    make(&tam, 64, HATCH_VOLUME_3D, false);
    ck_assert_uint_eq(volume.texels.depth, 64);
    ck_assert_uint_eq(volume.texels.level_count, 9);
    ck_assert_uint_eq(volume.levels, 4);
    for (uint32_t level = 0; level < 4; level++)
        for (uint32_t k = 0; k < 64u >> level; k++) {
            uint32_t of128 = (2 * k + 1) << level;
            float tone = (float)of128 / 128;
            ck_assert(!taken[of128]);
            taken[of128] = true;
            ck_assert_uint_eq(slice(level, k), hatch_unorm8(by_level(0, 0, level, tone, 0)));
        }
    ck_assert_uint_eq(figures.slices, 64 + 32 + 16 + 8);
    ck_assert_uint_eq(figures.blended, 0);
    ck_assert_double_eq_tol(figures.distance, 0, 1e-6);
}
END_TEST

START_TEST(levels_of_a_volume_are_dense_up_to_four_slices)
{
    const struct hatch_texels thick = {.depth = 31}, layered = {.layers = 4}, thin = {.layers = 3};
    ck_assert_uint_eq(hatch_volume_dense_levels(&thick, 3, 1), 3);
    ck_assert_uint_eq(hatch_volume_dense_levels(&thick, 5, 1), 3);   /* 31, 15, 7 slices */
    ck_assert_uint_eq(hatch_volume_dense_levels(&thick, 5, 0.5), 4); /* the first of 62, 30, 14, 6 slices */
    ck_assert_uint_eq(hatch_volume_dense_levels(&layered, 5, 1), 5);
    ck_assert_uint_eq(hatch_volume_dense_levels(&thin, 5, 1), 0);
}
END_TEST

/* The only slice of a level has the tone in the middle. */
START_TEST(few_slices_have_their_tones_on_all_levels)
{
    struct hatch_tam tam = made_map(256, 128, 1, "Y", by_level);
    for (uint32_t tones = 2; tones <= 8; tones *= 2) {
        make(&tam, tones, HATCH_VOLUME_3D, false);
        for (uint32_t level = 0; level < 4; level++) {
            const uint32_t depth = hatch_mip_size(tones, level);
            for (uint32_t k = 0; k < depth; k++)
                ck_assert_uint_eq(slice(level, k),
                                  hatch_unorm8(by_level(0, 0, level, ((float)k + 0.5f) / (float)depth, 0)));
        }
    }
}
END_TEST

START_TEST(a_ramp_is_reproduced_at_every_position_tone_and_level)
{
    struct hatch_tam tam = made_map(64, 255, 1, "Y", made_ramp);
    make(&tam, 32, _i ? HATCH_VOLUME_ARRAY : HATCH_VOLUME_3D, false);
    for (int i = 0; i <= 100; i++)
        for (int lod = 0; lod <= 12; lod++) {
            float value, tone = (float)i / 100;
            hatch_volume_sample(&volume, 0.013f * (float)i, -0.7f * (float)i, tone, 0.5f * (float)lod, true, &value);
            /* half a step of 8 bits and half a column */
            ck_assert_msg(fabsf(value - (1 - tone)) <= 0.005f, "tone %g lod %g: %g", (double)tone, 0.5 * lod,
                          (double)value);
        }
}
END_TEST

/* On the coarsest level, the only slice is at tone 1/2. Above the darkest tone of a map, its last column remains. Where
 * one slice is darker than that tone and the next is not, tones between them are lighter by up to a quarter of their
 * distance; and means of slices that are cut off are. */
START_TEST(dark_tones_of_a_map_are_held_on_all_levels)
{
    static const float darkests[] = {0.9f, 0.95f, 0.97f};
    for (size_t k = 0; k < sizeof darkests / sizeof *darkests; k++) {
        const float darkest = darkests[k];
        struct hatch_tam tam = made_map(64, 240, darkest, "Y", made_ramp);
        make(&tam, 64, _i ? HATCH_VOLUME_ARRAY : HATCH_VOLUME_3D, false);
        for (int i = 0; i <= 100; i++)
            for (int lod = 0; lod <= 24; lod++) {
                float value, tone = (float)i / 100, want = 1 - fminf(tone, darkest);
                hatch_volume_sample(&volume, 0.3f, 0.4f, tone, 0.25f * (float)lod, true, &value);
                ck_assert_msg(fabsf(value - want) <= (_i ? 0.005f : 0.032f), "darkest %g tone %g lod %g: %g",
                              (double)darkest, (double)tone, 0.25 * lod, (double)value);
            }
    }
}
END_TEST

/* A map without its darkest columns, as one made for needs: its volume has 50 slices, and ends at tone 50/64. */
START_TEST(the_last_tone_of_a_part_of_a_map_is_held)
{
    struct hatch_tam tam = made_map(64, 240, 1, "Y", made_ramp);
    hatch_tam_cut(&tam, 180, 0, 0.01);
    make(&tam, 64, HATCH_VOLUME_3D, false);
    ck_assert_float_eq(volume.darkest, 0.75f);
    ck_assert_uint_eq(volume.texels.depth, 50);
    for (int i = 0; i <= 75; i++)
        for (int lod = 0; lod <= 24; lod++) {
            float value, tone = (float)i / 100;
            hatch_volume_sample(&volume, 0.3f, 0.4f, tone, 0.25f * (float)lod, true, &value);
            ck_assert_msg(fabsf(value - (1 - tone)) <= 0.032f, "tone %g lod %g: %g", (double)tone, 0.25 * lod,
                          (double)value);
        }
}
END_TEST

/* Without the correction tones 0 and 1 return the first and the last slice. */
START_TEST(the_first_and_the_last_tone_are_corrected)
{
    struct hatch_tam tam = made_map(64, 255, 1, "Y", made_ramp);
    float value;
    make(&tam, 4, HATCH_VOLUME_3D, false);
    hatch_volume_sample(&volume, 0, 0, 0, 0, false, &value);
    ck_assert_float_eq_tol(value, 0.875f, 0.005f);
    hatch_volume_sample(&volume, 0, 0, 0, 0, true, &value);
    ck_assert_float_eq(value, 1);
    hatch_volume_sample(&volume, 0, 0, 1, 0, true, &value);
    ck_assert_float_eq(value, 0);
    hatch_volume_sample(&volume, 0, 0, 1, 0, false, &value);
    ck_assert_float_eq_tol(value, 0.125f, 0.005f);
    volume.darkest = 0.9f;
    hatch_volume_sample(&volume, 0, 0, 1, 0, true, &value);
    ck_assert_float_eq_tol(value, 0.1f, 0.005f);
}
END_TEST

START_TEST(a_constant_map_is_constant)
{
    struct hatch_tam tam = made_map(64, 16, 1, "Y", constant);
    make(&tam, 8, HATCH_VOLUME_3D, false);
    for (uint32_t level = 0; level < volume.texels.level_count; level++)
        for (size_t i = 0; i < hatch_texels_level_size(&volume.texels, level); i++)
            ck_assert_uint_eq(volume.texels.texels[level][i], 153);
}
END_TEST

START_TEST(a_stroke_is_sharp_at_its_edges_and_over_tone)
{
    struct hatch_tam tam = made_map(64, 255, 1, "Y", one_stroke);
    float value;
    make(&tam, 128, HATCH_VOLUME_ARRAY, false);
    for (int i = 0; i <= 100; i++) {
        float tone = (float)i / 100;
        hatch_volume_sample(&volume, 0.375f, 0.3f, tone, 0, true, &value);
        if (tone < 0.49f)
            ck_assert_float_eq(value, 1);
        if (tone > 0.51f)
            ck_assert_float_eq(value, 0);
        hatch_volume_sample(&volume, 0.75f, 0.3f, tone, 0, true, &value);
        ck_assert(tone > 0.99f || value == 1);
        hatch_volume_sample(&volume, 0.25f, 0.3f, 0.6f, 0, true, &value); /* on its edge */
        ck_assert_float_eq_tol(value, 0.5f, 1e-5f);
    }
}
END_TEST

static float speckle(float u, float v, uint32_t level, float tone, uint32_t channel)
{
    (void)channel;
    float light = hatch_random_unit(7, (uint64_t)(u * 1024) << 20 | (uint64_t)(v * 1024), level);
    return light * (1 - tone);
}

START_TEST(filtered_levels_are_means_of_eight)
{
    struct hatch_tam tam = made_map(64, 64, 1, "Y", speckle);
    make(&tam, 32, HATCH_VOLUME_3D, false);
    ck_assert_uint_eq(volume.levels, 2);
    const uint8_t *fine = volume.texels.texels[1];
    for (uint32_t i = 0; i < 16 * 16 * 8; i++) {
        uint32_t x = i % 16, y = i / 16 % 16, z = i / 256, sum = 4;
        for (uint32_t j = 0; j < 8; j++)
            sum += fine[((2 * z + j / 4) * 32 + 2 * y + j / 2 % 2) * 32 + 2 * x + j % 2];
        ck_assert_uint_eq(volume.texels.texels[2][i], sum / 8);
    }
    ck_assert_uint_eq(volume.texels.level_count, 7);
    make(&tam, 256, HATCH_VOLUME_3D, false); /* deeper than it is wide */
    ck_assert_uint_eq(volume.texels.level_count, 9);
    ck_assert_uint_eq(hatch_texels_level_size(&volume.texels, 7), 2);
    ck_assert_uint_eq(volume.texels.texels[8][0], (volume.texels.texels[7][0] + volume.texels.texels[7][1] + 1u) / 2);
}
END_TEST

START_TEST(colours_keep_their_channels)
{
    struct hatch_tam tam = made_map(64, 64, 1, "RGB", colors);
    make(&tam, 16, HATCH_VOLUME_3D, _i);
    uint32_t channels = _i ? 4 : 3;
    ck_assert_uint_eq(volume.texels.channels, channels);
    for (size_t i = 0; i < 64u * 64 * 16; i++) {
        const uint8_t *texel = volume.texels.texels[0] + i * channels;
        float tone = ((float)(i / 4096) + 0.5f) / 16;
        for (uint32_t c = 0; c < 3; c++) {
            float u = ((float)(i % 64) + 0.5f) / 64, v = ((float)(i / 64 % 64) + 0.5f) / 64;
            ck_assert_uint_eq(texel[c], hatch_unorm8(colors(u, v, 0, tone, c)));
        }
        ck_assert(!_i || texel[3] == 255);
    }
}
END_TEST

START_TEST(missing_columns_are_blended_and_counted)
{
    struct hatch_tam tam = made_map(64, 6, 0.9f, "Y", made_ramp);
    make(&tam, 64, HATCH_VOLUME_3D, false);
    ck_assert_uint_gt(figures.blended, 70);
    ck_assert_double_gt(figures.distance, 0.06);
    ck_assert_double_le(figures.distance, 0.0751);
    for (uint32_t k = 0; k < 64; k++) {
        double tone = fmin((k + 0.5) / 64, 0.9);
        ck_assert_double_eq_tol(slice(0, k) / 255.0, 1 - tone, 0.006);
    }
}
END_TEST

START_TEST(a_map_may_have_as_many_columns_as_there_are)
{
    struct hatch_tam tam = made_map(2, HATCH_TAM_TONES_MAX, 1, "Y", made_ramp);
    ck_assert_uint_eq(tam.tones, HATCH_TAM_TONES_MAX);
}
END_TEST

START_TEST(a_map_with_too_few_columns_is_rejected)
{
    struct hatch_tam tam = made_map(64, 1, 0.9f, "Y", made_ramp);
    const struct hatch_volume_options how = {64, HATCH_VOLUME_3D, false};
    ck_assert_int_eq(hatch_volume_make(&tam, &how, NULL, &map_arena, &volume, &figures, &map_err), HATCH_BAD_INPUT);
    ck_assert_str_eq(map_err.text,
                     "too few columns for a volume: a slice is 0.447 in tone from the nearest of 1 columns");
}
END_TEST

/* Slices of tones 1/4 and 3/4 lie in the middle between paper and columns of tones 1/2 and 1. */
START_TEST(a_slice_may_be_a_quarter_from_every_column)
{
    struct hatch_tam tam = made_map(64, 2, 1, "Y", made_ramp);
    make(&tam, 2, HATCH_VOLUME_ARRAY, false);
    ck_assert_double_eq(figures.distance, 0.25);
    ck_assert_uint_eq(figures.blended, figures.slices);
}
END_TEST

START_TEST(any_number_of_threads_gives_the_same_result)
{
    struct hatch_pool *pool;
    struct hatch_tam tam = made_map(64, 64, 1, "Y", one_stroke);
    const struct hatch_volume_options how = {32, HATCH_VOLUME_3D, false};
    make(&tam, 32, HATCH_VOLUME_3D, false);
    struct hatch_volume alone = volume;
    HATCH_TEST_OK(hatch_pool_make(3, &map_arena, &pool, &map_err), &map_err);
    HATCH_TEST_OK(hatch_volume_make(&tam, &how, pool, &map_arena, &volume, &figures, &map_err), &map_err);
    hatch_pool_free(pool);
    for (uint32_t level = 0; level < 7; level++)
        ck_assert(memcmp(alone.texels.texels[level], volume.texels.texels[level],
                         hatch_texels_level_size(&volume.texels, level)) == 0);
}
END_TEST

START_TEST(metadata_is_read_from_the_file)
{
    struct hatch_tam tam = made_map(64, 64, 1, "Y", made_ramp);
    const char *const good[] = {HATCH_TAM_ATTR_LEVELS, "2", HATCH_VOLUME_KEY_DARKEST, "0.9", NULL};
    const char *const bad[] = {HATCH_TAM_ATTR_LEVELS, "99", HATCH_VOLUME_KEY_DARKEST, "0.9", NULL};
    const char *const worse[] = {HATCH_TAM_ATTR_LEVELS, "2", HATCH_VOLUME_KEY_DARKEST, "nan", NULL};
    const char *const least[] = {HATCH_TAM_ATTR_LEVELS, "1", HATCH_VOLUME_KEY_DARKEST, "0", NULL};
    const char *const most[] = {HATCH_TAM_ATTR_LEVELS, "7", HATCH_VOLUME_KEY_DARKEST, "1", NULL};
    const char *const more[] = {HATCH_TAM_ATTR_LEVELS, "8", HATCH_VOLUME_KEY_DARKEST, "1", NULL};
    struct hatch_volume got;
    make(&tam, 32, HATCH_VOLUME_3D, false);
    HATCH_TEST_OK(hatch_volume_from_texels(&volume.texels, good, &got, &map_err), &map_err);
    ck_assert_uint_eq(got.levels, 2);
    ck_assert_float_eq(got.darkest, 0.9f);
    HATCH_TEST_OK(hatch_volume_from_texels(&volume.texels, least, &got, &map_err), &map_err);
    HATCH_TEST_OK(hatch_volume_from_texels(&volume.texels, most, &got, &map_err), &map_err);
    ck_assert_int_eq(hatch_volume_from_texels(&volume.texels, more, &got, &map_err), HATCH_BAD_INPUT);
    ck_assert_int_eq(hatch_volume_from_texels(&volume.texels, bad, &got, &map_err), HATCH_BAD_INPUT);
    ck_assert_int_eq(hatch_volume_from_texels(&volume.texels, worse, &got, &map_err), HATCH_BAD_INPUT);
    ck_assert_int_eq(hatch_volume_from_texels(&volume.texels, NULL, &got, &map_err), HATCH_BAD_INPUT);
}
END_TEST

static enum hatch_status make_again(void *context, struct hatch_arena *keep, struct hatch_arena *scratch,
                                    struct hatch_err *err)
{
    const struct hatch_volume_options how = {8, HATCH_VOLUME_3D, false};
    HATCH_TRY(hatch_tam_check_nesting(context, NULL, scratch, err));
    return hatch_volume_make(context, &how, NULL, keep, &volume, &figures, err);
}

START_TEST(every_failed_allocation_is_a_status)
{
    struct hatch_tam tam = made_map(64, 16, 1, "Y", made_ramp);
    memset(&volume, 0, sizeof volume);
    hatch_test_fail_alloc(make_again, &tam, &volume, sizeof volume);
}
END_TEST

static Suite *suite(void)
{
    Suite *suite = suite_create("tam volume");
    TCase *tests = tcase_create("volume");
    tcase_add_checked_fixture(tests, map_begin, map_end);
    tcase_add_test(tests, tones_are_those_of_the_paper);
    tcase_add_test(tests, levels_of_a_volume_are_dense_up_to_four_slices);
    tcase_add_test(tests, few_slices_have_their_tones_on_all_levels);
    tcase_add_loop_test(tests, a_ramp_is_reproduced_at_every_position_tone_and_level, 0, 2);
    tcase_add_loop_test(tests, dark_tones_of_a_map_are_held_on_all_levels, 0, 2);
    tcase_add_test(tests, the_last_tone_of_a_part_of_a_map_is_held);
    tcase_add_test(tests, the_first_and_the_last_tone_are_corrected);
    tcase_add_test(tests, a_constant_map_is_constant);
    tcase_add_test(tests, a_stroke_is_sharp_at_its_edges_and_over_tone);
    tcase_add_test(tests, filtered_levels_are_means_of_eight);
    tcase_add_loop_test(tests, colours_keep_their_channels, 0, 2);
    tcase_add_test(tests, missing_columns_are_blended_and_counted);
    tcase_add_test(tests, a_map_may_have_as_many_columns_as_there_are);
    tcase_add_test(tests, a_map_with_too_few_columns_is_rejected);
    tcase_add_test(tests, a_slice_may_be_a_quarter_from_every_column);
    tcase_add_test(tests, any_number_of_threads_gives_the_same_result);
    tcase_add_test(tests, metadata_is_read_from_the_file);
    tcase_add_test(tests, every_failed_allocation_is_a_status);
    suite_add_tcase(suite, tests);
    return suite;
}
HATCH_TEST_MAIN(suite)
