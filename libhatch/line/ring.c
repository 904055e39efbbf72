/* The vertices around each vertex of a mesh with feature lines. */
#include "base/random.h"
#include "line/mesh.h"

/* Counts the corners at each vertex, and computes a number per vertex that is 0 if faces surround it completely: each
 * neighbour then follows the vertex in one face and precedes it in another, so that the hashes cancel. */
static void count_corners(const struct hatch_mesh *mesh, uint32_t *first, uint64_t *open)
{
    for (size_t i = 0; i < 3 * (size_t)mesh->face_count; i++) {
        uint32_t after = mesh->indices[i % 3 == 2 ? i - 2 : i + 1];
        uint32_t before = mesh->indices[i % 3 == 0 ? i + 2 : i - 1];
        first[mesh->indices[i] + 1]++;
        open[mesh->indices[i]] += hatch_random_mix(after) - hatch_random_mix(before);
    }
}

enum hatch_status hatch_line_ring_make(const struct hatch_mesh *mesh, struct hatch_arena *arena,
                                       struct hatch_arena *scratch, struct hatch_line_ring *ring, struct hatch_err *err)
{
    struct hatch_arena_mark mark = hatch_arena_mark(scratch);
    size_t count = mesh->vertex_count;
    uint64_t *open;
    uint32_t *at;
    struct hatch_line_ring made = {0};
    HATCH_TRY(HATCH_ALLOC(scratch, &open, count, err));
    HATCH_TRY(HATCH_ALLOC(scratch, &at, count + 1, err));
    HATCH_TRY(HATCH_ALLOC(arena, &made.first, count + 1, err));
    HATCH_TRY(HATCH_ALLOC(arena, &made.neighbours, 3 * (size_t)mesh->face_count, err));
    count_corners(mesh, made.first, open);
    for (size_t v = 0; v < count; v++)
        at[v + 1] = made.first[v + 1] = made.first[v] + (open[v] ? 0 : made.first[v + 1]);
    for (size_t i = 0; i < 3 * (size_t)mesh->face_count; i++)
        if (!open[mesh->indices[i]])
            made.neighbours[at[mesh->indices[i]]++] = mesh->indices[i % 3 == 2 ? i - 2 : i + 1];
    hatch_arena_rewind(scratch, mark);
    *ring = made;
    return HATCH_OK;
}
