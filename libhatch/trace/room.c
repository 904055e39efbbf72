/* Memory of arrays that grow to many megabytes. */
#include "trace/work.h"

void hatch_trace_room_init(struct hatch_trace_room *room, struct hatch_budget *budget)
{
    *room = (struct hatch_trace_room){.used = 0};
    for (int i = 0; i < 2; i++)
        hatch_arena_init_shared(&room->arenas[i], budget);
}

void hatch_trace_room_free(struct hatch_trace_room *room)
{
    for (int i = 0; i < 2; i++)
        hatch_arena_free(&room->arenas[i]);
    room->spare_capacity = 0;
}

enum hatch_status hatch_trace_room_reserve(struct hatch_trace_room *room, void *array, size_t size, uint32_t count,
                                           uint32_t *capacity, struct hatch_err *err)
{
    uint32_t other = 1 - room->used;
    if (count < *capacity)
        return HATCH_OK;
    hatch_arena_free(&room->arenas[other]);
    room->spare_capacity = 0;
    HATCH_TRY(hatch_curve_reserve(&room->arenas[other], array, size, count, capacity, err));
    hatch_arena_free(&room->arenas[room->used]);
    room->used = other;
    return HATCH_OK;
}

enum hatch_status hatch_trace_room_swap(struct hatch_trace_room *room, void *now, size_t size, uint32_t capacity,
                                        void **array, struct hatch_err *err)
{
    struct hatch_arena *other = &room->arenas[1 - room->used];
    if (room->spare_capacity != capacity) {
        hatch_arena_free(other);
        room->spare_capacity = 0;
        room->spare = hatch_arena_unset(other, capacity, size, err);
        if (!room->spare)
            return HATCH_LIMIT;
        room->spare_capacity = capacity;
    }
    *array = room->spare;
    room->spare = now;
    room->used = 1 - room->used;
    return HATCH_OK;
}
