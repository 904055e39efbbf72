#include <math.h>
#include <stdio.h>

#include "base/reports.h"
#include "fail_alloc.h"
#include "made.h"
#include "solid/points.h"

#define SIZE 32u
#define TEXELS (SIZE * SIZE * SIZE)

/* One of each kind, without features finer than a few texels. */
static const char *const smooth[] = {
    "kind perlin\nscale 3",         "kind turbulence\nscale 2\noctaves 2",
    "kind wood\nrings 3\nfibers 4", "kind marble\nveins 1 0 -2\nscale 2\noctaves 2",
    "kind worley\nscale 4",         "kind worley\nscale 3\ndistance f2-f1",
    "kind stipple\ndots 4",         "kind strokes\nlength 0.3\nwidth 0.1\ngrow 1",
    "kind paper\nscale 4",          "kind canvas\nthreads 4",
};
#define SMOOTH (sizeof smooth / sizeof *smooth)

START_TEST(textures_are_uniform)
{
    struct hatch_solid solid = make_solid(smooth[_i], SIZE, 1, NULL);
    uint32_t counts[256] = {0};
    ck_assert_uint_eq(solid.size, SIZE);
    ck_assert_uint_eq(solid.channels, 1);
    for (uint32_t i = 0; i < TEXELS; i++)
        counts[solid.texels[i]]++;
    for (uint32_t i = 0; i < 256; i++)
        ck_assert_uint_eq(counts[i], TEXELS / 256);
}
END_TEST

/* Returns the mean step from slice `at` to the next along an axis. */
static double step(const struct hatch_solid *solid, uint32_t axis, uint32_t at)
{
    static const uint32_t strides[] = {1, SIZE, SIZE * SIZE};
    uint64_t sum = 0;
    for (uint32_t i = 0; i < TEXELS; i++)
        if (i / strides[axis] % SIZE == at) {
            uint32_t next = at + 1 < SIZE ? i + strides[axis] : i - at * strides[axis];
            sum += (uint64_t)abs(solid->texels[i] - solid->texels[next]);
        }
    return (double)sum / (SIZE * SIZE);
}

START_TEST(textures_continue_over_the_border)
{
    struct hatch_solid solid = make_solid(smooth[_i], SIZE, 1, NULL);
    for (uint32_t axis = 0; axis < 3; axis++) {
        double largest = 0, mean = 0;
        for (uint32_t at = 0; at + 1 < SIZE; at++) {
            largest = fmax(largest, step(&solid, axis, at));
            mean += step(&solid, axis, at) / (SIZE - 1);
        }
        ck_assert_double_lt(mean, 60); /* of independent values: 85 */
        ck_assert_double_le(step(&solid, axis, SIZE - 1), 1.1 * largest);
    }
}
END_TEST

START_TEST(threads_do_not_change_textures_and_seeds_do)
{
    struct hatch_arena arena;
    struct hatch_pool *pool;
    hatch_arena_init(&arena, 1 << 20);
    HATCH_TEST_OK(hatch_pool_make(3, &arena, &pool, &err), &err);
    struct hatch_solid one = make_solid(smooth[_i], SIZE, 1, NULL), three = make_solid(smooth[_i], SIZE, 1, pool),
                       other = make_solid(smooth[_i], SIZE, 2, pool);
    ck_assert_mem_eq(one.texels, three.texels, TEXELS);
    uint32_t differ = 0;
    for (uint32_t i = 0; i < TEXELS; i++)
        differ += one.texels[i] != other.texels[i];
    ck_assert_uint_gt(differ, TEXELS / 2);
    hatch_pool_free(pool);
    hatch_arena_free(&arena);
}
END_TEST

START_TEST(worley_is_the_distance_from_the_points)
{
    struct hatch_solid solid = make_solid("kind worley\nscale 3\nequalize no\njitter 0.5\ndistance f2", 16, 4, NULL);
    struct hatch_solid_points points;
    HATCH_TEST_OK(hatch_solid_points_jitter(3, 0.5f, 4, &keep, &points, &err), &err);
    for (uint32_t i = 0; i < 16 * 16 * 16; i += 37) {
        const float at[3] = {((float)(i % 16) + 0.5f) / 16, ((float)(i / 16 % 16) + 0.5f) / 16,
                             ((float)(i / 256) + 0.5f) / 16};
        float distances[2];
        hatch_solid_points_nearest(&points, at, distances);
        ck_assert_uint_eq(solid.texels[i], hatch_unorm8(3 * distances[1]));
    }
}
END_TEST

/* With one vein along y and nothing else, marble is a cosine. */
START_TEST(marble_without_warp_is_a_cosine)
{
    struct hatch_solid solid = make_solid("kind marble\nveins 0 1 0\nwarp 0\nequalize no", 16, 1, NULL);
    struct hatch_solid sharp = make_solid("kind marble\nveins 0 1 0\nwarp 0\nsharpness 2\nequalize no", 16, 1, NULL);
    for (uint32_t y = 0; y < 16; y++) {
        double height = 0.5 + 0.5 * cos(6.283185307179586 * (y + 0.5) / 16);
        ck_assert_double_eq_tol(solid.texels[(3 * 16 + y) * 16 + 5], 255 * (1 - height), 0.51);
        ck_assert_double_eq_tol(sharp.texels[(7 * 16 + y) * 16 + 2], 255 * (1 - height * height), 0.51);
    }
}
END_TEST

START_TEST(contrast_and_colors_apply_to_the_values)
{
    struct hatch_solid plain = make_solid("kind perlin\nequalize no", 16, 1, NULL);
    struct hatch_solid strong = make_solid("kind perlin\nequalize no\ncontrast 2", 16, 1, NULL);
    struct hatch_solid colored = make_solid("kind perlin\ncolor 0 000\ncolor 1 f00", 16, 1, NULL);
    struct hatch_solid even = make_solid("kind perlin\nequalize yes\ncolor 0 000\ncolor 1 fff", 16, 1, NULL);
    ck_assert_uint_eq(colored.channels, 3);
    uint64_t sum = 0;
    for (uint32_t i = 0; i < 16 * 16 * 16; i++) {
        int want = 2 * plain.texels[i] - 127;
        ck_assert_int_le(abs(strong.texels[i] - (want < 0 ? 0 : want > 255 ? 255 : want)), 2);
        ck_assert_uint_eq(colored.texels[3 * i], plain.texels[i]);
        ck_assert_uint_eq(colored.texels[3 * i + 1], 0);
        sum += even.texels[3 * i + 1];
    }
    ck_assert_double_eq_tol((double)sum / (16 * 16 * 16), 127.5, 1e-9);
}
END_TEST

/* Share of steps between ink and paper along an axis, at a tone. */
static double crossings(const struct hatch_solid *solid, uint32_t axis)
{
    double sum = 0;
    for (uint32_t at = 0; at < SIZE; at++)
        sum += step(solid, axis, at);
    return sum / SIZE;
}

/* Noise is 0 at the corners of its cells, and threads are alike in all texels, where there are too many of them. */
START_TEST(textures_have_no_finer_features_than_their_texels_show)
{
    static const char *const styles[][2] = {
        {"kind perlin\nscale 64", "kind perlin\nscale 16"},
        {"kind turbulence\nscale 128\noctaves 3", "kind turbulence\nscale 16\noctaves 1"},
        {"kind marble\nscale 64", "kind marble\nscale 16"},
        {"kind paper\nscale 64", "kind paper\nscale 16"},
        {"kind worley\nscale 64", "kind worley\nscale 16"},
        {"kind wood\nscale 64\nfibers 128\nrings 64", "kind wood\nscale 16\nfibers 32\nrings 16"},
        {"kind canvas\nthreads 64\nvary 0", "kind canvas\nthreads 8\nvary 0"}};
    struct hatch_solid finer = make_solid(styles[_i][0], SIZE, 1, NULL),
                       finest = make_solid(styles[_i][1], SIZE, 1, NULL);
    ck_assert_mem_eq(finer.texels, finest.texels, TEXELS);
    double away = 0; /* from steps between independent values */
    for (uint32_t axis = 0; axis < 3; axis++)
        away = fmax(away, fabs(crossings(&finer, axis) - 256.0 / 3));
    ck_assert_double_gt(away, 1.5);
}
END_TEST

START_TEST(strokes_run_in_their_direction)
{
    static const char *const lines[] = {"1 0 0", "0 1 0", "0 0 1"};
    for (uint32_t axis = 0; axis < 3; axis++) {
        char text[128];
        snprintf(text, sizeof text, "kind strokes\ndirection %s\nwidth 0.1\nlength 0.5\njitter 0", lines[axis]);
        struct hatch_solid solid = make_solid(text, SIZE, 1, NULL);
        for (uint32_t other = 0; other < 3; other++)
            if (other != axis)
                ck_assert_double_lt(3 * crossings(&solid, axis), crossings(&solid, other));
    }
}
END_TEST

/* Strokes of tones up to 0.5 have the first direction, those beyond the second, however fast they grow. */
START_TEST(directions_have_their_tones)
{
    static const char *const grow[] = {"0.01", "0.1", "1"};
    static const uint8_t below[] = {64, 115, 217}; /* of tones .25, .45 and .85 */
    double ratio[3];
    char text[200];
    snprintf(text, sizeof text,
             "kind strokes\ndirection 1 0 0 0 0.5\ndirection 0 0 1 0.5 1\nwidth 0.1\nlength 0.5\njitter 0\ngrow %s",
             grow[_i]);
    struct hatch_solid solid = make_solid(text, SIZE, 1, NULL), bands = solid;
    HATCH_TEST_OK(HATCH_ALLOC(&keep, &bands.texels, TEXELS, &err), &err);
    for (uint32_t k = 0; k < 3; k++) {
        for (uint32_t i = 0; i < TEXELS; i++)
            bands.texels[i] = solid.texels[i] < below[k] ? 0 : 255;
        ratio[k] = crossings(&bands, 0) / crossings(&bands, 2);
    }
    ck_assert_double_lt(ratio[0], 0.3);
    ck_assert_double_lt(ratio[1], 0.3);
    ck_assert_double_gt(ratio[2], 0.3);
}
END_TEST

/* The threads of all axes are crossed equally often, and no slice is much lighter than others. */
START_TEST(canvas_is_woven_along_all_axes)
{
    struct hatch_solid solid = make_solid("kind canvas\nthreads 8\nvary 0", SIZE, 1, NULL);
    double x = crossings(&solid, 0), y = crossings(&solid, 1), z = crossings(&solid, 2);
    ck_assert_double_eq_tol(x, y, 0.02 * x);
    ck_assert_double_eq_tol(x, z, 0.02 * x);
    for (uint32_t slice = 0; slice < SIZE; slice++) {
        double sum = 0;
        for (uint32_t i = 0; i < SIZE * SIZE; i++)
            sum += solid.texels[slice * SIZE * SIZE + i];
        ck_assert_double_eq_tol(sum / (SIZE * SIZE), 127.5, 16);
    }
}
END_TEST

START_TEST(mip_levels_are_means)
{
    struct hatch_texels texture;
    struct hatch_solid solid = make_solid("kind wood\ncolor 0 000\ncolor 1 fa0", 16, 1, NULL);
    HATCH_TEST_OK(hatch_solid_mips(&solid, &keep, &texture, &err), &err);
    ck_assert_uint_eq(texture.level_count, 5);
    ck_assert_uint_eq(texture.depth, 16);
    unsigned sum = 0;
    for (int corner = 0; corner < 8; corner++)
        sum += solid.texels[3 * (((2 + corner / 4) * 16 + 4 + corner / 2 % 2) * 16 + 6 + corner % 2) + 1];
    ck_assert_uint_eq(texture.texels[1][3 * ((1 * 8 + 2) * 8 + 3) + 1], (sum + 4) / 8);
    struct hatch_solid taken;
    HATCH_TEST_OK(hatch_solid_take(&texture, &keep, &taken, &err), &err);
    ck_assert_ptr_eq(taken.texels, solid.texels);
    texture.depth = 8;
    ck_assert_int_eq(hatch_solid_take(&texture, &keep, &taken, &err), HATCH_BAD_INPUT);
    ck_assert_str_eq(err.text, "16x16x8 texels, want a cube or a square");
}
END_TEST

/* Code 188 of sRGB is 0.5029 in linear light, 128 of 255; 64 is 0.0513, 13 of 255. Alpha is left out. */
START_TEST(codes_of_srgb_are_decoded)
{
    static const uint8_t codes[] = {0, 64, 188, 255}, values[2][4] = {{0, 64, 188, 255}, {0, 13, 128, 255}};
    for (uint32_t channels = 1; channels <= 4; channels += channels == 1 ? 2 : 1)
        for (int srgb = 0; srgb < 2; srgb++) {
            struct hatch_solid taken;
            struct hatch_texels texture = {
                .width = 8, .height = 8, .channels = channels, .level_count = 1, .srgb = srgb != 0};
            HATCH_TEST_OK(hatch_texels_make(&keep, &texture, &err), &err);
            for (size_t i = 0; i < 64 * channels; i++)
                texture.texels[0][i] = codes[i / channels % 4];
            HATCH_TEST_OK(hatch_solid_take(&texture, &keep, &taken, &err), &err);
            ck_assert_uint_eq(taken.channels, channels == 1 ? 1 : 3);
            for (size_t i = 0; i < 64 * taken.channels; i++)
                ck_assert_uint_eq(taken.texels[i], values[srgb][i / taken.channels % 4]);
        }
}
END_TEST

/* Makes a texture of n slices of a and the rest of b, as the parts of an OpenEXR file. */
static enum hatch_status join(struct hatch_image *a, uint32_t n, struct hatch_image *b, struct hatch_solid *solid)
{
    struct hatch_mipmap parts[8] = {{.name = "slice.000"}};
    for (uint32_t i = 0; i < 8; i++) {
        parts[i].level_count = 1;
        parts[i].levels = i < n ? a : b;
    }
    hatch_mipmap_set_text(&parts[0], HATCH_SOLID_KEY_ISOTROPIC, "yes");
    ck_assert(hatch_solid_is_slices(parts, 8));
    ck_assert(!hatch_solid_is_slices(parts + 1, 7));
    return hatch_solid_of_slices(parts, 8, &keep, solid, &err);
}

START_TEST(slices_are_a_cube)
{
    struct hatch_image grey, colored, wide, large;
    struct hatch_solid solid;
    HATCH_TEST_OK(hatch_image_make(&keep, 8, 8, "YA", &grey, &err), &err);
    HATCH_TEST_OK(hatch_image_make(&keep, 8, 8, "RGB", &colored, &err), &err);
    HATCH_TEST_OK(hatch_image_make(&keep, 16, 8, "Y", &wide, &err), &err);
    HATCH_TEST_OK(hatch_image_make(&keep, 16, 16, "Y", &large, &err), &err);
    grey.pixels[2 * 5] = 200 / 255.0f;
    colored.pixels[3 * 5 + 2] = 1;
    HATCH_TEST_OK(join(&grey, 8, &grey, &solid), &err);
    ck_assert_uint_eq(solid.channels, 1);
    ck_assert_uint_eq(solid.texels[64 + 5], 200);
    ck_assert(solid.isotropic);
    HATCH_TEST_OK(join(&colored, 8, &colored, &solid), &err);
    ck_assert_uint_eq(solid.channels, 3);
    ck_assert_uint_eq(solid.texels[3 * (7 * 64 + 5) + 2], 255);
    ck_assert_int_eq(join(&grey, 3, &colored, &solid), HATCH_BAD_INPUT);
    ck_assert_str_eq(err.text, "slice 3: no channel Y, want Y, or R, G and B");
    ck_assert_int_eq(join(&colored, 3, &grey, &solid), HATCH_BAD_INPUT);
    ck_assert_str_eq(err.text, "slice 3: no channel R, want Y, or R, G and B");
    ck_assert_int_eq(join(&grey, 7, &wide, &solid), HATCH_BAD_INPUT);
    ck_assert_str_eq(err.text, "slice 7: 16x8 texels, the first one has 8x8");
    ck_assert_int_eq(join(&large, 8, &large, &solid), HATCH_BAD_INPUT);
    ck_assert_str_eq(err.text, "16x16x8 texels, want a cube or a square");
}
END_TEST

/* 15,000 strokes and 64 rows: the strokes are most of the work, and more than the rows are reported. */
START_TEST(strokes_are_reported_as_they_are_made)
{
    struct hatch_solid_style style = {0};
    struct hatch_solid solid;
    struct reports reports = {0};
    const struct hatch_progress progress = {note_share, &reports};
    const struct hatch_solid_options options = {.style = &style, .size = 8, .seed = 1, .progress = &progress};
    HATCH_TEST_OK(parse_style("kind strokes\nwidth 0.03\nlength 0.25\ndensity 3", &style), &err);
    HATCH_TEST_OK(hatch_solid_from_style(&options, &keep, &scratch, &solid, &err), &err);
    ck_assert_uint_gt(reports.count, 64 + 12);
    ck_assert_double_lt(reports.last, 1);
    ck_assert_uint_gt(hatch_solid_style_bytes(&style, 8), 15000 * HATCH_SOLID_POINT_BYTES);
}
END_TEST

static enum hatch_status make(void *context, struct hatch_arena *arena, struct hatch_arena *temporary,
                              struct hatch_err *error)
{
    struct hatch_solid_style style = {0};
    HATCH_TRY(parse_style("kind strokes\nwidth 0.1\nlength 0.1\ndensity 2", &style));
    const struct hatch_solid_options options = {.style = &style, .size = 8, .seed = 1};
    return hatch_solid_from_style(&options, arena, temporary, context, error);
}

START_TEST(textures_survive_every_failed_allocation)
{
    struct hatch_solid solid = {0};
    hatch_test_fail_alloc(make, &solid, &solid, sizeof solid);
}
END_TEST

static Suite *suite(void)
{
    Suite *suite = suite_create("solid make");
    TCase *tests = tcase_create("make");
    tcase_add_checked_fixture(tests, begin, end);
    tcase_add_loop_test(tests, textures_are_uniform, 0, SMOOTH);
    tcase_add_loop_test(tests, textures_continue_over_the_border, 0, SMOOTH);
    tcase_add_loop_test(tests, threads_do_not_change_textures_and_seeds_do, 0, SMOOTH);
    tcase_add_loop_test(tests, textures_have_no_finer_features_than_their_texels_show, 0, 7);
    tcase_add_test(tests, worley_is_the_distance_from_the_points);
    tcase_add_test(tests, marble_without_warp_is_a_cosine);
    tcase_add_test(tests, contrast_and_colors_apply_to_the_values);
    tcase_add_test(tests, strokes_run_in_their_direction);
    tcase_add_loop_test(tests, directions_have_their_tones, 0, 3);
    tcase_add_test(tests, canvas_is_woven_along_all_axes);
    tcase_add_test(tests, slices_are_a_cube);
    tcase_add_test(tests, strokes_are_reported_as_they_are_made);
    tcase_add_test(tests, mip_levels_are_means);
    tcase_add_test(tests, codes_of_srgb_are_decoded);
    tcase_add_test(tests, textures_survive_every_failed_allocation);
    suite_add_tcase(suite, tests);
    return suite;
}
HATCH_TEST_MAIN(suite)
