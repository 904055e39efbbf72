#include "solid/points.h"

#include <float.h>
#include <math.h>

#include "arenas.h"
#include "base/random.h"
#include "fail_alloc.h"

static struct hatch_solid_points points;

/* The two smallest distances to the points and their copies in the 125 cubes around. */
static void nearest_by_force(const float at[3], float distances[2])
{
    distances[0] = distances[1] = FLT_MAX;
    for (uint32_t i = 0; i < points.count; i++)
        for (int copy = 0; copy < 125; copy++) {
            float dx = at[0] - points.at[i][0] - (float)(copy % 5 - 2),
                  dy = at[1] - points.at[i][1] - (float)(copy / 5 % 5 - 2),
                  dz = at[2] - points.at[i][2] - (float)(copy / 25 - 2);
            float distance = sqrtf(dx * dx + dy * dy + dz * dz) * points.factors[i];
            if (distance < distances[0]) {
                distances[1] = distances[0];
                distances[0] = distance;
            } else
                distances[1] = fminf(distances[1], distance);
        }
}

static void check_nearest(uint32_t places)
{
    for (uint32_t i = 0; i < places; i++) {
        float at[3], got[2], want[2];
        for (uint32_t c = 0; c < 3; c++)
            at[c] = hatch_random_unit(9, c, i);
        hatch_solid_points_nearest(&points, at, got);
        nearest_by_force(at, want);
        for (int k = 0; k < 2; k++)
            ck_assert_float_eq_tol(got[k], want[k], 1e-6f);
    }
}

START_TEST(nearest_points_are_those_of_an_exhaustive_search)
{
    static const uint32_t sides[] = {1, 2, 3, 8};
    for (int i = 0; i < 4; i++) {
        HATCH_TEST_OK(hatch_solid_points_jitter(sides[i], 1, 5, &keep, &points, &err), &err);
        check_nearest(60);
    }
    static const uint32_t counts[] = {1, 2, 30, 500};
    for (int i = 0; i < 4; i++) {
        HATCH_TEST_OK(hatch_solid_points_spread(counts[i], 1, 5, NULL, NULL, &keep, &scratch, &points, &err), &err);
        check_nearest(60);
    }
}
END_TEST

START_TEST(each_cell_has_one_jittered_point)
{
    HATCH_TEST_OK(hatch_solid_points_jitter(4, 0, 1, &keep, &points, &err), &err);
    ck_assert_uint_eq(points.count, 64);
    for (uint32_t i = 0; i < 64; i++) {
        ck_assert_float_eq(points.at[i][0], ((float)(i % 4) + 0.5f) / 4);
        ck_assert_float_eq(points.at[i][2], ((float)(i / 16) + 0.5f) / 4);
    }
    HATCH_TEST_OK(hatch_solid_points_jitter(4, 1, 1, &keep, &points, &err), &err);
    float moved = 0;
    for (uint32_t i = 0; i < 64; i++) {
        uint32_t cell = (hatch_solid_cell(points.at[i][2], 4) * 4 + hatch_solid_cell(points.at[i][1], 4)) * 4 +
                        hatch_solid_cell(points.at[i][0], 4);
        ck_assert_uint_eq(cell, i);
        moved = fmaxf(moved, fabsf(points.at[i][0] * 4 - (float)(i % 4) - 0.5f));
    }
    ck_assert_float_gt(moved, 0.4f);
}
END_TEST

/* Returns the smallest distance between two points, relative to count^(-1/3). */
static float least_distance(void)
{
    float least = FLT_MAX;
    for (uint32_t i = 0; i < points.count; i++)
        for (uint32_t j = 0; j < i; j++) {
            float squared = 0;
            for (int c = 0; c < 3; c++) {
                float away = fabsf(points.at[i][c] - points.at[j][c]);
                away = fminf(away, 1 - away);
                squared += away * away;
            }
            least = fminf(least, squared);
        }
    return sqrtf(least) * (float)cbrt(points.count);
}

START_TEST(spread_points_keep_their_distance)
{
    static const uint32_t counts[] = {8, 100, 1000, 2744};
    for (uint64_t i = 0; i < 4; i++) {
        HATCH_TEST_OK(hatch_solid_points_spread(counts[i], 0, i, NULL, NULL, &keep, &scratch, &points, &err), &err);
        ck_assert_uint_eq(points.count, counts[i]);
        ck_assert_uint_eq(points.first[points.cells * points.cells * points.cells], counts[i]);
        ck_assert_float_gt(least_distance(), 0.7f); /* of random points: about 0.1 of 1000 */
        ck_assert_float_eq(points.factors[0], 1);
    }
}
END_TEST

START_TEST(points_stand_in_their_cells_and_keep_their_numbers)
{
    uint32_t seen[300] = {0};
    HATCH_TEST_OK(hatch_solid_points_spread(300, 0.5f, 1, NULL, NULL, &keep, &scratch, &points, &err), &err);
    for (uint32_t cell = 0; cell < points.cells * points.cells * points.cells; cell++)
        for (uint32_t i = points.first[cell]; i < points.first[cell + 1]; i++) {
            uint32_t y = hatch_solid_cell(points.at[i][1], points.cells);
            ck_assert_uint_eq(y, cell / points.cells % points.cells);
            ck_assert_uint_eq(seen[points.numbers[i]]++, 0);
            ck_assert(points.factors[i] >= 0.75f && points.factors[i] <= 1.25f);
        }
}
END_TEST

START_TEST(threads_do_not_change_points)
{
    struct hatch_solid_points one;
    struct hatch_arena arena;
    struct hatch_pool *pool;
    hatch_arena_init(&arena, 1 << 20);
    HATCH_TEST_OK(hatch_pool_make(3, &arena, &pool, &err), &err);
    HATCH_TEST_OK(hatch_solid_points_spread(700, 0.5f, 1, NULL, NULL, &keep, &scratch, &one, &err), &err);
    HATCH_TEST_OK(hatch_solid_points_spread(700, 0.5f, 1, pool, NULL, &keep, &scratch, &points, &err), &err);
    ck_assert_mem_eq(one.at, points.at, 700 * sizeof *one.at);
    ck_assert_mem_eq(one.factors, points.factors, 700 * sizeof *one.factors);
    hatch_pool_free(pool);
    hatch_arena_free(&arena);
}
END_TEST

static enum hatch_status spread(void *context, struct hatch_arena *arena, struct hatch_arena *temporary,
                                struct hatch_err *error)
{
    return hatch_solid_points_spread(50, 0, 1, NULL, NULL, arena, temporary, context, error);
}

START_TEST(points_survive_every_failed_allocation)
{
    struct hatch_solid_points made = {0};
    hatch_test_fail_alloc(spread, &made, &made, sizeof made);
}
END_TEST

static Suite *suite(void)
{
    Suite *suite = suite_create("solid points");
    TCase *tests = tcase_create("points");
    tcase_add_checked_fixture(tests, begin, end);
    tcase_add_test(tests, nearest_points_are_those_of_an_exhaustive_search);
    tcase_add_test(tests, each_cell_has_one_jittered_point);
    tcase_add_test(tests, spread_points_keep_their_distance);
    tcase_add_test(tests, points_stand_in_their_cells_and_keep_their_numbers);
    tcase_add_test(tests, threads_do_not_change_points);
    tcase_add_test(tests, points_survive_every_failed_allocation);
    suite_add_tcase(suite, tests);
    return suite;
}
HATCH_TEST_MAIN(suite)
