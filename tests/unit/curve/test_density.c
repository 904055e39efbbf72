#include "arenas.h"
#include "run.h"

#include "curve/density.h"

#define STROKES 128

static const float positions[] = {0, 0, 0, 1, 0, 0, 0, 1, 0};
static const uint32_t faces[] = {0, 1, 2};
static double area = 0.5;
static const struct hatch_curve_groups whole = {.count = 1, .area = &area};
static struct hatch_mesh mesh;
static struct hatch_curve_point points[2 * STROKES];
static struct hatch_curve curves[STROKES];
static struct hatch_curve_set set = {.gap = 1, .count = STROKES};
static const struct hatch_curves all = {1, STROKES, 2 * STROKES, &set, curves, points, 0, 0};

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
    HATCH_TEST_OK(hatch_curves_even_thresholds(&all, &mesh, &whole, &scratch, even, &err), &err);
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
    HATCH_TEST_OK(hatch_curves_even_thresholds(&all, &mesh, &whole, &scratch, even, &err), &err);
    for (uint32_t p = 0; p < 2 * STROKES; p++)
        ck_assert_double_eq_tol((double)even[p], 1000 / HATCH_DENSITY_MOST, 1e-3);
}
END_TEST

/* Three triangles apart, whose areas are 1/2, 2 and 1/2: on the first are `many` strokes, on the second twice as many,
 * and on the third one, all of length 1/4 and of the same threshold. */
static struct hatch_curves make_three(uint32_t many)
{
    static const float sides[] = {1, 2, 1};
    float *to;
    HATCH_TEST_OK(hatch_mesh_make(&keep, 9, 3, &mesh, &err), &err);
    to = mesh.attributes[0].data;
    for (uint32_t v = 0; v < 9; v++) {
        for (uint32_t k = 0; k < 3; k++)
            to[3 * v + k] = sides[v / 3] * positions[3 * (v % 3) + k] + (k == 2 ? (float)(v / 3) : 0);
        mesh.indices[v] = v;
    }
    set.count = 3 * many + 1;
    for (uint32_t s = 0; s < set.count; s++) {
        uint32_t face = s < many ? 0 : s < 3 * many ? 1 : 2;
        curves[s] = (struct hatch_curve){.first = 2 * s, .count = 2, .id = s};
        for (uint32_t i = 0; i < 2; i++)
            points[2 * s + i] = (struct hatch_curve_point){.face = face,
                                                           .share = {0.25f / sides[face] * (float)i, 0.5f},
                                                           .threshold = 1 + 1e-5f * (float)(2 * s + i)};
    }
    return (struct hatch_curves){.set_count = 1,
                                 .count = set.count,
                                 .point_count = 2 * set.count,
                                 .sets = &set,
                                 .curves = curves,
                                 .points = points};
}

START_TEST(components_are_evened_on_their_own)
{
    const uint32_t many = HATCH_DENSITY_FEW;
    const struct hatch_curves three = make_three(many);
    const float first = (float)many / 2, second = (float)many / 4; /* strokes of length 1/4 on an area of 1/2, of 2 */
    struct hatch_curve_groups groups;
    float even[2 * STROKES], densest[3];
    HATCH_TEST_OK(hatch_curves_group(&three, &mesh, &keep, &scratch, &groups, &err), &err);
    ck_assert_uint_eq(groups.count, 3);
    ck_assert_uint_eq(groups.of_face[2], 0); /* it has few strokes */
    for (uint32_t f = 0; f < 3; f++)
        ck_assert_double_eq_tol(groups.area[groups.of_face[f]], f == 1 ? 2 : 0.5, 1e-6);
    for (uint32_t p = 0; p < three.point_count; p++)
        even[p] = 0.75f * (points[p].face == 0 ? first : points[p].face == 1 ? second : 0.5f);
    HATCH_TEST_OK(hatch_curves_even_thresholds(&three, &mesh, &groups, &scratch, even, &err), &err);
    HATCH_TEST_OK(hatch_curves_densest(&three, &groups, even, &scratch, densest, &err), &err);
    ck_assert_float_eq_tol(densest[groups.of_face[0]], first, first / (float)many);
    ck_assert_float_eq_tol(densest[groups.of_face[1]], second, second / (float)many);
    ck_assert_float_eq_tol(densest[groups.of_face[2]], 0.375f, 1e-6f); /* the end of its only stroke */
}
END_TEST

START_TEST(components_with_few_strokes_are_evened_together)
{
    const struct hatch_curves three = make_three(HATCH_DENSITY_FEW / 2 - 1);
    struct hatch_curve_groups groups;
    HATCH_TEST_OK(hatch_curves_group(&three, &mesh, &keep, &scratch, &groups, &err), &err);
    ck_assert_uint_eq(groups.count, 1);
    ck_assert_double_eq_tol(groups.area[0], 3, 1e-6);
}
END_TEST

START_TEST(a_single_threshold_is_not_the_greatest_density)
{
    enum { COUNT = 2 * HATCH_DENSITY_BEYOND };
    static float thresholds[COUNT];
    static struct hatch_curve_point places[COUNT];
    struct hatch_curves many = {.point_count = COUNT, .points = places};
    float densest = 0;
    for (uint32_t i = 0; i < COUNT; i++)
        thresholds[i] = 1 + (float)(7919 * i % COUNT); /* each number once */
    HATCH_TEST_OK(hatch_curves_densest(&many, &whole, thresholds, &scratch, &densest, &err), &err);
    ck_assert_float_eq(densest, COUNT - 2);
    thresholds[5] = 1e6f;
    HATCH_TEST_OK(hatch_curves_densest(&many, &whole, thresholds, &scratch, &densest, &err), &err);
    ck_assert_float_eq(densest, COUNT - 1);
    many.point_count = HATCH_DENSITY_BEYOND - 1;
    HATCH_TEST_OK(hatch_curves_densest(&many, &whole, thresholds, &scratch, &densest, &err), &err);
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
    tcase_add_test(tests, components_are_evened_on_their_own);
    tcase_add_test(tests, components_with_few_strokes_are_evened_together);
    tcase_add_test(tests, a_single_threshold_is_not_the_greatest_density);
    suite_add_tcase(made, tests);
    return made;
}

HATCH_TEST_MAIN(suite)
