/* Feature lines of a posed scene: silhouettes, creases and boundaries, from meshes to segments in the picture. The
 * renderer tests which samples are hidden, and draws the segments. */
#ifndef HATCH_LINE_LINES_H
#define HATCH_LINE_LINES_H

#include "line/strip.h"
#include "scene/unit_scene.h"

struct hatch_line_style {
    uint32_t kinds;    /* enum hatch_line_kind, joined; HATCH_LINES_NONE: no lines */
    double width_px;   /* over 0 */
    double crease_rad; /* edges that turn by more are creases; 0 .. π */
};

struct hatch_lines {
    struct hatch_line_style style;
    struct hatch_unit_scene *scene;
    struct hatch_arena *scratch;
    struct hatch_line_mesh *meshes; /* of each of the scene's meshes two: about its origin, and for shaped items */
};

/* A frame's lines. All of them are tested together, so that a GPU is waited for only once. */
struct hatch_line_frame {
    size_t sample_count;
    struct hatch_line_sample *samples; /* where visibility is to be tested */
    struct hatch_line_part *parts;
};

/* Finds the edges of a scene's meshes, once for all views and poses.
 *   scene, scratch  kept by reference
 *   arena           keeps the edges */
enum hatch_status hatch_lines_make(struct hatch_unit_scene *scene, const struct hatch_line_style *style,
                                   struct hatch_arena *arena, struct hatch_arena *scratch, struct hatch_lines *lines,
                                   struct hatch_err *err) HATCH_MUST_USE;

/* Traces the lines of the posed scene in a tile of a picture. Items whose shape holes of a texture cut out have none.
 *   arena  keeps the frame; not the scratch arena of hatch_lines_make */
enum hatch_status hatch_lines_trace(const struct hatch_lines *lines, const struct hatch_view *view,
                                    const struct hatch_tile *tile, struct hatch_arena *arena,
                                    struct hatch_line_frame *frame, struct hatch_err *err) HATCH_MUST_USE;

/* Joins the visible pieces of a frame's lines to segments. Closes short gaps, drops short crumbs.
 *   seen      per sample, sums of enum hatch_line_seen
 *   segments  out: in arena, *count of them */
enum hatch_status hatch_lines_join(const struct hatch_lines *lines, const struct hatch_line_frame *frame,
                                   const uint8_t *seen, struct hatch_arena *arena, struct hatch_line_segment **segments,
                                   size_t *count, struct hatch_err *err) HATCH_MUST_USE;

#endif
