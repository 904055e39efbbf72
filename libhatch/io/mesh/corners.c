#include "io/mesh/corners.h"

#include <string.h>

#include "base/random.h"

struct hatch_corners hatch_corners_in(struct hatch_arena *scratch)
{
    return (struct hatch_corners){.list = {.arena = scratch}, .scratch = scratch};
}

const struct hatch_corner *hatch_corners_list(const struct hatch_corners *corners)
{
    return (const struct hatch_corner *)(const void *)corners->list.data;
}

static uint64_t hash_of(const struct hatch_corner *corner)
{
    uint64_t h = hatch_random_mix((uint64_t)corner->part[0] << 32 | corner->part[1]);
    return hatch_random_mix(h ^ corner->part[2]);
}

static enum hatch_status grow_slots(struct hatch_corners *corners, struct hatch_err *err)
{
    if (corners->count < corners->slot_count / 2)
        return HATCH_OK;
    uint32_t count = corners->slot_count ? corners->slot_count * 2 : 1024;
    uint32_t *slots = count < corners->slot_count ? NULL : HATCH_NEW(corners->scratch, uint32_t, count, err);
    if (!slots)
        return hatch_fail(err, HATCH_LIMIT, "%u vertices need too much memory", corners->count);
    for (uint32_t v = 0; v < corners->count; v++) {
        uint64_t slot = hash_of(&hatch_corners_list(corners)[v]);
        while (slots[slot & (count - 1)])
            slot++;
        slots[slot & (count - 1)] = v + 1;
    }
    corners->slots = slots;
    corners->slot_count = count;
    return HATCH_OK;
}

enum hatch_status hatch_corners_add(struct hatch_corners *corners, const struct hatch_corner *corner, uint32_t *vertex,
                                    struct hatch_err *err)
{
    HATCH_TRY(grow_slots(corners, err));
    uint64_t slot = hash_of(corner);
    uint32_t found;
    while ((found = corners->slots[slot & (corners->slot_count - 1)]) != 0) {
        if (memcmp(&hatch_corners_list(corners)[found - 1], corner, sizeof *corner) == 0) {
            *vertex = found - 1;
            return HATCH_OK;
        }
        slot++;
    }
    HATCH_TRY(hatch_buffer_add(&corners->list, corner, sizeof *corner, err));
    *vertex = corners->count++;
    corners->slots[slot & (corners->slot_count - 1)] = corners->count;
    return HATCH_OK;
}

enum hatch_status hatch_corners_gather(const struct hatch_corners *corners, int part, const float *values,
                                       uint32_t width, float missing, const float **out, struct hatch_err *err)
{
    const struct hatch_corner *list = hatch_corners_list(corners);
    uint32_t v = 0;
    *out = NULL;
    while (v < corners->count && list[v].part[part] == HATCH_CORNER_ABSENT)
        v++;
    if (v == corners->count)
        return HATCH_OK;
    float *data;
    HATCH_TRY(HATCH_ALLOC(corners->scratch, &data, (size_t)corners->count * width, err));
    for (v = 0; v < corners->count; v++)
        for (size_t k = 0; k < width; k++) {
            size_t index = list[v].part[part];
            data[v * (size_t)width + k] = index == HATCH_CORNER_ABSENT ? missing : values[index * width + k];
        }
    *out = data;
    return HATCH_OK;
}

enum hatch_status hatch_corners_numbers(const struct hatch_corners *corners, struct hatch_arena *arena,
                                        const uint32_t **numbers, struct hatch_err *err)
{
    uint32_t *list;
    HATCH_TRY(HATCH_ALLOC_UNSET(arena, &list, corners->count, err));
    for (uint32_t v = 0; v < corners->count; v++)
        list[v] = hatch_corners_list(corners)[v].part[0];
    *numbers = list;
    return HATCH_OK;
}

enum hatch_status hatch_corners_count_unused(const struct hatch_corners *corners, uint32_t count, uint32_t *unused,
                                             struct hatch_err *err)
{
    uint8_t *seen;
    HATCH_TRY(HATCH_ALLOC(corners->scratch, &seen, count, err));
    for (uint32_t v = 0; v < corners->count; v++)
        seen[hatch_corners_list(corners)[v].part[0]] = 1;
    for (uint32_t i = 0; i < count; i++)
        *unused += !seen[i];
    return HATCH_OK;
}
