/* Direction marks over a frame's surfaces. */
#ifndef RENDER_OVERLAY_MARKS_H
#define RENDER_OVERLAY_MARKS_H

#include "line/marks.h"
#include "render-gl/frame/frame.h"

/* Zeroed: no marks. */
struct mark_overlay {
    struct hatch_marks marks;
    const struct gpu_program *program;
    GLuint array, buffer;
};

/* Spreads marks over the posed scene, and compiles.
 *   height_px  of the picture from the view: the distance between marks suits it
 *   arena      keeps the marks
 * HATCH_BAD_INPUT where no mesh has directions. */
enum hatch_status mark_overlay_make(struct mark_overlay *overlay, struct frame *frame, const struct hatch_view *view,
                                    double height_px, struct hatch_arena *arena, struct hatch_err *err) HATCH_MUST_USE;

/* Draws them at the scene's pose, before the surfaces in the frame's canvas. Between frame_begin and frame_end. */
void mark_overlay_draw(struct mark_overlay *overlay, struct frame *frame);

/* Leaves *overlay zeroed. */
void mark_overlay_free(struct mark_overlay *overlay);

#endif
