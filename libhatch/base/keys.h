/* A hash table that numbers 64-bit keys: equal keys get equal numbers, counted from 0 in order of appearance. */
#ifndef HATCH_BASE_KEYS_H
#define HATCH_BASE_KEYS_H

#include "base/arena.h"

struct hatch_keys {
    struct hatch_arena *arena;
    uint64_t *keys;    /* by number */
    uint32_t *slots;   /* capacity entries: number + 1; 0: empty */
    uint32_t count;    /* number of different keys */
    uint32_t capacity; /* a power of two, at least twice count */
};

/* Makes an empty table, which grows in arena. */
enum hatch_status hatch_keys_make(struct hatch_arena *arena, struct hatch_keys *keys,
                                  struct hatch_err *err) HATCH_MUST_USE;

/* Finds the number of a key. A new key is added: its number is the old count, and count rises by 1. */
enum hatch_status hatch_keys_number(struct hatch_keys *keys, uint64_t key, uint32_t *number,
                                    struct hatch_err *err) HATCH_MUST_USE;

/* Returns the key of an unordered pair: the same for (a, b) and (b, a). */
static inline uint64_t hatch_keys_pair(uint32_t a, uint32_t b)
{
    return a < b ? (uint64_t)a << 32 | b : (uint64_t)b << 32 | a;
}

#endif
