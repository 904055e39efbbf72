#include <assert.h>
#include <limits.h>
#include <string.h>
#include <suitesparse/cholmod.h>

#include "sparse/sparse.h"

struct hatch_sparse_factor {
    cholmod_common *common;
    cholmod_factor *factor;
};

/* Configures CHOLMOD: it prints nothing, factorizes in simplicial mode after an AMD ordering, and allocates exactly
 * what the analysis has counted. */
static void set_up(cholmod_common *common)
{
    common->print = 0;
    common->supernodal = CHOLMOD_SIMPLICIAL;
    common->final_ll = 0;
    common->nmethods = 1;
    common->method[0].ordering = CHOLMOD_AMD;
    common->grow0 = 0;
    common->grow1 = 0;
    common->grow2 = 0;
}

/* Returns a CHOLMOD matrix that refers to the caller's arrays. CHOLMOD only reads them. */
static cholmod_sparse view_of(const struct hatch_sparse *matrix)
{
    cholmod_sparse view = {.nrow = matrix->size,
                           .ncol = matrix->size,
                           .nzmax = matrix->first[matrix->size],
                           .stype = 1,
                           .itype = CHOLMOD_INT,
                           .xtype = CHOLMOD_REAL,
                           .dtype = CHOLMOD_DOUBLE,
                           .sorted = 1,
                           .packed = 1};
    union {
        const void *from;
        void *to;
    } first = {matrix->first}, row = {matrix->row}, value = {matrix->value};
    view.p = first.to;
    view.i = row.to;
    view.x = value.to;
    return view;
}

static enum hatch_status failure(const cholmod_common *common, struct hatch_err *err)
{
    if (common->status == CHOLMOD_TOO_LARGE)
        return hatch_fail(err, HATCH_LIMIT,
                          "the matrix has too many entries for a Cholesky factorisation: use another solver");
    return hatch_fail(err, HATCH_LIMIT, "out of memory during the Cholesky factorisation");
}

static enum hatch_status check_pivots(const cholmod_factor *factor, struct hatch_err *err)
{
    const int *first = factor->p;
    const double *value = factor->x;
    for (size_t i = 0; i < factor->n; i++)
        if (!(value[first[i]] > 0))
            return hatch_fail(err, HATCH_BAD_INPUT,
                              "the Cholesky factorisation failed (%zu rows, not positive definite): use another solver",
                              factor->n);
    return HATCH_OK;
}

static enum hatch_status factorize(const struct hatch_sparse *matrix, size_t limit_bytes,
                                   struct hatch_sparse_factor *made, struct hatch_err *err)
{
    cholmod_common *common = made->common;
    cholmod_sparse view = view_of(matrix);
    made->factor = cholmod_analyze(&view, common);
    if (!made->factor)
        return failure(common, err);
    double bytes = common->lnz * (sizeof(double) + sizeof(int)) + matrix->size * 6.0 * sizeof(int);
    if (common->lnz > INT_MAX || !(bytes <= (double)limit_bytes))
        return hatch_fail(err, HATCH_LIMIT,
                          "the Cholesky factors (%lu rows) take %.0f MB, over the memory limit: use another solver",
                          (unsigned long)matrix->size, bytes / 1e6);
    int done = cholmod_factorize(&view, made->factor, common);
    if (!done || common->status < 0)
        return failure(common, err);
    if (common->status == CHOLMOD_NOT_POSDEF)
        return hatch_fail(err, HATCH_BAD_INPUT,
                          "the Cholesky factorisation failed (%lu rows, not positive definite): use another solver",
                          (unsigned long)matrix->size);
    return check_pivots(made->factor, err);
}

enum hatch_status hatch_sparse_factorize(const struct hatch_sparse *matrix, size_t limit_bytes,
                                         struct hatch_sparse_factor **factor, struct hatch_err *err)
{
    assert(matrix->size > 0);
    if (matrix->size > INT_MAX || matrix->first[matrix->size] > INT_MAX)
        return hatch_fail(err, HATCH_LIMIT,
                          "the matrix has too many entries for a Cholesky factorisation: use another solver");
    cholmod_common start;
    cholmod_start(&start);
    set_up(&start);
    struct hatch_sparse_factor *made = cholmod_calloc(1, sizeof *made, &start);
    if (made)
        made->common = cholmod_malloc(1, sizeof start, &start);
    if (!made || !made->common) {
        if (made)
            cholmod_free(1, sizeof *made, made, &start);
        cholmod_finish(&start);
        return hatch_fail(err, HATCH_LIMIT, "out of memory during the Cholesky factorisation");
    }
    *made->common = start;
    enum hatch_status status = factorize(matrix, limit_bytes, made, err);
    if (status == HATCH_OK)
        *factor = made;
    else
        hatch_sparse_free(made);
    return status;
}

enum hatch_status hatch_sparse_solve(const struct hatch_sparse_factor *factor, const double *right, uint32_t columns,
                                     double *solution, struct hatch_err *err)
{
    size_t size = factor->factor->n;
    union {
        const void *from;
        void *to;
    } values = {right};
    cholmod_dense view = {.nrow = size,
                          .ncol = columns,
                          .nzmax = size * columns,
                          .d = size,
                          .x = values.to,
                          .xtype = CHOLMOD_REAL,
                          .dtype = CHOLMOD_DOUBLE};
    cholmod_dense *found = cholmod_solve(CHOLMOD_A, factor->factor, &view, factor->common);
    if (!found)
        return hatch_fail(err, HATCH_LIMIT, "out of memory while solving with the Cholesky factors");
    memcpy(solution, found->x, size * columns * sizeof *solution);
    cholmod_free_dense(&found, factor->common);
    return HATCH_OK;
}

void hatch_sparse_free(struct hatch_sparse_factor *factor)
{
    if (!factor)
        return;
    cholmod_common end = *factor->common;
    cholmod_free_factor(&factor->factor, &end);
    cholmod_free(1, sizeof end, factor->common, &end);
    cholmod_free(1, sizeof *factor, factor, &end);
    cholmod_finish(&end);
}
