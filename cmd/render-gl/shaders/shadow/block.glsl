// What each light's maps show; the same as struct shadow_block of shadow.h.
layout(std140, binding = BLOCK_SHADOWS) uniform Shadows {
    mat4 map_from_unit[24];
    vec4 maps[64];    // first layer, below 0: none; layers; maps a unit at distance 1, in x and in y
    vec4 shadow_edge; // half its width; 1/pixels of a map
};
