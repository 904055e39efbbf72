#include "lapped/heap.h"

#include <string.h>

#define CAPACITY_MIN 64u

enum hatch_status hatch_lapped_reserve(struct hatch_arena *arena, void **array, uint32_t *capacity, uint32_t needed,
                                       size_t size, struct hatch_err *err)
{
    if (needed <= *capacity)
        return HATCH_OK;
    uint32_t more = *capacity < CAPACITY_MIN ? CAPACITY_MIN : *capacity;
    while (more < needed)
        more = more > UINT32_MAX / 2 ? UINT32_MAX : more * 2;
    void *larger = hatch_arena_array(arena, more, size, err);
    if (!larger)
        return HATCH_LIMIT;
    if (*capacity)
        memcpy(larger, *array, (size_t)*capacity * size);
    *array = larger;
    *capacity = more;
    return HATCH_OK;
}

static bool before(const struct hatch_heap_item *a, const struct hatch_heap_item *b)
{
    return a->key < b->key || (a->key == b->key && a->id < b->id);
}

enum hatch_status hatch_heap_push(struct hatch_heap *heap, double key, uint32_t id, struct hatch_err *err)
{
    void *items = heap->items;
    HATCH_TRY(hatch_lapped_reserve(heap->arena, &items, &heap->capacity, heap->count + 1, sizeof *heap->items, err));
    heap->items = items;
    struct hatch_heap_item item = {key, id};
    uint32_t at = heap->count++;
    while (at > 0 && before(&item, &heap->items[(at - 1) / 2])) {
        heap->items[at] = heap->items[(at - 1) / 2];
        at = (at - 1) / 2;
    }
    heap->items[at] = item;
    return HATCH_OK;
}

bool hatch_heap_pop(struct hatch_heap *heap, struct hatch_heap_item *item)
{
    if (heap->count == 0)
        return false;
    *item = heap->items[0];
    struct hatch_heap_item last = heap->items[--heap->count];
    uint32_t at = 0;
    for (;;) {
        uint32_t child = 2 * at + 1;
        if (child >= heap->count)
            break;
        if (child + 1 < heap->count && before(&heap->items[child + 1], &heap->items[child]))
            child++;
        if (!before(&heap->items[child], &last))
            break;
        heap->items[at] = heap->items[child];
        at = child;
    }
    heap->items[at] = last;
    return true;
}
