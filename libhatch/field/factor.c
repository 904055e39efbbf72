#include <string.h>

#include "sparse/sparse.h"
#include "field/system.h"

/* A complex entry x + iy is the real block (x -y; y x): node n has the unknowns 2n and 2n + 1. */

/* The links that lead to each node, by rising source. Links exist in both directions, so that system->first bounds
 * both. */
struct arrivals {
    uint32_t *link, *source;
};

static enum hatch_status sort_arrivals(const struct hatch_field_system *system, struct hatch_arena *scratch,
                                       struct arrivals *arrivals, struct hatch_err *err)
{
    uint32_t links = system->first[system->count];
    uint32_t *next;
    HATCH_TRY(HATCH_ALLOC(scratch, &next, system->count, err));
    HATCH_TRY(HATCH_ALLOC(scratch, &arrivals->link, links, err));
    HATCH_TRY(HATCH_ALLOC(scratch, &arrivals->source, links, err));
    memcpy(next, system->first, system->count * sizeof *next);
    for (uint32_t n = 0; n < system->count; n++)
        for (uint32_t i = system->first[n]; i < system->first[n + 1]; i++) {
            uint32_t at = next[system->to[i]]++;
            arrivals->link[at] = i;
            arrivals->source[at] = n;
        }
    return HATCH_OK;
}

struct matrix {
    uint32_t *first, *row;
    double *value;
};

/* Fills column 2n (real) or 2n + 1 down to the diagonal, from entry `at` on. Returns the entry after its last. Links
 * between the same two nodes are summed. */
static uint32_t fill_column(const struct hatch_field_system *system, const struct arrivals *arrivals, uint32_t n,
                            bool real, uint32_t at, struct matrix *matrix)
{
    uint32_t begin = at;
    for (uint32_t k = system->first[n]; k < system->first[n + 1] && arrivals->source[k] < n; k++) {
        const double *link = &system->link[2 * (size_t)arrivals->link[k]];
        uint32_t row = 2 * arrivals->source[k];
        if (at == begin || matrix->row[at - 2] != row) {
            matrix->row[at] = row;
            matrix->row[at + 1] = row + 1;
            at += 2;
        }
        matrix->value[at - 2] -= real ? link[0] : -link[1];
        matrix->value[at - 1] -= real ? link[1] : link[0];
    }
    matrix->row[at] = 2 * n + !real;
    matrix->value[at] = system->diagonal[n];
    return at + 1;
}

static enum hatch_status solve(const struct hatch_field_system *system, size_t limit_bytes, struct hatch_arena *scratch,
                               double *z, struct hatch_err *err)
{
    struct arrivals arrivals;
    struct matrix matrix;
    HATCH_TRY(sort_arrivals(system, scratch, &arrivals, err));
    uint64_t entries = 2 * (uint64_t)system->first[system->count] + 2 * (uint64_t)system->count;
    if (entries >= UINT32_MAX)
        return hatch_fail(err, HATCH_LIMIT, "%lu points are too many for the Cholesky solver: use multigrid",
                          (unsigned long)system->count);
    HATCH_TRY(HATCH_ALLOC(scratch, &matrix.first, 2 * (size_t)system->count + 1, err));
    HATCH_TRY(HATCH_ALLOC(scratch, &matrix.row, entries, err));
    HATCH_TRY(HATCH_ALLOC(scratch, &matrix.value, entries, err));
    uint32_t at = 0;
    for (uint32_t c = 0; c < 2 * system->count; c++) {
        at = fill_column(system, &arrivals, c / 2, c % 2 == 0, at, &matrix);
        matrix.first[c + 1] = at;
    }
    const struct hatch_sparse sparse = {2 * system->count, matrix.first, matrix.row, matrix.value};
    struct hatch_sparse_factor *factor = NULL;
    HATCH_TRY(hatch_sparse_factorize(&sparse, limit_bytes, &factor, err));
    enum hatch_status status = hatch_sparse_solve(factor, system->rhs, 1, z, err);
    hatch_sparse_free(factor);
    return status;
}

enum hatch_status hatch_field_solve_cholesky(const struct hatch_field_system *system, size_t limit_bytes,
                                             struct hatch_arena *scratch, double *z, struct hatch_err *err)
{
    struct hatch_arena_mark mark = hatch_arena_mark(scratch);
    enum hatch_status status = solve(system, limit_bytes, scratch, z, err);
    hatch_arena_rewind(scratch, mark);
    return status;
}
