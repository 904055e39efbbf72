/* Chains projected into a picture, clipped, and cut into pieces so short that each is treated as wholly visible or
 * wholly hidden. */
#ifndef HATCH_LINE_STRIP_H
#define HATCH_LINE_STRIP_H

#include "line/trace.h"

/* Narrow lines further outside a tile do not affect those inside; of wide ones hatch_lines_reach_px tells (lines.h). */
#define HATCH_LINES_REACH_PX 40u

/* A straight piece of a line, in pixels from the tile's lower left corner. */
struct hatch_line_piece {
    float a[2], b[2];
    float depth[2];   /* at both ends: a surface with a larger value in the depth buffer hides it */
    uint32_t segment; /* of the trace; the pieces of a segment lie on a straight line */
    float place[3];   /* of its start, in the unit scene */
    float pixel;      /* size of a pixel there, in the unit scene */
};

/* How a brush draws a piece, at both of its ends. */
struct hatch_line_touch {
    float width[2];     /* as a share of the lines' width */
    float ink[2];       /* 0 .. 1 */
    float beside[2][2]; /* by how much it is moved, in pixels */
};

/* Successive visible pieces on a straight line, to be drawn. */
struct hatch_line_segment {
    float a[2], b[2], depth[2]; /* as in struct hatch_line_piece */
    float in_halo;              /* 1: a halo may cover a part of it; else 0 */
    float width[2], ink[2];     /* as in struct hatch_line_touch; 1 without a brush */
};

/* Where the visibility of a piece is tested. */
struct hatch_line_sample {
    float at[2];    /* pixels from the tile's lower left corner */
    float limit;    /* the piece is hidden where the depth buffer has a larger value */
    float turn_rad; /* direction of the line in the picture */
    float away[2];  /* unit vector across a silhouette, away from its surface; 0 0 for other lines */
    float behind;   /* across a silhouette, the surface beyond it has a smaller value in the depth buffer */
    float depth;    /* of the silhouette in the depth buffer */
};

/* Visibility of a piece, as bits. */
enum hatch_line_seen {
    HATCH_LINE_VISIBLE = 1, /* no surface hides it; a silhouette: and the surface beyond it lies deeper */
    HATCH_LINE_TOUCHED = 2, /* a halo covers a part of the sample */
    HATCH_LINE_COVERED = 4, /* a halo covers more than half of the sample */
    HATCH_LINE_FLAT = 8     /* no surface hides it, but the surface beyond the silhouette does not lie deeper */
};

/* The other bits, shifted, are the weight of a piece under a brush, 0 .. 15: its width is HATCH_LINE_WEIGHT_LEAST plus
 * as many times HATCH_LINE_WEIGHT_STEP. */
#define HATCH_LINE_WEIGHT_SHIFT 4
#define HATCH_LINE_WEIGHT_LEAST 0.25f
#define HATCH_LINE_WEIGHT_STEP 0.13333333f

/* A strip of connected pieces. */
struct hatch_line_strip {
    uint32_t first, count; /* range of pieces */
    bool closed;
    bool joined[2]; /* whether the line may continue before, after the strip */
};

struct hatch_line_strips {
    uint32_t strip_count, piece_count;
    struct hatch_line_strip *strips;
    struct hatch_line_piece *pieces;
    struct hatch_line_sample *samples; /* one per piece */
};

/* The picture to cut lines for. */
struct hatch_line_picture {
    const struct hatch_view *view;
    const struct hatch_tile *tile;
    double margin_px; /* lines are kept up to this distance outside the tile */
};

/* Clips chains at the near and far planes, where floats are too inaccurate, and margin_px outside the tile, and cuts
 * them into pieces. The places of the cuts do not depend on the tile. Chains that reach less than a tenth of a pixel in
 * the picture are left out.
 *   strips  out: in arena */
enum hatch_status hatch_line_strips_make(const struct hatch_line_trace *trace, const struct hatch_line_chains *chains,
                                         const struct hatch_line_picture *picture, struct hatch_arena *arena,
                                         struct hatch_line_strips *strips, struct hatch_err *err) HATCH_MUST_USE;

/* Pieces that are not drawn themselves, but replaced by a straight segment over all of them. */
#define HATCH_LINE_BRIDGED 2u

/* Cleans up the visibility along each strip: hidden gaps between visible parts are closed if they are short, if their
 * ends are close together in the picture, or if nothing hides them and they are not long; then short isolated visible
 * parts (also between haloes) are hidden; then visible parts are trimmed where a hidden part follows. Of the pieces
 * that haloes cover, those next to an uncovered one stay visible, so that the line reaches the halo.
 *   gap_px    gaps shorter than this are closed
 *   speck_px  visible parts shorter than this are hidden, unless the line may continue beyond the strip
 *   trim_px   length that visible parts lose at a hidden one
 *   seen      per piece: bits of enum hatch_line_seen
 *   visible   out: per piece, 0, 1 or HATCH_LINE_BRIDGED */
void hatch_line_strips_smooth(const struct hatch_line_strips *strips, double gap_px, double speck_px, double trim_px,
                              const uint8_t *seen, uint8_t *visible);

/* Hides short visible parts that run along longer ones, as where a surface folds over itself by a fraction of a pixel.
 *   visible  in and out: per piece, from hatch_line_strips_smooth
 *   arena    for temporary data */
enum hatch_status hatch_line_strips_drop_doubles(const struct hatch_line_strips *strips, uint8_t *visible,
                                                 struct hatch_arena *arena, struct hatch_err *err) HATCH_MUST_USE;

/* Joins visible pieces into segments, in the order of the line, and returns the number of segments. Pieces that a halo
 * may cover (touched ones and their neighbours) are put into segments of their own.
 *   visible   per piece, from hatch_line_strips_smooth
 *   seen      as for hatch_line_strips_smooth
 *   touches   per piece: how a brush draws it; NULL: without a brush
 *   segments  out: room for piece_count */
uint32_t hatch_line_strips_visible(const struct hatch_line_strips *strips, const uint8_t *visible, const uint8_t *seen,
                                   const struct hatch_line_touch *touches, struct hatch_line_segment *segments);

#endif
