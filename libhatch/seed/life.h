/* How long each stroke of a seed set stays while a view goes out.
 *
 * Seed i in a tile of a level is, where it stays, seed i - 1 of the tile of the next level that holds its own
 * (seed/seeds.h); which it does in one of every four tiles. Among the others an order says who goes first: in it
 * the strokes that are left keep as far from each other as can be, so that patterns between levels are as
 * even as those on them. */
#ifndef HATCH_SEED_LIFE_H
#define HATCH_SEED_LIFE_H

#include "seed/fade.h"
#include "seed/seeds.h"

#define HATCH_LIFE_STAYS 255u

/* The life of hatch_fade_weight that a step below HATCH_LIFE_STAYS stands for. */
static inline double hatch_life_value(uint8_t step)
{
    return (step + 0.5) / HATCH_LIFE_STAYS;
}

/* Which of four tiles shows a seed at the next level, 2 v + u of their columns and rows modulo 2. */
uint8_t hatch_life_tile(const struct hatch_seed_set *set, uint32_t seed);

/* life[4 * seed + tile]: in steps, those of a law; HATCH_LIFE_STAYS in the tile of hatch_life_tile. places: of all
 * seeds. Time is quadratic in their number. */
enum hatch_status hatch_life_make(const struct hatch_seed_set *set, const struct hatch_seed_place *places,
                                  enum hatch_fade_law law, struct hatch_arena *scratch, uint8_t *life,
                                  struct hatch_err *err) HATCH_MUST_USE;

#endif
