/* Lifetimes: how long each stroke of a seed set stays while the view moves out.
 *
 * From one nesting level to the next, four tiles merge into one. Of the four copies of the stroke at seed point i, one
 * stays: in the large tile it is at seed point i - 1 (seed/seeds.h). The other three vanish. The order in which strokes
 * vanish is found by farthest-point sampling, so that those that remain are always spread evenly, between levels as
 * well as at levels. */
#ifndef HATCH_SEED_LIFE_H
#define HATCH_SEED_LIFE_H

#include "seed/fade.h"
#include "seed/seeds.h"

#define HATCH_LIFE_STAYS 255u

/* Converts a lifetime in steps, below HATCH_LIFE_STAYS, to the life that hatch_fade_weight takes. */
static inline double hatch_life_value(uint8_t step)
{
    return (step + 0.5) / HATCH_LIFE_STAYS;
}

/* Returns which of four merging tiles keeps the stroke of a seed point: 2 v + u, where u is the tile's column and v its
 * row, both modulo 2. */
uint8_t hatch_life_tile(const struct hatch_seed_set *set, uint32_t seed);

/* Computes the lifetimes of the strokes of a set. Time is quadratic in the number of seed points.
 *   points  those of the set
 *   life    out: [4 * seed + tile], in steps, where tile is numbered as in hatch_life_tile; HATCH_LIFE_STAYS for the
 *           stroke that stays */
enum hatch_status hatch_life_make(const struct hatch_seed_set *set, const struct hatch_seed_point *points,
                                  enum hatch_fade_law law, struct hatch_arena *scratch, uint8_t *life,
                                  struct hatch_err *err) HATCH_MUST_USE;

#endif
