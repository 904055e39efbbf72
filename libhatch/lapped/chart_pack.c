#include <math.h>

#include "lapped/atlas.h"
#include "lapped/heap.h"

/* Number of bisections in the search for the smallest square. */
#define SEARCH_ROUNDS 40

/* Packs the boxes in the given order onto shelves of the given width. Returns the total height, or infinity if a box is
 * too wide. */
static double fill_shelves(const double *sizes, const uint32_t *order, uint32_t count, double width, double gap,
                           double *corners)
{
    double x = gap, y = gap, shelf_height = 0;
    for (uint32_t i = 0; i < count; i++) {
        const double *size = &sizes[2 * (size_t)order[i]];
        if (x > gap && x + size[0] + gap > width) {
            x = gap;
            y += shelf_height + gap;
            shelf_height = 0;
        }
        if (x + size[0] + gap > width)
            return HUGE_VAL;
        corners[2 * (size_t)order[i]] = x;
        corners[2 * (size_t)order[i] + 1] = y;
        x += size[0] + gap;
        shelf_height = fmax(shelf_height, size[1]);
    }
    return y + shelf_height + gap;
}

enum hatch_status hatch_charts_pack(const double *sizes, uint32_t count, double margin, struct hatch_arena *scratch,
                                    double *corners, double *side, struct hatch_err *err)
{
    struct hatch_arena_mark mark = hatch_arena_mark(scratch);
    struct hatch_heap heap = {.arena = scratch};
    struct hatch_heap_item item;
    uint32_t *order = HATCH_NEW(scratch, uint32_t, count, err);
    enum hatch_status status = order ? HATCH_OK : HATCH_LIMIT;
    double high = 0;
    for (uint32_t i = 0; i < count && status == HATCH_OK; i++) {
        status = hatch_heap_push(&heap, -sizes[2 * (size_t)i + 1], i, err);
        high += sizes[2 * (size_t)i] + sizes[2 * (size_t)i + 1];
    }
    if (status == HATCH_OK) {
        for (uint32_t i = 0; hatch_heap_pop(&heap, &item); i++)
            order[i] = item.id;
        /* Limited so that gaps take at most a quarter of the side. */
        margin = fmin(margin, 0.125 / sqrt((double)count));
        double low = 0;
        high *= 2;
        for (int i = 0; i < SEARCH_ROUNDS; i++) {
            double middle = (low + high) / 2;
            if (fill_shelves(sizes, order, count, middle, margin * middle, corners) <= middle)
                high = middle;
            else
                low = middle;
        }
        fill_shelves(sizes, order, count, high, margin * high, corners);
        *side = high;
    }
    hatch_arena_rewind(scratch, mark);
    return status;
}
