#include "curve/reserve.h"

#include <string.h>

#define ITEMS_MIN 1024u

enum hatch_status hatch_curve_reserve(struct hatch_arena *arena, void *array, size_t size, uint32_t count,
                                      uint32_t *capacity, struct hatch_err *err)
{
    void *old, *made;
    if (count < *capacity)
        return HATCH_OK;
    memcpy(&old, array, sizeof old);
    if (count > UINT32_MAX / 4)
        return hatch_fail(err, HATCH_LIMIT, "too many strokes: use a wider gap or fewer levels");
    uint32_t wanted = count > 0 ? 2 * count : ITEMS_MIN;
    made = hatch_arena_unset(arena, wanted, size, err);
    if (!made)
        return HATCH_LIMIT;
    if (count > 0)
        memcpy(made, old, count * size);
    memcpy(array, &made, sizeof made);
    *capacity = wanted;
    return HATCH_OK;
}
