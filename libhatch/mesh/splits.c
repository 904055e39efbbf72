#include "mesh/splits.h"

#include <assert.h>
#include <string.h>

/* Lists the corners by vertex, those of a vertex in ascending order.
 *   first   scratch, zero: vertex_count + 2 numbers
 *   sorted  out: corner_count corners */
static void sort_corners(const uint32_t *vertex, size_t corner_count, uint32_t vertex_count, uint32_t *first,
                         uint32_t *sorted)
{
    for (uint32_t i = 0; i < corner_count; i++)
        first[vertex[i] + 2]++;
    for (uint32_t v = 0; v < vertex_count; v++)
        first[v + 2] += first[v + 1];
    for (uint32_t i = 0; i < corner_count; i++)
        sorted[first[vertex[i] + 1]++] = i;
}

/* Finds for each corner the first one that has the same vertex and the same class.
 *   sorted  the corners by vertex
 *   newest  scratch, zero per class; becomes 1 + the first corner with this class at the newest vertex that has it
 *   leader  out: per corner */
static void find_leaders(const uint32_t *vertex, const uint32_t *class_of, const uint32_t *sorted, size_t corner_count,
                         uint32_t *newest, uint32_t *leader)
{
    for (uint32_t k = 0; k < corner_count; k++) {
        uint32_t i = sorted[k], *corner = &newest[class_of[i]];
        if (*corner == 0 || vertex[*corner - 1] != vertex[i])
            *corner = i + 1;
        leader[i] = *corner - 1;
    }
}

/* Returns the vertex for a class that is new at an old vertex: this vertex itself for its first class, else a copy. */
static uint32_t add_class(struct hatch_splits *s, uint32_t vertex, uint32_t class)
{
    uint32_t v = vertex;
    if (s->class_at[vertex] != HATCH_NO_CLASS) {
        v = s->count++;
        s->origin[v] = vertex;
    }
    s->class_at[v] = class;
    return v;
}

enum hatch_status hatch_splits_make(const uint32_t *vertex, const uint32_t *class_of, size_t corner_count,
                                    uint32_t vertex_count, struct hatch_arena *scratch, struct hatch_splits *splits,
                                    struct hatch_err *err)
{
    size_t most = corner_count + vertex_count;
    struct hatch_splits made = {.count = vertex_count};
    HATCH_TRY(HATCH_ALLOC(scratch, &made.class_at, most, err));
    HATCH_TRY(HATCH_ALLOC(scratch, &made.origin, most, err));
    HATCH_TRY(HATCH_ALLOC(scratch, &made.indices, corner_count, err));
    struct hatch_arena_mark mark = hatch_arena_mark(scratch);
    uint32_t *first, *sorted, *newest;
    HATCH_TRY(HATCH_ALLOC(scratch, &first, (size_t)vertex_count + 2, err));
    HATCH_TRY(HATCH_ALLOC(scratch, &sorted, corner_count, err));
    HATCH_TRY(HATCH_ALLOC(scratch, &newest, most, err));
    for (uint32_t i = 0; i < corner_count; i++)
        assert(class_of[i] < most);
    sort_corners(vertex, corner_count, vertex_count, first, sorted);
    find_leaders(vertex, class_of, sorted, corner_count, newest, made.indices);
    hatch_arena_rewind(scratch, mark);
    memset(made.class_at, 0xff, most * sizeof *made.class_at);
    for (uint32_t v = 0; v < vertex_count; v++)
        made.origin[v] = v;
    /* A leader comes before the corners that it leads. */
    for (uint32_t i = 0; i < corner_count; i++)
        made.indices[i] =
            made.indices[i] == i ? add_class(&made, vertex[i], class_of[i]) : made.indices[made.indices[i]];
    *splits = made;
    return HATCH_OK;
}
