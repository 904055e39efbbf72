/* Sparse symmetric positive definite systems, factored by CHOLMOD (simplicial, the same bits on
 * every machine). The only place that sees CHOLMOD. */
#ifndef HATCH_SPARSE_SPARSE_H
#define HATCH_SPARSE_SPARSE_H

#include "base/arena.h"

/* The upper triangle of a symmetric matrix by columns: rows of column c are row[first[c]] ..
 * row[first[c + 1] - 1], rising, the diagonal last and present. Owned by the caller. */
struct hatch_sparse {
    uint32_t size;
    const uint32_t *first; /* size + 1 */
    const uint32_t *row;
    const double *value;
};

/* A factor is CHOLMOD's own memory: free it. Entries: fewer than 2³² (else HATCH_LIMIT, as when
 * the factor would take more than limit_bytes, which is known before it is made). HATCH_BAD_INPUT
 * when the matrix is not positive definite. */
struct hatch_sparse_factor;

enum hatch_status hatch_sparse_factorize(const struct hatch_sparse *matrix, size_t limit_bytes,
                                         struct hatch_sparse_factor **factor, struct hatch_err *err) HATCH_MUST_USE;

/* Solves matrix · x = right for `columns` right sides of size doubles each, one after another.
 * solution may be right. */
enum hatch_status hatch_sparse_solve(const struct hatch_sparse_factor *factor, const double *right, uint32_t columns,
                                     double *solution, struct hatch_err *err) HATCH_MUST_USE;

/* NULL is allowed. */
void hatch_sparse_free(struct hatch_sparse_factor *factor);

#endif
