#include "curve/cells.h"

#include <math.h>
#include <string.h>

#include "curve/reserve.h"

#define BITS 21u /* of a coordinate in a key; cells 2^21 sides apart count as one */

static const int64_t middle = (int64_t)1 << (BITS - 1); /* of the coordinates that keys tell apart */

static uint64_t key_of(const int64_t at[3])
{
    uint64_t key = 0;
    for (int k = 0; k < 3; k++)
        key = key << BITS | ((uint64_t)(at[k] + middle) & (((uint64_t)1 << BITS) - 1));
    return key;
}

enum hatch_status hatch_cells_make(double side, struct hatch_arena *arena, struct hatch_cells *cells,
                                   struct hatch_err *err)
{
    *cells = (struct hatch_cells){.side = side};
    HATCH_TRY(hatch_keys_make(arena, &cells->keys, err));
    return hatch_keys_make(arena, &cells->blocks, err);
}

/* Finds the cells of a new block.
 *   low  their least coordinates */
static enum hatch_status fill_block(struct hatch_cells *cells, uint32_t block, const int64_t low[3],
                                    struct hatch_err *err)
{
    struct hatch_arena *arena = cells->keys.arena;
    HATCH_TRY(hatch_curve_reserve(arena, &cells->corners, sizeof *cells->corners, block, &cells->block_capacity, err));
    for (int corner = 0; corner < 8; corner++) {
        const int64_t at[3] = {low[0] + (corner & 1), low[1] + (corner >> 1 & 1), low[2] + (corner >> 2 & 1)};
        uint32_t *number = &cells->corners[block][corner], count = cells->keys.count;
        HATCH_TRY(hatch_keys_number(&cells->keys, key_of(at), number, err));
        HATCH_TRY(hatch_curve_reserve(arena, &cells->cells, sizeof *cells->cells, *number, &cells->cell_capacity, err));
        if (*number == count)
            cells->cells[count] = (struct hatch_cell){.ink = 0, .area = 0};
    }
    return HATCH_OK;
}

enum hatch_status hatch_cells_around(struct hatch_cells *cells, const double at[3], uint32_t corner[8],
                                     double weight[8], struct hatch_err *err)
{
    int64_t low[3];
    double part[3];
    uint32_t block, blocks = cells->blocks.count;
    for (int k = 0; k < 3; k++) {
        double along = at[k] / cells->side, whole = floor(along);
        low[k] = (int64_t)(whole > -0x1p30 ? whole < 0x1p30 ? whole : 0x1p30 : -0x1p30);
        part[k] = along - whole;
    }
    HATCH_TRY(hatch_keys_number(&cells->blocks, key_of(low), &block, err));
    if (block == blocks)
        HATCH_TRY(fill_block(cells, block, low, err));
    memcpy(corner, cells->corners[block], sizeof cells->corners[block]);
    for (int i = 0; i < 8; i++) {
        weight[i] = 1;
        for (int k = 0; k < 3; k++)
            weight[i] *= i >> k & 1 ? part[k] : 1 - part[k];
    }
    return HATCH_OK;
}

enum hatch_status hatch_cells_add(struct hatch_cells *cells, const double at[3], double ink, double area,
                                  struct hatch_err *err)
{
    uint32_t corner[8];
    double weight[8];
    HATCH_TRY(hatch_cells_around(cells, at, corner, weight, err));
    for (int i = 0; i < 8; i++) {
        cells->cells[corner[i]].ink += (float)(weight[i] * ink);
        cells->cells[corner[i]].area += (float)(weight[i] * area);
    }
    return HATCH_OK;
}

void hatch_cells_middle(const struct hatch_cells *cells, uint32_t cell, double at[3])
{
    uint64_t key = cells->keys.keys[cell];
    for (int k = 2; k >= 0; k--, key >>= BITS)
        at[k] = cells->side * (double)((int64_t)(key & (((uint64_t)1 << BITS) - 1)) - middle);
}
