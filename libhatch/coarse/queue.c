#include "coarse/queue.h"

#include <string.h>

#define ABSENT UINT32_MAX

enum hatch_status hatch_coarse_queue_make(uint32_t item_count, struct hatch_arena *arena,
                                          struct hatch_coarse_queue *queue, struct hatch_err *err)
{
    struct hatch_coarse_queue made = {0};
    HATCH_TRY(HATCH_ALLOC(arena, &made.items, item_count, err));
    HATCH_TRY(HATCH_ALLOC(arena, &made.place, item_count, err));
    HATCH_TRY(HATCH_ALLOC(arena, &made.key, item_count, err));
    memset(made.place, 0xff, item_count * sizeof *made.place);
    *queue = made;
    return HATCH_OK;
}

static bool before(const struct hatch_coarse_queue *queue, uint32_t a, uint32_t b)
{
    return queue->key[a] < queue->key[b] || (queue->key[a] == queue->key[b] && a < b);
}

static void put(struct hatch_coarse_queue *queue, uint32_t place, uint32_t item)
{
    queue->items[place] = item;
    queue->place[item] = place;
}

/* Moves an item from a place to where the heap's order wants it. */
static void settle(struct hatch_coarse_queue *queue, uint32_t at, uint32_t item)
{
    while (at > 0 && before(queue, item, queue->items[(at - 1) / 2])) {
        put(queue, at, queue->items[(at - 1) / 2]);
        at = (at - 1) / 2;
    }
    for (uint32_t child; (child = 2 * at + 1) < queue->count; at = child) {
        if (child + 1 < queue->count && before(queue, queue->items[child + 1], queue->items[child]))
            child++;
        if (!before(queue, queue->items[child], item))
            break;
        put(queue, at, queue->items[child]);
    }
    put(queue, at, item);
}

void hatch_coarse_queue_set(struct hatch_coarse_queue *queue, uint32_t item, double key)
{
    queue->key[item] = key;
    settle(queue, queue->place[item] == ABSENT ? queue->count++ : queue->place[item], item);
}

void hatch_coarse_queue_drop(struct hatch_coarse_queue *queue, uint32_t item)
{
    uint32_t place = queue->place[item];
    if (place == ABSENT)
        return;
    queue->place[item] = ABSENT;
    uint32_t last = queue->items[--queue->count];
    if (last != item)
        settle(queue, place, last);
}

bool hatch_coarse_queue_pop(struct hatch_coarse_queue *queue, uint32_t *item)
{
    if (queue->count == 0)
        return false;
    *item = queue->items[0];
    hatch_coarse_queue_drop(queue, *item);
    return true;
}
