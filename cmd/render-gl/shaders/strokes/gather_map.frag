// Gathers the fragments of the strokes of a tonal art map: those that cover the texel, in the two levels nearest to the
// footprint of the pixel. What a fragment counts follows from the blends of levels and columns, so that strokes that
// only one of them has fade in and out. libhatch/cover/cover.h explains the marks.
#define RATIO 4.0 // as with four samples per pixel: the fit takes the mean of many fragments
#define ROW_BITS LIST_ROW_BITS
#include "frame/amounts.glsl"
#include "tones/targets.glsl"
#include "tones/tones.glsl"
#include "strokes/place.glsl"

const float WEIGHT_LEAST = 0.02; // strokes that have faded further are not seen

layout(early_fragment_tests) in; // hidden fragments are not gathered

in vec2 v_texcoord;
layout(location = 0) out float o_magnified; // pixels per texel of the finest level

// Gathers the strokes of a texel. place: of the tone among the columns; share: of the level
void gather_texel(uint texel, ivec2 tile, float place, float share)
{
    for (uint i = word(texel), end = word(texel + 1u); i < end; i++) {
        uint at = word(3u) + 2u * i, id = word(at), bits = word(at + 1u);
        float weight = share * clamp(place - float(bits >> 20 & 255u), 0.0, 1.0);
        float covered = float(bits >> 12 & 255u) / 255.0;
        uint from = bits >> 28 | id >> 30 << 4; // the tile of the stroke's middle: hatch_cover_mark_tile
        ivec2 middle = tile + ivec2(from & 7u, from >> 3) - 3;
        if (weight >= WEIGHT_LEAST)
            add_fragment(id_in(middle, id & 0xffffffu, id >> 24 & 63u), float(bits & 4095u) / 4095.0, weight * covered);
    }
}

void gather_ink(float amount)
{
    float level = clamp(column_level, 0.0, float(word(2u)) - 1.0), finer = floor(level);
    ivec2 tile = ivec2(floor(column_place));
    for (float l = finer; l < level + 1.0; l++) {
        int size = max(int(word(1u)) >> int(l), 1);
        ivec2 texel = min(ivec2(fract(column_place) * float(size)), size - 1);
        gather_texel(word(8u + uint(l)) + uint(texel.y * size + texel.x), tile, place_of(amount), 1.0 - abs(l - level));
    }
}

void main()
{
    aim(v_texcoord);
    o_magnified = exp2(-column_level);
    vec2 asked = amounts(), x = dFdx(v_texcoord), y = dFdy(v_texcoord);
    find_place(x.x * y.y - x.y * y.x < 0.0);
    ink_index = 0u;
    gather_ink(asked.x);
#ifdef TWO_INKS
    ink_index = 1u;
    gather_ink(asked.y);
#endif
}
