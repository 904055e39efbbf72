#include "arenas.h"
#include "run.h"

#include "curve/cells.h"

static struct hatch_cells cells;

START_TEST(weights_tell_how_near_the_middles_are)
{
    const double at[3] = {2.25 * 3, -0.5 * 3, 7 * 3};
    uint32_t corner[8];
    double weight[8], sum = 0, mean[3] = {0, 0, 0};
    HATCH_TEST_OK(hatch_cells_make(3, &keep, &cells, &err), &err);
    HATCH_TEST_OK(hatch_cells_around(&cells, at, corner, weight, &err), &err);
    for (int i = 0; i < 8; i++) {
        double middle[3];
        hatch_cells_middle(&cells, corner[i], middle);
        ck_assert_double_eq(middle[0], i & 1 ? 9 : 6);
        ck_assert_double_eq(middle[1], i & 2 ? 0 : -3);
        ck_assert_double_eq(middle[2], i & 4 ? 24 : 21);
        ck_assert_double_eq_tol(weight[i], (i & 1 ? 0.25 : 0.75) * 0.5 * (i & 4 ? 0 : 1), 1e-15);
        sum += weight[i];
        for (int k = 0; k < 3; k++)
            mean[k] += weight[i] * middle[k];
    }
    ck_assert_double_eq_tol(sum, 1, 1e-15);
    for (int k = 0; k < 3; k++)
        ck_assert_double_eq_tol(mean[k], at[k], 1e-14);
}
END_TEST

START_TEST(sums_are_kept_while_the_table_grows)
{
    enum { SIDE = 20 };
    double ink = 0, area = 0, moment = 0;
    HATCH_TEST_OK(hatch_cells_make(0.5, &keep, &cells, &err), &err);
    for (int i = 0; i < SIDE * SIDE * SIDE; i++) {
        const double at[3] = {0.5 * (i % SIDE) + 0.125, 0.5 * (i / SIDE % SIDE), -0.5 * (i / SIDE / SIDE) - 0.25};
        HATCH_TEST_OK(hatch_cells_add(&cells, at, 1, 2 + i % SIDE, &err), &err);
    }
    ck_assert_uint_eq(cells.keys.count, (SIDE + 1) * (SIDE + 1) * (SIDE + 1));
    for (uint32_t c = 0; c < cells.keys.count; c++) {
        double middle[3];
        hatch_cells_middle(&cells, c, middle);
        ink += (double)cells.cells[c].ink;
        area += (double)cells.cells[c].area;
        moment += (double)cells.cells[c].ink * middle[0];
    }
    ck_assert_double_eq_tol(ink, SIDE * SIDE * SIDE, 1e-3);
    ck_assert_double_eq_tol(area, (2 + (SIDE - 1) / 2.0) * SIDE * SIDE * SIDE, 1e-2);
    ck_assert_double_eq_tol(moment / ink, 0.5 * (SIDE - 1) / 2 + 0.125, 1e-6);
}
END_TEST

START_TEST(places_far_out_and_cells_of_no_size_are_safe)
{
    const double at[3] = {3e38, -3e38, 0};
    uint32_t corner[8];
    double weight[8];
    HATCH_TEST_OK(hatch_cells_make(1e-38, &keep, &cells, &err), &err);
    HATCH_TEST_OK(hatch_cells_around(&cells, at, corner, weight, &err), &err);
    for (int i = 0; i < 8; i++)
        ck_assert_uint_lt(corner[i], cells.keys.count);
}
END_TEST

static Suite *suite(void)
{
    Suite *made = suite_create("cells");
    TCase *tests = tcase_create("cells");
    tcase_add_checked_fixture(tests, begin, end);
    tcase_add_test(tests, weights_tell_how_near_the_middles_are);
    tcase_add_test(tests, sums_are_kept_while_the_table_grows);
    tcase_add_test(tests, places_far_out_and_cells_of_no_size_are_safe);
    suite_add_tcase(made, tests);
    return made;
}

HATCH_TEST_MAIN(suite)
