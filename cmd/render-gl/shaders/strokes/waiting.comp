// Lists the fragments whose stroke shares a slot with others.
#include "strokes/fragments.glsl"
#include "strokes/slots.glsl"

layout(local_size_x = 64) in;
#include "frame/index.glsl"
layout(binding = UNIT_TECHNIQUE + 1) uniform sampler2D extremes; // output of blend.frag
layout(std430, binding = STORAGE_SORTED) buffer Waiting {
    uint waiting_count, unused_word;
    uvec2 waiting[]; // ids
};
layout(location = UNIFORM_COUNT) uniform uint count;

void main()
{
    uint i = index_of();
    if (i >= count)
        return;
    uvec2 id = fragments[i].xy;
    vec2 hashes = texelFetch(extremes, texel_of(slot_of(id)), 0).zw;
    if (hashes.x + hashes.y != 0.0)
        waiting[atomicAdd(waiting_count, 1u)] = id;
}
