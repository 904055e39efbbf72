/* Shadow maps (Williams 1978): depth as each light sees it, in layers of one texture. shaders/shadow/shadow.glsl
 * computes from them the share of a light that reaches a point, with soft edges (Reeves et al. 1987). */
#ifndef RENDER_FRAME_SHADOW_H
#define RENDER_FRAME_SHADOW_H

#include "render-gl/frame/block.h"
#include "render-gl/frame/pass.h"
#include "render-gl/scene/scene.h"

#define SHADOW_LAYERS_MAX 24u /* directional lights and spots take one, lamps that shine all around take six */

/* std140; the same as in shaders/shadow/block.glsl */
struct shadow_block {
    float map_from_unit[SHADOW_LAYERS_MAX][16]; /* to 0 .. 1 in each coordinate; column-major */
    float maps[HATCH_LIGHTS_MAX][4]; /* first layer, below 0: none; layers; maps a unit at distance 1, in x and in y */
    float edge[4];                   /* half the edges' width in the unit scene; 1/pixels of a map */
};

/* Zeroed to begin with. */
struct shadow {
    const struct gpu_program *draw[2]; /* items whole, items with holes; NULL until shadow_prepare */
    GLuint maps, framebuffer, buffer;
    GLuint samplers[2];       /* filtered; texel by texel */
    uint32_t size_px, layers; /* of maps */
    uint32_t pose_number;     /* of the scene that they show */
    bool drawn;               /* the maps are up to date */
    struct shadow_block block;
};

/* Compiles. Calling it again is cheap. */
enum hatch_status shadow_prepare(struct shadow *shadow, struct gpu_programs *programs,
                                 struct hatch_err *err) HATCH_MUST_USE;

/* Chooses layers for a frame's lights, in their order while layers are left, and makes their maps, which stay drawn
 * while lights and pose stay. Updates the uniform block.
 *   frame  its lights are set
 *   width  of shadows' edges, in the unit scene
 * HATCH_LIMIT when the GPU has no memory for the maps. */
enum hatch_status shadow_begin(struct shadow *shadow, const struct frame_block *frame, const struct scene *scene,
                               double width, struct hatch_err *err) HATCH_MUST_USE;

/* Begins drawing a layer, with the programs of `draw`. */
void shadow_begin_layer(const struct shadow *shadow, uint32_t layer);

/* Binds the maps for shaders. */
void shadow_use(const struct shadow *shadow);

void shadow_free(struct shadow *shadow);

#endif
