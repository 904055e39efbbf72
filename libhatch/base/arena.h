/* Arenas: libhatch allocates its memory from them; only third-party libraries (CHOLMOD, readers and writers of formats)
 * allocate elsewhere.
 *
 * Results go to the arena that the caller passes, temporary data to a scratch arena that the function rewinds before it
 * returns. An arena has a limit, so that wrong sizes in a file end in HATCH_LIMIT and do not exhaust the machine's
 * memory. An arena is used by one thread at a time. In builds with HATCH_ARENA_SEPARATE (the sanitizer builds) each
 * allocation is a block of its own, so that AddressSanitizer sees every overrun. */
#ifndef HATCH_BASE_ARENA_H
#define HATCH_BASE_ARENA_H

#include <stddef.h>
#include <stdint.h>

#include "base/status.h"

#define HATCH_ARENA_ALIGN 64u              /* alignment of every allocation, in bytes */
#define HATCH_ARENA_STEP ((size_t)4 << 20) /* least size of a block once as much is in use */

struct hatch_arena_block;
struct hatch_budget; /* base/budget.h */

/* Private except for the members marked as public, which are read-only. */
struct hatch_arena {
    struct hatch_arena_block *blocks; /* newest first */
    size_t limit_bytes;               /* public: largest used_bytes allowed */
    size_t used_bytes;                /* public: bytes obtained from the system at present */
    size_t peak_bytes;                /* public: largest used_bytes so far */
    struct hatch_budget *budget;      /* NULL: the arena's limit is its own */
    uint64_t fail_countdown;          /* for tests: see hatch_arena_fail_after */
};

struct hatch_arena_mark {
    struct hatch_arena_block *block;
    size_t block_used;
};

/* Makes an empty arena; allocates nothing yet.
 *   limit_bytes  1 .. SIZE_MAX */
void hatch_arena_init(struct hatch_arena *arena, size_t limit_bytes);

/* Makes an empty arena that shares a limit with others. The arenas may be used by several threads at once, each by one.
 *   budget  all blocks are taken from it; it must outlive them */
void hatch_arena_init_shared(struct hatch_arena *arena, struct hatch_budget *budget);

/* Returns all memory to the system; the arena is empty and usable again. */
void hatch_arena_free(struct hatch_arena *arena);

/* Allocates an array of zeros, aligned to HATCH_ARENA_ALIGN. Returns NULL, with HATCH_LIMIT in err, if the arena's
 * limit would be exceeded, if the system has no memory left, or if count * size overflows. The message tells how much
 * the arena uses or, with a budget, all arenas that share it. A count of 0 is allowed and returns a pointer, too.
 *   size  of an item in bytes, at least 1 */
void *hatch_arena_array(struct hatch_arena *arena, size_t count, size_t size, struct hatch_err *err);

/* Allocates an array like hatch_arena_array, but leaves it uninitialized. It is meant for large arrays that are filled
 * at once: their pages are then first touched by the threads that fill them. */
void *hatch_arena_unset(struct hatch_arena *arena, size_t count, size_t size, struct hatch_err *err);

/* HATCH_NEW(arena, float, n, err) allocates n zeroed floats, HATCH_NEW_UNSET n uninitialized ones; NULL on failure. */
#define HATCH_NEW(arena, type, count, err) ((type *)hatch_arena_array((arena), (count), sizeof(type), (err)))
#define HATCH_NEW_UNSET(arena, type, count, err) ((type *)hatch_arena_unset((arena), (count), sizeof(type), (err)))

/* The same as expressions whose value is a status, for C only: HATCH_ALLOC(arena, &items, n, err) sets items to n
 * zeroed items of its type, or to NULL on failure. */
#define HATCH_ALLOC(arena, pointer, count, err)                                                                        \
    ((*(pointer) = hatch_arena_array((arena), (count), sizeof **(pointer), (err))) ? HATCH_OK : HATCH_LIMIT)
#define HATCH_ALLOC_UNSET(arena, pointer, count, err)                                                                  \
    ((*(pointer) = hatch_arena_unset((arena), (count), sizeof **(pointer), (err))) ? HATCH_OK : HATCH_LIMIT)

/* Copies text and adds a terminating zero; returns NULL on failure, like hatch_arena_array.
 *   length  in bytes, without a terminating zero */
char *hatch_arena_text(struct hatch_arena *arena, const char *text, size_t length, struct hatch_err *err);

/* Returns a mark. Rewinding to a mark frees everything that was allocated after it. Marks nest. */
struct hatch_arena_mark hatch_arena_mark(const struct hatch_arena *arena);
void hatch_arena_rewind(struct hatch_arena *arena, struct hatch_arena_mark mark);

/* For tests: makes the n-th allocation from now (1: the next one) and all later ones fail; 0: none fails. */
void hatch_arena_fail_after(struct hatch_arena *arena, uint64_t n);

#endif
