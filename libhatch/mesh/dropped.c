#include "mesh/dropped.h"

#include <string.h>

#include "base/random.h"

uint32_t hatch_mesh_find_degenerate(const struct hatch_mesh *mesh, const uint32_t *point, uint8_t *dropped)
{
    double corners[3][3];
    uint32_t count = 0;
    for (uint32_t f = 0; f < mesh->face_count; f++) {
        const uint32_t *p = &point[(size_t)f * 3];
        if (p[0] == p[1] || p[1] == p[2] || p[2] == p[0] || !hatch_mesh_corners(mesh, f, corners)) {
            dropped[f] = 1;
            count++;
        }
    }
    return count;
}

/* Returns whether sorting reverses the face. */
static bool sorted_points(const uint32_t *point, uint32_t face, uint32_t out[3])
{
    bool reversed = false;
    memcpy(out, &point[(size_t)face * 3], 3 * sizeof *out);
    for (int pass = 0; pass < 2; pass++)
        for (int k = 0; k + 1 < 3; k++)
            if (out[k] > out[k + 1]) {
                uint32_t swap = out[k];
                out[k] = out[k + 1];
                out[k + 1] = swap;
                reversed = !reversed;
            }
    return reversed;
}

enum hatch_status hatch_mesh_find_duplicates(const uint32_t *point, uint32_t face_count, uint8_t *dropped,
                                             struct hatch_arena *scratch, struct hatch_mesh_duplicates *found,
                                             struct hatch_err *err)
{
    size_t capacity = 16;
    while (capacity < (size_t)face_count * 2)
        capacity *= 2;
    struct hatch_arena_mark mark = hatch_arena_mark(scratch);
    uint32_t *slots;
    HATCH_TRY(HATCH_ALLOC(scratch, &slots, capacity, err)); /* hash table: face + 1; 0: empty */
    *found = (struct hatch_mesh_duplicates){0};
    for (uint32_t f = 0; f < face_count; f++) {
        if (dropped[f])
            continue;
        uint32_t own[3], other[3];
        bool turned = sorted_points(point, f, own), other_turned = false;
        uint64_t hash = hatch_random_mix((uint64_t)own[0] << 32 | own[1]);
        size_t slot = hatch_random_mix(hash ^ own[2]) & (capacity - 1);
        for (; slots[slot]; slot = (slot + 1) & (capacity - 1)) {
            other_turned = sorted_points(point, slots[slot] - 1, other);
            if (memcmp(own, other, sizeof own) == 0)
                break;
        }
        if (slots[slot]) {
            dropped[f] = 1;
            found->count++;
            found->reversed += turned != other_turned;
        } else {
            slots[slot] = f + 1;
        }
    }
    hatch_arena_rewind(scratch, mark);
    return HATCH_OK;
}
