/* Compares pictures of volumes and threshold textures with their models in libhatch, on a plane of one tone parallel to
 * the screen, with texels larger and smaller than pixels. */
#include <math.h>

#include "image/block_compress.h"
#include "render_frame.h"
#include "render_map.h"
#include "tam/thresholds.h"
#include "tam/volume.h"

enum { SIZE = 64, TONES = 16 };

static struct test_frame frame;
static struct hatch_tam map;
static struct hatch_volume volume;
static struct hatch_thresholds thresholds;
static struct asset asset;
static float anisotropy = 1;

/* Makes a map whose texels darken at two random tones each. */
static void nested_map(void)
{
    random_map(SIZE, TONES, &frame.args.keep, &map);
    for (uint32_t t = 0; t < TONES; t++) {
        map.target[t] = (float)(t + 1) / TONES;
        for (uint32_t level = 0; level < map.columns[t].level_count; level++) {
            struct hatch_image *image = &map.columns[t].levels[level];
            for (uint32_t i = 0; i < image->width * image->height; i++) {
                float first = hatch_random_unit(3, level, 2 * i), second = hatch_random_unit(3, level, 2 * i + 1);
                image->pixels[i] = 1 - 0.5f * (map.target[t] > first) - 0.5f * (map.target[t] > second);
            }
        }
    }
}

static void begin(double tone, double tiles)
{
    struct hatch_mesh mesh = frame_plane(&frame, 2);
    frame_open(&mesh, &frame_unit, NULL, &frame);
    frame.asset = asset;
    frame.assets.limits.anisotropy = frame.shown.style.anisotropy = fminf(anisotropy, frame.context.anisotropy_max);
    frame.shown.style.curve.low = frame.shown.style.curve.high = tone;
    frame.on_gpu.unit.items[0].repeat[0] = frame.on_gpu.unit.items[0].repeat[1] = (float)tiles;
}

static void make_volume(enum hatch_volume_layout layout)
{
    struct hatch_volume_options how = {.tones = TONES / 2, .layout = layout};
    struct hatch_volume_figures figures;
    HATCH_TEST_OK(hatch_volume_make(&map, &how, NULL, &frame.args.keep, &volume, &figures, &frame.err), &frame.err);
    asset.texture = (struct tone_texture){.holds = TONE_TEXTURE_VOLUME,
                                          .texels = volume.texels,
                                          .levels = volume.levels,
                                          .darkest = volume.darkest,
                                          .top = volume.top};
}

static void make_thresholds(void)
{
    struct hatch_threshold_options how = {.bins = HATCH_THRESHOLD_BINS, .seed = 1};
    HATCH_TEST_OK(
        hatch_thresholds_make(&map, &how, NULL, &frame.args.keep, &frame.args.scratch, &thresholds, &frame.err),
        &frame.err);
    asset.texture = (struct tone_texture){
        .holds = TONE_TEXTURE_THRESHOLDS, .texels = thresholds.texels, .levels = thresholds.levels, .darkest = 1};
}

static void make_exact(void)
{
    struct hatch_exact exact;
    HATCH_TEST_OK(hatch_exact_make(&map, NULL, &frame.args.keep, &frame.args.scratch, &exact, &frame.err), &frame.err);
    asset.texture = (struct tone_texture){
        .holds = TONE_TEXTURE_RUNS, .texels = exact.texels, .exact = exact, .levels = exact.levels, .darkest = 1};
}

/* GPUs may interpolate texels with eight bits only: a step this close to the tone may count or not. */
#define FILTER (1.5 / 255)
#define HEIGHTS 4.0 /* in 255ths: seven heights, each rounded by half a step, and the rounding of the picture */

/* Draws a tone and returns the largest difference from the model.
 *   tiles  repetitions across the picture; powers of two give whole levels */
static double worst_of(const char *technique, double tone, double tiles)
{
    struct hatch_image image;
    double worst = 0;
    begin(tone, tiles);
    frame_draw(&frame, technique, &view_facing, SIZE, SIZE, 1, &image);
    for (uint32_t row = 0; row < SIZE; row++)
        for (uint32_t column = 0; column < SIZE; column++) {
            float u = (float)((column + 0.5) / SIZE * tiles), v = (float)((row + 0.5) / SIZE * tiles);
            float want, value[4];
            float lod = (float)fmax(log2(tiles), 0), drawn = image.pixels[3 * (row * SIZE + column)], dark;
            if (asset.texture.holds == TONE_TEXTURE_VOLUME) {
                hatch_volume_sample(&volume, u, v, (float)tone, lod, true, value);
                dark = want = value[0];
            } else if (asset.texture.exact.columns) {
                dark = want = hatch_exact_sample(&asset.texture.exact, u, v, (float)tone, lod);
            } else {
                double margin = tiles < 1 ? FILTER : 0;
                want = hatch_thresholds_sample(&thresholds, u, v, (float)(tone - margin), lod);
                dark = hatch_thresholds_sample(&thresholds, u, v, (float)(tone + margin), lod);
            }
            worst = fmax(worst, fmax((double)(drawn - want), (double)(dark - drawn)));
        }
    frame_close(&frame);
    return worst;
}

/* Compresses the volume, with its greys varied at random; the model reads the texels that hatch_texels_decompress
 * returns. BC1 and BC7 hold the greys as colours. */
static void pack(enum hatch_texels_code code)
{
    struct hatch_texels plain = volume.texels;
    plain.channels = code == HATCH_TEXELS_BC4 ? 1 : 3;
    HATCH_TEST_OK(hatch_texels_make(&frame.args.keep, &plain, &frame.err), &frame.err);
    for (uint32_t level = 0; level < plain.level_count; level++)
        for (size_t i = 0; i < hatch_texels_level_size(&plain, level); i++)
            plain.texels[level][i] = (uint8_t)(volume.texels.texels[level][i / plain.channels] *
                                               hatch_random_unit(9, level, i / plain.channels));
    HATCH_TEST_OK(hatch_texels_compress(&plain, code, NULL, &frame.args.keep, &asset.texture.texels, NULL, &frame.err),
                  &frame.err);
    HATCH_TEST_OK(hatch_texels_decompress(&asset.texture.texels, &frame.args.keep, &volume.texels, &frame.err),
                  &frame.err);
}

/* Draws tones of a volume of which the darkest is `darkest`. */
static void check_volume(enum hatch_volume_layout layout, enum hatch_texels_code code, float darkest)
{
    static const double tones[] = {0, 0.01, 0.06, 0.3, 0.517, 0.99, 1}, tiles[] = {0.4, 1, 2, 4};
    frame_arenas(&frame);
    nested_map();
    make_volume(layout);
    asset.texture.darkest = volume.darkest = darkest;
    if (code != HATCH_TEXELS_PLAIN)
        pack(code);
    for (size_t t = 0; t < sizeof tones / sizeof *tones; t++)
        for (size_t k = 0; k < sizeof tiles / sizeof *tiles; k++) {
            double worst = worst_of("volume", tones[t], tiles[k]);
            /* drivers may round values between the end points of a block down */
            double most = (tiles[k] < 1 ? 2 : 1) + (code != HATCH_TEXELS_PLAIN ? 1 : 0);
            ck_assert_msg(worst <= most / 255, "tone %g, %g tiles: %g/255", tones[t], tiles[k], 255 * worst);
        }
    hatch_arena_free(&frame.args.keep);
    hatch_arena_free(&frame.args.scratch);
}

START_TEST(volumes_match_the_model)
{
    check_volume(HATCH_VOLUME_3D, HATCH_TEXELS_PLAIN, 1);
    check_volume(HATCH_VOLUME_3D, HATCH_TEXELS_PLAIN, 0.97f);
}
END_TEST

/* The images are even: drivers choose the texels of anisotropic filters as they like. */
START_TEST(tone_ends_alike_under_anisotropic_filters)
{
    static const double tones[] = {0, 0.01, 0.03, 0.06, 0.97, 0.99, 1};
    frame_arenas(&frame);
    random_map(SIZE, TONES, &frame.args.keep, &map);
    for (uint32_t t = 0; t < TONES; t++) {
        map.target[t] = (float)(t + 1) / TONES;
        for (uint32_t level = 0; level < map.columns[t].level_count; level++) {
            struct hatch_image *image = &map.columns[t].levels[level];
            for (uint32_t i = 0; i < image->width * image->height; i++)
                image->pixels[i] = 1 - map.target[t];
        }
    }
    make_volume(HATCH_VOLUME_3D);
    anisotropy = 8;
    for (size_t t = 0; t < sizeof tones / sizeof *tones; t++)
        for (double tiles = 0.5; tiles <= 4; tiles *= 2) {
            double worst = worst_of("volume", tones[t], tiles);
            ck_assert_msg(worst <= 1.0 / 255, "tone %g, %g tiles: %g/255", tones[t], tiles, 255 * worst);
        }
    anisotropy = 1;
    hatch_arena_free(&frame.args.keep);
    hatch_arena_free(&frame.args.scratch);
}
END_TEST

START_TEST(layered_volumes_match_the_model)
{
    check_volume(HATCH_VOLUME_ARRAY, HATCH_TEXELS_PLAIN, 1);
}
END_TEST

/* The driver and hatch_texels_decompress decode blocks alike. */
START_TEST(block_compressed_volumes_match_the_model)
{
    check_volume(HATCH_VOLUME_ARRAY, HATCH_TEXELS_BC4, 1);
    check_volume(HATCH_VOLUME_ARRAY, HATCH_TEXELS_BC1, 1);
    check_volume(HATCH_VOLUME_3D, HATCH_TEXELS_BC7, 1);
}
END_TEST

START_TEST(threshold_textures_match_the_model)
{
    static const double tones[] = {0, 0.06, 0.3, 0.517, 0.99}, tiles[] = {0.4, 1, 2, 4};
    frame_arenas(&frame);
    nested_map();
    make_thresholds();
    for (size_t t = 0; t < sizeof tones / sizeof *tones; t++)
        for (size_t k = 0; k < sizeof tiles / sizeof *tiles; k++) {
            double worst = worst_of("threshold", tones[t], tiles[k]);
            ck_assert_msg(worst <= (tiles[k] < 1 ? HEIGHTS : 1.0) / 255, "tone %g, %g tiles: %g/255", tones[t],
                          tiles[k], 255 * worst);
        }
    hatch_arena_free(&frame.args.keep);
    hatch_arena_free(&frame.args.scratch);
}
END_TEST

START_TEST(exact_runs_match_the_model)
{
    static const double tones[] = {0, 0.06, 0.3, 0.75, 1}, tiles[] = {0.4, 1, 4, 64};
    frame_arenas(&frame);
    nested_map();
    make_exact();
    for (size_t t = 0; t < sizeof tones / sizeof *tones; t++)
        for (size_t k = 0; k < sizeof tiles / sizeof *tiles; k++) {
            double worst = worst_of("threshold", tones[t], tiles[k]);
            ck_assert_msg(worst <= 1.0 / 255, "tone %g, %g tiles: %g/255", tones[t], tiles[k], 255 * worst);
        }
    hatch_arena_free(&frame.args.keep);
    hatch_arena_free(&frame.args.scratch);
}
END_TEST

/* At the tones of a volume's slices, with one texel per pixel, both forms read the same texel. */
START_TEST(exact_runs_equal_the_volume_at_its_tones)
{
    frame_arenas(&frame);
    nested_map();
    make_volume(HATCH_VOLUME_ARRAY);
    struct asset forms[2] = {asset};
    make_exact();
    forms[1] = asset;
    for (uint32_t slice = 0; slice < TONES / 2; slice += 3)
        for (double tiles = 1; tiles <= 4; tiles *= 2) {
            struct hatch_image pictures[2];
            for (int k = 0; k < 2; k++) {
                asset = forms[k];
                begin((slice + 0.5) / (TONES / 2.0), tiles);
                frame_draw(&frame, k ? "threshold" : "volume", &view_facing, SIZE, SIZE, 1, &pictures[k]);
                frame_close(&frame);
            }
            double worst = frame_difference(&pictures[0], &pictures[1]);
            ck_assert_msg(worst <= 2.0 / 255, "slice %u, %g tiles: %g/255", slice, tiles, 255 * worst);
        }
    hatch_arena_free(&frame.args.keep);
    hatch_arena_free(&frame.args.scratch);
}
END_TEST

START_TEST(tone_0_is_blank_paper)
{
    frame_arenas(&frame);
    nested_map();
    if (_i)
        make_exact();
    else
        make_thresholds();
    begin(0, 1);
    struct hatch_image image;
    frame_draw(&frame, "threshold-soft", &view_facing, SIZE, SIZE, 1, &image);
    for (size_t i = 0; i < 3 * SIZE * SIZE; i++)
        ck_assert_float_eq(image.pixels[i], 1.0f);
    frame_finish(&frame);
}
END_TEST

static Suite *suite(void)
{
    Suite *made = suite_create("render fine");
    TCase *tests = tcase_create("fine");
    tcase_add_test(tests, volumes_match_the_model);
    tcase_add_test(tests, tone_ends_alike_under_anisotropic_filters);
    tcase_add_test(tests, layered_volumes_match_the_model);
    tcase_add_test(tests, block_compressed_volumes_match_the_model);
    tcase_add_test(tests, threshold_textures_match_the_model);
    tcase_add_test(tests, exact_runs_match_the_model);
    tcase_add_test(tests, exact_runs_equal_the_volume_at_its_tones);
    tcase_add_loop_test(tests, tone_0_is_blank_paper, 0, 2);
    suite_add_tcase(made, tests);
    return made;
}

HATCH_TEST_MAIN(suite)
