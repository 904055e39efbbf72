/* Haloes (Appel, Rohlf & Stein 1979): paper beside the edge of a surface that passes before a farther one. Found in
 * the depth picture: edges are where depth jumps, and what lies behind one of them within the halo's width is
 * covered. shaders/halo.glsl says how far. */
#ifndef RENDER_HALO_H
#define RENDER_HALO_H

#include "render-gl/target.h"
#include "scene/view.h"

#define HALO_BLOCK 8u /* cells along a side of a block */
#define HALO_PROGRAMS 3
#define HALO_BINDING 3u
#define HALO_UNIT_BLOCKS 8u
#define HALO_UNIT_DEPTHS 14u
#define HALO_UNIT_CELLS 15u
#define HALO_REACH_MAX_PX 64.0

struct halo {
    GLuint programs[HALO_PROGRAMS];
    GLuint cells, blocks, buffer; /* of each cell its nearest edge: place and depth; of each block its nearest depth */
    GLuint framebuffers[HALO_PROGRAMS];
    uint32_t cell, width, height; /* samples along a cell's side; cells */
};

/* Compiles. Again compiles anew; the old programs stay when the new ones have an error. */
enum hatch_status halo_compile(const struct shader_source *shaders, struct halo *halo,
                               struct hatch_err *err) HATCH_MUST_USE;

/* Finds the edges in the target's depth and binds them for what asks about haloes of reach_px, 0.5 to
 * HALO_REACH_MAX_PX. HATCH_LIMIT when the GPU has no memory for it. */
enum hatch_status halo_find(struct halo *halo, const struct target *target, const struct hatch_view *view,
                            double reach_px, struct hatch_err *err) HATCH_MUST_USE;

/* Puts a colour, in linear light, over the target's samples where haloes are. After halo_find. */
void halo_draw(const struct halo *halo, const struct target *target, const float rgb[3]);

/* A zeroed struct is allowed. */
void halo_free(struct halo *halo);

#endif
