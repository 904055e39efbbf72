/* Feature lines of a posed scene (silhouettes, creases and boundaries), from meshes to segments in the picture. The
 * caller tests the visibility of the samples, and draws the segments. */
#ifndef HATCH_LINE_LINES_H
#define HATCH_LINE_LINES_H

#include "line/brush/brush.h"
#include "line/surface/surface.h"

struct hatch_line_style {
    uint32_t kinds;    /* bits of enum hatch_line_kind */
    double width_px;   /* over 0 */
    double crease_rad; /* least angle between the faces at a crease, 0 .. π */
    struct hatch_line_brush brush;
};

/* The edges of a scene, for all views and poses. */
struct hatch_lines {
    struct hatch_line_style style;
    struct hatch_unit_scene *scene;
    struct hatch_arena *scratch;
    uint32_t surface_count;
    struct hatch_line_surface *surfaces; /* in the order of the scene's items */
};

/* The lines of a frame. All samples are in one array, so that a GPU can test them in one pass. */
struct hatch_line_frame {
    size_t sample_count;
    struct hatch_line_sample *samples; /* where visibility is to be tested */
    struct hatch_line_part *parts;     /* internal */
};

/* The features or the silhouettes of a surface, as chains in the unit scene. */
struct hatch_line_curves {
    struct hatch_line_trace trace;
    struct hatch_line_chains chains;
    bool silhouettes; /* false: creases and boundaries */
    bool deformed;    /* creases and boundaries may be others at each pose */
};

/* Finds the edges of a scene's surfaces, for all views and poses. Creases and boundaries of deformed surfaces are found
 * anew at each pose. Items with cut_out set have no lines.
 *   scene, scratch  kept by reference
 *   arena           for the edges */
enum hatch_status hatch_lines_make(struct hatch_unit_scene *scene, const struct hatch_line_style *style,
                                   struct hatch_arena *arena, struct hatch_arena *scratch, struct hatch_lines *lines,
                                   struct hatch_err *err) HATCH_MUST_USE;

/* Returns how far outside a tile lines affect those inside, in pixels: half their width, and as far as it takes to tell
 * whether a part is too short to be drawn, which depends on their width, too. At least HATCH_LINES_REACH_PX. */
uint32_t hatch_lines_reach_px(const struct hatch_line_style *style);

/* Traces the lines of the posed scene in a tile of a picture.
 *   arena  for the frame; not the scratch arena of hatch_lines_make */
enum hatch_status hatch_lines_trace(const struct hatch_lines *lines, const struct hatch_view *view,
                                    const struct hatch_tile *tile, struct hatch_arena *arena,
                                    struct hatch_line_frame *frame, struct hatch_err *err) HATCH_MUST_USE;

/* Traces the lines of the posed scene without projecting them.
 *   height_px  of the picture
 *   curves     out: in arena, *count of them: at most two per surface, the features and then the silhouettes */
enum hatch_status hatch_lines_pose(const struct hatch_lines *lines, const struct hatch_view *view, double height_px,
                                   struct hatch_arena *arena, struct hatch_line_curves **curves, uint32_t *count,
                                   struct hatch_err *err) HATCH_MUST_USE;

/* Joins the visible pieces of a frame's lines into segments. Closes short gaps and drops short isolated parts.
 *   seen      per sample: bits of enum hatch_line_seen
 *   segments  out: in arena, *count of them */
enum hatch_status hatch_lines_join(const struct hatch_lines *lines, const struct hatch_line_frame *frame,
                                   const uint8_t *seen, struct hatch_arena *arena, struct hatch_line_segment **segments,
                                   size_t *count, struct hatch_err *err) HATCH_MUST_USE;

#endif
