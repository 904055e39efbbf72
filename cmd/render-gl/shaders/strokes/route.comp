// Finds the slot of each fragment's stroke in a table with double hashing, and counts the fragments of each. In place
// of the id, a fragment gets its slot and its rank among those of the stroke.
#include "strokes/fragments.glsl"
#include "strokes/hash.glsl"

layout(local_size_x = 64) in;
#include "frame/index.glsl"
struct Slot { // struct strokes_slot of technique/strokes/strokes.h
    uint low, high; // id; 0: free
    uint count, first;
    int kept; // below 0: its patch does not own the stroke
};
layout(std430, binding = STORAGE_SLOTS) buffer Slots { Slot slots[]; }; // a power of two
layout(location = UNIFORM_COUNT) uniform uint count;

const uint LOST = 0xffffffffu; // slot of a fragment that finds none
const uint PROBES = 64u;       // more are needed only if the table is nearly full
const float MIDDLE = 0.25;     // fragments whose t is nearer to .5 decide alone, if there are any

// Returns the vote of a patch's fragment: whether the patch lies on top, mostly around the middle of the stroke.
int vote_of(uint bits)
{
    float away = abs(float(bits & 0xffffu) / 65535.0 - 0.5);
    int vote = 1 + int(4096.0 * max(1.0 - away / MIDDLE, 0.0));
    return (bits & FRAGMENT_BELOW) == 0u ? vote : -vote;
}

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
    for (uint n = 0u; n < PROBES; n++) {
        uint slot = probe(id, n, uint(slots.length()));
        if (takes(slot, id))
            return slot;
    }
    return LOST;
}

void main()
{
    uint i = index_of();
    if (i >= count)
        return;
    uint slot = slot_of(fragments[i].xy);
    fragments[i].x = slot;
    if (slot == LOST)
        return;
    fragments[i].y = atomicAdd(slots[slot].count, 1u);
    if ((fragments[i].w & FRAGMENT_LAPPED) != 0u)
        atomicAdd(slots[slot].kept, vote_of(fragments[i].w));
}
