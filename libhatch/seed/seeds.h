/* Seed sets: where the strokes of a recursive procedural tonal art map stand in its unit tile, one
 * set per layer (Recursive Procedural Tonal Art Maps, §4).
 *
 * Seed i is the uniform cycle turned left by i crumbs, read as a periodic quaternary fraction: with
 * crumb = 2 v + u, the bits of u and of v. So zooming by two into a quarter, s -> fraction of 2 s, takes
 * seed i to seed i + 1. */
#ifndef HATCH_SEED_SEEDS_H
#define HATCH_SEED_SEEDS_H

#include "base/bytes.h"
#include "seed/cycle.h"

#define HATCH_SEED_LAYERS_MAX 256u

struct hatch_seed_set {
    uint32_t count;  /* N, HATCH_CYCLE_MIN .. HATCH_CYCLE_MAX */
    uint8_t *crumbs; /* count: 0 .. 3 */
};

struct hatch_seeds {
    uint32_t layer_count; /* 1 .. HATCH_SEED_LAYERS_MAX */
    struct hatch_seed_set *layers;
};

/* A position in the tile: 64 bits after the point, so that differences wrap as the tile does. */
struct hatch_seed_place {
    uint64_t u, v;
};

/* The places of all seeds of a set: places[i] is seed i. places: set->count entries. */
void hatch_seed_places(const struct hatch_seed_set *set, struct hatch_seed_place *places);

/* seeds(5): one line per layer with its cycle as digits; lines that begin with # are comments.
 * HATCH_BAD_INPUT with the line's number for any other byte, a cycle that is too short or whose line does
 * not end (then the file is cut), no layer. */
enum hatch_status hatch_seeds_read(struct hatch_bytes file, struct hatch_arena *arena, struct hatch_seeds *seeds,
                                   struct hatch_err *err) HATCH_MUST_USE;

/* comment: one line that goes first, without its #; NULL for none. */
enum hatch_status hatch_seeds_write(const struct hatch_seeds *seeds, const char *comment, struct hatch_buffer *file,
                                    struct hatch_err *err) HATCH_MUST_USE;

#endif
