/* Feature lines over the picture of any technique: the GPU tells which samples are hidden, and draws the rest. */
#ifndef RENDER_OVERLAY_LINES_H
#define RENDER_OVERLAY_LINES_H

#include "line/lines.h"
#include "render-gl/frame/frame.h"
#include "shared/cmd.h"

/* Zeroed: no lines. */
struct line_overlay {
    struct hatch_lines lines;
    float color[3];           /* linear light */
    bool haloes;              /* lines end at the haloes of nearer surfaces, which the frame has found before */
    struct hatch_arena frame; /* the lines of a frame */
    const struct gpu_program *test, *stroke, *over;
    GLuint array, segments;
    GLuint samples;            /* a texel per sample */
    struct gpu_target results; /* the same */
};

struct line_overlay_style {
    struct hatch_line_style lines;
    float color[3];
    bool haloes;
};

/* Finds the scene's edges, and compiles.
 *   scene       kept by reference
 *   max_memory  bytes for the lines of a frame
 *   args        keep holds the edges; scratch is kept by reference */
enum hatch_status line_overlay_make(struct line_overlay *overlay, struct scene *scene,
                                    const struct line_overlay_style *style, struct gpu_programs *programs,
                                    struct cmd_args *args, struct hatch_err *err) HATCH_MUST_USE;

/* Draws the lines of the posed scene over the picture of a frame that has ended. The canvas's depth holds the surfaces
 * that hide them. HATCH_LIMIT when memory does not suffice. */
enum hatch_status line_overlay_draw(struct line_overlay *overlay, struct frame *frame,
                                    struct hatch_err *err) HATCH_MUST_USE;

/* Leaves *overlay zeroed. */
void line_overlay_free(struct line_overlay *overlay);

#endif
