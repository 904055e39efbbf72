/* Haloes (Appel, Rohlf & Stein 1979): paper beside the edge of a surface that passes before a farther one. Edges are
 * found in the depth picture, where depth jumps; surfaces behind an edge are covered within the halo's width
 * (shaders/halo/halo.glsl). */
#ifndef RENDER_FRAME_HALO_H
#define RENDER_FRAME_HALO_H

#include "render-gl/frame/canvas.h"
#include "render-gl/frame/targets.h"
#include "view/view.h"

#define HALO_REACH_MAX_PX 64.0

/* Zeroed to begin with. */
struct halo {
    const struct gpu_program *find_cells, *find_blocks, *cover; /* NULL until halo_prepare */
    GLuint buffer;
    GLuint framebuffer; /* the canvas without its depth, which shaders read */
    uint32_t block_count;
};

/* Compiles. Calling it again is cheap. */
enum hatch_status halo_prepare(struct halo *halo, struct gpu_programs *programs, struct hatch_err *err) HATCH_MUST_USE;

/* Finds the edges in the canvas's depth, and binds them for shaders that look for haloes until the frame ends.
 *   targets   give the edges a place
 *   reach_px  width of haloes, 0.5 to HALO_REACH_MAX_PX
 * HATCH_LIMIT when the GPU has no memory for it. */
enum hatch_status halo_find(struct halo *halo, const struct canvas *canvas, const struct hatch_view *view,
                            double reach_px, struct frame_targets *targets, struct hatch_err *err) HATCH_MUST_USE;

/* Draws a colour, in linear light, over the canvas's samples where haloes are. After halo_find. */
void halo_draw(const struct halo *halo, const struct canvas *canvas, const float rgb[3]);

void halo_free(struct halo *halo);

#endif
