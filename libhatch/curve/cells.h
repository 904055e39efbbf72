/* Cells of space in which the ink of strokes and the area of a surface are summed. */
#ifndef HATCH_CURVE_CELLS_H
#define HATCH_CURVE_CELLS_H

#include "base/keys.h"

struct hatch_cell {
    float ink;  /* of the strokes in it, if they were one unit wide, in mesh units squared */
    float area; /* of the surface, in mesh units squared */
};

/* The cells of a level that something was added to, and the blocks of two by two by two cells around places. */
struct hatch_cells {
    double side;              /* of a cell, in mesh units, greater than 0 */
    struct hatch_keys keys;   /* of cells: their coordinates, in sides */
    struct hatch_keys blocks; /* by the least coordinates of their cells */
    uint32_t (*corners)[8];   /* per block: its cells */
    struct hatch_cell *cells; /* per cell */
    uint32_t cell_capacity, block_capacity;
};

/* Makes an empty set of cells, which grows in arena. */
enum hatch_status hatch_cells_make(double side, struct hatch_arena *arena, struct hatch_cells *cells,
                                   struct hatch_err *err) HATCH_MUST_USE;

/* Finds the eight cells whose middles are around a place; those that are new are empty.
 *   corner  out: numbers of cells
 *   weight  out: how near the place is to each, 0 .. 1; their sum is 1 */
enum hatch_status hatch_cells_around(struct hatch_cells *cells, const double at[3], uint32_t corner[8],
                                     double weight[8], struct hatch_err *err) HATCH_MUST_USE;

/* Divides ink and area among the cells around a place. */
enum hatch_status hatch_cells_add(struct hatch_cells *cells, const double at[3], double ink, double area,
                                  struct hatch_err *err) HATCH_MUST_USE;

/* Finds the middle of a cell.
 *   cell  a number below cells->keys.count */
void hatch_cells_middle(const struct hatch_cells *cells, uint32_t cell, double at[3]);

#endif
