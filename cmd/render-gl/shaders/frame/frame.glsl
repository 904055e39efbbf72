// What a frame is made with; the same as struct frame_block of frame.h.
struct Light {
    vec4 position;  // xyz; w: 0 directional, 1 point or spot
    vec4 direction; // xyz: to the light, or along the spot; w: strength
    vec4 cone;      // scale and offset of the spot's edge, 1/range^2, smallest distance^2
};

layout(std140, binding = BLOCK_FRAME) uniform Frame {
    mat4 clip_from_unit;
    vec4 eye;   // w: 0 when xyz is the direction to an orthographic camera
    vec4 paper, ink, light_ink;
    vec4 curve; // darkness of full light, of none, gamma, samples a pixel
    vec4 shade; // 0, ambient, strength of the highlight, its exponent
    vec4 viewport; // half the tile's width and height in pixels
    vec4 hatch; // cosine and sine of the strokes' turn, over their size
    ivec4 counts; // lights, columns, ink mode, whether the last column is all ink
    vec4 ramp_low[2], ramp_scale[2];
    vec4 targets[64];
    Light lights[64];
};

// One draw: an item seen from one side.
layout(location = UNIFORM_UNIT_FROM_MESH) uniform mat4 unit_from_mesh;
layout(location = UNIFORM_NORMAL_FROM_MESH) uniform mat3 normal_from_mesh;
layout(location = UNIFORM_SIDE) uniform float side;
layout(location = UNIFORM_PASS) uniform int pass;
layout(location = UNIFORM_BASE) uniform vec4 base; // lightness of the material, its texture's level, alpha cutoff
layout(binding = UNIT_BASE) uniform sampler2D base_texture;
