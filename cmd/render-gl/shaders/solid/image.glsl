// Inputs of the passes over the image: what the first pass has drawn, and the paper behind it.
#include "frame/frame.glsl"

layout(std140, binding = BLOCK_TECHNIQUE) uniform Solids {
    vec4 zoom; // y: pixels along a period of the paper; w: how far ink runs
    vec4 marks;
    vec4 edges;
    vec4 inks[16];
    vec4 offset, axes[3]; // of the first texture: its mean and deviation, as in solid/zoom.glsl
};

layout(binding = UNIT_SOLIDS) uniform sampler3D paper_octaves;
layout(binding = UNIT_TECHNIQUE + 1) uniform sampler2D wash;
layout(binding = UNIT_TECHNIQUE + 2) uniform sampler2D grain;
layout(binding = UNIT_TECHNIQUE + 3) uniform sampler2D blurred; // or the painted pixels
layout(binding = UNIT_TECHNIQUE + 4) uniform sampler2D depths;
layout(binding = UNIT_TONES) uniform sampler2D colors; // of inks

ivec2 inside(vec2 at)
{
    return clamp(ivec2(at), ivec2(0), textureSize(depths, 0) - 1);
}

// Returns the number of samples along a pixel's side.
int side_samples()
{
    return int(sqrt(curve.w) + 0.5);
}

// Returns the height of the paper behind the scene, -1 .. 1, around the mean of the texture, whatever its contrast. at:
// in pixels of the tile; level: of a mip chain
float paper_height(vec2 at, float depth, float level)
{
    vec3 place = vec3((at + viewport.zw) / zoom.y, depth);
    float away = textureLod(paper_octaves, place, level).r - axes[2].w;
    return clamp(away / (1.7 * axes[1].w), -1.0, 1.0);
}
