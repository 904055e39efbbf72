/* The solvers on a grid of nodes, whose minimum is known: all nodes have the value of the one with data. */
#include <math.h>
#include <string.h>

#include "arenas.h"
#include "base/random.h"
#include "field/system.h"

#define SIDE 40u
#define NODES (SIDE * SIDE)
#define ANGLE 0.7

struct grid {
    struct hatch_field_system system;
    double z[2 * NODES];
};

/* Links of weight 1 to the four neighbours, and data at one node.
 *   side  nodes along a side, at most SIDE */
static struct grid *make_grid(uint32_t side)
{
    uint32_t nodes = side * side, given = 77 % nodes;
    struct grid *made = HATCH_NEW(&keep, struct grid, 1, &err);
    ck_assert_ptr_nonnull(made);
    struct hatch_field_system *system = &made->system;
    system->count = nodes;
    system->first = HATCH_NEW(&keep, uint32_t, NODES + 1, &err);
    system->to = HATCH_NEW(&keep, uint32_t, 4 * NODES, &err);
    system->link = HATCH_NEW(&keep, double, 8 * NODES, &err);
    system->diagonal = HATCH_NEW(&keep, double, NODES, &err);
    system->data_weight = HATCH_NEW(&keep, double, NODES, &err);
    system->rhs = HATCH_NEW(&keep, double, 2 * NODES, &err);
    ck_assert(system->first && system->to && system->link && system->diagonal && system->data_weight && system->rhs);
    uint32_t links = 0;
    for (uint32_t n = 0; n < nodes; n++) {
        const bool inside[4] = {n % side > 0, n % side < side - 1, n >= side, n < nodes - side};
        const uint32_t beside[4] = {n - 1, n + 1, n - side, n + side};
        for (int k = 0; k < 4; k++)
            if (inside[k]) {
                system->to[links] = beside[k];
                system->link[2 * links++] = 1;
                system->diagonal[n] += 1;
            }
        system->first[n + 1] = links;
        double angle = ANGLE + 2 * ((double)hatch_random_unit(3, 0, n) - 0.5);
        made->z[2 * n] = cos(angle);
        made->z[2 * n + 1] = sin(angle);
    }
    system->data_weight[given] = 5;
    system->diagonal[given] += 5;
    system->rhs[2 * given] = 5 * cos(ANGLE);
    system->rhs[2 * given + 1] = 5 * sin(ANGLE);
    return made;
}

START_TEST(all_nodes_take_the_value_of_the_data)
{
    struct grid *grid = make_grid(SIDE);
    struct hatch_field_convergence convergence = {.iterations = 3};
    struct hatch_field_levels *levels;
    double z[2 * NODES + 1] = {[2 * NODES] = 7}; /* the last one is not of a node */
    memcpy(z, grid->z, sizeof grid->z);
    HATCH_TEST_OK(hatch_field_coarsen(&grid->system, &keep, &levels, &err), &err);
    for (int from_zero = 0; from_zero < 2; from_zero++) {
        HATCH_TEST_OK(hatch_field_solve_multigrid(levels, 1e-8, 200, &scratch, z, &convergence, &err), &err);
        for (uint32_t n = 0; n < NODES; n++) {
            ck_assert_double_eq_tol(z[2 * n], cos(ANGLE), 1e-5);
            ck_assert_double_eq_tol(z[2 * n + 1], sin(ANGLE), 1e-5);
        }
        ck_assert_double_eq(z[2 * NODES], 7);
        memset(z, 0, sizeof grid->z);
    }
    ck_assert_uint_lt(convergence.iterations, 3 + 2 * 60);
    memset(z, 0, sizeof grid->z);
    HATCH_TEST_OK(hatch_field_solve_cholesky(&grid->system, (size_t)1 << 28, &scratch, z, &err), &err);
    for (uint32_t n = 0; n < NODES; n++) {
        ck_assert_double_eq_tol(z[2 * n], cos(ANGLE), 1e-9);
        ck_assert_double_eq_tol(z[2 * n + 1], sin(ANGLE), 1e-9);
    }
    ck_assert_double_eq(z[2 * NODES], 7);
}
END_TEST

/* Measured: 2 iterations on a system that has no coarser one, and 20; without backward sweeps on the coarsest level, 7
 * and 22. */
START_TEST(multigrid_takes_few_iterations)
{
    static const uint32_t sides[2] = {3, SIDE}, most[2] = {3, 25};
    for (int i = 0; i < 2; i++) {
        struct grid *grid = make_grid(sides[i]);
        struct hatch_field_convergence convergence = {0};
        struct hatch_field_levels *levels;
        HATCH_TEST_OK(hatch_field_coarsen(&grid->system, &keep, &levels, &err), &err);
        HATCH_TEST_OK(hatch_field_solve_multigrid(levels, 1e-8, 200, &scratch, grid->z, &convergence, &err), &err);
        ck_assert_uint_le(convergence.iterations, most[i]);
    }
}
END_TEST

START_TEST(all_nodes_take_the_angle_of_the_data)
{
    struct grid *grid = make_grid(SIDE);
    struct hatch_field_convergence convergence = {.iterations = 3};
    HATCH_TEST_OK(hatch_field_descend(&grid->system, 1e-7, 2000, &scratch, grid->z, &convergence, &err), &err);
    ck_assert_uint_gt(convergence.iterations, 3 + 10);
    ck_assert_uint_lt(convergence.iterations, 3 + 500);
    ck_assert_ptr_null(hatch_arena_mark(&scratch).block);
    for (uint32_t n = 0; n < NODES; n++) {
        ck_assert_double_eq_tol(grid->z[2 * n], cos(ANGLE), 1e-3);
        ck_assert_double_eq_tol(grid->z[2 * n + 1], sin(ANGLE), 1e-3);
    }
}
END_TEST

/* Nine numbers of the state, and two for each of the eight steps kept; blocks of an arena leave some memory unused. */
START_TEST(a_node_takes_25_numbers)
{
    for (uint32_t numbers = 24; numbers <= 28; numbers += 4) {
        struct grid *grid = make_grid(SIDE);
        struct hatch_field_convergence convergence = {0};
        struct hatch_arena small;
        hatch_arena_init(&small, numbers * NODES * sizeof(double));
        enum hatch_status want = numbers < 25 ? HATCH_LIMIT : HATCH_OK;
        ck_assert_int_eq(hatch_field_descend(&grid->system, 1e-3, 5, &small, grid->z, &convergence, &err), want);
        hatch_arena_free(&small);
    }
}
END_TEST

static Suite *suite(void)
{
    Suite *suite = suite_create("field solvers");
    TCase *tests = tcase_create("solvers");
    tcase_add_checked_fixture(tests, begin, end);
    tcase_add_test(tests, all_nodes_take_the_value_of_the_data);
    tcase_add_test(tests, multigrid_takes_few_iterations);
    tcase_add_test(tests, all_nodes_take_the_angle_of_the_data);
    tcase_add_test(tests, a_node_takes_25_numbers);
    suite_add_tcase(suite, tests);
    return suite;
}
HATCH_TEST_MAIN(suite)
