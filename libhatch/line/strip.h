/* Chains of segments as they lie in a picture: cut to what can be seen of them there, into pieces
 * short enough for each to be hidden or not. */
#ifndef HATCH_LINE_STRIP_H
#define HATCH_LINE_STRIP_H

#include "line/trace.h"

#define HATCH_LINES_REACH_PX 40u /* what lies further outside a tile changes no line within it */

/* In pixels from the tile's lower left corner. */
struct hatch_line_piece {
    float a[2], b[2];
    float depth[2];   /* at both ends: what the depth buffer holds for a surface that hides it */
    uint32_t segment; /* pieces of one segment with one number lie on a straight line */
};

/* A straight line of pieces, as it is drawn. */
struct hatch_line_segment {
    float a[2], b[2], depth[2];
    float in_halo; /* 1: a halo may lie over some of it; 0 */
};

/* Where a piece's visibility is tested, and the depth that hides it: what the depth buffer holds
 * there is nearer than limit. turn_rad: the direction of its line. */
struct hatch_line_sample {
    float at[2], limit, turn_rad;
};

/* What is known of a piece: sums of these. */
enum hatch_line_seen {
    HATCH_LINE_VISIBLE = 1, /* no surface hides it */
    HATCH_LINE_TOUCHED = 2, /* a halo lies over its middle */
    HATCH_LINE_COVERED = 4  /* over more than half of that */
};

/* Pieces that hang together. */
struct hatch_line_strip {
    uint32_t first, count;
    bool closed;
    bool joined[2]; /* the line may go on where the strip begins and ends */
};

struct hatch_line_strips {
    uint32_t strip_count, piece_count;
    struct hatch_line_strip *strips;
    struct hatch_line_piece *pieces;
    struct hatch_line_sample *samples; /* one per piece */
};

/* The picture that lines are cut for. */
struct hatch_line_picture {
    const struct hatch_view *view;
    const struct hatch_tile *tile;
    double margin_px; /* distance outside the tile up to which lines are kept */
};

/* Cuts chains at the near plane and margin_px outside the tile. The cuts between pieces do not depend on the tile.
 *   strips  out: in arena */
enum hatch_status hatch_line_strips_make(const struct hatch_line_trace *trace, const struct hatch_line_chains *chains,
                                         const struct hatch_line_picture *picture, struct hatch_arena *arena,
                                         struct hatch_line_strips *strips, struct hatch_err *err) HATCH_MUST_USE;

/* Makes visibility even along each strip. A hidden gap shorter than gap_px between visible parts is closed; then a
 * visible crumb shorter than crumb_px, which nothing joins, is hidden, and so is one that haloes leave; then the
 * ends of visible parts at hidden ones lose the pieces that begin within trim_px. Of what haloes cover pieces beside
 * the rest stay, to end where the halo begins. seen: per piece, sums of enum hatch_line_seen; visible: the same,
 * becomes 0 or 1. */
void hatch_line_strips_smooth(const struct hatch_line_strips *strips, double gap_px, double crumb_px, double trim_px,
                              const uint8_t *seen, uint8_t *visible);

/* Writes the visible parts as segments, and returns how many there are: at most piece_count. Pieces of
 * one straight segment become one, those that haloes touch and those beside them apart from the rest. seen: as
 * above. */
uint32_t hatch_line_strips_visible(const struct hatch_line_strips *strips, const uint8_t *visible, const uint8_t *seen,
                                   struct hatch_line_segment *segments);

#endif
