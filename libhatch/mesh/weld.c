#include <math.h>
#include <string.h>

#include "base/random.h"
#include "mesh/mesh.h"

#define EMPTY UINT32_MAX

/* Coordinates of at most this share of the mesh's size count as 0: the vertices at the poles of a sphere are often at
 * sin(π), which is 1e-16 in doubles. */
#define ZERO_SHARE 0x1p-40f

/* Returns the bits of a position, with -0 and all coordinates of at most zero_max replaced by 0. */
static void position_bits(const float *position, float zero_max, uint32_t bits[3])
{
    for (int k = 0; k < 3; k++) {
        memcpy(&bits[k], &position[k], sizeof bits[k]);
        if (fabsf(position[k]) <= zero_max)
            bits[k] = 0;
    }
}

static float find_zero_max(const struct hatch_mesh *mesh)
{
    float low[3], high[3], size = 0;
    if (hatch_mesh_bounds(mesh, low, high))
        for (int k = 0; k < 3; k++)
            size = fmaxf(size, ZERO_SHARE * high[k] - ZERO_SHARE * low[k]);
    return size;
}

static uint64_t hash(const uint32_t bits[3])
{
    uint64_t h = hatch_random_mix((uint64_t)bits[0] << 32 | bits[1]);
    return hatch_random_mix(h ^ bits[2]);
}

enum hatch_status hatch_mesh_weld(const struct hatch_mesh *mesh, struct hatch_arena *scratch, uint32_t *vertex_to_point,
                                  uint32_t *point_count, struct hatch_err *err)
{
    const float *positions = mesh->attributes[0].data, zero_max = find_zero_max(mesh);
    size_t capacity = 16;
    while (capacity < (size_t)mesh->vertex_count * 2)
        capacity *= 2;
    struct hatch_arena_mark mark = hatch_arena_mark(scratch);
    uint32_t *slots;
    HATCH_TRY(HATCH_ALLOC(scratch, &slots, capacity, err)); /* first vertex of a point, or EMPTY */
    memset(slots, 0xff, capacity * sizeof *slots);
    uint32_t count = 0;
    for (uint32_t v = 0; v < mesh->vertex_count; v++) {
        uint32_t bits[3], other[3];
        position_bits(&positions[(size_t)v * 3], zero_max, bits);
        size_t slot = hash(bits) & (capacity - 1);
        for (; slots[slot] != EMPTY; slot = (slot + 1) & (capacity - 1)) {
            position_bits(&positions[(size_t)slots[slot] * 3], zero_max, other);
            if (memcmp(bits, other, sizeof bits) == 0)
                break;
        }
        if (slots[slot] == EMPTY) {
            slots[slot] = v;
            vertex_to_point[v] = count++;
        } else {
            vertex_to_point[v] = vertex_to_point[slots[slot]];
        }
    }
    *point_count = count;
    hatch_arena_rewind(scratch, mark);
    return HATCH_OK;
}
