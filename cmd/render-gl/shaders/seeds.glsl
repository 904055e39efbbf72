// Recursive procedural tonal art maps: the ink of strokes that stand at seeds. The same as seed/rptam.c.
struct SeedLayer {
    vec4 turn;          // cosine, sine of the strokes' direction; offset of their ranks
    uvec4 at;           // seeds, the first of them, the first of its lists, texels along a side
    float darkness[20]; // of the layers up to this one, at 0, 1/16 .. 1 of it
};

layout(std430, binding = 1) readonly buffer SeedLayers {
    vec4 stroke;       // length, width in pixels, ink, side of the tile in pixels
    vec4 fade;         // overlap with depth, with tone; the paper's law; strokes shrink
    uvec4 layer_count; // y: look at every seed
    SeedLayer layers[];
};
layout(std430, binding = 2) readonly buffer Seeds { vec4 seeds[]; }; // u, v, tone's rank, tile
layout(std430, binding = 3) readonly buffer SeedLists { uint lists[]; };
layout(binding = 4) uniform sampler2D stroke_image;

const int STEPS = 17;

// How much of a layer an amount of ink asks for.
float layer_amount(uint layer, float amount)
{
    int low = 0;
    while (low + 2 < STEPS && amount > layers[layer].darkness[low + 1])
        low++;
    float begin = layers[layer].darkness[low], end = layers[layer].darkness[low + 1];
    return clamp((float(low) + (amount - begin) / max(end - begin, 1e-6)) / float(STEPS - 1), 0.0, 1.0);
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
    if (any(lessThan(at, vec2(0.5))) || any(greaterThan(at, size - 0.5)))
        return 0.0;
    return textureLod(stroke_image, at / size, 0.0).r;
}

// What one layer leaves of the paper. at: the place in seed space; m: between the levels, 0 .. 1.
float layer_paper(uint layer, vec2 at, float m, float amount)
{
    uvec4 where = layers[layer].at;
    vec2 turn = layers[layer].turn.xy;
    float offset = layers[layer].turn.z;
    float overlap = max(fade.x, 1e-6), tone_overlap = max(fade.y, 1e-6);
    float front = fade_front(fade.z > 0.5 ? 1.0 - m : (exp2(2.0 - 2.0 * m) - 1.0) / 3.0, overlap);
    float tone_front = fade_front(amount, tone_overlap), px = stroke.w * exp2(-m), paper = 1.0;
    uvec2 texel = min(uvec2(fract(at) * float(where.w)), uvec2(where.w - 1u));
    uint list = where.z + texel.y * where.w + texel.x, base = where.z + where.w * where.w + 1u;
    bool all = layer_count.y > 0u;
    uint begin = all ? 0u : lists[list], end = all ? where.x : lists[list + 1u];
    for (uint i = begin; i < end; i++) {
        uint seed = all ? i : lists[base + i];
        vec4 s = seeds[where.y + seed];
        vec2 away = at - s.xy, tile = floor(away + 0.5);
        away -= tile;
        vec2 odd = mod(tile, 2.0);
        float weight = fade_weight(tone_front, s.z, tone_overlap);
        float in_tile = 2.0 * odd.y + odd.x;
        if (in_tile != s.w)
            weight *= fade_weight(front, (float(seed) + 0.25 * (in_tile + offset)) / float(where.x), overlap);
        if (weight <= 0.0)
            continue;
        vec2 place = px * vec2(dot(turn, away), turn.x * away.y - turn.y * away.x);
        float alpha = fade.w > 0.5 ? stroke_alpha(place * inversesqrt(weight)) : weight * stroke_alpha(place);
        paper *= 1.0 - stroke.z * alpha;
    }
    return paper;
}
