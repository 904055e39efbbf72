// Puts the fragments of each stroke side by side.
#include "strokes/fragments.glsl"

layout(local_size_x = 64) in;
#include "frame/index.glsl"
struct Slot {
    uint low, high, count, first, joined;
};
layout(std430, binding = STORAGE_SLOTS) readonly buffer Slots { Slot slots[]; };
layout(std430, binding = STORAGE_SORTED) writeonly buffer Sorted { uvec2 sorted[]; }; // z and w of fragments
layout(location = UNIFORM_COUNT) uniform uint count;

const uint DROPPED = 0xffffffffu; // first fragment of a stroke that is not drawn

void main()
{
    uint i = index_of();
    if (i < count && fragments[i].x < uint(slots.length()) && slots[fragments[i].x].first != DROPPED)
        sorted[slots[fragments[i].x].first + fragments[i].y] = fragments[i].zw;
}
