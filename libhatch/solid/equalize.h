/* Equalization: values become ranks, so that a threshold t covers the share t of the texels. */
#ifndef HATCH_SOLID_EQUALIZE_H
#define HATCH_SOLID_EQUALIZE_H

#include "base/parallel.h"

/* Replaces values by bytes in the same order, of which each of 0 .. 255 occurs equally often or, if the values are no
 * multiple of 256, once more or less. Equal values are ordered by a hash of their index.
 *   values  count finite numbers
 *   count   a multiple of 64, up to 2^28
 *   bytes   out: count bytes; the same for any number of threads
 * HATCH_LIMIT when scratch does not have a megabyte; with less than one for each thread, fewer work. */
enum hatch_status hatch_equalize(const float *values, uint32_t count, struct hatch_pool *pool,
                                 struct hatch_arena *scratch, uint8_t *bytes, struct hatch_err *err) HATCH_MUST_USE;

#endif
