#include "stroke/stroke.h"

#include <string.h>

enum hatch_status hatch_stroke_list_add(struct hatch_stroke_list *list, struct hatch_arena *arena,
                                        const struct hatch_stroke *stroke, struct hatch_err *err)
{
    if (list->count == list->capacity) {
        uint32_t capacity = list->capacity ? list->capacity * 2 : 1024;
        struct hatch_stroke *items;
        HATCH_TRY(HATCH_ALLOC(arena, &items, capacity, err));
        if (list->count)
            memcpy(items, list->items, list->count * sizeof *items);
        list->items = items;
        list->capacity = capacity;
    }
    list->items[list->count++] = *stroke;
    return HATCH_OK;
}
