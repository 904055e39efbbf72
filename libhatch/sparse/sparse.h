/* Sparse symmetric positive definite systems, solved by CHOLMOD (simplicial, with the same bits on every machine). No
 * other module includes CHOLMOD's headers. */
#ifndef HATCH_SPARSE_SPARSE_H
#define HATCH_SPARSE_SPARSE_H

#include "base/arena.h"

/* The upper triangle of a symmetric matrix by columns, owned by the caller. Column c has entries first[c] ..
 * first[c + 1] - 1 with rising rows; the diagonal entry is present and last. */
struct hatch_sparse {
    uint32_t size;         /* rows and columns */
    const uint32_t *first; /* size + 1 */
    const uint32_t *row;   /* per entry */
    const double *value;   /* per entry */
};

/* A factorization, in CHOLMOD's own memory. */
struct hatch_sparse_factor;

/* Factorizes a matrix of at most 2^31 - 1 entries. HATCH_LIMIT also for larger ones; HATCH_BAD_INPUT when the matrix is
 * not positive definite.
 *   limit_bytes  HATCH_LIMIT, before factorizing, when the factors would need more
 *   factor       out: to be freed with hatch_sparse_free */
enum hatch_status hatch_sparse_factorize(const struct hatch_sparse *matrix, size_t limit_bytes,
                                         struct hatch_sparse_factor **factor, struct hatch_err *err) HATCH_MUST_USE;

/* Solves matrix * x = right for several right sides.
 *   right     columns * size numbers, one right side after another
 *   solution  out: as right; may be right */
enum hatch_status hatch_sparse_solve(const struct hatch_sparse_factor *factor, const double *right, uint32_t columns,
                                     double *solution, struct hatch_err *err) HATCH_MUST_USE;

/* Frees a factorization.
 *   factor  may be NULL */
void hatch_sparse_free(struct hatch_sparse_factor *factor);

#endif
