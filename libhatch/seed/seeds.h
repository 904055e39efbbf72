/* Seed sets: the seed points of a recursive procedural tonal art map, which are the positions of its strokes in the
 * unit tile, one set per layer (Recursive Procedural Tonal Art Maps, §4).
 *
 * A set is stored as a uniform cycle (seed/cycle/cycle.h) of crumbs: base-4 digits, each made of a bit of v and a bit
 * of u (crumb = 2 v + u). The coordinates of seed point i are the periodic binary fractions that these bits form once
 * the cycle is rotated left by i crumbs. Enlarging a quarter of the tile to the whole tile (s becomes the fraction of 2
 * s) therefore takes seed point i to seed point i + 1. */
#ifndef HATCH_SEED_SEEDS_H
#define HATCH_SEED_SEEDS_H

#include "base/bytes.h"
#include "seed/cycle/cycle.h"

#define HATCH_SEED_LAYERS_MAX 256u

struct hatch_seed_set {
    uint32_t count;  /* N, HATCH_CYCLE_MIN .. HATCH_CYCLE_MAX */
    uint8_t *crumbs; /* count entries, 0 .. 3 */
};

struct hatch_seeds {
    uint32_t layer_count;          /* 1 .. HATCH_SEED_LAYERS_MAX */
    struct hatch_seed_set *layers; /* layer_count entries */
};

/* Position of a seed point in the tile, in units of 2^-64 of its side, so that differences wrap with the tile. */
struct hatch_seed_point {
    uint64_t u, v;
};

/* Computes the seed points of a set.
 *   points  out: set->count entries */
void hatch_seed_points(const struct hatch_seed_set *set, struct hatch_seed_point *points);

/* Reads seeds(5): one line per layer with its cycle as digits; lines that begin with # are comments.
 *   seeds  out, in arena; unchanged on failure
 * HATCH_BAD_INPUT, which names the line, for a character other than 0 to 3, a cycle that is too short or too long, or a
 * last line without a line feed (the file is truncated); HATCH_BAD_INPUT also for a file without layers; HATCH_LIMIT
 * for more than HATCH_SEED_LAYERS_MAX layers. */
enum hatch_status hatch_seeds_read(struct hatch_bytes file, struct hatch_arena *arena, struct hatch_seeds *seeds,
                                   struct hatch_err *err) HATCH_MUST_USE;

/* Appends the sets to file as seeds(5).
 *   comment  first line, without #; NULL: none */
enum hatch_status hatch_seeds_write(const struct hatch_seeds *seeds, const char *comment, struct hatch_buffer *file,
                                    struct hatch_err *err) HATCH_MUST_USE;

#endif
