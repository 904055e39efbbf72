// The uniforms of a frame and of a draw call. Block Frame is struct frame_block of frame/block.h, where its members are
// explained.
struct Light {
    vec4 position;  // xyz; w: 0 directional, 1 point or spot
    vec4 direction; // xyz: to the light; of a spot: its axis; w: strength
    vec4 cone;      // scale and offset of the spot's falloff; 1/range^2; smallest distance^2
};

layout(std140, binding = BLOCK_FRAME) uniform Frame {
    mat4 clip_from_unit;
    vec4 eye;   // position, w: 1; of an orthographic camera the direction to it, w: 0
    vec4 paper, ink, light_ink;
    vec4 curve; // tone of fully lit and of unlit surfaces; gamma; samples per pixel
    vec4 shade; // 0; ambient light; strength and exponent of highlights
    vec4 viewport; // half the tile's width and height in pixels
    vec4 hatch; // cosine and sine of the strokes' turn, divided by their scale
    ivec4 counts; // lights; columns; enum frame_ink_mode; 1: the darkest tone is all ink
    vec4 ramp_low[2], ramp_scale[2];
    vec4 targets[64];
    Light lights[64];
};

// A draw call: one side of an item. side: 1 front, -1 back.
layout(location = UNIFORM_UNIT_FROM_MESH) uniform mat4 unit_from_mesh;
layout(location = UNIFORM_NORMAL_FROM_MESH) uniform mat3 normal_from_mesh;
layout(location = UNIFORM_SIDE) uniform float side;
layout(location = UNIFORM_PASS) uniform int pass;
layout(location = UNIFORM_BASE) uniform vec4 base; // lightness of the material, mip level at vertices, alpha cutoff
layout(binding = UNIT_BASE) uniform sampler2D base_texture;
