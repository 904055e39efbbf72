/* A binary heap of numbered items, smallest key first. Equal keys are ordered by number, so that the order is total. */
#ifndef HATCH_LAPPED_HEAP_H
#define HATCH_LAPPED_HEAP_H

#include <stdbool.h>

#include "base/arena.h"

struct hatch_heap_item {
    double key;
    uint32_t id;
};

/* Initialise with {.arena = a}. */
struct hatch_heap {
    struct hatch_heap_item *items;
    uint32_t count, capacity;
    struct hatch_arena *arena;
};

/* Adds an item. */
enum hatch_status hatch_heap_push(struct hatch_heap *heap, double key, uint32_t id,
                                  struct hatch_err *err) HATCH_MUST_USE;

/* Removes the smallest item. Returns false when the heap is empty. */
bool hatch_heap_pop(struct hatch_heap *heap, struct hatch_heap_item *item);

/* Grows an array by doubling, if necessary; new items are zero. The old array stays in the arena.
 *   array     in and out: start of the array
 *   capacity  in and out: number of items that fit
 *   needed    number of items that must fit
 *   size      of an item, in bytes */
enum hatch_status hatch_lapped_reserve(struct hatch_arena *arena, void **array, uint32_t *capacity, uint32_t needed,
                                       size_t size, struct hatch_err *err) HATCH_MUST_USE;

#endif
