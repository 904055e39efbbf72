/* Numbers things by a 64-bit key: equal keys, equal numbers, counted from 0 in order of appearance. */
#ifndef RENDER_LINES_KEYS_H
#define RENDER_LINES_KEYS_H

#include "base/arena.h"

struct hatch_keys {
    struct hatch_arena *arena;
    uint64_t *keys;           /* by number */
    uint32_t *slots;          /* number + 1; 0: empty */
    uint32_t count, capacity; /* capacity: a power of two, twice the keys that there is room for */
};

/* An empty table in the arena, which grows there. */
enum hatch_status hatch_keys_make(struct hatch_arena *arena, struct hatch_keys *keys,
                                  struct hatch_err *err) HATCH_MUST_USE;

/* The key's number; keys->count - 1 after the call, and count one higher, when it is new. */
enum hatch_status hatch_keys_number(struct hatch_keys *keys, uint64_t key, uint32_t *number,
                                    struct hatch_err *err) HATCH_MUST_USE;

/* The key of two numbers, whatever their order. */
static inline uint64_t hatch_keys_pair(uint32_t a, uint32_t b)
{
    return a < b ? (uint64_t)a << 32 | b : (uint64_t)b << 32 | a;
}

#endif
