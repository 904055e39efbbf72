/* Shadow maps (Williams 1978): how far each light sees, in layers of one depth texture. shaders/shadow.glsl reads
 * them and says what share of a light reaches a point, with soft edges (Reeves et al. 1987). */
#ifndef RENDER_SHADOW_H
#define RENDER_SHADOW_H

#include "render-gl/frame.h"
#include "render-gl/scene.h"
#include "render-gl/shader.h"

#define SHADOW_LAYERS 24u     /* a sun and a spot take one, a lamp that shines all around takes six */
#define SHADOW_UNIT 13u       /* filtered */
#define SHADOW_UNIT_TEXELS 2u /* texel by texel */
#define SHADOW_BINDING 2u

/* std140; the same as in shaders/shadow_block.glsl */
struct shadow_block {
    float map_from_unit[SHADOW_LAYERS][16]; /* 0 .. 1 in each coordinate; column-major */
    float maps[LIGHTS_MAX][4]; /* first layer, below 0: none; layers; maps a unit at distance 1, in x and in y */
    float edge[4];             /* half the edges' width in the unit scene; 1/pixels of a map */
};

struct shadow {
    GLuint maps, framebuffer, buffer;
    GLuint samplers[2];       /* for these */
    GLuint programs[2];       /* draw whole faces; those with holes */
    uint32_t size_px, layers; /* of maps */
    uint32_t pose_number;     /* of the scene that they show */
    bool drawn;               /* they hold what they are to show */
    struct shadow_block block;
};

/* Compiles. Again compiles anew; the old programs stay when the new ones have an error. */
enum hatch_status shadow_compile(const struct shader_source *shaders, struct shadow *shadow,
                                 struct hatch_err *err) HATCH_MUST_USE;

/* Chooses layers for a frame's lights, in their order while there are some, and makes room for them. What is drawn
 * stays drawn while lights and pose do. width: of shadows' edges, in the unit scene. HATCH_LIMIT when the GPU has no
 * memory for them. */
enum hatch_status shadow_begin(const struct frame_block *frame, const struct gpu_scene *scene, double width,
                               struct shadow *shadow, struct hatch_err *err) HATCH_MUST_USE;

/* Binds a layer to be drawn into, with the state for it. Whoever draws next binds another framebuffer. */
void shadow_begin_layer(const struct shadow *shadow, uint32_t layer);

/* Binds what shaders read. */
void shadow_use(const struct shadow *shadow);

/* A zeroed struct is allowed. */
void shadow_free(struct shadow *shadow);

#endif
