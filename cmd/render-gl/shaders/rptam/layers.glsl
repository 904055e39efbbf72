// Algorithm 2 of libhatch/seed/rptam.h. For each layer, computes the nesting depth from the scale of the surface on
// the screen, and draws those strokes that are on the coverage list for the fragment's place at that depth.
#include "rptam/seeds.glsl"
#include "rptam/place.glsl"

// Returns the transmittance of a layer, 0 .. 1. way: progress from paper, 0, to the darkest tone, 1. With an amount of
// ink below 1 the layer has only the strokes that it would have log4(1/amount) levels further out. The integer part of
// the depth is read from the float's exponent.
float left_by(SeedLayer layer, float way, mat2 pixels)
{
    float amount = clamp(layer.tone.x * way + layer.tone.y, 0.0, 1.0);
    float unit = width_across(pixels, layer.turn.xy), pattern = layer.turn.z / (unit * unit * amount); // 4^depth
    if (!(amount >= 1e-4 && pattern > 1e-36 && pattern < 1e36))
        return 1.0; // no ink, or no nesting depth: the surface is seen edge on or has no scale
    int whole = ((floatBitsToInt(pattern) >> 23) - 127) >> 1;
    float far = intBitsToFloat((127 - whole) << 23), tile = intBitsToFloat((127 + whole) << 23);
    return layer_paper(layer, place_at(float(whole)), unit * tile, 1.0 / (pattern * far * far), whole);
}

float ink_of(mat2 pixels, float amount)
{
    float way = way_to(amount), left = 1.0;
    for (int i = 0; i < seed_layers.x && way > layers[i].tone.z; i++)
        left *= left_by(layers[i], way, pixels);
    return 1.0 - left;
}
