#include "base/keys.h"

#include <string.h>

#include "base/random.h"

#define FIRST_CAPACITY 1024u

static uint32_t slot_of(const struct hatch_keys *keys, uint64_t key)
{
    uint32_t slot = (uint32_t)hatch_random_mix(key) & (keys->capacity - 1);
    while (keys->slots[slot] && keys->keys[keys->slots[slot] - 1] != key)
        slot = (slot + 1) & (keys->capacity - 1);
    return slot;
}

static enum hatch_status grow(struct hatch_keys *keys, uint32_t capacity, struct hatch_err *err)
{
    struct hatch_keys grown = {.arena = keys->arena, .count = keys->count, .capacity = capacity};
    HATCH_TRY(HATCH_ALLOC(keys->arena, &grown.keys, capacity / 2, err));
    HATCH_TRY(HATCH_ALLOC(keys->arena, &grown.slots, capacity, err));
    if (keys->count)
        memcpy(grown.keys, keys->keys, keys->count * sizeof *keys->keys);
    for (uint32_t i = 0; i < grown.count; i++)
        grown.slots[slot_of(&grown, grown.keys[i])] = i + 1;
    *keys = grown;
    return HATCH_OK;
}

enum hatch_status hatch_keys_make(struct hatch_arena *arena, struct hatch_keys *keys, struct hatch_err *err)
{
    struct hatch_keys made = {.arena = arena};
    HATCH_TRY(grow(&made, FIRST_CAPACITY, err));
    *keys = made;
    return HATCH_OK;
}

enum hatch_status hatch_keys_number(struct hatch_keys *keys, uint64_t key, uint32_t *number, struct hatch_err *err)
{
    uint32_t slot = slot_of(keys, key);
    if (!keys->slots[slot]) {
        if (keys->count == keys->capacity / 2) {
            if (keys->capacity > UINT32_MAX / 2)
                return hatch_fail(err, HATCH_LIMIT,
                                  "the mesh is too large: more than %u different vertices, edges or faces",
                                  keys->count);
            HATCH_TRY(grow(keys, 2 * keys->capacity, err));
            slot = slot_of(keys, key);
        }
        keys->keys[keys->count++] = key;
        keys->slots[slot] = keys->count;
    }
    *number = keys->slots[slot] - 1;
    return HATCH_OK;
}
