/* Direction marks: short lines over the surfaces that show the direction field. */
#ifndef RENDER_OVERLAY_MARKS_H
#define RENDER_OVERLAY_MARKS_H

#include "line/marks.h"
#include "render-gl/frame/frame.h"

/* Zeroed: no marks. */
struct mark_overlay {
    struct hatch_marks marks;
    const struct gpu_program *program;
    GLuint array, buffer; /* vertex array and buffer of struct hatch_mark_line */
};

/* Spreads marks over the posed scene and compiles the program.
 *   view       view of the first picture; together with height_px it determines the distance between marks
 *   height_px  height of the picture
 *   arena      holds the marks
 * HATCH_BAD_INPUT if no mesh has directions. */
enum hatch_status mark_overlay_make(struct mark_overlay *overlay, struct frame *frame, const struct hatch_view *view,
                                    double height_px, struct hatch_arena *arena, struct hatch_err *err) HATCH_MUST_USE;

/* Draws the marks at the scene's current pose, slightly in front of the surfaces. Must be called between frame_begin
 * and frame_end. */
void mark_overlay_draw(struct mark_overlay *overlay, struct frame *frame);

/* Releases array and buffer; leaves *overlay zeroed. */
void mark_overlay_free(struct mark_overlay *overlay);

#endif
