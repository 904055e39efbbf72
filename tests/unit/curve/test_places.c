#include "arenas.h"
#include "run.h"

#include <math.h>

#include "curve/places.h"

#define SIDE 60u  /* of a square, in gaps */
#define PARTS 15u /* of a row of strokes: one after the other */
#define ROWS (2 * SIDE)
#define STROKES (ROWS * PARTS)

static struct hatch_mesh mesh;
static struct hatch_curve_point points[2 * STROKES];
static struct hatch_curve curves[STROKES];
static float thresholds[2 * STROKES];

/* Returns a threshold: on the mean, as many are under a limit as the limit says. */
static float threshold_of(uint32_t row)
{
    return 2 * ((float)(row * 79 % ROWS) + 0.5f) / (float)ROWS;
}

/* Makes rows of strokes half a gap apart, along the x axis of a square, and corrects their thresholds.
 *   dense  share of the square, from x 0 on, beyond which every second row has no strokes
 *   cut    beyond which the strokes have free ends: elsewhere, each goes on as the next one */
static void even_rows(double dense, double cut)
{
    static const float corners[] = {0, 0, 0, SIDE, 0, 0, SIDE, SIDE, 0, 0, SIDE, 0};
    static const uint32_t faces[] = {0, 1, 2, 0, 2, 3};
    struct hatch_curve_set set = {.gap = 1};
    HATCH_TEST_OK(hatch_mesh_make(&keep, 4, 2, &mesh, &err), &err);
    for (int i = 0; i < 12; i++)
        mesh.attributes[0].data[i] = corners[i];
    for (int i = 0; i < 6; i++)
        mesh.indices[i] = faces[i];
    for (uint32_t i = 0; i < STROKES; i++) {
        double y = (i / PARTS + 0.5) / ROWS, middle = (i % PARTS + 0.5) / PARTS;
        if (middle > dense && i / PARTS % 2 == 1)
            continue;
        for (uint32_t end = 0; end < 2; end++) {
            double x = (double)(i % PARTS + end) / PARTS;
            uint32_t face = y > x, p = 2 * set.count + end;
            points[p] = (struct hatch_curve_point){.face = face,
                                                   .share = {(float)(face ? x : x - y), (float)(face ? y - x : y)},
                                                   .threshold = threshold_of(i / PARTS)};
            thresholds[p] = points[p].threshold;
        }
        curves[set.count] =
            (struct hatch_curve){.first = 2 * set.count, .count = 2, .id = i, .free_ends = middle > cut ? 3 : 0};
        set.count++;
    }
    if (set.count < STROKES)
        curves[set.count].count = 0; /* ends the list */
    const struct hatch_curves all = {1, set.count, 2 * set.count, &set, curves, points, 0, 0};
    HATCH_TEST_OK(hatch_curves_even_places(&all, &mesh, NULL, &scratch, thresholds, &err), &err);
}

/* Returns the mean factor of thresholds between two places along the x axis, far from the borders.
 *   of      strokes' points: 2 * STROKES, some of them with threshold 0
 *   evened  their thresholds, corrected
 *   most    greatest threshold of points that count */
static double factor_of(const struct hatch_curve_point *of, const float *evened, float most, double from, double to)
{
    double sum = 0, count = 0;
    for (uint32_t p = 0; p < 2 * STROKES; p++) {
        float at[3];
        if (of[p].threshold <= 0 || of[p].threshold > most)
            continue;
        hatch_curve_position(&mesh, &of[p], at);
        if ((double)at[0] < from * SIDE || (double)at[0] > to * SIDE || fabs((double)at[1] - SIDE / 2.0) > SIDE / 3.0)
            continue;
        sum += log((double)(evened[p] / of[p].threshold));
        count++;
    }
    ck_assert(count > 0);
    return exp(sum / count);
}

static double factor_between(double from, double to)
{
    return factor_of(points, thresholds, 2, from, to);
}

START_TEST(equal_strokes_stay_equal)
{
    even_rows(1, 1);
    double factor = factor_between(0.2, 0.8);
    ck_assert_double_eq_tol(factor, 1, 0.12);
    ck_assert_double_eq_tol(factor_between(0.2, 0.4), factor, 0.03);
    ck_assert_double_eq_tol(factor_between(0.6, 0.8), factor, 0.03);
}
END_TEST

START_TEST(thresholds_are_lower_where_strokes_are_few)
{
    even_rows(0.5, 1);
    ck_assert_double_eq_tol(factor_between(0.7, 0.9) / factor_between(0.1, 0.3), 1 / 1.5, 0.1);
}
END_TEST

START_TEST(ends_count_as_lost_ink)
{
    even_rows(1, 0.5);
    double lost = factor_between(0.7, 0.9) / factor_between(0.1, 0.3);
    ck_assert_double_lt(lost, 0.87); /* two ends of .35 gaps of a stroke of 4 */
    ck_assert_double_gt(lost, 0.77);
}
END_TEST

/* Corrects the thresholds of the strokes that the last call of even_rows has left, with those below 1/2 as a coarse
 * level and the others as a finer one, for equal families.
 *   evened  out: per family, of the points as they are listed: coarse ones first */
static void even_levels(uint32_t families, struct hatch_curve_point *listed, float *evened)
{
    static struct hatch_curve list[2 * STROKES];
    struct hatch_curve_set sets[5] = {{.gap = 0}};
    uint32_t count = 0, from = 0;
    for (uint32_t family = 0; family < families; family++)
        for (uint32_t level = 0; level < 2; level++) {
            struct hatch_curve_set *set = &sets[2 * family + level];
            *set = (struct hatch_curve_set){.family = family, .level = level, .gap = level ? 1 : 2, .first = count};
            for (uint32_t c = 0; curves[c].count > 0; c++)
                if ((points[curves[c].first].threshold < 0.5f) == (level == 0)) {
                    list[count] = curves[c];
                    list[count].first = from;
                    for (uint32_t end = 0; end < 2; end++)
                        listed[from++] = points[curves[c].first + end];
                    count++;
                }
            set->count = count - set->first;
        }
    for (uint32_t i = 0; i < from; i++)
        evened[i] = listed[i].threshold;
    const struct hatch_curves all = {2 * families, count, from, sets, list, listed, 0, 0};
    float *again = HATCH_NEW(&keep, float, from, &err);
    struct hatch_pool *pool;
    memcpy(again, evened, from * sizeof *again);
    HATCH_TEST_OK(hatch_curves_even_places(&all, &mesh, NULL, &scratch, evened, &err), &err);
    HATCH_TEST_OK(hatch_pool_make(3, &keep, &pool, &err), &err);
    HATCH_TEST_OK(hatch_curves_even_places(&all, &mesh, pool, &scratch, again, &err), &err);
    hatch_pool_free(pool);
    ck_assert_mem_eq(again, evened, from * sizeof *again);
}

/* Where every second row is missing, the strokes of each level are corrected by as much as any are; families do not
 * count for each other. */
START_TEST(levels_and_families_are_corrected_alike)
{
    static struct hatch_curve_point listed[4 * STROKES], twice[4 * STROKES];
    static float one[4 * STROKES], two[4 * STROKES];
    uint32_t count = 0, coarse = 0;
    even_rows(0.5, 1);
    while (curves[count].count > 0)
        count++;
    even_levels(1, listed, one);
    even_levels(2, twice, two);
    for (uint32_t i = 0; i < 2 * count; i++) {
        ck_assert_float_eq(two[i], one[i]);
        ck_assert_float_eq(two[2 * count + i], one[i]);
        coarse += listed[i].threshold < 0.5f;
    }
    ck_assert(coarse > count / 4 && coarse < count);
    for (float most = 0.3f; most < 2.5f; most *= 1.9f)
        ck_assert_double_eq_tol(factor_of(listed, one, most, 0.7, 0.9), 1 / 1.5, 0.03);
}
END_TEST

static Suite *suite(void)
{
    Suite *made = suite_create("places");
    TCase *tests = tcase_create("places");
    tcase_add_checked_fixture(tests, begin, end);
    tcase_add_test(tests, equal_strokes_stay_equal);
    tcase_add_test(tests, thresholds_are_lower_where_strokes_are_few);
    tcase_add_test(tests, ends_count_as_lost_ink);
    tcase_add_test(tests, levels_and_families_are_corrected_alike);
    suite_add_tcase(made, tests);
    return made;
}

HATCH_TEST_MAIN(suite)
