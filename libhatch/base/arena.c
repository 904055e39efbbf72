#include "base/arena.h"

#include <assert.h>
#include <stdalign.h>
#include <stdlib.h>
#include <string.h>

#include "base/budget.h"

struct hatch_arena_block {
    struct hatch_arena_block *older;
    size_t capacity; /* bytes of payload */
    size_t used;
    alignas(HATCH_ARENA_ALIGN) unsigned char payload[];
};

/* A new block is as large as all earlier blocks together, within these bounds: small results take little memory, and
 * large ones need few blocks. */
#define SMALLEST_BLOCK ((size_t)16 << 10)

void hatch_arena_init(struct hatch_arena *arena, size_t limit_bytes)
{
    assert(limit_bytes > 0);
    *arena = (struct hatch_arena){.limit_bytes = limit_bytes};
}

void hatch_arena_init_shared(struct hatch_arena *arena, struct hatch_budget *budget)
{
    hatch_arena_init(arena, budget->limit_bytes);
    arena->budget = budget;
}

static void give_back(struct hatch_arena *arena, size_t bytes)
{
    if (arena->budget)
        hatch_budget_give(arena->budget, bytes);
}

static void drop_newest(struct hatch_arena *arena)
{
    struct hatch_arena_block *block = arena->blocks;
    arena->blocks = block->older;
    arena->used_bytes -= block->capacity;
    give_back(arena, block->capacity);
    free(block);
}

void hatch_arena_free(struct hatch_arena *arena)
{
    while (arena->blocks)
        drop_newest(arena);
}

static size_t block_capacity(const struct hatch_arena *arena, size_t bytes)
{
#ifdef HATCH_ARENA_SEPARATE
    (void)arena;
    return bytes;
#else
    size_t step = arena->used_bytes < SMALLEST_BLOCK ? SMALLEST_BLOCK : arena->used_bytes;
    if (step > HATCH_ARENA_STEP)
        step = HATCH_ARENA_STEP;
    size_t available = arena->limit_bytes - arena->used_bytes;
    if (step > available)
        step = available;
    return bytes > step ? bytes : step;
#endif
}

static struct hatch_arena_block *add_block(struct hatch_arena *arena, size_t bytes)
{
    if (bytes > arena->limit_bytes - arena->used_bytes)
        return NULL;
    size_t capacity = block_capacity(arena, bytes);
    if (arena->budget && !hatch_budget_take(arena->budget, capacity)) {
        capacity = bytes;
        if (!hatch_budget_take(arena->budget, capacity))
            return NULL;
    }
    size_t whole = sizeof(struct hatch_arena_block) + capacity;
    if (whole < capacity || whole > SIZE_MAX - HATCH_ARENA_ALIGN) {
        give_back(arena, capacity);
        return NULL;
    }
    whole = (whole + HATCH_ARENA_ALIGN - 1) / HATCH_ARENA_ALIGN * HATCH_ARENA_ALIGN;
    struct hatch_arena_block *block = aligned_alloc(HATCH_ARENA_ALIGN, whole);
    if (!block) {
        give_back(arena, capacity);
        return NULL;
    }
    block->older = arena->blocks;
    block->capacity = capacity;
    block->used = 0;
    arena->blocks = block;
    arena->used_bytes += capacity;
    if (arena->used_bytes > arena->peak_bytes)
        arena->peak_bytes = arena->used_bytes;
    return block;
}

static void *allocate(struct hatch_arena *arena, size_t bytes)
{
    if (arena->fail_countdown && --arena->fail_countdown == 0) {
        arena->fail_countdown = 1; /* later allocations fail, too */
        return NULL;
    }
    struct hatch_arena_block *block = arena->blocks;
#ifdef HATCH_ARENA_SEPARATE
    block = add_block(arena, bytes);
    if (!block)
        return NULL;
#else
    size_t rounded = (bytes + HATCH_ARENA_ALIGN - 1) / HATCH_ARENA_ALIGN * HATCH_ARENA_ALIGN;
    if (rounded < bytes)
        return NULL;
    bytes = rounded;
    if (!block || bytes > block->capacity - block->used) {
        block = add_block(arena, bytes);
        if (!block)
            return NULL;
    }
#endif
    void *at = block->payload + block->used;
    block->used += bytes;
    return at;
}

void *hatch_arena_array(struct hatch_arena *arena, size_t count, size_t size, struct hatch_err *err)
{
    void *at = hatch_arena_unset(arena, count, size, err);
    return at ? memset(at, 0, count * size) : NULL;
}

void *hatch_arena_unset(struct hatch_arena *arena, size_t count, size_t size, struct hatch_err *err)
{
    assert(size > 0);
    void *at = NULL;
    if (count <= SIZE_MAX / size)
        at = allocate(arena, count * size);
    if (!at)
        hatch_fail(err, HATCH_LIMIT, "out of memory: %zu items of %zu bytes needed, %zu bytes in use, limit %zu", count,
                   size, arena->budget ? atomic_load(&arena->budget->used_bytes) : arena->used_bytes,
                   arena->limit_bytes);
    return at;
}

char *hatch_arena_text(struct hatch_arena *arena, const char *text, size_t length, struct hatch_err *err)
{
    char *copy = HATCH_NEW(arena, char, length + 1, err);
    if (copy)
        memcpy(copy, text, length);
    return copy;
}

struct hatch_arena_mark hatch_arena_mark(const struct hatch_arena *arena)
{
    return (struct hatch_arena_mark){arena->blocks, arena->blocks ? arena->blocks->used : 0};
}

void hatch_arena_rewind(struct hatch_arena *arena, struct hatch_arena_mark mark)
{
    while (arena->blocks != mark.block) {
        assert(arena->blocks);
        drop_newest(arena);
    }
    if (arena->blocks)
        arena->blocks->used = mark.block_used;
}

void hatch_arena_fail_after(struct hatch_arena *arena, uint64_t n)
{
    arena->fail_countdown = n;
}
