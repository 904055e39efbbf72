/* Sparse symmetric positive definite systems, factored by CHOLMOD (simplicial, the same bits on every machine).
 * The only place that sees CHOLMOD. */
#ifndef HATCH_SPARSE_SPARSE_H
#define HATCH_SPARSE_SPARSE_H

#include "base/arena.h"

/* The upper triangle of a symmetric matrix by columns: rows of column c are row[first[c]] .. row[first[c + 1] - 1],
 * rising, the diagonal last and present. Owned by the caller. */
struct hatch_sparse {
    uint32_t size;
    const uint32_t *first; /* size + 1 */
    const uint32_t *row;
    const double *value;
};

/* Solves matrix · x = right for `columns` right sides of size doubles each, one after another. HATCH_BAD_INPUT
 * when the matrix is not positive definite, HATCH_LIMIT when memory does not suffice. solution may be right. */
enum hatch_status hatch_sparse_solve(const struct hatch_sparse *matrix, const double *right, uint32_t columns,
                                     double *solution, struct hatch_err *err) HATCH_MUST_USE;

#endif
