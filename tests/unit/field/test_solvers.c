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
    uint32_t component_first[3];
    double z[2 * NODES];
};

/* Adds data of an angle to a node. */
static void give(struct hatch_field_system *system, uint32_t node, double weight, double angle)
{
    system->data_weight[node] += weight;
    system->diagonal[node] += weight;
    system->rhs[2 * node] += weight * cos(angle);
    system->rhs[2 * node + 1] += weight * sin(angle);
}

/* Links of weight 1 to the four neighbours.
 *   side  nodes along a side, at most SIDE
 *   cut   row that has no links to the one before: the first of the second component; 0: there is one component */
static struct grid *make_bare_grid(uint32_t side, uint32_t cut)
{
    uint32_t nodes = side * side;
    struct grid *made = HATCH_NEW(&keep, struct grid, 1, &err);
    ck_assert_ptr_nonnull(made);
    struct hatch_field_system *system = &made->system;
    system->count = nodes;
    system->component_count = cut > 0 ? 2 : 1;
    system->component_first = made->component_first;
    made->component_first[1] = cut > 0 ? cut * side : nodes;
    made->component_first[2] = nodes;
    system->first = HATCH_NEW(&keep, uint32_t, NODES + 1, &err);
    system->to = HATCH_NEW(&keep, uint32_t, 4 * NODES, &err);
    system->link = HATCH_NEW(&keep, double, 8 * NODES, &err);
    system->diagonal = HATCH_NEW(&keep, double, NODES, &err);
    system->data_weight = HATCH_NEW(&keep, double, NODES, &err);
    system->rhs = HATCH_NEW(&keep, double, 2 * NODES, &err);
    ck_assert(system->first && system->to && system->link && system->diagonal && system->data_weight && system->rhs);
    uint32_t links = 0;
    for (uint32_t n = 0; n < nodes; n++) {
        uint32_t row = n / side;
        const bool inside[4] = {n % side > 0, n % side<side - 1, row> 0 && row != cut,
                                row + 1 < side && row + 1 != cut};
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
    return made;
}

/* As above, with data at one node. */
static struct grid *make_grid(uint32_t side)
{
    struct grid *made = make_bare_grid(side, 0);
    give(&made->system, 77 % (side * side), 5, ANGLE);
    return made;
}

/* Solves by both iterative solvers, from zero and from the values in grid->z, to tolerances that suit directions. */
static void solve(struct grid *grid, bool descend, double *z)
{
    struct hatch_field_convergence convergence = {0};
    struct hatch_field_levels *levels;
    if (descend) {
        memcpy(z, grid->z, sizeof grid->z);
        HATCH_TEST_OK(hatch_field_descend(&grid->system, 1e-5, 2000, &scratch, z, &convergence, &err), &err);
        return;
    }
    memset(z, 0, sizeof grid->z);
    HATCH_TEST_OK(hatch_field_coarsen(&grid->system, &keep, &levels, &err), &err);
    HATCH_TEST_OK(hatch_field_solve_multigrid(levels, 1e-4, 200, &scratch, z, &convergence, &err), &err);
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

/* to = i^quarters from */
static void turn(uint32_t quarters, const double from[2], double to[2])
{
    static const double unit[4][2] = {{1, 0}, {0, 1}, {-1, 0}, {0, -1}};
    const double *by = unit[quarters % 4], x = from[0], y = from[1];
    to[0] = by[0] * x - by[1] * y;
    to[1] = by[0] * y + by[1] * x;
}

/* The quarters by which the axes of a node are turned below. */
static uint32_t quarters_of(uint32_t node)
{
    return (uint32_t)(4 * (double)hatch_random_unit(3, 2, node));
}

/* Axes of nodes are arbitrary. Where those of each node are turned, so are its links and its data; its value turns with
 * them, and the solver takes as many iterations, or one more or less where a residual is rounded. */
START_TEST(the_axes_of_nodes_do_not_matter)
{
    struct grid *grid = make_grid(SIDE);
    const struct hatch_field_system *system = &grid->system;
    struct hatch_field_convergence convergence[2] = {{0}};
    struct hatch_field_levels *levels;
    double z[2][2 * NODES], want[2];
    for (int turned = 0; turned < 2; turned++) {
        for (uint32_t n = 0; n < NODES; n++) {
            uint32_t own = turned ? quarters_of(n) : 0;
            for (uint32_t i = system->first[n]; turned && i < system->first[n + 1]; i++)
                turn(own + 4 - quarters_of(system->to[i]), &system->link[2 * i], &system->link[2 * i]);
            turn(own, &system->rhs[2 * n], &system->rhs[2 * n]);
            turn(own, &grid->z[2 * n], &z[turned][2 * n]);
        }
        HATCH_TEST_OK(hatch_field_coarsen(system, &keep, &levels, &err), &err);
        HATCH_TEST_OK(hatch_field_solve_multigrid(levels, 1e-8, 200, &scratch, z[turned], &convergence[turned], &err),
                      &err);
    }
    ck_assert_uint_le(convergence[1].iterations, convergence[0].iterations + 1);
    ck_assert_uint_ge(convergence[1].iterations + 1, convergence[0].iterations);
    for (uint32_t n = 0; n < NODES; n++) {
        turn(quarters_of(n), &z[0][2 * n], want);
        ck_assert_double_eq_tol(z[1][2 * n], want[0], 1e-6);
        ck_assert_double_eq_tol(z[1][2 * n + 1], want[1], 1e-6);
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

/* Rounding ends it: the gradient never is zero. Measured: 669 iterations. */
START_TEST(a_descent_ends_where_no_step_lowers_the_energy)
{
    struct grid *grid = make_grid(SIDE);
    struct hatch_field_convergence convergence = {0};
    HATCH_TEST_OK(hatch_field_descend(&grid->system, 0, 5000, &scratch, grid->z, &convergence, &err), &err);
    ck_assert_double_gt(convergence.residual, 0);
    ck_assert_uint_lt(convergence.iterations, 2000);
}
END_TEST

/* Half of the nodes, and the last row, have data that is in effect exact, and nearly all of the weight. Between them
 * the values of linear are proportional to the distance, and so are the angles of hz. */
START_TEST(exact_data_does_not_hide_the_rest)
{
    const uint32_t begun = SIDE / 2, end = SIDE - 1;
    for (int descend = 0; descend < 2; descend++) {
        struct grid *grid = make_bare_grid(SIDE, 0);
        double z[2 * NODES];
        for (uint32_t n = 0; n < NODES; n++)
            if (n / SIDE <= begun || n / SIDE == end)
                give(&grid->system, n, 1e6 * grid->system.diagonal[n], n / SIDE == end ? ANGLE : 0);
        solve(grid, descend, z);
        for (uint32_t n = begun * SIDE; n < NODES; n++) {
            double share = (double)(n / SIDE - begun) / (end - begun);
            double want[2] = {1 + share * (cos(ANGLE) - 1), share * sin(ANGLE)};
            if (descend) {
                want[0] = cos(share * ANGLE);
                want[1] = sin(share * ANGLE);
            }
            ck_assert_double_eq_tol(z[2 * n], want[0], 2e-3);
            ck_assert_double_eq_tol(z[2 * n + 1], want[1], 2e-3);
        }
    }
}
END_TEST

/* The first component has data of all angles at all nodes, the second one faint datum. */
START_TEST(a_component_does_not_hide_another)
{
    struct grid *grid = make_bare_grid(SIDE, SIDE / 2);
    double z[2 * NODES];
    for (uint32_t n = 0; n < NODES / 2; n++)
        give(&grid->system, n, 1, 7 * (double)hatch_random_unit(3, 1, n));
    give(&grid->system, NODES - 77, 1e-6, ANGLE);
    solve(grid, false, z);
    for (uint32_t n = NODES / 2; n < NODES; n++) {
        ck_assert_double_eq_tol(z[2 * n], cos(ANGLE), 1e-3);
        ck_assert_double_eq_tol(z[2 * n + 1], sin(ANGLE), 1e-3);
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
    tcase_add_test(tests, the_axes_of_nodes_do_not_matter);
    tcase_add_test(tests, all_nodes_take_the_angle_of_the_data);
    tcase_add_test(tests, a_descent_ends_where_no_step_lowers_the_energy);
    tcase_add_test(tests, exact_data_does_not_hide_the_rest);
    tcase_add_test(tests, a_component_does_not_hide_another);
    tcase_add_test(tests, a_node_takes_25_numbers);
    suite_add_tcase(suite, tests);
    return suite;
}
HATCH_TEST_MAIN(suite)
