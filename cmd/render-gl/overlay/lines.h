/* Feature lines over the picture of any technique. libhatch traces them on the processor (line/lines.h); the GPU tests
 * samples of them for visibility and draws the visible parts. */
#ifndef RENDER_OVERLAY_LINES_H
#define RENDER_OVERLAY_LINES_H

#include "line/lines.h"
#include "render-gl/frame/frame.h"
#include "shared/cmd.h"

/* Zeroed: no lines. */
struct line_overlay {
    struct hatch_lines lines;
    float color[3];           /* linear light */
    bool haloes;              /* haloes cut off lines; halo_draw has found their edges in the same frame */
    struct hatch_arena frame; /* holds the lines of one frame */
    const struct gpu_program *test, *stroke, *over; /* test samples, draw segments' coverage, draw colour by coverage */
    GLuint array, segments;                         /* vertex array and buffer of struct hatch_line_segment */
    GLuint samples;                                 /* texture with two texels per sample; 0: none was tested yet */
    struct gpu_target results;                      /* per sample: bits of enum hatch_line_seen; zeroed like it */
};

struct line_overlay_style {
    struct hatch_line_style lines;
    float color[3]; /* linear light */
    bool haloes;    /* haloes cut off lines */
};

/* Finds the edges of the scene's meshes and compiles the programs.
 *   scene  kept by reference
 *   args   its arena keep holds the edges; its arena scratch is kept by reference; its max_memory limits the memory
 *          for the lines of one frame */
enum hatch_status line_overlay_make(struct line_overlay *overlay, struct scene *scene,
                                    const struct line_overlay_style *style, struct gpu_programs *programs,
                                    struct cmd_args *args, struct hatch_err *err) HATCH_MUST_USE;

/* Draws the lines of the posed scene over the picture, after frame_end. The depth of the canvas hides them.
 * HATCH_LIMIT when memory does not suffice. */
enum hatch_status line_overlay_draw(struct line_overlay *overlay, struct frame *frame,
                                    struct hatch_err *err) HATCH_MUST_USE;

/* Releases everything but the edges; leaves *overlay zeroed. */
void line_overlay_free(struct line_overlay *overlay);

#endif
