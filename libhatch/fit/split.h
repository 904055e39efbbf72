/* Strokes that no single cubic can follow. Where a texture is distorted, as at the poles and the rims of round shapes,
 * the fragments of a stroke may lie apart in the picture, or run along a bend that is too long for a cubic. */
#ifndef HATCH_FIT_SPLIT_H
#define HATCH_FIT_SPLIT_H

#include <stdbool.h>

#include "base/arena.h"
#include "fit/cubic.h"

#define HATCH_FIT_PARTS_MAX 32u

/* A part of a stroke. */
struct hatch_stroke_part {
    uint32_t end; /* one past its last fragment */
    bool goes_on; /* the next part is the other half of a whole */
};

/* Returns the share of a stroke's weight that lies farther than reach_px from the curve of a cubic, 0 .. 1. */
double hatch_cubic_missed(const struct hatch_cubic *cubic, const struct hatch_fragment *fragments, size_t count,
                          double reach_px);

/* Divides the fragments of a stroke into parts that cubics follow: those that touch each other, each halved until
 * nearly all of its weight is within reach, up to three times. A part that a curve follows in another direction than
 * that of its parameters gets parameters in that direction. The result does not depend on the order of the
 * fragments, which are reordered on failure, too.
 *   fragments  in, out: count of them; reordered, so that each part is contiguous; their parameters may change
 *   reach_px   greatest distance of fragments from the curve of their part
 *   parts      out: part_count of them, 1 .. HATCH_FIT_PARTS_MAX
 * HATCH_LIMIT when memory does not suffice. */
enum hatch_status hatch_fragments_split(struct hatch_fragment *fragments, uint32_t count, double reach_px,
                                        struct hatch_arena *scratch,
                                        struct hatch_stroke_part parts[HATCH_FIT_PARTS_MAX], uint32_t *part_count,
                                        struct hatch_err *err) HATCH_MUST_USE;

#endif
