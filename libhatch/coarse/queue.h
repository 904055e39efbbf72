/* A priority queue of numbered items, smallest key first, in which each item is at most once and its key may change.
 * Equal keys are ordered by number, so that the order is total. */
#ifndef HATCH_COARSE_QUEUE_H
#define HATCH_COARSE_QUEUE_H

#include <stdbool.h>

#include "base/arena.h"

struct hatch_coarse_queue {
    uint32_t count;
    uint32_t *items; /* a binary heap */
    uint32_t *place; /* per item: its index in items, or UINT32_MAX */
    double *key;     /* per item */
};

/* Makes an empty queue for items 0 .. item_count - 1. */
enum hatch_status hatch_coarse_queue_make(uint32_t item_count, struct hatch_arena *arena,
                                          struct hatch_coarse_queue *queue, struct hatch_err *err) HATCH_MUST_USE;

/* Adds an item, or changes its key. */
void hatch_coarse_queue_set(struct hatch_coarse_queue *queue, uint32_t item, double key);

/* Removes an item, if it is in the queue. */
void hatch_coarse_queue_drop(struct hatch_coarse_queue *queue, uint32_t item);

/* Removes the smallest item. Returns false when the queue is empty. */
bool hatch_coarse_queue_pop(struct hatch_coarse_queue *queue, uint32_t *item);

#endif
