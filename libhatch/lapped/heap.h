/* A queue of numbered things, smallest key first; equal keys by number, so that order is total. */
#ifndef HATCH_LAPPED_HEAP_H
#define HATCH_LAPPED_HEAP_H

#include <stdbool.h>

#include "base/arena.h"

struct hatch_heap_item {
    double key;
    uint32_t id;
};

struct hatch_heap {
    struct hatch_heap_item *items;
    uint32_t count, room;
    struct hatch_arena *arena;
};

/* Adds an item; the heap begins as {.arena = a} and doubles there. */
enum hatch_status hatch_heap_push(struct hatch_heap *heap, double key, uint32_t id,
                                  struct hatch_err *err) HATCH_MUST_USE;

/* false when it is empty. */
bool hatch_heap_pop(struct hatch_heap *heap, struct hatch_heap_item *item);

/* Room for at least `want` items of size bytes in *array, the first *room of which are kept. */
enum hatch_status hatch_heap_reserve(struct hatch_arena *arena, void **array, uint32_t *room, uint32_t want,
                                     size_t size, struct hatch_err *err) HATCH_MUST_USE;

#endif
