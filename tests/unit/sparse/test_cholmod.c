#include <math.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>
#include <suitesparse/SuiteSparse_config.h>

#include "base/random.h"
#include "run.h"
#include "sparse/sparse.h"

enum { SIZE = 40 };

/* A tridiagonal matrix: a constant diagonal, -1 beside it. */
struct chain {
    uint32_t first[SIZE + 1], row[2 * SIZE];
    double value[2 * SIZE];
};

static struct hatch_sparse chain_make(struct chain *chain, double diagonal)
{
    uint32_t count = 0;
    for (uint32_t c = 0; c < SIZE; c++) {
        chain->first[c] = count;
        if (c > 0) {
            chain->row[count] = c - 1;
            chain->value[count++] = -1;
        }
        chain->row[count] = c;
        chain->value[count++] = diagonal;
    }
    chain->first[SIZE] = count;
    return (struct hatch_sparse){SIZE, chain->first, chain->row, chain->value};
}

START_TEST(solution_times_matrix_is_the_right_side)
{
    struct chain chain;
    struct hatch_sparse matrix = chain_make(&chain, 2);
    struct hatch_sparse_factor *factor = NULL;
    struct hatch_err err;
    double right[2 * SIZE], x[2 * SIZE];
    for (uint32_t i = 0; i < 2 * SIZE; i++)
        right[i] = (double)hatch_random_unit(1, 2, i) - 0.5;
    memcpy(x, right, sizeof x);
    HATCH_TEST_OK(hatch_sparse_factorize(&matrix, (size_t)1 << 20, &factor, &err), &err);
    HATCH_TEST_OK(hatch_sparse_solve(factor, x, 2, x, &err), &err);
    hatch_sparse_free(factor);
    for (uint32_t k = 0; k < 2 * SIZE; k++) {
        uint32_t i = k % SIZE;
        double sum = 2 * x[k] - (i > 0 ? x[k - 1] : 0) - (i + 1 < SIZE ? x[k + 1] : 0);
        ck_assert_double_eq_tol(sum, right[k], 1e-12);
    }
}
END_TEST

START_TEST(indefinite_matrices_are_refused)
{
    const double diagonals[] = {0, -2, 1, (double)NAN};
    for (size_t i = 0; i < sizeof diagonals / sizeof *diagonals; i++) {
        struct chain chain;
        struct hatch_sparse matrix = chain_make(&chain, diagonals[i]);
        struct hatch_sparse_factor *factor = NULL;
        struct hatch_err err;
        ck_assert_int_eq(hatch_sparse_factorize(&matrix, (size_t)1 << 20, &factor, &err), HATCH_BAD_INPUT);
        ck_assert_ptr_null(factor);
        ck_assert_str_eq(err.text,
                         "the Cholesky factorisation failed (40 rows, not positive definite): use another solver");
    }
}
END_TEST

START_TEST(factors_over_the_limit_are_refused)
{
    struct chain chain;
    struct hatch_sparse matrix = chain_make(&chain, 2);
    struct hatch_sparse_factor *factor = NULL;
    struct hatch_err err;
    ck_assert_int_eq(hatch_sparse_factorize(&matrix, 100, &factor, &err), HATCH_LIMIT);
    ck_assert_ptr_null(factor);
}
END_TEST

START_TEST(null_may_be_freed)
{
    hatch_sparse_free(NULL);
}
END_TEST

/* Failing allocators for CHOLMOD, which does not use arenas. */
static unsigned until_failure;

static void *failing_malloc(size_t size)
{
    return until_failure && --until_failure == 0 ? NULL : malloc(size);
}

static void *failing_calloc(size_t count, size_t size)
{
    return until_failure && --until_failure == 0 ? NULL : calloc(count, size);
}

static void *failing_realloc(void *from, size_t size)
{
    return until_failure && --until_failure == 0 ? NULL : realloc(from, size);
}

static void set_failing_allocators(void)
{
#if SUITESPARSE_MAIN_VERSION >= 7
    SuiteSparse_config_malloc_func_set(failing_malloc);
    SuiteSparse_config_calloc_func_set(failing_calloc);
    SuiteSparse_config_realloc_func_set(failing_realloc);
#else
    SuiteSparse_config.malloc_func = failing_malloc;
    SuiteSparse_config.calloc_func = failing_calloc;
    SuiteSparse_config.realloc_func = failing_realloc;
#endif
}

/* Fails each allocation of a factorization and a solution in turn; SANITIZE=1 finds leaks. */
START_TEST(failed_allocations_are_reported)
{
    struct chain chain;
    struct hatch_sparse matrix = chain_make(&chain, 2);
    double right[SIZE] = {1}, before[SIZE], x[SIZE];
    enum hatch_status status = HATCH_LIMIT;
    set_failing_allocators();
    for (unsigned n = 1; status != HATCH_OK; n++) {
        struct hatch_sparse_factor *factor = NULL;
        struct hatch_err err = {0};
        memset(x, 7, sizeof x);
        memcpy(before, x, sizeof x);
        until_failure = n;
        status = hatch_sparse_factorize(&matrix, (size_t)1 << 20, &factor, &err);
        ck_assert((status == HATCH_OK) == (factor != NULL));
        if (factor)
            status = hatch_sparse_solve(factor, right, 1, x, &err);
        bool failed = until_failure == 0;
        until_failure = 0;
        hatch_sparse_free(factor);
        ck_assert_msg(status == (failed ? HATCH_LIMIT : HATCH_OK), "allocation %u: status %d", n, (int)status);
        ck_assert(!failed || (err.text[0] && memcmp(x, before, sizeof x) == 0));
        ck_assert_msg(n < 1000, "no success after a thousand allocations");
        ck_assert(failed || n > 10);
    }
}
END_TEST

static Suite *suite(void)
{
    Suite *suite = suite_create("sparse cholmod");
    TCase *tests = tcase_create("cholmod");
    tcase_add_test(tests, solution_times_matrix_is_the_right_side);
    tcase_add_test(tests, indefinite_matrices_are_refused);
    tcase_add_test(tests, factors_over_the_limit_are_refused);
    tcase_add_test(tests, null_may_be_freed);
    tcase_add_test(tests, failed_allocations_are_reported);
    suite_add_tcase(suite, tests);
    return suite;
}

HATCH_TEST_MAIN(suite)
