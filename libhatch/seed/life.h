/* Lifetimes: how long each stroke of a seed set stays while the view moves out.
 *
 * A stroke that stays is that of seed point i in a tile of one nesting level and of seed point i - 1 in the tile of the
 * next level that contains it (seed/seeds.h); this is so in one of every four tiles. The other strokes vanish in an
 * order in which the remaining ones are always as far apart as possible, so that patterns between levels are as even
 * as those at levels. */
#ifndef HATCH_SEED_LIFE_H
#define HATCH_SEED_LIFE_H

#include "seed/fade.h"
#include "seed/seeds.h"

#define HATCH_LIFE_STAYS 255u

/* Returns the life, for hatch_fade_weight, of a step below HATCH_LIFE_STAYS. */
static inline double hatch_life_value(uint8_t step)
{
    return (step + 0.5) / HATCH_LIFE_STAYS;
}

/* Returns the tile in which the stroke of a seed point stays in the next level: 2 v + u, its row and column modulo
 * 2. */
uint8_t hatch_life_tile(const struct hatch_seed_set *set, uint32_t seed);

/* Computes the lifetimes of the strokes of a set. Time is quadratic in the number of seed points.
 *   points  of the set
 *   life    out: [4 * seed + tile], in steps; HATCH_LIFE_STAYS in the tile of hatch_life_tile */
enum hatch_status hatch_life_make(const struct hatch_seed_set *set, const struct hatch_seed_point *points,
                                  enum hatch_fade_law law, struct hatch_arena *scratch, uint8_t *life,
                                  struct hatch_err *err) HATCH_MUST_USE;

#endif
