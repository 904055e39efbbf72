#include "tam_made.h"

#include <math.h>

#include "base/random.h"
#include "fail_alloc.h"
#include "tam/exact.h"
#include "tam/thresholds.h"

static struct hatch_thresholds made;
static const struct hatch_threshold_figures *const figures = &made.figures;
static struct hatch_exact exact;

static void make(const struct hatch_tam *tam, uint32_t bins, const float *border)
{
    const struct hatch_threshold_options how = {.bins = bins, .border = border, .seed = 1};
    HATCH_TEST_OK(hatch_thresholds_make(tam, &how, NULL, &map_arena, &map_scratch, &made, &map_err), &map_err);
}

static void make_exact(const struct hatch_tam *tam)
{
    HATCH_TEST_OK(hatch_exact_make(tam, NULL, &map_arena, &map_scratch, &exact, &map_err), &map_err);
}

/* A channel of a texel, 0 .. 255. */
static uint8_t channel_of(uint32_t level, size_t texel, uint32_t layer, uint32_t channel)
{
    size_t side = hatch_mip_size(made.texels.width, level);
    return made.texels.texels[level][(layer * side * side + texel) * 4 + channel];
}

static float constant(float u, float v, uint32_t level, float tone, uint32_t channel)
{
    (void)u, (void)v, (void)level, (void)tone, (void)channel;
    return 0.6f;
}

/* A stroke from tone .5 on with soft edges, and a stroke across it from .8 on. */
static float two_strokes(float u, float v, uint32_t level, float tone, uint32_t channel)
{
    (void)level, (void)channel;
    float first = u > 0.25f && u < 0.5f ? 1 : u > 0.25f - 1.0f / 32 && u < 0.5f + 1.0f / 32 ? 0.5f : 0;
    float second = v > 0.6f && v < 0.7f ? 1 : 0, dark = tone > 0.4999f ? first : 0;
    return 1 - (tone > 0.7999f ? fmaxf(dark, second) : dark);
}

static float gets_lighter(float u, float v, uint32_t level, float tone, uint32_t channel)
{
    (void)channel;
    bool hit = level == 1 && u > 0.29f && u < 0.3f && v > 0.5f && v < 0.54f && tone > 0.6f;
    return hit ? 0.9f : 1 - tone;
}

/* Every texel darkens at twelve random tones. */
static float many_changes(float u, float v, uint32_t level, float tone, uint32_t channel)
{
    (void)channel;
    uint64_t texel = (uint64_t)(u * 4096) * 4096 + (uint64_t)(v * 4096);
    float light = 1;
    for (uint64_t i = 0; i < 12; i++)
        light *= tone > hatch_random_unit(5, texel, i) ? 0.8f : 1;
    return light + 0 * (float)level;
}

START_TEST(a_step_lies_where_its_column_begins)
{
    struct hatch_tam tam = made_map(64, 255, 1, "Y", two_strokes);
    make(&tam, 7, NULL);
    for (int i = 0; i < 255; i++) {
        float tone = (float)(i + 1) / 255, shown = tam.target[i];
        float want = two_strokes(0.375f, 0.3f, 0, shown, 0);
        /* exact at the centre of a texel at the tone of a column */
        ck_assert_float_eq(hatch_thresholds_sample(&made, 0.3828125f, 0.3046875f, tone, 0), want);
    }
    ck_assert_double_eq(figures->merged, 0);
    ck_assert_double_eq(figures->error, 0);
    ck_assert_float_eq(made.border[0], 0);
    ck_assert_float_eq(made.border[made.bins], 1);
}
END_TEST

/* Ink from tone .999 on. */
static float only_the_darkest(float u, float v, uint32_t level, float tone, uint32_t channel)
{
    (void)u, (void)v, (void)level, (void)channel;
    return tone > 0.999f ? 0 : 1;
}

/* Columns of tones 255/256 and 1 are nearer to each other than codes of tone: 254.5/255, half-way, rounds to 1. */
START_TEST(the_darkest_of_many_columns_appears_at_its_tone)
{
    struct hatch_tam tam = made_map(64, 256, 1, "Y", only_the_darkest);
    make(&tam, 7, NULL);
    for (int lod = 0; lod < 7; lod++) {
        ck_assert_float_eq(hatch_thresholds_sample(&made, 0.3f, 0.6f, 1, (float)lod), 0);
        ck_assert_float_eq(hatch_thresholds_sample(&made, 0.3f, 0.6f, 0.995f, (float)lod), 1);
    }
}
END_TEST

/* Compares every texel of every level at the tone of every column; no steps are merged. */
START_TEST(steps_that_fit_the_bins_are_exact)
{
    struct hatch_tam tam = made_map(64, 20, 1, "Y", two_strokes);
    make(&tam, 2, (const float[]){0, 0.6f, 1});
    for (uint32_t level = 0; level < 7; level++) {
        uint32_t size = 64u >> level;
        for (uint32_t c = 0; c < 20; c++)
            for (uint32_t i = 0; i < size * size; i++) {
                float u = ((float)(i % size) + 0.5f) / (float)size, v = ((float)(i / size) + 0.5f) / (float)size;
                float want = tam.columns[c].levels[level].pixels[i];
                float got = hatch_thresholds_sample(&made, u, v, tam.target[c], (float)level);
                ck_assert_float_eq_tol(got, want, 0.5f / 255 + 1e-6f);
            }
    }
}
END_TEST

START_TEST(steps_stay_within_their_bins)
{
    struct hatch_tam tam = made_map(64, 255, 1, "Y", many_changes);
    make(&tam, 7, NULL);
    for (uint32_t level = 0; level < 7; level++)
        for (size_t texel = 0; texel < (64u >> level) * (64u >> level); texel++)
            for (uint32_t bin = 0; bin < 7; bin++) {
                float x = channel_of(level, texel, bin / 4, bin % 4) / 255.0f;
                ck_assert_float_ge(x, made.border[bin] - 1e-6f);
                ck_assert_float_lt(x, made.border[bin + 1] + 1e-6f);
            }
    ck_assert_double_gt(figures->steps, 8);
    ck_assert_double_gt(figures->merged, 0.5);
}
END_TEST

/* Two strokes, from tones .2 and .8 on, separated by one empty texel of the finest level. */
static float apart(float u, float v, uint32_t level, float tone, uint32_t channel)
{
    (void)v, (void)level, (void)channel;
    bool left = u > 0.25f && u<0.5f, right = u> 0.5f + 1.0f / 64 && u < 0.75f;
    return (left && tone > 0.1999f) || (right && tone > 0.7999f) ? 0 : 1;
}

START_TEST(an_empty_texel_has_the_mean_x_of_its_neighbours)
{
    struct hatch_tam tam = made_map(64, 10, 1, "Y", apart);
    make(&tam, 1, NULL);
    for (size_t y = 0; y < 64; y++) {
        uint32_t left = channel_of(0, y * 64 + 31, 0, 0), right = channel_of(0, y * 64 + 33, 0, 0);
        ck_assert(left < 60 && right > 190);
        ck_assert_uint_eq(channel_of(0, y * 64 + 32, 2, 0), 0);
        ck_assert_uint_eq(channel_of(0, y * 64 + 32, 0, 0), (left + right + 1) / 2);
    }
}
END_TEST

/* Empty texels have height 0 and the x of their neighbours, so that a stroke appears at the same tone over its whole
 * soft edge. */
START_TEST(empty_texels_do_not_move_the_steps_of_their_neighbours)
{
    struct hatch_tam tam = made_map(64, 255, 1, "Y", two_strokes);
    make(&tam, 7, NULL);
    for (int i = 0; i < 64; i++) {
        float u = 0.2f + 0.006f * (float)i;
        float before = hatch_thresholds_sample(&made, u, 0.3f, 126.9f / 255, 0);
        float after = hatch_thresholds_sample(&made, u, 0.3f, 127.1f / 255, 0);
        ck_assert_float_eq(before, 1);
        if (u > 0.235f && u < 0.515f) /* within reach of a texel of the stroke */
            ck_assert_float_lt(after, 1);
    }
}
END_TEST

START_TEST(merged_steps_keep_their_height_and_mean_tone)
{
    struct hatch_tam tam = made_map(64, 255, 1, "Y", many_changes);
    make(&tam, 3, (const float[]){0, 0.4f, 0.75f, 1});
    for (int i = 1; i < 20; i++) {
        float tone = 0.05f * (float)i;
        uint32_t column = (uint32_t)lrintf(tone * 255) - 1;
        double want = 0, got = 0;
        for (size_t t = 0; t < 4096; t++) {
            double dark = 0;
            for (uint32_t bin = 0; bin < 3; bin++)
                dark += tone * 255 > channel_of(0, t, 0, bin) ? channel_of(0, t, 2, bin) / 255.0 : 0;
            got += dark / 4096;
            want += (1 - (double)tam.columns[column].levels[0].pixels[t]) / 4096;
        }
        ck_assert_double_eq_tol(got, want, 0.02);
    }
    for (size_t t = 0; t < 4096; t++) {
        uint32_t sum = 0u + channel_of(0, t, 2, 0) + channel_of(0, t, 2, 1) + channel_of(0, t, 2, 2);
        ck_assert_uint_eq(sum, 255u - hatch_unorm8(tam.columns[254].levels[0].pixels[t]));
    }
}
END_TEST

/* All texels of a crossing of soft edges with another stroke get the same x on all levels; texels of a ramp,
 * with a step at every tone, get different ones. */
START_TEST(crossing_strokes_use_one_random_number)
{
    struct hatch_tam tam = made_map(64, 255, 1, "Y", two_strokes);
    make(&tam, 1, NULL);
    uint32_t met = 0, first = 0;
    for (uint32_t level = 0; level < 3; level++) {
        uint32_t size = 64u >> level;
        for (uint32_t i = 0; i < size * size; i++) {
            float u = ((float)(i % size) + 0.5f) / (float)size, v = ((float)(i / size) + 0.5f) / (float)size;
            if (two_strokes(u, v, 0, 0.6f, 0) != 0.5f || two_strokes(u, v, 0, 1, 0) != 0)
                continue;
            first = met++ ? first : channel_of(level, i, 0, 0);
            ck_assert_uint_eq(channel_of(level, i, 0, 0), first);
        }
    }
    ck_assert_uint_ge(met, 24);

    bool seen[256] = {false};
    uint32_t kinds = 0;
    tam = made_map(64, 255, 1, "Y", made_ramp);
    make(&tam, 1, NULL);
    for (size_t i = 0; i < 4096; i++) {
        kinds += seen[channel_of(0, i, 0, 0)] ? 0 : 1;
        seen[channel_of(0, i, 0, 0)] = true;
    }
    ck_assert_uint_gt(kinds, 128);
}
END_TEST

/* The error equals the area between sampled thresholds and the map, summed over tones. */
START_TEST(the_error_is_the_area_between)
{
    struct hatch_tam tam = made_map(64, 255, 1, "Y", many_changes);
    make(&tam, 7, NULL);
    double sum = 0, texels = 64 * 64 + 32 * 32;
    for (uint32_t level = 0; level < 2; level++)
        for (size_t t = 0; t < (64u >> level) * (64u >> level); t++)
            for (uint32_t c = 0; c < 255; c++) {
                uint32_t dark = 0;
                for (uint32_t bin = 0; bin < 7; bin++)
                    dark +=
                        c + 1 > channel_of(level, t, bin / 4, bin % 4) ? channel_of(level, t, 2 + bin / 4, bin % 4) : 0;
                double want = 255 - hatch_unorm8(tam.columns[c].levels[level].pixels[t]);
                sum += fabs(dark - want) / 255 / 255;
            }
    ck_assert_double_gt(figures->error, 0.005);
    ck_assert_double_eq_tol(figures->error, sum / texels, 1e-9);
}
END_TEST

START_TEST(a_constant_map_has_one_step)
{
    struct hatch_tam tam = made_map(64, 16, 1, "Y", constant);
    make(&tam, 7, NULL);
    ck_assert_double_eq(figures->steps, 1);
    ck_assert_float_eq(hatch_thresholds_sample(&made, 0.1f, 0.2f, 0, 0), 1);
    ck_assert_float_eq_tol(hatch_thresholds_sample(&made, 0.1f, 0.2f, 0.5f, 2.5f), 0.6f, 1e-5f);
}
END_TEST

static float paper(float u, float v, uint32_t level, float tone, uint32_t channel)
{
    (void)u, (void)v, (void)level, (void)tone, (void)channel;
    return 1;
}

START_TEST(paper_has_no_steps)
{
    struct hatch_tam tam = made_map(64, 16, 1, "Y", paper);
    make(&tam, 7, NULL);
    ck_assert_double_eq(figures->steps, 0);
    ck_assert_double_eq(figures->merged, 0);
    ck_assert_double_eq(figures->error, 0);
    ck_assert_float_eq(hatch_thresholds_sample(&made, 0.1f, 0.2f, 1, 0), 1);
}
END_TEST

/* Makes a map with a picture that is 0.2 on the left of a column, 0.8 from there on. */
static void make_with_picture(uint32_t width, uint32_t height, uint32_t column)
{
    struct hatch_tam tam = made_map(64, 4, 1, "Y", two_strokes);
    struct hatch_image picture;
    HATCH_TEST_OK(hatch_image_make(&map_arena, width, height, "Y", &picture, &map_err), &map_err);
    for (size_t i = 0; i < (size_t)width * height; i++)
        picture.pixels[i] = i % width < column ? 0.2f : 0.8f;
    const struct hatch_threshold_options how = {.bins = 7, .modulation = &picture};
    HATCH_TEST_OK(hatch_thresholds_make(&tam, &how, NULL, &map_arena, &map_scratch, &made, &map_err), &map_err);
}

START_TEST(pictures_are_stored_in_the_spare_channels)
{
    make_with_picture(128, 32, 64);
    ck_assert_uint_eq(channel_of(0, 31, 1, 3), 51);
    ck_assert_uint_eq(channel_of(0, 32, 1, 3), 204);
    ck_assert_uint_eq(channel_of(6, 0, 1, 3), 128);
    for (size_t i = 0; i < 4096; i++)
        ck_assert_uint_eq(channel_of(0, i, 3, 3), 255);
    make_with_picture(96, 40, 32); /* a texel is 1.5 pixels wide: a third of the one at the step is left of it */
    ck_assert_uint_eq(channel_of(0, 20, 1, 3), 51);
    ck_assert_uint_eq(channel_of(0, 21, 1, 3), 153);
    ck_assert_uint_eq(channel_of(0, 22, 1, 3), 204);
}
END_TEST

START_TEST(a_pixel_that_gets_lighter_is_named)
{
    struct hatch_tam tam = made_map(64, 10, 1, "Y", gets_lighter);
    const struct hatch_threshold_options how = {.bins = 7};
    static const char message[] = "tone.006: level 1: pixel (9, 16) gets lighter, from 0.400 to 0.902";
    ck_assert_int_eq(hatch_thresholds_make(&tam, &how, NULL, &map_arena, &map_scratch, &made, &map_err),
                     HATCH_BAD_INPUT);
    ck_assert_msg(strstr(map_err.text, message) != NULL, "%s", map_err.text);
    ck_assert_int_eq(hatch_exact_make(&tam, NULL, &map_arena, &map_scratch, &exact, &map_err), HATCH_BAD_INPUT);
    ck_assert_ptr_nonnull(strstr(map_err.text, message));
    ck_assert_int_eq(hatch_tam_check_nesting(&tam, NULL, &map_scratch, &map_err), HATCH_BAD_INPUT);
    ck_assert_ptr_nonnull(strstr(map_err.text, message));
}
END_TEST

static float blue_gets_lighter(float u, float v, uint32_t level, float tone, uint32_t channel)
{
    return channel == 2 ? gets_lighter(u, v, level, tone, channel) : 1 - tone;
}

START_TEST(a_colour_that_gets_lighter_is_named)
{
    struct hatch_tam tam = made_map(64, 10, 1, "RGB", blue_gets_lighter);
    ck_assert_int_eq(hatch_tam_check_nesting(&tam, NULL, &map_scratch, &map_err), HATCH_BAD_INPUT);
    ck_assert_ptr_nonnull(strstr(map_err.text, "tone.006: level 1: pixel (9, 16) gets lighter"));
}
END_TEST

START_TEST(a_map_in_colour_is_rejected)
{
    struct hatch_tam tam = made_map(64, 10, 1, "RGB", made_ramp);
    const struct hatch_threshold_options how = {.bins = 7};
    ck_assert_int_eq(hatch_thresholds_make(&tam, &how, NULL, &map_arena, &map_scratch, &made, &map_err),
                     HATCH_BAD_INPUT);
    HATCH_TEST_OK(hatch_tam_check_nesting(&tam, NULL, &map_scratch, &map_err), &map_err);
}
END_TEST

/* The result is within half a step of 8 bits of a full-resolution volume, at every tone. */
START_TEST(exact_runs_equal_the_map)
{
    struct hatch_tam tam = made_map(64, 100, 0.9f, "Y", _i ? many_changes : made_ramp);
    make_exact(&tam);
    for (int i = 0; i <= 300; i++) {
        float tone = (float)i / 300;
        uint32_t level = (uint32_t)i % 7, size = 64u >> level, column = 0;
        size_t texel = hatch_random_u64(3, 1, (uint64_t)i) % (size * size);
        while (column < 100 && tam.target[column] <= tone)
            column++;
        const struct hatch_image *above = column < 100 ? &tam.columns[column].levels[level] : NULL;
        const struct hatch_image *below = column > 0 ? &tam.columns[column - 1].levels[level] : NULL;
        float from = below ? below->pixels[texel] : 1, to = above ? above->pixels[texel] : from;
        float start = column > 0 ? tam.target[column - 1] : 0, end = column < 100 ? tam.target[column] : 2;
        float want = from + (to - from) * (tone - start) / (end - start);
        float u = ((float)(texel % size) + 0.5f) / (float)size, v = ((float)(texel / size) + 0.5f) / (float)size;
        ck_assert_float_eq_tol(hatch_exact_sample(&exact, u, v, tone, (float)level), want, 0.5f / 255 + 1e-5f);
    }
}
END_TEST

START_TEST(exact_runs_are_read_back_and_damage_is_detected)
{
    struct hatch_tam tam = made_map(64, 40, 1, "Y", two_strokes);
    struct hatch_exact got;
    make_exact(&tam);
    ck_assert_uint_eq(exact.texels.level_count, 1);
    HATCH_TEST_OK(hatch_exact_from_texels(&exact.texels, &got, &map_err), &map_err);
    ck_assert_uint_eq(got.run_count, exact.run_count);
    ck_assert_uint_eq(got.levels, 2);
    uint8_t *words = exact.texels.texels[0];
    for (uint32_t word = 0; word < 8 + 7 + 40 + 4097; word++) {
        bool unchecked = word == 7 || (word >= 15 && word < 55); /* the unused word, and the tones */
        uint8_t high = words[4 * word + 3];
        words[4 * word + 3] = 0xff;
        ck_assert(unchecked || hatch_exact_from_texels(&exact.texels, &got, &map_err) == HATCH_BAD_INPUT);
        words[4 * word + 3] = high;
    }
    for (uint8_t levels = 0; levels <= 8; levels++) {
        words[4 * 3] = levels; /* levels with strokes, of 7 */
        ck_assert_int_eq(hatch_exact_from_texels(&exact.texels, &got, &map_err),
                         levels >= 1 && levels <= 7 ? HATCH_OK : HATCH_BAD_INPUT);
    }
    words[4 * 3] = 2;
    HATCH_TEST_OK(hatch_exact_from_texels(&exact.texels, &got, &map_err), &map_err);
    uint32_t first = words[4 * 5] | (uint32_t)words[4 * 5 + 1] << 8; /* runs fill the rest of the texture, two a word */
    for (uint32_t more = 0; more < 2; more++) {
        uint32_t runs = 2 * (HATCH_EXACT_WIDTH * exact.texels.height - first) + more;
        for (uint32_t i = 0; i < 4; i++)
            words[4 * 6 + i] = (uint8_t)(runs >> 8 * i);
        ck_assert_int_eq(hatch_exact_from_texels(&exact.texels, &got, &map_err), more ? HATCH_BAD_INPUT : HATCH_OK);
    }
    for (uint32_t i = 0; i < 4; i++)
        words[4 * 6 + i] = (uint8_t)(exact.run_count >> 8 * i);
    HATCH_TEST_OK(hatch_exact_from_texels(&exact.texels, &got, &map_err), &map_err);
    exact.texels.height--;
    ck_assert_int_eq(hatch_exact_from_texels(&exact.texels, &got, &map_err), HATCH_BAD_INPUT);
}
END_TEST

START_TEST(borders_are_read_from_the_file)
{
    struct hatch_tam tam = made_map(64, 4, 1, "Y", two_strokes);
    struct hatch_thresholds got;
    const char *keys[] = {HATCH_TAM_ATTR_LEVELS, "2", HATCH_THRESHOLD_KEY_BORDERS, "0 0.5 0.75 1", NULL};
    make(&tam, 3, NULL);
    HATCH_TEST_OK(hatch_thresholds_from_texels(&made.texels, keys, &got, &map_err), &map_err);
    ck_assert_uint_eq(got.bins, 3);
    ck_assert_float_eq(got.border[2], 0.75f);
    static const char *const levels[4] = {"0", "1", "7", "8"};
    for (int i = 0; i < 4; i++) {
        keys[1] = levels[i];
        ck_assert_int_eq(hatch_thresholds_from_texels(&made.texels, keys, &got, &map_err),
                         i % 3 ? HATCH_OK : HATCH_BAD_INPUT);
    }
    keys[1] = "2";
    keys[3] = "0 1";
    HATCH_TEST_OK(hatch_thresholds_from_texels(&made.texels, keys, &got, &map_err), &map_err);
    ck_assert_uint_eq(got.bins, 1);
    static const char *const bad[] = {"", "1", "0 0.5 0.4 1", "0 nan 1", "0 2", "x"};
    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++) {
        keys[3] = bad[i];
        ck_assert_int_eq(hatch_thresholds_from_texels(&made.texels, keys, &got, &map_err), HATCH_BAD_INPUT);
    }
}
END_TEST

START_TEST(any_number_of_threads_gives_the_same_result)
{
    struct hatch_pool *pool;
    struct hatch_tam tam = made_map(64, 64, 1, "Y", many_changes);
    const struct hatch_threshold_options how = {.bins = 7, .seed = 1};
    make(&tam, 7, NULL);
    struct hatch_thresholds alone = made;
    HATCH_TEST_OK(hatch_pool_make(3, &map_arena, &pool, &map_err), &map_err);
    HATCH_TEST_OK(hatch_thresholds_make(&tam, &how, pool, &map_arena, &map_scratch, &made, &map_err), &map_err);
    hatch_pool_free(pool);
    for (uint32_t level = 0; level < 7; level++)
        ck_assert(memcmp(alone.texels.texels[level], made.texels.texels[level],
                         hatch_texels_level_size(&made.texels, level)) == 0);
}
END_TEST

static enum hatch_status make_again(void *context, struct hatch_arena *keep, struct hatch_arena *scratch,
                                    struct hatch_err *err)
{
    const struct hatch_threshold_options how = {.bins = 7};
    return hatch_thresholds_make(context, &how, NULL, keep, scratch, &made, err);
}

static enum hatch_status make_exact_again(void *context, struct hatch_arena *keep, struct hatch_arena *scratch,
                                          struct hatch_err *err)
{
    return hatch_exact_make(context, NULL, keep, scratch, &exact, err);
}

START_TEST(every_failed_allocation_is_a_status)
{
    struct hatch_tam tam = made_map(64, 16, 1, "Y", made_ramp);
    memset(&made, 0, sizeof made);
    memset(&exact, 0, sizeof exact);
    hatch_test_fail_alloc(make_again, &tam, &made, sizeof made);
    hatch_test_fail_alloc(make_exact_again, &tam, &exact, sizeof exact);
}
END_TEST

static Suite *suite(void)
{
    Suite *suite = suite_create("tam thresholds");
    TCase *tests = tcase_create("thresholds");
    tcase_add_checked_fixture(tests, map_begin, map_end);
    tcase_add_test(tests, a_step_lies_where_its_column_begins);
    tcase_add_test(tests, the_darkest_of_many_columns_appears_at_its_tone);
    tcase_add_test(tests, steps_that_fit_the_bins_are_exact);
    tcase_add_test(tests, steps_stay_within_their_bins);
    tcase_add_test(tests, an_empty_texel_has_the_mean_x_of_its_neighbours);
    tcase_add_test(tests, empty_texels_do_not_move_the_steps_of_their_neighbours);
    tcase_add_test(tests, merged_steps_keep_their_height_and_mean_tone);
    tcase_add_test(tests, crossing_strokes_use_one_random_number);
    tcase_add_test(tests, the_error_is_the_area_between);
    tcase_add_test(tests, a_constant_map_has_one_step);
    tcase_add_test(tests, paper_has_no_steps);
    tcase_add_test(tests, pictures_are_stored_in_the_spare_channels);
    tcase_add_test(tests, a_pixel_that_gets_lighter_is_named);
    tcase_add_test(tests, a_colour_that_gets_lighter_is_named);
    tcase_add_test(tests, a_map_in_colour_is_rejected);
    tcase_add_loop_test(tests, exact_runs_equal_the_map, 0, 2);
    tcase_add_test(tests, exact_runs_are_read_back_and_damage_is_detected);
    tcase_add_test(tests, borders_are_read_from_the_file);
    tcase_add_test(tests, any_number_of_threads_gives_the_same_result);
    tcase_add_test(tests, every_failed_allocation_is_a_status);
    suite_add_tcase(suite, tests);
    return suite;
}
HATCH_TEST_MAIN(suite)
