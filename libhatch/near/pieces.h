/* Triangles cut finer and finer towards the eye, in numbers of twice a double's digits: so floats can
 * carry what is left of a piece's coordinates, however near a picture is taken. Only sums and halves make
 * a corner from two others: what lies on an edge is one to the bit in both faces. */
#ifndef HATCH_NEAR_PIECES_H
#define HATCH_NEAR_PIECES_H

#include <stdbool.h>
#include <stdint.h>

#include "base/status.h"
#include "math/pair.h"

struct hatch_piece_corner {
    struct hatch_pair at[3]; /* in the camera's coordinates: right, up, back; the eye is at 0 0 0 */
    struct hatch_pair uv[2];
    double weight[3]; /* of the face's corners; their sum is 1 */
};

/* What a picture shows of the camera's coordinates. */
struct hatch_piece_view {
    bool orthographic;
    double low[2], high[2]; /* sides of the picture: x and y at distance 1 (orthographic: anywhere) */
    double near;            /* over 0; perspective: what is nearer along the view is not seen */
    double ratio;           /* over 0: an edge is cut that is longer than so many times its distance from
                               the eye (orthographic: from the axis, at least the picture's own size) */
};

/* Takes a piece, whose corners live until it returns; what it fails with ends the cutting. */
typedef enum hatch_status (*hatch_piece_visit)(void *context, const struct hatch_piece_corner *const corner[3],
                                               struct hatch_err *err);

/* Calls visit for each piece of a face that may be seen; pieces keep the face's winding. Edges are cut in
 * the middle, by their length and place alone: pieces of faces that share an edge meet corner to corner
 * where both are seen. The pieces are some tens for each doubling of the distance. Fails as visit does. */
enum hatch_status hatch_pieces_cut(const struct hatch_piece_corner face[3], const struct hatch_piece_view *view,
                                   hatch_piece_visit visit, void *context, struct hatch_err *err) HATCH_MUST_USE;

/* How far a point at 0 0 0 is from a triangle, in doubles. */
double hatch_piece_distance(const double corner[3][3]);

/* a as a whole number of 2^-64, 128 bits in two's complement, words[3] the highest; returns what is left, 0 .. 2^-64.
 * a: less than 2^62 either way. */
struct hatch_pair hatch_piece_fixed(struct hatch_pair a, uint32_t words[4]);

#endif
