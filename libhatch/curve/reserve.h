/* Arrays of strokes, and of what belongs to them, that grow. */
#ifndef HATCH_CURVE_RESERVE_H
#define HATCH_CURVE_RESERVE_H

#include "base/arena.h"

/* Makes room for one more item in an array that doubles.
 *   array     address of the pointer to the items
 *   size      of an item, in bytes
 *   capacity  in, out */
enum hatch_status hatch_curve_reserve(struct hatch_arena *arena, void *array, size_t size, uint32_t count,
                                      uint32_t *capacity, struct hatch_err *err) HATCH_MUST_USE;

#endif
