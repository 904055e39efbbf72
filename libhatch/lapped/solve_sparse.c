#include <stdlib.h>
#include <string.h>

#include "lapped/work.h"
#include "sparse/sparse.h"

/* Share of each diagonal entry that is added to it, so that rounding leaves the matrices positive definite; where it is
 * not enough, SHIFT_FACTOR times as much is added. */
#define SHIFT_MIN 1e-12
#define SHIFT_FACTOR 1e3
#define SHIFT_MAX 1e-2

/* The upper triangles of the matrices for x and for y, which have the same entries, and what is needed to fill them. */
struct matrices {
    uint32_t *first, *row;
    double *value[2];
    uint32_t *face_first, *faces; /* the faces around each vertex */
    uint32_t *column, *entry;     /* per row: the last column with an entry there, and that entry */
};

static enum hatch_status allocate(struct hatch_arena *arena, const struct hatch_patch *patch, struct matrices *m,
                                  struct hatch_err *err)
{
    size_t count = patch->vertex_count, corners = 3 * (size_t)patch->face_count, entries = count + corners;
    HATCH_TRY(HATCH_ALLOC(arena, &m->first, count + 1, err));
    HATCH_TRY(HATCH_ALLOC(arena, &m->row, entries, err));
    for (int i = 0; i < 2; i++)
        HATCH_TRY(HATCH_ALLOC(arena, &m->value[i], entries, err));
    HATCH_TRY(HATCH_ALLOC(arena, &m->face_first, count + 1, err));
    HATCH_TRY(HATCH_ALLOC(arena, &m->faces, corners, err));
    HATCH_TRY(HATCH_ALLOC(arena, &m->column, count, err));
    return HATCH_ALLOC(arena, &m->entry, count, err);
}

static void list_faces(const struct hatch_patch *patch, struct matrices *m)
{
    uint32_t end = 0;
    for (uint32_t i = 0; i < 3 * patch->face_count; i++)
        m->face_first[patch->corners[i]]++;
    for (uint32_t v = 0; v <= patch->vertex_count; v++)
        m->face_first[v] = end += m->face_first[v];
    for (uint32_t i = 3 * patch->face_count; i-- > 0;)
        m->faces[--m->face_first[patch->corners[i]]] = i / 3;
}

static int compare_rows(const void *a, const void *b)
{
    uint32_t x = *(const uint32_t *)a, y = *(const uint32_t *)b;
    return (x > y) - (x < y);
}

/* Lists the rows of a column down to its diagonal, in order. Returns the entry after its last. */
static uint32_t list_rows(const struct hatch_patch *patch, uint32_t column, struct matrices *m)
{
    uint32_t begin = m->first[column], end = begin;
    for (uint32_t i = m->face_first[column]; i < m->face_first[column + 1]; i++) {
        for (uint32_t c = 0; c < 3; c++) {
            uint32_t row = patch->corners[3 * m->faces[i] + c];
            if (row > column || m->column[row] == column)
                continue;
            m->column[row] = column;
            m->row[end++] = row;
        }
    }
    qsort(m->row + begin, end - begin, sizeof *m->row, compare_rows);
    for (uint32_t i = begin; i < end; i++)
        m->entry[m->row[i]] = i;
    return end;
}

/* Adds a face's part of a column. Vertex 0 is fixed at the origin: it has its diagonal entries alone. */
static void add_face(const struct hatch_solver *solver, const struct hatch_patch *patch, uint32_t local,
                     uint32_t column, struct matrices *m)
{
    const uint32_t *corner = &patch->corners[3 * local];
    for (uint32_t own = 0; own < 3; own++) {
        for (uint32_t c = 0; c < 3 && corner[own] == column; c++) {
            double entry[2];
            if (corner[c] > column || (corner[c] == 0 && column > 0))
                continue;
            hatch_solver_entry(solver, local, c, own, entry);
            for (int i = 0; i < 2; i++)
                m->value[i][m->entry[corner[c]]] += entry[i];
        }
    }
}

static enum hatch_status factorize(const struct hatch_patch *patch, struct matrices *m, double *value,
                                   size_t limit_bytes, struct hatch_sparse_factor **factor, struct hatch_err *err)
{
    const struct hatch_sparse matrix = {patch->vertex_count, m->first, m->row, value};
    enum hatch_status status = HATCH_BAD_INPUT;
    for (double shift = SHIFT_MIN; status == HATCH_BAD_INPUT && shift < SHIFT_MAX; shift *= SHIFT_FACTOR) {
        for (uint32_t v = 0; v < patch->vertex_count; v++)
            value[m->first[v + 1] - 1] *= 1 + shift;
        status = hatch_sparse_factorize(&matrix, limit_bytes, factor, err);
    }
    if (status == HATCH_LIMIT)
        return hatch_fail(err, status, "out of memory for the factors of a patch of %u vertices, %zu bytes are left",
                          patch->vertex_count, limit_bytes);
    if (status == HATCH_BAD_INPUT)
        return hatch_fail(err, status, "no solution for a patch of %u vertices: want a smaller size",
                          patch->vertex_count);
    return status;
}

enum hatch_status hatch_sparse_solver_make(const struct hatch_solver *solver, const struct hatch_patch *patch,
                                           struct hatch_sparse_solver *made, struct hatch_err *err)
{
    struct matrices m;
    HATCH_TRY(HATCH_ALLOC(solver->arena, &made->column, patch->vertex_count, err));
    HATCH_TRY(allocate(solver->arena, patch, &m, err));
    memset(m.column, 0xff, patch->vertex_count * sizeof *m.column);
    list_faces(patch, &m);
    for (uint32_t v = 0; v < patch->vertex_count; v++) {
        m.first[v + 1] = list_rows(patch, v, &m);
        for (uint32_t i = m.face_first[v]; i < m.face_first[v + 1]; i++)
            add_face(solver, patch, m.faces[i], v, &m);
    }
    for (int i = 0; i < 2; i++) {
        size_t left = solver->arena->limit_bytes - solver->arena->used_bytes;
        HATCH_TRY(factorize(patch, &m, m.value[i], left, &made->factor[i], err));
    }
    return HATCH_OK;
}

void hatch_sparse_solver_free(struct hatch_sparse_solver *made)
{
    for (int i = 0; i < 2; i++)
        hatch_sparse_free(made->factor[i]);
}

enum hatch_status hatch_sparse_solver_solve(const struct hatch_sparse_solver *made, double (*right_side)[2],
                                            uint32_t count, struct hatch_err *err)
{
    for (int i = 0; i < 2; i++) {
        for (uint32_t v = 0; v < count; v++)
            made->column[v] = right_side[v][i];
        HATCH_TRY(hatch_sparse_solve(made->factor[i], made->column, 1, made->column, err));
        for (uint32_t v = 0; v < count; v++)
            right_side[v][i] = made->column[v];
    }
    return HATCH_OK;
}
