/* Haloes (Appel, Rohlf & Stein 1979): strips of bare paper along the edges of surfaces that pass in front of farther
 * ones. An edge is a jump of depth in the depth buffer. Paper covers the surfaces behind it up to the halo's width
 * (shaders/halo/halo.glsl). */
#ifndef RENDER_FRAME_HALO_H
#define RENDER_FRAME_HALO_H

#include "render-gl/frame/canvas.h"
#include "render-gl/frame/targets.h"
#include "view/view.h"

/* Zeroed before the first call. */
struct halo {
    GLuint buffer;      /* uniform block Halo */
    GLuint framebuffer; /* has the canvas's colour only, because shaders read the canvas's depth at the same time */
};

/* Finds the edges in the canvas's depth, and draws haloes beside them over the canvas's samples. The edges stay bound
 * for shaders until the frame ends.
 *   reach_px  width of haloes from an edge, 0.5 .. 64
 *   rgb       colour of haloes, linear light
 *   targets   supplies the transient targets that hold the edges
 * HATCH_LIMIT when the GPU has no memory for the targets. */
enum hatch_status halo_draw(struct halo *halo, const struct canvas *canvas, const struct hatch_view *view,
                            double reach_px, const float rgb[3], struct gpu_programs *programs,
                            struct frame_targets *targets, struct hatch_err *err) HATCH_MUST_USE;

/* Releases buffer and framebuffer; leaves *halo zeroed. */
void halo_free(struct halo *halo);

#endif
