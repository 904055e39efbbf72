#include "mesh/splits.h"

#include <string.h>

/* Finds or makes the copy of a vertex that a class uses. The first class keeps the vertex itself; the copies for other
 * classes form a linked list that begins there.
 *   next  per vertex: the next copy, or 0 */
static uint32_t vertex_for(struct hatch_splits *s, uint32_t *next, uint32_t vertex, uint32_t class)
{
    while (s->class_at[vertex] != class) {
        if (s->class_at[vertex] == HATCH_NO_CLASS) {
            s->class_at[vertex] = class;
        } else {
            if (next[vertex] == 0) {
                s->origin[s->count] = s->origin[vertex];
                next[vertex] = s->count++;
            }
            vertex = next[vertex];
        }
    }
    return vertex;
}

enum hatch_status hatch_splits_make(const uint32_t *vertex, const uint32_t *class_of, size_t corner_count,
                                    uint32_t vertex_count, struct hatch_arena *scratch, struct hatch_splits *splits,
                                    struct hatch_err *err)
{
    size_t most = corner_count + vertex_count;
    struct hatch_splits made = {.count = vertex_count};
    uint32_t *next;
    HATCH_TRY(HATCH_ALLOC(scratch, &made.class_at, most, err));
    HATCH_TRY(HATCH_ALLOC(scratch, &made.origin, most, err));
    HATCH_TRY(HATCH_ALLOC(scratch, &made.indices, corner_count, err));
    HATCH_TRY(HATCH_ALLOC(scratch, &next, most, err));
    memset(made.class_at, 0xff, most * sizeof *made.class_at);
    for (uint32_t v = 0; v < vertex_count; v++)
        made.origin[v] = v;
    for (size_t i = 0; i < corner_count; i++)
        made.indices[i] = vertex_for(&made, next, vertex[i], class_of[i]);
    *splits = made;
    return HATCH_OK;
}
