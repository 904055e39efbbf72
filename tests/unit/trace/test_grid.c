/* Items in cells of space, against all pairs. */
#include <math.h>
#include <stdbool.h>
#include <string.h>

#include "arenas.h"
#include "base/random.h"
#include "trace/grid.h"

enum { ITEMS = 3000 };

static double places[ITEMS][3];

/* Scatters items in a cube around the origin. */
static void scatter(uint64_t seed, double half)
{
    for (uint32_t i = 0; i < ITEMS; i++)
        for (uint32_t k = 0; k < 3; k++)
            places[i][k] = half * (2 * (double)hatch_random_unit(seed, k, i) - 1);
}

/* Checks that each item in the cells that a cube around a place touches is listed once, and no other. */
static void check_near(const struct hatch_trace_grid *grid, uint32_t count, const double at[3], double radius)
{
    uint32_t heads[27], wrong = 0;
    static uint8_t seen[ITEMS];
    memset(seen, 0, sizeof seen);
    uint32_t cells = hatch_trace_grid_near(grid, at, radius, heads);
    ck_assert_uint_le(cells, 27);
    for (uint32_t c = 0; c < cells; c++)
        for (uint32_t i = heads[c]; i != HATCH_TRACE_NONE; i = grid->next[i]) {
            ck_assert_uint_lt(i, count);
            ck_assert(!seen[i]);
            seen[i] = 1;
        }
    for (uint32_t i = 0; i < count; i++) {
        bool touched = true;
        for (int k = 0; k < 3; k++) {
            const double cell = floor(places[i][k] / grid->cell);
            touched =
                touched && cell >= floor((at[k] - radius) / grid->cell) && cell <= floor((at[k] + radius) / grid->cell);
        }
        wrong += seen[i] != touched;
    }
    ck_assert_uint_eq(wrong, 0);
}

/* Some hundred items to a cell, and cells for each of them: tables grow. After a clearing, cells of another size hold
 * what is added then. */
START_TEST(items_are_found_in_the_cells_around)
{
    static const double sides[] = {1.3, 0.02};
    struct hatch_trace_grid grid;
    hatch_trace_grid_begin(0.3, &keep, &grid);
    for (int pass = 0; pass < 2; pass++) {
        scatter((uint64_t)pass, 2);
        hatch_trace_grid_clear(&grid, sides[pass]);
        for (uint32_t i = 0; i < ITEMS; i++) {
            HATCH_TEST_OK(hatch_trace_grid_add(&grid, i, places[i], &err), &err);
            if (i % 500 == 7)
                check_near(&grid, i + 1, places[i / 2], sides[pass]);
        }
        for (uint32_t i = 0; i < ITEMS; i += 100)
            for (int part = 0; part <= 4; part++)
                check_near(&grid, ITEMS, places[i], 0.25 * part * sides[pass]);
        ck_assert(pass == 0 ? grid.used <= 4 * 4 * 4 : grid.used > ITEMS * 9 / 10);
        ck_assert_uint_ge(grid.slots, 2 * grid.used);
    }
}
END_TEST

/* Items need not be added in the order of their numbers. */
START_TEST(numbers_of_items_may_leave_gaps)
{
    struct hatch_trace_grid grid;
    uint32_t heads[27];
    const double at[3] = {-0.5, 0.5, 0.5};
    hatch_trace_grid_begin(1, &keep, &grid);
    HATCH_TEST_OK(hatch_trace_grid_add(&grid, 70000, at, &err), &err);
    HATCH_TEST_OK(hatch_trace_grid_add(&grid, 3, at, &err), &err);
    ck_assert_uint_eq(hatch_trace_grid_near(&grid, at, 0.25, heads), 1);
    ck_assert_uint_eq(heads[0], 3);
    ck_assert_uint_eq(grid.next[3], 70000);
    ck_assert_uint_eq(grid.next[70000], HATCH_TRACE_NONE);
}
END_TEST

START_TEST(an_empty_grid_has_no_items)
{
    struct hatch_trace_grid grid;
    uint32_t heads[27];
    const double at[3] = {0.5, 0.5, 0.5};
    hatch_trace_grid_begin(1, &keep, &grid);
    hatch_trace_grid_clear(&grid, 2);
    ck_assert_uint_eq(hatch_trace_grid_near(&grid, at, 1, heads), 0);
    HATCH_TEST_OK(hatch_trace_grid_add(&grid, 0, at, &err), &err);
    ck_assert_uint_eq(hatch_trace_grid_near(&grid, at, 1, heads), 1);
    hatch_trace_grid_clear(&grid, 1);
    ck_assert_uint_eq(grid.used, 0);
    ck_assert_uint_eq(hatch_trace_grid_near(&grid, at, 1, heads), 0);
}
END_TEST

static Suite *suite(void)
{
    Suite *made = suite_create("grid");
    TCase *tests = tcase_create("grid");
    tcase_add_checked_fixture(tests, begin, end);
    tcase_add_test(tests, items_are_found_in_the_cells_around);
    tcase_add_test(tests, numbers_of_items_may_leave_gaps);
    tcase_add_test(tests, an_empty_grid_has_no_items);
    suite_add_tcase(made, tests);
    return made;
}

HATCH_TEST_MAIN(suite)
