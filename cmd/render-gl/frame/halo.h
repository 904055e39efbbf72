/* Haloes (Appel, Rohlf & Stein 1979): strips of bare paper along the edges of surfaces that pass in front of farther
 * ones. Edges are found in the depth buffer, where depth jumps; surfaces behind an edge are covered within the halo's
 * width (shaders/halo/halo.glsl). */
#ifndef RENDER_FRAME_HALO_H
#define RENDER_FRAME_HALO_H

#include "render-gl/frame/canvas.h"
#include "render-gl/frame/targets.h"
#include "view/view.h"

#define HALO_REACH_MAX_PX 64.0

/* Zeroed before the first call. */
struct halo {
    const struct gpu_program *find_cells, *find_blocks, *cover; /* NULL until halo_prepare */
    GLuint buffer;                                              /* uniform block */
    GLuint framebuffer;   /* the canvas's colour alone, since shaders read its depth */
    uint32_t block_count; /* blocks of the canvas, from halo_find */
};

/* Compiles the programs. Repeated calls return at once. */
enum hatch_status halo_prepare(struct halo *halo, struct gpu_programs *programs, struct hatch_err *err) HATCH_MUST_USE;

/* Finds the edges in the canvas's depth, and binds them for shaders until the frame ends.
 *   reach_px  width of haloes from an edge, 0.5 .. HALO_REACH_MAX_PX
 *   targets   supplies the transient targets that hold the edges
 * HATCH_LIMIT when the GPU has no memory for them. */
enum hatch_status halo_find(struct halo *halo, const struct canvas *canvas, const struct hatch_view *view,
                            double reach_px, struct frame_targets *targets, struct hatch_err *err) HATCH_MUST_USE;

/* Draws the haloes that halo_find has found over the canvas's samples.
 *   rgb  their colour, linear light */
void halo_draw(const struct halo *halo, const struct canvas *canvas, const float rgb[3]);

/* Releases buffer and framebuffer; leaves *halo zeroed. */
void halo_free(struct halo *halo);

#endif
