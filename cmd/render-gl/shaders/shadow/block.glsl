// The shadow maps of all lights: struct shadow_block of frame/shadow.h, where the members are explained.
layout(std140, binding = BLOCK_SHADOWS) uniform Shadows {
    mat4 map_from_unit[24];
    vec4 maps[64];    // first layer (negative: none); number of layers; shares of the map that a length of 1 covers
    vec4 shadow_edge; // half the width of soft edges; 1 / side of a map in texels
};
