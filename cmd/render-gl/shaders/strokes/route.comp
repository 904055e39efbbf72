// Finds the slot of each fragment's stroke in a table with double hashing, and counts the fragments of each. In place
// of the id, a fragment gets its slot and its rank among those of the stroke.
#include "strokes/fragments.glsl"

layout(local_size_x = 64) in;
struct Slot { // struct strokes_slot of technique/strokes/strokes.h
    uint low, high; // id; 0: free
    uint count, first;
    uint joined;
};
layout(std430, binding = STORAGE_SLOTS) buffer Slots { Slot slots[]; }; // a power of two
layout(location = UNIFORM_COUNT) uniform uint count;

const uint LOST = 0xffffffffu; // slot of a fragment that finds none
const uint PROBES = 64u;       // more are needed only if the table is nearly full

// Returns whether a slot holds an id; takes it if it is free.
bool takes(uint slot, uvec2 id)
{
    uint low = atomicCompSwap(slots[slot].low, 0u, id.x);
    if (low != 0u && low != id.x)
        return false;
    uint high = atomicCompSwap(slots[slot].high, 0u, id.y);
    return high == 0u || high == id.y;
}

uint slot_of(uvec2 id)
{
    uint mask = uint(slots.length()) - 1u, slot = (id.x ^ id.x >> 15) & mask, way = id.y | 1u;
    for (uint n = 0u; n < PROBES; n++) {
        if (takes(slot, id))
            return slot;
        slot = slot + way & mask;
    }
    return LOST;
}

void main()
{
    uint i = gl_GlobalInvocationID.x;
    if (i >= count)
        return;
    uint slot = slot_of(fragments[i].xy);
    fragments[i].x = slot;
    if (slot != LOST)
        fragments[i].y = atomicAdd(slots[slot].count, 1u);
}
