// Recursive procedural tonal art maps: the ink of strokes that stand at seeds. The same as seed/rptam.c.
struct SeedLayer {
    vec4 turn;        // cosine, sine of the strokes' direction; offset of their ranks
    ivec4 at;         // seeds, the first of them, the first of its lists, texels along a side
    vec4 darkness[5]; // of the layers up to this one, at 0, 1/16 .. 1 of it
};

layout(std140, binding = 1) uniform SeedLayers {
    vec4 stroke;       // length, width in pixels, ink, side of the tile in pixels
    vec4 fade;         // overlap with depth, with tone; the paper's law; strokes shrink
    ivec4 layer_count; // y: look at every seed
    SeedLayer layers[8];
};
layout(binding = 4) uniform sampler2D stroke_image;
layout(binding = 5) uniform samplerBuffer seeds;  // u, v, tone's rank, four times the number and the tile
layout(binding = 6) uniform isamplerBuffer lists; // per texel: its first seed, the one after its last

float darkness_at(int layer, int step)
{
    return layers[layer].darkness[step / 4][step % 4];
}

// How much of a layer an amount of ink asks for.
float layer_amount(int layer, float amount)
{
    int low = 0;
    for (int step = 8; step > 0; step /= 2)
        low += amount > darkness_at(layer, low + step) ? step : 0;
    low = min(low, 15);
    float begin = darkness_at(layer, low), end = darkness_at(layer, low + 1);
    return clamp((float(low) + (amount - begin) / max(end - begin, 1e-6)) / 16.0, 0.0, 1.0);
}

// Where the front of fading stands, so that the mean over ranks is `share`.
float fade_front(float share, float overlap)
{
    float q = 1.0 - overlap, less = min(overlap, q), more = max(overlap, q);
    float twice = 2.0 * overlap * q;
    if (share <= less / (2.0 * more))
        return sqrt(twice * share);
    if (share >= 1.0 - less / (2.0 * more))
        return 1.0 - sqrt(twice * (1.0 - share));
    return share * more + 0.5 * less;
}

float fade_weight(float front, float rank, float overlap)
{
    return clamp((front - rank * (1.0 - overlap)) / overlap, 0.0, 1.0);
}

// Alpha at a place in pixels from the middle of a stroke.
float stroke_alpha(vec2 px)
{
    vec2 size = vec2(textureSize(stroke_image, 0));
    vec2 at = 1.0 + (px / stroke.xy + 0.5) * (size - 2.0);
    return textureLod(stroke_image, at / size, 0.0).r; // its border is nothing, and goes on outside
}

// What one layer leaves of the paper. at: the place in seed space; m: between the levels, 0 .. 1.
float layer_paper(int layer, vec2 at, float m, float amount)
{
    ivec4 where = layers[layer].at;
    vec2 turn = layers[layer].turn.xy;
    float overlap = max(fade.x, 1e-6), tone_overlap = max(fade.y, 1e-6);
    float front = fade_front(fade.z > 0.5 ? 1.0 - m : (exp2(2.0 - 2.0 * m) - 1.0) / 3.0, overlap);
    float tone_front = fade_front(amount, tone_overlap), px = stroke.w * exp2(-m), paper = 1.0;
    ivec2 texel = min(ivec2(fract(at) * float(where.w)), ivec2(where.w - 1));
    ivec2 list = texelFetch(lists, where.z + texel.y * where.w + texel.x).xy;
    if (layer_count.y > 0)
        list = ivec2(where.y, where.y + where.x);
    if (amount <= 0.0)
        list.y = list.x;
    for (int i = list.x; i < list.y; i++) {
        vec4 s = texelFetch(seeds, i);
        vec2 away = at - s.xy, tile = floor(away + 0.5);
        away -= tile;
        vec2 odd = tile - 2.0 * floor(0.5 * tile);
        float in_tile = 2.0 * odd.y + odd.x, number = floor(0.25 * s.w);
        float rank = (number + 0.25 * (in_tile + layers[layer].turn.z)) / float(where.x);
        float weight = fade_weight(tone_front, s.z, tone_overlap);
        weight *= in_tile == s.w - 4.0 * number ? 1.0 : fade_weight(front, rank, overlap);
        vec2 place = px * vec2(dot(turn, away), turn.x * away.y - turn.y * away.x);
        bool shrinks = fade.w > 0.5;
        float alpha = stroke_alpha(shrinks ? place * inversesqrt(max(weight, 1e-12)) : place);
        paper *= 1.0 - stroke.z * alpha * (shrinks ? step(1e-12, weight) : weight);
    }
    return paper;
}
