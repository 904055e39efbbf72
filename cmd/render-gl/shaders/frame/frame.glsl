// The uniforms of a frame and of a draw call. Block Frame is struct frame_block of frame/block.h; its members are
// explained there.
struct Light {
    vec4 position;  // xyz; w: 0 directional, 1 point or spot
    vec4 direction; // xyz: direction to a directional light, or axis of a spot; w: strength
    vec4 cone;      // scale and offset of a spot's falloff; 1 / range^2; square of the smallest distance
};

layout(std140, binding = BLOCK_FRAME) uniform Frame {
    mat4 clip_from_unit;
    vec4 eye;   // w = 1: position of the camera; w = 0 (orthographic): direction towards the camera
    vec4 paper, ink, light_ink;
    vec4 curve; // least and greatest amount of ink; gamma; samples per pixel
    vec4 shade; // darkest tone of a volume; ambient light; strength and exponent of highlights
    vec4 viewport; // half the tile's width and height, and its lower left corner, in pixels
    vec4 hatch; // cosine and sine of the pattern's rotation, both divided by its scale
    ivec4 counts; // number of lights, of columns; enum frame_ink_mode; unused
    vec4 ramp_low[2], ramp_scale[2];
    vec4 targets[64];
    Light lights[64];
};

// Uniforms of a draw call, which draws one side of an item. side: 1: front, -1: back.
layout(location = UNIFORM_UNIT_FROM_MESH) uniform mat4 unit_from_mesh;
layout(location = UNIFORM_NORMAL_FROM_MESH) uniform mat3 normal_from_mesh;
layout(location = UNIFORM_SIDE) uniform float side;
layout(location = UNIFORM_PASS) uniform int pass;
layout(location = UNIFORM_ITEM) uniform uint item; // index of the item
layout(location = UNIFORM_MATERIAL) uniform uint material; // index of its material
layout(location = UNIFORM_REST) uniform vec4 rest; // offset; units per length of the mesh: struct hatch_item_rest
layout(location = UNIFORM_REST_AXES) uniform mat3 rest_axes; // from a mesh to the axes of solid textures
layout(location = UNIFORM_REST_LOG) uniform float rest_log; // binary logarithm of a unit in the unit scene
layout(location = UNIFORM_BASE) uniform vec4 base; // material's lightness; mip level for vertices; alpha cutoff
layout(binding = UNIT_BASE) uniform sampler2D base_texture;
