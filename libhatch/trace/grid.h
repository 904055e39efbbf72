/* Items by the cell of space that they lie in. */
#ifndef HATCH_TRACE_GRID_H
#define HATCH_TRACE_GRID_H

#include "base/arena.h"

#define HATCH_TRACE_NONE UINT32_MAX

struct hatch_trace_grid {
    double cell; /* side of a cell */
    uint32_t slots, used;
    uint64_t *key;  /* per slot: cell; ~0: free */
    uint32_t *head; /* per slot: the last item that was added */
    uint32_t *next; /* per item: the one added before it in its cell, or HATCH_TRACE_NONE */
    uint32_t capacity;
    struct hatch_arena *arena;
};

/* Makes a grid empty. Its arrays are in arena and grow.
 *   cell  greater than 0 */
void hatch_trace_grid_begin(double cell, struct hatch_arena *arena, struct hatch_trace_grid *grid);

/* Removes all items and sets the side of a cell. */
void hatch_trace_grid_clear(struct hatch_trace_grid *grid, double cell);

/* Adds an item: a number that was not added before. */
enum hatch_status hatch_trace_grid_add(struct hatch_trace_grid *grid, uint32_t item, const double at[3],
                                       struct hatch_err *err) HATCH_MUST_USE;

/* Lists the first items of the cells that a cube around a position touches. Follow grid->next from each.
 *   radius  half the side of the cube, at most a cell
 *   heads   out
 * Returns their number. */
uint32_t hatch_trace_grid_near(const struct hatch_trace_grid *grid, const double at[3], double radius,
                               uint32_t heads[27]);

#endif
