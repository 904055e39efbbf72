/* Subdivides triangles, more finely towards the eye, in double-double arithmetic. Every visible piece is small compared
 * with its distance, so that floats resolve it however near the eye is. New corners are edge midpoints, computed by
 * sums and halvings only, so two faces get bit-identical corners on a shared edge. */
#ifndef HATCH_NEAR_SUBDIVIDE_H
#define HATCH_NEAR_SUBDIVIDE_H

#include <stdbool.h>
#include <stdint.h>

#include "base/status.h"
#include "math/pair.h"

struct hatch_piece_corner {
    struct hatch_pair at[3];    /* position in camera coordinates: right, up, back; the eye is at 0 0 0 */
    struct hatch_pair place[3]; /* in the texture: u, v and 0, or a place in a solid texture */
    double weight[3];           /* barycentric coordinates in the face; their sum is 1 */
};

/* The visible region in camera coordinates. */
struct hatch_piece_view {
    bool orthographic;
    double low[2], high[2]; /* sides of the picture: x and y at distance 1 (orthographic: at any distance) */
    double near;            /* over 0; distance of the near plane (perspective) */
    double ratio; /* over 0: edges longer than ratio times their distance from the eye are cut (orthographic: distance
                     from the view axis, at least half the picture's size) */
};

/* A callback that receives a piece; its corners are valid until it returns. A failure ends the cutting. */
typedef enum hatch_status (*hatch_piece_visit)(void *context, const struct hatch_piece_corner *const corner[3],
                                               struct hatch_err *err);

/* Cuts a face and calls visit for each piece that may be visible. Pieces keep the face's winding. Edges are cut at
 * their midpoints, and whether an edge is cut depends on its own position only. So pieces of faces with a common edge
 * meet corner to corner where both are visible. There are some tens of pieces for each doubling of the distance from
 * the eye. Fails only as visit does. */
enum hatch_status hatch_pieces_cut(const struct hatch_piece_corner face[3], const struct hatch_piece_view *view,
                                   hatch_piece_visit visit, void *context, struct hatch_err *err) HATCH_MUST_USE;

/* Returns the distance of a triangle from the origin. */
double hatch_piece_distance(const double corner[3][3]);

/* Converts a number to fixed point with 64 fractional bits; returns the remainder, 0 .. 2^-64.
 *   a      of an absolute value below 2^62
 *   words  out: 128 bits in two's complement, words[3] the most significant */
struct hatch_pair hatch_piece_fixed(struct hatch_pair a, uint32_t words[4]);

#endif
