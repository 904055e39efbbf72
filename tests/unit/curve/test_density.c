#include "arenas.h"
#include "run.h"

#include "curve/density.h"

#define STROKES 64

static const float positions[] = {0, 0, 0, 1, 0, 0, 0, 1, 0};
static const uint32_t faces[] = {0, 1, 2};
static struct hatch_mesh mesh;
static struct hatch_curve_point points[2 * STROKES];
static struct hatch_curve curves[STROKES];
static struct hatch_curve_set set = {.gap = 1, .count = STROKES};
static const struct hatch_curves all = {1, STROKES, 2 * STROKES, &set, curves, points};

/* Strokes of length 1/4 on a triangle of area 1/2, so that each adds a density of 1/2. */
static void make_strokes(void)
{
    float *to;
    HATCH_TEST_OK(hatch_mesh_make(&keep, 3, 1, &mesh, &err), &err);
    to = mesh.attributes[0].data;
    for (int i = 0; i < 9; i++)
        to[i] = positions[i];
    for (int i = 0; i < 3; i++)
        mesh.indices[i] = faces[i];
    for (uint32_t s = 0; s < STROKES; s++) {
        curves[s] = (struct hatch_curve){.first = 2 * s, .count = 2, .id = s};
        for (uint32_t i = 0; i < 2; i++)
            points[2 * s + i] = (struct hatch_curve_point){.share = {0.25f * (float)i, 0.5f}, .threshold = 1};
    }
}

START_TEST(thresholds_become_the_density_below_them)
{
    float even[2 * STROKES];
    make_strokes();
    for (uint32_t p = 0; p < 2 * STROKES; p++) /* uneven, as levels make them */
        points[p].threshold = 0.5f * (float)(p / 2 + 1) * (p / 2 % 8 < 4 ? 1.3f : 0.9f);
    for (uint32_t p = 0; p < 2 * STROKES; p++)
        even[p] = points[p].threshold;
    HATCH_TEST_OK(hatch_curves_even_thresholds(&all, &mesh, &scratch, even, &err), &err);
    for (uint32_t p = 0; p < 2 * STROKES; p++) {
        double below = 0, upto = 0;
        for (uint32_t q = 0; q < 2 * STROKES; q++) {
            below += points[q].threshold < points[p].threshold ? 0.25 : 0;
            upto += points[q].threshold <= points[p].threshold ? 0.25 : 0;
        }
        ck_assert_double_ge((double)even[p], below);
        ck_assert_double_le((double)even[p], upto);
    }
}
END_TEST

START_TEST(no_threshold_changes_by_more_than_the_limit)
{
    float even[2 * STROKES];
    make_strokes();
    for (uint32_t p = 0; p < 2 * STROKES; p++)
        points[p].threshold = 1000;
    for (uint32_t p = 0; p < 2 * STROKES; p++)
        even[p] = points[p].threshold;
    HATCH_TEST_OK(hatch_curves_even_thresholds(&all, &mesh, &scratch, even, &err), &err);
    for (uint32_t p = 0; p < 2 * STROKES; p++)
        ck_assert_double_eq_tol((double)even[p], 1000 / HATCH_DENSITY_MOST, 1e-3);
}
END_TEST

START_TEST(a_single_threshold_is_not_the_greatest_density)
{
    enum { COUNT = 2 * HATCH_DENSITY_BEYOND };
    static float thresholds[COUNT];
    float densest = 0;
    for (uint32_t i = 0; i < COUNT; i++)
        thresholds[i] = 1 + (float)(7919 * i % COUNT); /* each number once */
    HATCH_TEST_OK(hatch_curves_densest(thresholds, COUNT, &scratch, &densest, &err), &err);
    ck_assert_float_eq(densest, COUNT - 2);
    thresholds[5] = 1e6f;
    HATCH_TEST_OK(hatch_curves_densest(thresholds, COUNT, &scratch, &densest, &err), &err);
    ck_assert_float_eq(densest, COUNT - 1);
    HATCH_TEST_OK(hatch_curves_densest(thresholds, HATCH_DENSITY_BEYOND - 1, &scratch, &densest, &err), &err);
    ck_assert_float_eq(densest, 1e6f); /* of few points, the greatest */
}
END_TEST

static Suite *suite(void)
{
    Suite *made = suite_create("density");
    TCase *tests = tcase_create("density");
    tcase_add_checked_fixture(tests, begin, end);
    tcase_add_test(tests, thresholds_become_the_density_below_them);
    tcase_add_test(tests, no_threshold_changes_by_more_than_the_limit);
    tcase_add_test(tests, a_single_threshold_is_not_the_greatest_density);
    suite_add_tcase(made, tests);
    return made;
}

HATCH_TEST_MAIN(suite)
