/* Sparse symmetric positive definite systems, solved by CHOLMOD in simplicial mode, which computes the same bits on
 * every machine. No other module includes CHOLMOD's headers. */
#ifndef HATCH_SPARSE_SPARSE_H
#define HATCH_SPARSE_SPARSE_H

#include "base/arena.h"

/* The upper triangle of a symmetric matrix, stored by columns and owned by the caller. Column c has the entries
 * first[c] .. first[c + 1] - 1, with ascending rows; the diagonal entry is present and last. */
struct hatch_sparse {
    uint32_t size;         /* rows and columns */
    const uint32_t *first; /* size + 1 items */
    const uint32_t *row;   /* per entry: its row */
    const double *value;   /* per entry */
};

/* A factorization, which CHOLMOD allocates outside all arenas. */
struct hatch_sparse_factor;

/* Factorizes a matrix of at most 2^31 - 1 entries. HATCH_LIMIT also for larger ones; HATCH_BAD_INPUT if the matrix is
 * not positive definite.
 *   limit_bytes  most memory for the factors; if they would need more, HATCH_LIMIT is returned before factorizing
 *   factor       out: to be freed with hatch_sparse_free */
enum hatch_status hatch_sparse_factorize(const struct hatch_sparse *matrix, size_t limit_bytes,
                                         struct hatch_sparse_factor **factor, struct hatch_err *err) HATCH_MUST_USE;

/* Solves matrix * x = right for several right-hand sides.
 *   right     columns * size numbers, one right-hand side after another
 *   solution  out: in the layout of right; may be the same array */
enum hatch_status hatch_sparse_solve(const struct hatch_sparse_factor *factor, const double *right, uint32_t columns,
                                     double *solution, struct hatch_err *err) HATCH_MUST_USE;

/* Frees a factorization.
 *   factor  may be NULL */
void hatch_sparse_free(struct hatch_sparse_factor *factor);

#endif
