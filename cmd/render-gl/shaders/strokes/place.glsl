// How fragments of strokes are added to the buffer, whatever the strokes come from.
#include "strokes/fragments.glsl"
#include "traced/noise.glsl"

flat in uint v_chart;

uint ink_index, place_index, lapped;
#ifdef OUTLINE
layout(binding = UNIT_SOURCE) uniform sampler2D owners; // owner.frag
#endif

// Finds the index of the place: a texture may cover two places of a surface, one of them mirrored. Fragments of a patch
// are gathered where others lie over it, too.
void find_place(bool mirrored)
{
#ifdef OUTLINE
    float owner = texelFetch(owners, ivec2(gl_FragCoord.xy), 0).r;
    lapped = FRAGMENT_LAPPED | (owner == float(v_chart + 2u) ? 0u : FRAGMENT_BELOW);
#else
    base_holes();
    lapped = 0u;
#endif
    place_index = mix_bits(0x85ebca6bu * item + 2u * v_chart + uint(mirrored));
}

// Returns the id of a stroke in a tile of the texture. which: a number of its own in the tile
uvec2 id_in(ivec2 tile, uint which, uint layer)
{
    uint place = mix_bits(mix_bits(uint(tile.x)) + 0x9e3779b9u * uint(tile.y));
    which = mix_bits(which) + place_index;
    uint low = mix_bits(place ^ which) << ID_HASH_SHIFT | layer << ID_LAYER_SHIFT | ink_index;
    return uvec2(low, mix_bits(place + 0x27d4eb2fu * which) | 1u);
}

// Adds a fragment; one that finds no room is only counted. t: 0 .. 1; covered: share of the pixel, 0 .. 1
void add_fragment(uvec2 id, float t, float covered)
{
    uint at = atomicAdd(fragment_count, 1u);
    if (at >= uint(fragments.length()))
        return;
    uvec2 pixel = uvec2(gl_FragCoord.xy);
    fragments[at] = uvec4(id, pixel.x | pixel.y << 16,
                          uint(t * 65535.0 + 0.5) | uint(covered * 16383.0 + 0.5) << 18 | lapped);
}
