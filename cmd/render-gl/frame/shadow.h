/* Shadow maps (Williams 1978): depth as seen from each light, in the layers of one texture. From these maps,
 * shaders/shadow/shadow.glsl computes the share of a light that reaches a point, with soft edges (Reeves et al. 1987).
 */
#ifndef RENDER_FRAME_SHADOW_H
#define RENDER_FRAME_SHADOW_H

#include "render-gl/frame/block.h"
#include "render-gl/gpu/program.h"
#include "render-gl/scene/scene.h"

#define SHADOW_LAYERS_MAX 24u /* a directional light or narrow spot uses one layer, any other light six */

/* std140 layout; the same as block Shadows of shaders/shadow/block.glsl. */
struct shadow_block {
    float map_from_unit[SHADOW_LAYERS_MAX][16]; /* from the unit scene to a map, 0 .. 1 in x, y, depth; column-major */
    float maps[HATCH_LIGHTS_MAX][4]; /* per light: first layer (negative: none), number of layers, and the shares of
                                        the map's width and height that a length of 1 covers (lamps: at distance 1) */
    float edge[4];                   /* half the width of soft edges in the unit scene, 1 / side of a map in texels */
};

/* Zeroed before the first call. */
struct shadow {
    GLuint maps;                /* depth texture, 2D array */
    GLuint framebuffer, buffer; /* buffer: the uniform block */
    GLuint samplers[2];         /* both compare depth; the first filters, the second reads single texels */
    uint32_t size_px;           /* side of a map */
    uint32_t layers;            /* layers in use */
    uint32_t pose_number;       /* the scene's pose_number when the maps were drawn */
    bool drawn;                 /* the maps are up to date */
    struct shadow_block block;
};

/* Draws the shadow maps of a frame's lights, unless they are up to date. Layers are
 * given to lights in their order; lights for which none are left cast no shadows. Updates the uniform block and binds
 * the maps for shaders.
 *   frame  the block whose lights are used
 *   width  width of the soft edges of shadows, in the unit scene
 * HATCH_LIMIT when the GPU has no memory for the maps. */
enum hatch_status shadow_draw(struct shadow *shadow, const struct frame_block *frame, const struct scene *scene,
                              double width, struct gpu_programs *programs, struct hatch_err *err) HATCH_MUST_USE;

/* Releases everything; leaves *shadow zeroed. */
void shadow_free(struct shadow *shadow);

#endif
