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
    bool haloes;              /* lines end at haloes, which halo_draw has found in the same frame */
    struct hatch_arena frame; /* holds the lines of one frame */
    const struct gpu_program *test, *stroke, *over; /* visibility of samples, coverage of segments, colour */
    GLuint array, segments;                         /* vertex array and buffer of struct hatch_line_segment */
    GLuint samples;                                 /* texture with one texel per sample */
    struct gpu_target results;                      /* enum hatch_line_seen per sample, joined */
};

struct line_overlay_style {
    struct hatch_line_style lines;
    float color[3]; /* linear light */
    bool haloes;    /* lines end at haloes */
};

/* Finds the edges of the scene's meshes and compiles the programs.
 *   scene  kept by reference
 *   args   keep holds the edges, scratch is kept by reference, max_memory limits the lines of one frame */
enum hatch_status line_overlay_make(struct line_overlay *overlay, struct scene *scene,
                                    const struct line_overlay_style *style, struct gpu_programs *programs,
                                    struct cmd_args *args, struct hatch_err *err) HATCH_MUST_USE;

/* Draws the lines of the posed scene over the picture, after frame_end. Surfaces in the canvas's depth hide them.
 * HATCH_LIMIT when memory does not suffice. */
enum hatch_status line_overlay_draw(struct line_overlay *overlay, struct frame *frame,
                                    struct hatch_err *err) HATCH_MUST_USE;

/* Releases everything but the edges; leaves *overlay zeroed. */
void line_overlay_free(struct line_overlay *overlay);

#endif
