#include "trace/grid.h"

#include <math.h>
#include <string.h>

#include "base/random.h"

#define FREE UINT64_MAX
#define SLOTS_MIN 1024u

void hatch_trace_grid_begin(double cell, struct hatch_arena *arena, struct hatch_trace_grid *grid)
{
    *grid = (struct hatch_trace_grid){.cell = cell, .arena = arena};
}

void hatch_trace_grid_clear(struct hatch_trace_grid *grid, double cell)
{
    grid->cell = cell;
    grid->used = 0;
    if (grid->slots > 0)
        memset(grid->key, 0xff, grid->slots * sizeof *grid->key);
}

/* Packs the coordinates of a cell, of 21 bits each; those outside wrap around, which only adds items to look at. */
static uint64_t key_of(int64_t x, int64_t y, int64_t z)
{
    const uint64_t mask = (1u << 21) - 1;
    return ((uint64_t)x & mask) << 42 | ((uint64_t)y & mask) << 21 | ((uint64_t)z & mask);
}

static uint32_t slot_of(const struct hatch_trace_grid *grid, uint64_t key)
{
    uint32_t slot = (uint32_t)hatch_random_mix(key) & (grid->slots - 1);
    while (grid->key[slot] != FREE && grid->key[slot] != key)
        slot = (slot + 1) & (grid->slots - 1);
    return slot;
}

static enum hatch_status grow_slots(struct hatch_trace_grid *grid, struct hatch_err *err)
{
    struct hatch_trace_grid old = *grid;
    grid->slots = old.slots > 0 ? 2 * old.slots : SLOTS_MIN;
    HATCH_TRY(HATCH_ALLOC_UNSET(grid->arena, &grid->key, grid->slots, err));
    HATCH_TRY(HATCH_ALLOC_UNSET(grid->arena, &grid->head, grid->slots, err));
    memset(grid->key, 0xff, grid->slots * sizeof *grid->key);
    for (uint32_t i = 0; i < old.slots; i++)
        if (old.key[i] != FREE) {
            uint32_t slot = slot_of(grid, old.key[i]);
            grid->key[slot] = old.key[i];
            grid->head[slot] = old.head[i];
        }
    return HATCH_OK;
}

static enum hatch_status reserve(struct hatch_trace_grid *grid, uint32_t item, struct hatch_err *err)
{
    uint32_t *old = grid->next, before = grid->capacity;
    if (item < before)
        return HATCH_OK;
    grid->capacity = item < 2 * before ? 2 * before : item + SLOTS_MIN;
    HATCH_TRY(HATCH_ALLOC_UNSET(grid->arena, &grid->next, grid->capacity, err));
    if (before > 0)
        memcpy(grid->next, old, before * sizeof *old);
    return HATCH_OK;
}

enum hatch_status hatch_trace_grid_add(struct hatch_trace_grid *grid, uint32_t item, const double at[3],
                                       struct hatch_err *err)
{
    HATCH_TRY(reserve(grid, item, err));
    if (2 * (grid->used + 1) > grid->slots)
        HATCH_TRY(grow_slots(grid, err));
    int64_t place[3];
    for (int k = 0; k < 3; k++)
        place[k] = (int64_t)floor(at[k] / grid->cell);
    uint64_t key = key_of(place[0], place[1], place[2]);
    uint32_t slot = slot_of(grid, key);
    if (grid->key[slot] == FREE) {
        grid->key[slot] = key;
        grid->head[slot] = HATCH_TRACE_NONE;
        grid->used++;
    }
    grid->next[item] = grid->head[slot];
    grid->head[slot] = item;
    return HATCH_OK;
}

uint32_t hatch_trace_grid_near(const struct hatch_trace_grid *grid, const double at[3], double radius,
                               uint32_t heads[27])
{
    int64_t low[3], high[3];
    uint32_t count = 0;
    if (grid->slots == 0)
        return 0;
    for (int k = 0; k < 3; k++) {
        low[k] = (int64_t)floor((at[k] - radius) / grid->cell);
        high[k] = (int64_t)floor((at[k] + radius) / grid->cell);
    }
    for (int64_t x = low[0]; x <= high[0]; x++)
        for (int64_t y = low[1]; y <= high[1]; y++)
            for (int64_t z = low[2]; z <= high[2] && count < 27; z++) {
                uint32_t slot = slot_of(grid, key_of(x, y, z));
                if (grid->key[slot] != FREE)
                    heads[count++] = grid->head[slot];
            }
    return count;
}
