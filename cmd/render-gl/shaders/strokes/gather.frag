// Gathers the fragments of strokes at seed points (Szecsi et al., Tonal Art Maps with Image Space Strokes, 2.1):
// one for each stroke that covers the pixel.
#include "frame/amounts.glsl"
#include "rptam/layers.glsl"
#include "strokes/place.glsl"

const float COVERED_LEAST = 0.02; // strokes that cover less of a pixel are not seen there

const uint CLIMBS = 8u; // levels that seed_numbers of libhatch/seed/pack.h tells about

layout(early_fragment_tests) in; // hidden fragments are not gathered

uint layer_index;

// Returns an id of the stroke that it keeps at all distances: it is made from the coarsest level that has the stroke.
// Tiles are known modulo 2^32, and modulo 2^(32 - CLIMBS) at that level.
uvec2 id_of(SeedLayer layer, int seed, ivec2 tile, int level)
{
    uint seed_numbers = texelFetch(numbers, seed).r, number = seed_numbers & 0xffffu;
    tile += fours_at(level);
    for (uint k = 0u; k < CLIMBS; k++) {
        uint crumb = seed_numbers >> (16u + 2u * k) & 3u;
        if (uint((tile.x & 1) + 2 * (tile.y & 1)) != crumb)
            break;
        tile >>= 1;
        level++;
        number = (number > 0u ? number : uint(layer.thin.z)) - 1u;
    }
    return id_in(tile & int(0xffffffffu >> CLIMBS), number + 0x10001u * uint(level), layer_index);
}

void gather(SeedLayer layer, int seed, ivec2 tile, float place, float covered, int level)
{
    if (covered >= COVERED_LEAST)
        add_fragment(id_of(layer, seed, tile, level), clamp(0.5 + place / (layer.stroke.z - 1.0), 0.0, 1.0), covered);
}

// Gathers the strokes of an amount of ink.
void gather_ink(mat2 pixels, float amount)
{
    float way = way_to(amount);
    for (int i = 0; i < seed_layers.x && way > layers[i].tone.z; i++) {
        layer_index = uint(i);
        left_by(layers[i], way, pixels);
    }
}

void main()
{
    vec2 asked = amounts();
    mat2 pixels = pixels_along_both();
    find_place(determinant(pixels) < 0.0);
    ink_index = 0u;
    gather_ink(pixels, asked.x);
#ifdef TWO_INKS
    ink_index = 1u;
    gather_ink(pixels, asked.y);
#endif
}
