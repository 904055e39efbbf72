/* The borders of bins that are fitted to the steps of a map. */
#include "tam_made.h"

#include <math.h>

#include "base/random.h"
#include "tam/thresholds.h"

static struct hatch_thresholds made;

static void make(const struct hatch_tam *tam, uint32_t bins, const float *border)
{
    const struct hatch_threshold_options how = {.bins = bins, .border = border, .seed = 1};
    HATCH_TEST_OK(hatch_thresholds_make(tam, &how, NULL, &map_arena, &map_scratch, &made, &map_err), &map_err);
}

START_TEST(fitted_bins_have_a_smaller_error_than_even_ones)
{
    static const float even[] = {0, 1 / 7.0f, 2 / 7.0f, 3 / 7.0f, 4 / 7.0f, 5 / 7.0f, 6 / 7.0f, 1};
    struct test_map map;
    map_style("ink", "darkest 1", &map);
    map.options.tones = 255;
    map.options.size_px = 128;
    map_fill(&map);
    make(&map.tam, 7, even);
    double of_even = made.figures.error;
    make(&map.tam, 7, NULL);
    ck_assert_double_lt(made.figures.error, 0.95 * of_even);
    ck_assert_double_lt((double)(1 - made.border[6]), 0.7 * (double)made.border[1]);
}
END_TEST

static uint64_t seed;

/* A few texels darken, at up to four random tones by random amounts. */
static float a_few_changes(float u, float v, uint32_t level, float tone, uint32_t channel)
{
    uint64_t texel = (uint64_t)(u * 32) * 32 + (uint64_t)(v * 32);
    float dark = 0;
    if (hatch_random_unit(seed, texel, 9) > 0.02 + 0.02 * (double)seed)
        return 1;
    for (uint64_t i = 0; i < 4; i++)
        if (hatch_random_unit(seed, texel, i) < 0.5)
            dark += tone > (float)hatch_random_unit(seed + 50, texel, i)
                        ? 0.25f * (float)hatch_random_unit(seed + 99, texel, i)
                        : 0;
    return 1 - dark + 0 * (float)(level + channel);
}

/* Lists the codes and heights of the steps of a texel of the finest level; there are at most eight. */
static int steps_at(const struct hatch_tam *tam, size_t texel, double code[8], double height[8])
{
    int count = 0;
    double before = 0;
    for (uint32_t c = 0; c < tam->tones; c++) {
        double dark = 255 - hatch_unorm8(tam->columns[c].levels[0].pixels[texel]);
        if (dark == before)
            continue;
        ck_assert_int_lt(count, 8);
        code[count] = fmax(0, ceil(((c ? (double)tam->target[c - 1] : 0) + (double)tam->target[c]) / 2 * 255 - 0.501));
        height[count++] = dark - before;
        before = dark;
    }
    return count;
}

/* Adds the costs of pairs of steps that are in one bin, if the second bin begins at code e, to cost[e]. */
static void add_pairs(double *cost, const double *codes, const double *heights, int count, const double *other_codes,
                      const double *other_heights, int other_count, bool same_texel)
{
    for (int i = 0; i < count; i++)
        for (int j = same_texel ? i + 1 : 0; j < other_count; j++) {
            double a = heights[i], b = other_heights[j], low = fmin(codes[i], other_codes[j]);
            double high = fmax(codes[i], other_codes[j]), weight = same_texel ? 2 * a * b / (a + b) : (a + b) / 6;
            for (int e = 1; e < 256; e++)
                cost[e] += low < e && high >= e ? 0 : weight * (high - low);
        }
}

/* With two bins all borders can be tried: none costs less than the fitted one, by sums over texels and neighbours. */
START_TEST(fitted_bins_have_the_least_cost)
{
    enum { SIZE = 32, TEXELS = SIZE * SIZE };
    static double code[TEXELS][8], height[TEXELS][8], cost[256];
    static int count[TEXELS];
    seed = (uint64_t)_i;
    memset(cost, 0, sizeof cost);
    struct hatch_tam tam = made_map(SIZE, 255, 1, "Y", a_few_changes);
    for (size_t t = 0; t < TEXELS; t++)
        count[t] = steps_at(&tam, t, code[t], height[t]);
    for (size_t t = 0; t < TEXELS; t++) {
        size_t right = t / SIZE * SIZE + (t + 1) % SIZE, below = (t + SIZE) % TEXELS;
        add_pairs(cost, code[t], height[t], count[t], code[t], height[t], count[t], true);
        add_pairs(cost, code[t], height[t], count[t], code[right], height[right], count[right], false);
        add_pairs(cost, code[t], height[t], count[t], code[below], height[below], count[below], false);
    }
    make(&tam, 2, NULL);
    int border = (int)lround((double)made.border[1] * 255), best = 1;
    for (int e = 2; e < 256; e++)
        best = cost[e] < cost[best] ? e : best;
    ck_assert_double_gt(cost[best], 0);
    ck_assert_double_le(cost[border], cost[best] * (1 + 1e-4));
}
END_TEST

static Suite *suite(void)
{
    Suite *suite = suite_create("tam threshold bins");
    TCase *tests = tcase_create("bins");
    tcase_add_checked_fixture(tests, map_begin, map_end);
    tcase_add_test(tests, fitted_bins_have_a_smaller_error_than_even_ones);
    tcase_add_loop_test(tests, fitted_bins_have_the_least_cost, 0, 30);
    suite_add_tcase(suite, tests);
    return suite;
}
HATCH_TEST_MAIN(suite)
