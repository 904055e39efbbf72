/* Solid textures from pictures, by both methods. */
#include <math.h>

#include "arenas.h"
#include "base/reports.h"
#include "base/random.h"
#include "fail_alloc.h"
#include "measure/solid_figures.h"
#include "synthesis/synthesis.h"

static const struct hatch_synthesis_options quick = {
    .size = 16, .method = HATCH_SYNTHESIS_KOPF, .seed = 1, .side = 6, .levels = 3, .iterations = 3, .axes = 7};

typedef float (*paint)(uint32_t x, uint32_t y, uint32_t c);

static struct hatch_image picture(uint32_t width, uint32_t height, const char *names, paint value)
{
    struct hatch_image image;
    HATCH_TEST_OK(hatch_image_make(&keep, width, height, names, &image, &err), &err);
    uint32_t n = image.channel_count;
    for (uint32_t i = 0; i < width * height * n; i++)
        image.pixels[i] = value(i / n % width, i / n / width, i % n);
    return image;
}

static float flat(uint32_t x, uint32_t y, uint32_t c)
{
    (void)x, (void)y;
    return 0.2f * (float)(c + 1);
}

static float board(uint32_t x, uint32_t y, uint32_t c)
{
    (void)c;
    return (x / 4 + y / 4) % 2 ? 0.8f : 0.2f;
}

static float dots(uint32_t x, uint32_t y, uint32_t c)
{
    (void)c;
    return (x + y) % 2 ? 0.8f : 0.2f;
}

/* Three colours whose channels mix in no order. */
static float three_colors(uint32_t x, uint32_t y, uint32_t c)
{
    static const float colors[3][3] = {{0.2f, 0.8f, 0.4f}, {0.8f, 0.4f, 0.2f}, {0.4f, 0.2f, 0.8f}};
    return colors[hatch_random_u64(5, 0, (uint64_t)(y / 4) * 64 + x / 4) % 3][c];
}

static float stripes(uint32_t x, uint32_t y, uint32_t c)
{
    (void)y, (void)c;
    return x / 4 % 2 ? 1.0f : 0.0f;
}

static float slope(uint32_t x, uint32_t y, uint32_t c)
{
    (void)c;
    return (float)(x + y) / 128;
}

static float blots(uint32_t x, uint32_t y, uint32_t c)
{
    float value = hatch_random_unit(5, c % 3, (uint64_t)(y / 3) * 64 + x / 3);
    return value * value;
}

static struct hatch_solid make(const struct hatch_image *image, const struct hatch_synthesis_options *options,
                               struct hatch_synthesis_figures *figures)
{
    struct hatch_solid solid;
    HATCH_TEST_OK(hatch_synthesis_make(image, options, NULL, NULL, &keep, &scratch, &solid, figures, &err), &err);
    return solid;
}

static size_t bytes_of(const struct hatch_solid *solid)
{
    return (size_t)solid->size * solid->size * solid->size * solid->channels;
}

START_TEST(a_constant_exemplar_makes_a_constant_solid)
{
    static const uint32_t sizes[][2] = {{1, 1}, {3, 40}, {40, 2}, {64, 64}};
    for (uint32_t i = 0; i < 8; i++) {
        struct hatch_synthesis_figures figures;
        struct hatch_synthesis_options options = quick;
        struct hatch_image image = picture(sizes[i / 2][0], sizes[i / 2][1], i % 4 < 2 ? "RGBA" : "Y", flat);
        options.method = i % 2 ? HATCH_SYNTHESIS_PYRAMID : HATCH_SYNTHESIS_KOPF;
        struct hatch_solid solid = make(&image, &options, &figures);
        ck_assert_uint_eq(solid.size, 16);
        ck_assert_uint_eq(solid.channels, i % 4 < 2 ? 3 : 1);
        ck_assert_double_eq(figures.energy, 0);
        for (size_t t = 0; t < bytes_of(&solid); t++)
            ck_assert_int_le(abs(solid.texels[t] - (int)(51 * (t % solid.channels + 1))), i % 2);
    }
}
END_TEST

START_TEST(a_checkerboard_keeps_its_values_and_its_histogram)
{
    struct hatch_synthesis_figures figures;
    struct hatch_solid_figures measured;
    struct hatch_image image = picture(64, 64, "Y", board);
    struct hatch_solid solid = make(&image, &quick, &figures);
    for (size_t t = 0; t < bytes_of(&solid); t++)
        ck_assert(solid.texels[t] == 51 || solid.texels[t] == 204);
    HATCH_TEST_OK(hatch_measure_solid(&solid, &image, 200, NULL, &scratch, &measured, &err), &err);
    ck_assert_double_lt(measured.histogram, 0.05);
    ck_assert_double_lt(measured.neighborhood_all, 0.2);
}
END_TEST

/* A picture of a single neighbourhood is compared by smaller ones. */
START_TEST(a_picture_as_small_as_a_neighbourhood_keeps_its_values)
{
    for (uint32_t side = 2; side <= quick.side; side++) {
        struct hatch_synthesis_figures figures;
        struct hatch_image image = picture(side, side, "Y", side < 5 ? dots : board);
        struct hatch_solid solid = make(&image, &quick, &figures);
        size_t light = 0;
        for (size_t t = 0; t < bytes_of(&solid); t++)
            light += solid.texels[t] > 127;
        ck_assert_uint_gt(light, bytes_of(&solid) / 8);
        ck_assert_uint_lt(light, bytes_of(&solid) / 8 * 7);
    }
}
END_TEST

START_TEST(a_solid_has_the_colours_of_the_exemplar_only)
{
    struct hatch_synthesis_figures figures;
    struct hatch_image image = picture(40, 40, "RGB", three_colors);
    struct hatch_solid solid = make(
        &image,
        &(struct hatch_synthesis_options){.size = 16, .side = 6, .levels = 1, .iterations = 4, .axes = 7, .seed = 1},
        &figures);
    for (size_t t = 0; t < bytes_of(&solid); t += 3) {
        const uint8_t *color = solid.texels + t;
        ck_assert_int_eq(color[0] + color[1] + color[2], 51 + 204 + 102);
        ck_assert((color[0] == 51 && color[1] == 204) || (color[0] == 204 && color[1] == 102) ||
                  (color[0] == 102 && color[1] == 51));
    }
}
END_TEST

START_TEST(stripes_show_along_two_axes)
{
    struct hatch_synthesis_options options = quick;
    struct hatch_synthesis_figures figures;
    struct hatch_solid_figures measured;
    struct hatch_image image = picture(64, 64, "Y", stripes);
    options.size = 32;
    options.iterations = 4;
    struct hatch_solid solid = make(&image, &options, &figures);
    HATCH_TEST_OK(hatch_measure_solid(&solid, &image, 100, NULL, &scratch, &measured, &err), &err);
    ck_assert_double_lt(measured.histogram, 0.02);
    ck_assert_double_gt(figures.energy, 0.1); /* no solid has stripes in all slices */
    for (size_t t = 0; t < bytes_of(&solid); t++)
        ck_assert(solid.texels[t] == 0 || solid.texels[t] == 255);
    options.axes = 3;
    solid = make(&image, &options, &figures);
    HATCH_TEST_OK(hatch_measure_solid(&solid, &image, 100, NULL, &scratch, &measured, &err), &err);
    ck_assert_double_lt(figures.energy, 0.05);
    ck_assert_double_lt(measured.neighborhood[0] + measured.neighborhood[1], 0.1);
    ck_assert_double_lt(measured.step[2], 0.02);
}
END_TEST

START_TEST(both_methods_keep_the_histogram)
{
    for (uint32_t method = 0; method < 2; method++) {
        struct hatch_synthesis_options options = quick;
        struct hatch_synthesis_figures figures;
        struct hatch_solid_figures measured;
        struct hatch_image image = picture(60, 50, "RGB", blots);
        options.method = method ? HATCH_SYNTHESIS_PYRAMID : HATCH_SYNTHESIS_KOPF;
        options.size = 32;
        struct hatch_solid solid = make(&image, &options, &figures);
        HATCH_TEST_OK(hatch_measure_solid(&solid, &image, 100, NULL, &scratch, &measured, &err), &err);
        ck_assert_double_lt(measured.histogram, 0.06);
        ck_assert_double_gt(measured.isotropy, 0.8);
        ck_assert(measured.seam < 1.3);
    }
}
END_TEST

START_TEST(exemplars_of_all_sizes_make_solids)
{
    static const uint32_t sizes[][2] = {{1, 1}, {2, 2}, {1, 70}, {70, 1}, {5, 7}, {12, 12}, {13, 300}, {4000, 9}};
    static const paint paints[] = {board, slope, blots};
    for (uint32_t i = 0; i < sizeof sizes / sizeof *sizes; i++)
        for (uint32_t p = 0; p < 6; p++) {
            struct hatch_synthesis_options options = quick;
            struct hatch_synthesis_figures figures;
            struct hatch_image image = picture(sizes[i][0], sizes[i][1], p % 2 ? "RGB" : "YA", paints[p / 2]);
            options.size = 8;
            options.iterations = 1;
            options.side = 12;
            make(&image, &options, &figures);
            ck_assert(figures.energy >= 0 && figures.energy <= 1);
            options.method = HATCH_SYNTHESIS_PYRAMID;
            make(&image, &options, &figures);
        }
}
END_TEST

/* Both searches, run to the end: the energies of what they made. */
START_TEST(the_fast_search_finds_what_the_exhaustive_one_finds)
{
    double energies[2] = {0, 0};
    for (uint64_t seed = 1; seed <= 2; seed++)
        for (int exhaustive = 0; exhaustive < 2; exhaustive++) {
            struct hatch_synthesis_options options = quick;
            struct hatch_synthesis_figures figures;
            struct hatch_image image = picture(32, 32, "Y", blots);
            options.exhaustive = exhaustive;
            options.seed = seed;
            options.levels = 2;
            make(&image, &options, &figures);
            energies[exhaustive] += figures.energy;
        }
    ck_assert_double_lt(energies[0], 1.05 * energies[1]);
    ck_assert_double_gt(energies[0], 0.9 * energies[1]);
}
END_TEST

START_TEST(threads_make_the_same_bytes_and_seeds_others)
{
    struct hatch_image image = picture(64, 48, "RGB", blots);
    struct hatch_pool *pool;
    HATCH_TEST_OK(hatch_pool_make(3, &keep, &pool, &err), &err);
    for (uint32_t method = 0; method < 2; method++) {
        struct hatch_synthesis_options options = quick;
        struct hatch_synthesis_figures figures;
        struct hatch_solid threads;
        options.method = method ? HATCH_SYNTHESIS_PYRAMID : HATCH_SYNTHESIS_KOPF;
        struct hatch_solid alone = make(&image, &options, &figures);
        HATCH_TEST_OK(hatch_synthesis_make(&image, &options, pool, NULL, &keep, &scratch, &threads, &figures, &err),
                      &err);
        ck_assert_mem_eq(alone.texels, threads.texels, bytes_of(&alone));
        options.seed = 2;
        struct hatch_solid other = make(&image, &options, &figures);
        ck_assert_mem_ne(alone.texels, other.texels, bytes_of(&alone));
    }
    hatch_pool_free(pool);
}
END_TEST

START_TEST(progress_rises_to_the_end)
{
    for (uint32_t method = 0; method < 2; method++) {
        struct reports reports = {0, 0};
        const struct hatch_progress progress = {note_share, &reports};
        struct hatch_synthesis_options options = quick;
        struct hatch_synthesis_figures figures;
        struct hatch_solid solid;
        struct hatch_image image = picture(40, 40, "RGB", blots);
        options.method = method ? HATCH_SYNTHESIS_PYRAMID : HATCH_SYNTHESIS_KOPF;
        HATCH_TEST_OK(hatch_synthesis_make(&image, &options, NULL, &progress, &keep, &scratch, &solid, &figures, &err),
                      &err);
        ck_assert_double_eq_tol(reports.last, 1, 1e-9);
        ck_assert_uint_ge(reports.count, options.iterations);
    }
}
END_TEST

static uint32_t reported;

static void count_reports(void *context, double share)
{
    (void)context, (void)share;
    reported++;
}

START_TEST(memory_is_sixteen_times_the_solid_at_most)
{
    for (uint32_t method = 0; method < 2; method++) {
        struct hatch_synthesis_options options = quick;
        struct hatch_synthesis_figures figures;
        struct hatch_solid solid;
        struct hatch_image image = picture(64, 64, "Y", blots);
        struct hatch_arena results, temporary;
        options.method = method ? HATCH_SYNTHESIS_PYRAMID : HATCH_SYNTHESIS_KOPF;
        options.size = 64;
        options.iterations = 1;
        hatch_arena_init(&results, (size_t)1 << 30);
        hatch_arena_init(&temporary, (size_t)1 << 30);
        HATCH_TEST_OK(hatch_synthesis_make(&image, &options, NULL, NULL, &results, &temporary, &solid, &figures, &err),
                      &err);
        ck_assert_uint_le(results.peak_bytes + temporary.peak_bytes, 16 * bytes_of(&solid));
        hatch_arena_free(&temporary);
        hatch_arena_free(&results);
    }
}
END_TEST

START_TEST(too_much_memory_is_refused_before_work)
{
    static const struct hatch_progress progress = {count_reports, NULL};
    for (uint32_t method = 0; method < 2; method++) {
        struct hatch_synthesis_options options = quick;
        struct hatch_synthesis_figures figures;
        struct hatch_solid solid;
        struct hatch_image image = picture(90, 90, "Y", blots);
        enum hatch_status status = HATCH_LIMIT;
        options.method = method ? HATCH_SYNTHESIS_PYRAMID : HATCH_SYNTHESIS_KOPF;
        options.iterations = 1;
        reported = 0;
        for (size_t limit = 65536; status == HATCH_LIMIT; limit += 16384) {
            struct hatch_arena temporary;
            ck_assert_uint_eq(reported, 0);
            hatch_arena_init(&temporary, limit);
            status = hatch_synthesis_make(&image, &options, NULL, &progress, &keep, &temporary, &solid, &figures, &err);
            hatch_arena_free(&temporary);
        }
        ck_assert_int_eq(status, HATCH_OK);
        ck_assert_uint_gt(reported, 0);
    }
}
END_TEST

struct call {
    struct hatch_solid solid;
    struct hatch_synthesis_figures figures;
};

static enum hatch_status call_method(enum hatch_synthesis_method method, struct call *call, struct hatch_arena *results,
                                     struct hatch_arena *temporary, struct hatch_err *error)
{
    struct hatch_synthesis_options options = quick;
    static struct hatch_image image;
    if (!image.pixels)
        image = picture(300, 290, "RGB", blots);
    options.method = method;
    options.size = 8;
    options.iterations = 1;
    return hatch_synthesis_make(&image, &options, NULL, NULL, results, temporary, &call->solid, &call->figures, error);
}

static enum hatch_status call_kopf(void *context, struct hatch_arena *results, struct hatch_arena *temporary,
                                   struct hatch_err *error)
{
    return call_method(HATCH_SYNTHESIS_KOPF, context, results, temporary, error);
}

static enum hatch_status call_pyramid(void *context, struct hatch_arena *results, struct hatch_arena *temporary,
                                      struct hatch_err *error)
{
    return call_method(HATCH_SYNTHESIS_PYRAMID, context, results, temporary, error);
}

START_TEST(each_allocation_may_fail)
{
    struct call call = {.figures = {0}};
    hatch_test_fail_alloc(call_kopf, &call, &call, sizeof call);
    hatch_test_fail_alloc(call_pyramid, &call, &call, sizeof call);
}
END_TEST

static Suite *suite(void)
{
    Suite *suite = suite_create("synthesis");
    TCase *tests = tcase_create("synthesis");
    tcase_add_checked_fixture(tests, begin, end);
    tcase_add_test(tests, a_constant_exemplar_makes_a_constant_solid);
    tcase_add_test(tests, a_checkerboard_keeps_its_values_and_its_histogram);
    tcase_add_test(tests, a_picture_as_small_as_a_neighbourhood_keeps_its_values);
    tcase_add_test(tests, a_solid_has_the_colours_of_the_exemplar_only);
    tcase_add_test(tests, stripes_show_along_two_axes);
    tcase_add_test(tests, both_methods_keep_the_histogram);
    tcase_add_test(tests, exemplars_of_all_sizes_make_solids);
    tcase_add_test(tests, the_fast_search_finds_what_the_exhaustive_one_finds);
    tcase_add_test(tests, threads_make_the_same_bytes_and_seeds_others);
    tcase_add_test(tests, progress_rises_to_the_end);
    tcase_add_test(tests, memory_is_sixteen_times_the_solid_at_most);
    tcase_add_test(tests, too_much_memory_is_refused_before_work);
    tcase_add_test(tests, each_allocation_may_fail);
    suite_add_tcase(suite, tests);
    return suite;
}
HATCH_TEST_MAIN(suite)
