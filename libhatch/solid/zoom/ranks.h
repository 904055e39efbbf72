#ifndef HATCH_SOLID_ZOOM_RANKS_H
#define HATCH_SOLID_ZOOM_RANKS_H

#include "base/parallel.h"
#include "solid/solid.h"

/* Turns the values of a grey texture into their ranks, 0 .. 255, so that a threshold t covers the share t of the
 * texels. A few equal values have the rank in their middle. Where they are many, as in a texture of black dots on
 * white, a threshold between their ranks has to cover a part of them: those with darker surroundings come first, so
 * that shapes grow from their borders.
 *   solid  in: the texture; out: its ranks, in arena
 * HATCH_LIMIT when the memory does not suffice. */
enum hatch_status hatch_zoom_rank(struct hatch_solid *solid, struct hatch_pool *pool, struct hatch_arena *arena,
                                  struct hatch_arena *scratch, struct hatch_err *err) HATCH_MUST_USE;

#endif
