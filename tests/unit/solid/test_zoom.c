#include "run.h"

#include <math.h>

#include "arenas.h"
#include "base/random.h"
#include "fail_alloc.h"
#include "solid/zoom.h"

#define SIZE 16u
#define POINTS 20000u

static struct hatch_solid solid;

/* Fills the texture with noise whose values have an uneven distribution. */
static void make_noise(uint32_t channels)
{
    HATCH_TEST_OK(hatch_solid_make(&keep, SIZE, channels, &solid, &err), &err);
    for (size_t i = 0; i < (size_t)SIZE * SIZE * SIZE * channels; i++) {
        float value = hatch_random_unit(7, 1, i);
        solid.texels[i] = hatch_unorm8(value * value);
    }
}

static void make_zoom(uint32_t size, enum hatch_zoom_blend blend, struct hatch_zoom *zoom, struct hatch_texels *mips)
{
    HATCH_TEST_OK(hatch_zoom_make(&solid, size, false, blend, NULL, &keep, &scratch, zoom, &err), &err);
    HATCH_TEST_OK(hatch_zoom_mips(zoom, blend, &keep, mips, &err), &err);
}

START_TEST(weights_meet_the_papers_constraints)
{
    double begin[HATCH_ZOOM_OCTAVES], end[HATCH_ZOOM_OCTAVES], between[HATCH_ZOOM_OCTAVES];
    hatch_zoom_weights(0, begin);
    hatch_zoom_weights(1, end);
    ck_assert_double_eq(begin[0], 0);
    ck_assert_double_eq(end[3], 0);
    for (int i = 0; i + 1 < (int)HATCH_ZOOM_OCTAVES; i++)
        ck_assert_double_eq_tol(end[i], begin[i + 1], 1e-16);
    for (int step = 0; step <= 100; step++) {
        double s = step / 100.0, sum = 0;
        hatch_zoom_weights(s, between);
        for (int i = 0; i < (int)HATCH_ZOOM_OCTAVES; i++)
            sum += between[i];
        ck_assert_double_eq_tol(sum, 1, 1e-15);
        ck_assert_double_eq_tol(between[0], s / 2, 1e-15);
        ck_assert_double_eq_tol(between[2], 1.0 / 3 - s / 6, 1e-15);
    }
}
END_TEST

/* At centres of texels of A, where it is not interpolated, the blend is the sum of the octaves of T. */
START_TEST(two_scales_of_a_are_four_octaves_of_t)
{
    struct hatch_zoom zoom;
    struct hatch_texels mips, base;
    make_noise(1);
    make_zoom(4 * SIZE, HATCH_ZOOM_LINEAR, &zoom, &mips);
    HATCH_TEST_OK(hatch_solid_mips(&solid, &keep, &base, &err), &err);
    for (uint32_t i = 0; i < 300; i++)
        for (int s = 0; s <= 1; s++) {
            double weights[HATCH_ZOOM_OCTAVES], sum = 0;
            float place[3], value[3];
            for (uint32_t k = 0; k < 3; k++)
                place[k] = (s ? 2.0f : 1.0f) * (floorf(64 * hatch_random_unit(3, k, i)) + 0.5f) / 64;
            hatch_zoom_weights(s, weights);
            for (int octave = 0; octave < (int)HATCH_ZOOM_OCTAVES; octave++) {
                float scaled[3], texel[3];
                for (int k = 0; k < 3; k++)
                    scaled[k] = ldexpf(place[k], octave - 1);
                hatch_zoom_sample(&base, 0, scaled, texel);
                sum += weights[octave] * (double)texel[0];
            }
            hatch_zoom_blend_at(&mips, HATCH_ZOOM_LINEAR, place, (float)s, 0, value);
            ck_assert_double_eq_tol((double)value[0], sum, 0.51 / 255);
        }
}
END_TEST

/* Of colours, and of an image that is smaller than its square. */
START_TEST(flat_textures_are_the_same_at_every_depth)
{
    struct hatch_image image;
    struct hatch_zoom zoom;
    struct hatch_texels mips;
    HATCH_TEST_OK(hatch_image_make(&keep, 12, SIZE, "RGB", &image, &err), &err);
    for (size_t i = 0; i < (size_t)12 * SIZE * 3; i++)
        image.pixels[i] = hatch_random_unit(9, 0, i);
    HATCH_TEST_OK(hatch_solid_of_image(&image, &keep, &solid, &err), &err);
    ck_assert_uint_eq(solid.size, SIZE);
    ck_assert_uint_eq(solid.depth, 1);
    for (size_t y = 0; y < SIZE; y++)
        for (size_t c = 0; c < 3; c++) /* texel 1 lies under pixels 0 and 1: three quarters of a pixel wide */
            ck_assert_int_eq(solid.texels[(y * SIZE + 1) * 3 + c],
                             hatch_unorm8((image.pixels[36 * y + c] + 2 * image.pixels[36 * y + 3 + c]) / 3));
    make_zoom(4 * SIZE, HATCH_ZOOM_HISTOGRAM, &zoom, &mips);
    ck_assert_uint_eq(zoom.octaves.depth, 1);
    ck_assert_uint_eq(mips.level_count, 7);
    for (uint32_t i = 0; i < 200; i++) {
        float place[3] = {0, 0, 7.3f * hatch_random_unit(6, 2, i)}, value[3], base[3], sum[3] = {0};
        for (uint32_t k = 0; k < 2; k++)
            place[k] = (floorf(64 * hatch_random_unit(6, k, i)) + 0.5f) / 64;
        const struct hatch_texels finest = {
            .width = SIZE, .height = SIZE, .depth = 1, .channels = 3, .level_count = 1, .texels = {zoom.base.texels}};
        for (int octave = 0; octave < 3; octave++) {
            static const float weights[] = {1.0f / 2, 1.0f / 3, 1.0f / 6};
            float scaled[3] = {ldexpf(place[0], octave), ldexpf(place[1], octave), place[2]};
            hatch_zoom_sample(&finest, 0, scaled, base);
            for (int c = 0; c < 3; c++)
                sum[c] += weights[octave] * base[c];
        }
        hatch_zoom_blend_at(&mips, HATCH_ZOOM_LINEAR, place, 0, 0, value);
        for (int c = 0; c < 3; c++)
            ck_assert_float_eq_tol(value[c], sum[c], 0.51f / 255);
    }
}
END_TEST

START_TEST(a_cycle_ends_where_the_next_begins)
{
    struct hatch_zoom zoom;
    struct hatch_texels mips;
    const enum hatch_zoom_blend blend = _i ? HATCH_ZOOM_UNION : HATCH_ZOOM_LINEAR;
    make_noise(3);
    make_zoom(2 * SIZE, blend, &zoom, &mips);
    for (uint32_t i = 0; i < 500; i++) {
        float end[3], begin[3], place[3], half[3];
        for (uint32_t k = 0; k < 3; k++) {
            place[k] = 9 * hatch_random_unit(4, k, i);
            half[k] = place[k] / 2;
        }
        hatch_zoom_blend_at(&mips, blend, place, 1, 2, end);
        hatch_zoom_blend_at(&mips, blend, half, 0, 1, begin);
        for (int c = 0; c < 3; c++)
            ck_assert_float_eq_tol(end[c], begin[c], 1e-6f);
    }
}
END_TEST

/* Ranks are shares of lower values and half of the equal ones, where these are few. */
START_TEST(a_union_takes_ranks)
{
    struct hatch_zoom zoom;
    struct hatch_texels mips;
    HATCH_TEST_OK(hatch_solid_make(&keep, SIZE, 1, &solid, &err), &err);
    for (size_t i = 0; i < (size_t)SIZE * SIZE * SIZE; i++)
        solid.texels[i] = (uint8_t)(30 + i % 128);
    make_zoom(SIZE, HATCH_ZOOM_UNION, &zoom, &mips);
    for (size_t i = 0; i < 128; i++)
        ck_assert_uint_eq(zoom.base.texels[i], hatch_unorm8(((float)i + 0.5f) / 128));
    ck_assert_uint_eq(solid.texels[0], 30);
}
END_TEST

/* Fills the texture with a black ball on white, or a flat one with a disk. */
static void make_ball(bool flat)
{
    HATCH_TEST_OK(hatch_solid_make_like(&keep, &(struct hatch_solid){.depth = flat ? 1 : SIZE}, SIZE, 1, &solid, &err),
                  &err);
    for (size_t i = 0; i < hatch_solid_count(&solid); i++) {
        double x = (double)(i % SIZE) - 7.5, y = (double)(i / SIZE % SIZE) - 7.5;
        double z = flat ? 0 : (double)(i / SIZE / SIZE) - 7.5;
        solid.texels[i] = x * x + y * y + z * z < 25 ? 0 : 255;
    }
}

/* The ball grows from its middle to its border and, after all of its texels, on from there. */
START_TEST(a_union_orders_equal_values_by_what_is_around_them)
{
    const size_t at = _i ? SIZE / 2 * SIZE : (SIZE / 2 * SIZE + SIZE / 2) * SIZE; /* a row through the middle */
    struct hatch_zoom zoom;
    struct hatch_texels mips;
    uint32_t counts[256] = {0}, black = 0, white = 255;
    make_ball(_i);
    make_zoom(SIZE, HATCH_ZOOM_UNION, &zoom, &mips);
    for (size_t i = 0; i < hatch_solid_count(&solid); i++) {
        uint32_t rank = zoom.base.texels[i];
        counts[rank]++;
        black = solid.texels[i] == 0 && rank > black ? rank : black;
        white = solid.texels[i] && rank < white ? rank : white;
    }
    for (uint32_t rank = 0; rank < 256; rank++)
        ck_assert_uint_eq(counts[rank], hatch_solid_count(&solid) / 256);
    ck_assert_uint_le(black, white);
    for (size_t x = SIZE / 2; x + 1 < SIZE; x++)
        ck_assert_uint_le(zoom.base.texels[at + x], zoom.base.texels[at + x + 1] + 1u); /* of 256 */
}
END_TEST

/* A place is inked at a tone just where it is in the texture's marks of one of two sizes. They cover f and c of the
 * surface: marks keep their shape, and at the ends of a cycle only those of one size are left. */
START_TEST(a_union_shows_the_marks_of_two_octaves)
{
    struct hatch_zoom zoom;
    struct hatch_texels mips;
    make_noise(1);
    make_zoom(SIZE, HATCH_ZOOM_UNION, &zoom, &mips);
    for (uint32_t i = 0; i < 4000; i++) {
        float place[3], half[3], fine[3], coarse[3], value[3];
        const double s = (i % 9) / 8.0, tone = (double)hatch_random_unit(4, 3, i);
        const double d = (1 - 2 * s) * tone, c = 1 - 0.5 * (d + sqrt(d * d + 4 * (1 - tone))), f = c + d;
        for (uint32_t k = 0; k < 3; k++) {
            place[k] = 9 * hatch_random_unit(4, k, i);
            half[k] = place[k] / 2;
        }
        hatch_zoom_sample(&mips, 0, place, fine);
        hatch_zoom_sample(&mips, -1, half, coarse);
        hatch_zoom_blend_at(&mips, HATCH_ZOOM_UNION, place, (float)s, 0, value);
        ck_assert_double_eq_tol(1 - (1 - f) * (1 - c), tone, 1e-12);
        if (fmin(fabs((double)fine[0] - f), fabs((double)coarse[0] - c)) > 0.003)
            ck_assert_int_eq((double)value[0] < tone, (double)fine[0] < f || (double)coarse[0] < c);
    }
}
END_TEST

/* Mean and deviation of blended values at random points, changed by the table's row for s.
 *   level  at the beginning of the cycle */
static void measure(const struct hatch_texels *mips, enum hatch_zoom_blend blend, const struct hatch_zoom_table *table,
                    uint32_t step, float level, double *mean, double *deviation, double below[10])
{
    const float s = (float)step / (HATCH_ZOOM_STEPS - 1);
    double sum = 0, squares = 0;
    for (int t = 0; t < 10; t++)
        below[t] = 0;
    for (uint32_t i = 0; i < POINTS; i++) {
        float place[3], value[3];
        for (uint32_t k = 0; k < 3; k++)
            place[k] = 2 * hatch_random_unit(5, k, i);
        hatch_zoom_blend_at(mips, blend, place, s, level + s, value);
        uint32_t entry = (uint32_t)fminf(value[0] * HATCH_ZOOM_VALUES, HATCH_ZOOM_VALUES - 1);
        double changed = table->entries[0][step][entry] / 65535.0;
        sum += changed / POINTS;
        squares += changed * changed / POINTS;
        for (int t = 0; t < 10; t++)
            below[t] += (changed < t / 10.0) / (double)POINTS;
    }
    *mean = sum;
    *deviation = sqrt(squares - sum * sum);
}

static void spread_of_texture(double *mean, double *deviation)
{
    double sum = 0, squares = 0, count = SIZE * SIZE * SIZE;
    for (size_t i = 0; i < (size_t)count; i++) {
        sum += solid.texels[i] / 255.0 / count;
        squares += solid.texels[i] / 255.0 * solid.texels[i] / 255.0 / count;
    }
    *mean = sum;
    *deviation = sqrt(squares - sum * sum);
}

START_TEST(tables_give_back_mean_and_contrast)
{
    static const double most[] = {
        [HATCH_ZOOM_LINEAR] = 0.62, [HATCH_ZOOM_CONTRAST] = 1.03, [HATCH_ZOOM_HISTOGRAM] = 1.03};
    static const double least[] = {
        [HATCH_ZOOM_LINEAR] = 0.25, [HATCH_ZOOM_CONTRAST] = 0.85, [HATCH_ZOOM_HISTOGRAM] = 0.97};
    double mean, deviation, now_mean, now_deviation, below[10];
    make_noise(1);
    spread_of_texture(&mean, &deviation);
    for (int blend = HATCH_ZOOM_LINEAR; blend <= HATCH_ZOOM_HISTOGRAM; blend++) {
        struct hatch_zoom zoom;
        struct hatch_texels mips;
        struct hatch_zoom_table table;
        make_zoom(4 * SIZE, (enum hatch_zoom_blend)blend, &zoom, &mips);
        HATCH_TEST_OK(
            hatch_zoom_table_make(&zoom, &mips, (enum hatch_zoom_blend)blend, -1, &keep, &scratch, &table, &err), &err);
        for (uint32_t step = 0; step < HATCH_ZOOM_STEPS; step += 4) {
            measure(&mips, (enum hatch_zoom_blend)blend, &table, step, -1, &now_mean, &now_deviation, below);
            ck_assert_double_eq_tol(now_mean, mean, blend == HATCH_ZOOM_CONTRAST ? 0.02 : 0.006);
            ck_assert_double_le(now_deviation, most[blend] * deviation);
            ck_assert_double_ge(now_deviation, least[blend] * deviation);
        }
    }
}
END_TEST

/* A texture from 51 to 204, in few values or in all: no blended value is changed to one that it does not have. */
START_TEST(the_distribution_of_a_texture_ends_with_its_extremes)
{
    struct hatch_zoom zoom;
    struct hatch_texels mips;
    struct hatch_zoom_table table;
    make_noise(1);
    for (size_t i = 0; i < (size_t)SIZE * SIZE * SIZE; i++)
        solid.texels[i] = (uint8_t)(51 + (_i ? solid.texels[i] / 85 * 51 : solid.texels[i] * 3 / 5));
    make_zoom(2 * SIZE, HATCH_ZOOM_HISTOGRAM, &zoom, &mips);
    HATCH_TEST_OK(hatch_zoom_table_make(&zoom, &mips, HATCH_ZOOM_HISTOGRAM, -1, &keep, &scratch, &table, &err), &err);
    for (uint32_t step = 0; step < HATCH_ZOOM_STEPS; step++) {
        const uint16_t *entries = table.entries[0][step];
        for (uint32_t i = 0; i < HATCH_ZOOM_VALUES; i++)
            ck_assert(entries[i] >= 51 * 257 && entries[i] <= 204 * 257);
        ck_assert_uint_eq(entries[0], 51 * 257);
        ck_assert_uint_eq(entries[HATCH_ZOOM_VALUES - 1], 204 * 257);
    }
}
END_TEST

/* Also where the surface shows coarser levels, and levels between. */
START_TEST(ranks_cover_what_tones_ask_for)
{
    static const float levels[] = {-2.5f, -1, 0, 0.6f, 1.3f};
    static const enum hatch_zoom_blend blends[] = {HATCH_ZOOM_UNION, HATCH_ZOOM_RANK};
    const enum hatch_zoom_blend blend = blends[_i % 2];
    const float level = levels[_i / 2];
    struct hatch_zoom zoom;
    struct hatch_texels mips;
    struct hatch_zoom_table table;
    double mean, deviation, below[10];
    make_noise(1);
    make_zoom(2 * SIZE, blend, &zoom, &mips);
    HATCH_TEST_OK(hatch_zoom_table_make(&zoom, &mips, blend, (double)level, &keep, &scratch, &table, &err), &err);
    for (uint32_t step = 0; step < HATCH_ZOOM_STEPS; step++) {
        measure(&mips, blend, &table, step, level, &mean, &deviation, below);
        for (int t = 0; t < 10; t++)
            ck_assert_double_eq_tol(below[t], t / 10.0, 0.02);
    }
}
END_TEST

START_TEST(two_values_cover_what_tones_ask_for)
{
    struct hatch_zoom zoom;
    struct hatch_texels mips;
    struct hatch_zoom_table table;
    double mean, deviation, below[10];
    make_ball(false);
    make_zoom(2 * SIZE, HATCH_ZOOM_UNION, &zoom, &mips);
    HATCH_TEST_OK(hatch_zoom_table_make(&zoom, &mips, HATCH_ZOOM_UNION, 0, &keep, &scratch, &table, &err), &err);
    for (uint32_t step = 0; step < HATCH_ZOOM_STEPS; step++) {
        measure(&mips, HATCH_ZOOM_UNION, &table, step, 0, &mean, &deviation, below);
        for (int t = 0; t < 10; t++)
            ck_assert_double_eq_tol(below[t], t / 10.0, 0.03);
    }
}
END_TEST

START_TEST(axes_keep_colors)
{
    struct hatch_zoom zoom;
    HATCH_TEST_OK(hatch_solid_make(&keep, SIZE, 3, &solid, &err), &err);
    for (size_t i = 0; i < (size_t)SIZE * SIZE * SIZE; i++) {
        float mix = hatch_random_unit(8, 0, i);
        solid.texels[3 * i] = hatch_unorm8(0.9f - 0.5f * mix); /* red and green change together */
        solid.texels[3 * i + 1] = hatch_unorm8(0.1f + 0.4f * mix);
        solid.texels[3 * i + 2] = hatch_unorm8(0.5f + 0.05f * hatch_random_unit(8, 1, i));
    }
    HATCH_TEST_OK(hatch_zoom_make(&solid, SIZE, false, HATCH_ZOOM_LINEAR, NULL, &keep, &scratch, &zoom, &err), &err);
    for (size_t i = 0; i < (size_t)SIZE * SIZE * SIZE; i++)
        for (int k = 0; k < 3; k++) {
            float color = zoom.offset[k];
            for (int c = 0; c < 3; c++)
                color += zoom.axes[c][k] * zoom.base.texels[3 * i + (size_t)c] / 255;
            ck_assert_float_eq_tol(color, solid.texels[3 * i + (size_t)k] / 255.0f, 1.0f / 255);
        }
    double dot = 0;
    for (int k = 0; k < 3; k++)
        dot += (double)(zoom.axes[0][k] * zoom.axes[1][k]);
    ck_assert_double_eq_tol(dot, 0, 1e-6);
    ck_assert_float_ge(hypotf(zoom.axes[0][0], zoom.axes[0][1]), 0.6f); /* the first axis is theirs */
}
END_TEST

START_TEST(one_value_stays_one_value)
{
    HATCH_TEST_OK(hatch_solid_make(&keep, SIZE, 1, &solid, &err), &err);
    for (size_t i = 0; i < (size_t)SIZE * SIZE * SIZE; i++)
        solid.texels[i] = 100;
    for (int blend = HATCH_ZOOM_LINEAR; blend <= HATCH_ZOOM_HISTOGRAM; blend++) {
        struct hatch_zoom zoom;
        struct hatch_texels mips;
        struct hatch_zoom_table table;
        make_zoom(SIZE, (enum hatch_zoom_blend)blend, &zoom, &mips);
        HATCH_TEST_OK(
            hatch_zoom_table_make(&zoom, &mips, (enum hatch_zoom_blend)blend, -1, &keep, &scratch, &table, &err), &err);
        for (uint32_t level = 0; level < mips.level_count; level++)
            ck_assert_uint_eq(mips.texels[level][0], 100);
        for (uint32_t step = 0; step < HATCH_ZOOM_STEPS; step++)
            ck_assert_double_eq_tol(table.entries[0][step][100] / 65535.0, 100 / 255.0, 0.004);
    }
}
END_TEST

static enum hatch_zoom_blend failing;

static enum hatch_status make_all(void *context, struct hatch_arena *keeping, struct hatch_arena *working,
                                  struct hatch_err *error)
{
    struct hatch_zoom zoom;
    struct hatch_texels mips;
    HATCH_TRY(hatch_zoom_make(&solid, SIZE, false, failing, NULL, keeping, working, &zoom, error));
    HATCH_TRY(hatch_zoom_mips(&zoom, failing, keeping, &mips, error));
    return hatch_zoom_table_make(&zoom, &mips, failing, 0, keeping, working, context, error);
}

START_TEST(every_failed_allocation_is_a_limit)
{
    struct hatch_zoom_table table = {NULL};
    failing = _i ? HATCH_ZOOM_UNION : HATCH_ZOOM_HISTOGRAM;
    if (_i)
        make_ball(false);
    else
        make_noise(3);
    hatch_test_fail_alloc(make_all, &table, &table, sizeof table);
}
END_TEST

static Suite *suite(void)
{
    Suite *suite = suite_create("solid");
    TCase *tests = tcase_create("zoom");
    tcase_add_checked_fixture(tests, begin, end);
    tcase_add_test(tests, weights_meet_the_papers_constraints);
    tcase_add_test(tests, two_scales_of_a_are_four_octaves_of_t);
    tcase_add_test(tests, flat_textures_are_the_same_at_every_depth);
    tcase_add_loop_test(tests, a_cycle_ends_where_the_next_begins, 0, 2);
    tcase_add_test(tests, tables_give_back_mean_and_contrast);
    tcase_add_loop_test(tests, the_distribution_of_a_texture_ends_with_its_extremes, 0, 2);
    tcase_add_test(tests, a_union_takes_ranks);
    tcase_add_loop_test(tests, a_union_orders_equal_values_by_what_is_around_them, 0, 2);
    tcase_add_test(tests, two_values_cover_what_tones_ask_for);
    tcase_add_test(tests, a_union_shows_the_marks_of_two_octaves);
    tcase_add_loop_test(tests, ranks_cover_what_tones_ask_for, 0, 10);
    tcase_add_test(tests, axes_keep_colors);
    tcase_add_test(tests, one_value_stays_one_value);
    tcase_add_loop_test(tests, every_failed_allocation_is_a_limit, 0, 2);
    suite_add_tcase(suite, tests);
    return suite;
}

HATCH_TEST_MAIN(suite)
