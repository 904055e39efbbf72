/* Memory by lifetime: everything that libhatch allocates comes from an arena.
 *
 * Results go to the arena that the caller gives; temporaries go to a scratch arena, which the
 * function rewinds to where it found it before it returns. An arena has a limit, so that a header
 * that lies ends in HATCH_LIMIT and not in the machine's memory. An arena is used by one thread at
 * a time. In builds with HATCH_ARENA_SEPARATE (the sanitizer builds) each object is a block of its
 * own, so that AddressSanitizer sees every overrun.
 */
#ifndef HATCH_BASE_ARENA_H
#define HATCH_BASE_ARENA_H

#include <stddef.h>
#include <stdint.h>

#include "base/status.h"

#define HATCH_ARENA_ALIGN 64u

struct hatch_arena_block;

/* Fields are private but for the three that may be read. */
struct hatch_arena {
    struct hatch_arena_block *blocks; /* newest first */
    size_t limit_bytes;               /* read: what used_bytes may not pass */
    size_t used_bytes;                /* read: bytes taken from the system now */
    size_t peak_bytes;                /* read: the largest used_bytes so far */
    uint64_t fail_countdown;          /* tests: 0 = off */
};

struct hatch_arena_mark {
    struct hatch_arena_block *block;
    size_t block_used;
};

/* Makes an empty arena; takes no memory yet. limit_bytes: 1 .. SIZE_MAX. */
void hatch_arena_init(struct hatch_arena *arena, size_t limit_bytes);

/* Returns every block to the system; the arena is empty and usable again. */
void hatch_arena_free(struct hatch_arena *arena);

/* Returns count objects of size bytes each, zeroed, aligned to HATCH_ARENA_ALIGN; never NULL for
 * count 0. On failure (limit, overflow of count × size, system out of memory) returns NULL and
 * fills err with HATCH_LIMIT. size: at least 1. */
void *hatch_arena_array(struct hatch_arena *arena, size_t count, size_t size, struct hatch_err *err);

/* The same without the zeros, for what is large and filled at once: its pages are then touched first by
 * the threads that fill them. */
void *hatch_arena_unset(struct hatch_arena *arena, size_t count, size_t size, struct hatch_err *err);
#define HATCH_NEW_UNSET(arena, type, count, err) ((type *)hatch_arena_unset((arena), (count), sizeof(type), (err)))

/* HATCH_NEW(arena, float, n, err): n zeroed floats, or NULL with err filled. */
#define HATCH_NEW(arena, type, count, err) ((type *)hatch_arena_array((arena), (count), sizeof(type), (err)))

/* A zero-terminated copy of length bytes of text, or NULL with err filled. */
char *hatch_arena_text(struct hatch_arena *arena, const char *text, size_t length, struct hatch_err *err);

/* Everything allocated after a mark is freed by the rewind to it. Marks nest. */
struct hatch_arena_mark hatch_arena_mark(const struct hatch_arena *arena);
void hatch_arena_rewind(struct hatch_arena *arena, struct hatch_arena_mark mark);

/* For tests: the n-th allocation from now (1 = the next) and all later ones fail; 0 = none does. */
void hatch_arena_fail_after(struct hatch_arena *arena, uint64_t n);

#endif
