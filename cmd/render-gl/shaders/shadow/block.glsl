// The shadow maps of all lights: struct shadow_block of frame/shadow.h, where the members are explained.
layout(std140, binding = BLOCK_SHADOWS) uniform Shadows {
    mat4 map_from_unit[24];
    vec4 maps[64];    // first layer (negative: none); number of layers; length 1 at distance 1 as a share of the map
    vec4 shadow_edge; // half the width of soft edges; 1 / side of a map in texels
};
