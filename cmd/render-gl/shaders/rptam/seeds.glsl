// Recursive procedural tonal art maps: transmittance of a layer of strokes at seed points. The reference is
// libhatch/seed/rptam.c; the arrays are those of seed/pack.h.
struct SeedLayer {
    vec4 turn;   // cosine, sine of the strokes' direction; square of the tile's side in pixels; ink of a stroke
    vec4 tone;   // amount = x way + y; z: way at which the layer begins; w: number of further lists for smaller strokes
    vec4 stroke; // texels per pixel of the stroke's image, along and across; its size in texels minus 1
    ivec4 at;    // first coverage list; lists along a side of the tile; first texel of the image; if strokes differ:
                 // number of images times 2^16 plus number of seeds
    vec4 thin;   // x, y: smallest factors to which a stroke's length and width shrink
};

layout(std140, binding = BLOCK_TECHNIQUE) uniform SeedLayers {
    vec4 front;  // 2 p (1 - p), p: overlap; share at which the fading front becomes linear; its slope, its offset
    vec4 fade;   // weight = x front + y + z life (+ w in the next level); life: 0 .. 255
    vec4 law;    // x: 1: the front is m; y: 1: the share is 1 - m; z: 0; w: entries of `ways` per unit of ink
    ivec4 seed_layers; // x: number of layers
    SeedLayer layers[64];
};
layout(binding = UNIT_TECHNIQUE) uniform samplerBuffer stroke_texels; // alpha here, right, below, right below
layout(binding = UNIT_TECHNIQUE + 1) uniform usamplerBuffer seeds; // float bits of u, v; 4 lives; next level's
layout(binding = UNIT_TECHNIQUE + 2) uniform isamplerBuffer lists; // first seed, the one after the last
layout(binding = UNIT_TECHNIQUE + 4) uniform usamplerBuffer numbers; // index of each seed in its set
layout(binding = UNIT_TECHNIQUE + 3) uniform samplerBuffer ways;   // per tone step: way, and difference to the next

// Progress from paper, 0, to the darkest tone, 1, at an amount of ink.
float way_to(float amount)
{
    float at = clamp(amount * law.w, 0.0, 255.9999);
    vec2 step = texelFetch(ways, int(at)).xy;
    return step.x + fract(at) * step.y;
}

// Position of the fading front between two levels. q = 4^-m; m: 0 at this level .. 1 at the next.
float fade_front(float q)
{
    float m = -0.5 * log2(q);
    float share = law.y > 0.5 ? 1.0 - m : (4.0 * q - 1.0) / 3.0;
    float place = share * front.z + front.w;
    place = share <= front.y ? sqrt(max(front.x * share, 0.0)) : place;
    place = share >= 1.0 - front.y ? 1.0 - sqrt(max(front.x * (1.0 - share), 0.0)) : place;
    return law.x > 0.5 ? m : place;
}

#ifdef STROKES_VARY
// Variant 0 .. 15 of a seed's stroke: bit 3 mirrors it, the others choose the image. It depends on the level so that a
// stroke keeps its variant at every distance.
uint look_of(int seed, int level, SeedLayer layer)
{
    int count = layer.at.w & 0xffff;
    return uint((int(texelFetch(numbers, seed).r) + level + 128 * count) % count) * 2654435769u >> 28;
}
#endif

// Alpha of a stroke's image. place: in texels from its middle; row_first: first row of the image. The border of images
// is transparent, so that clamping makes everything outside transparent.
float stroke_alpha(vec2 place, int row_first, SeedLayer layer)
{
    place = clamp(0.5 * layer.stroke.zw + place, vec2(0.0), layer.stroke.zw);
    ivec2 texel = ivec2(place);
    texel.y += row_first;
    vec4 alpha = texelFetch(stroke_texels, layer.at.z + texel.y * (int(layer.stroke.z) + 1) + texel.x);
    vec2 share = fract(place);
    vec2 row = mix(alpha.xz, alpha.yw, share.x);
    return mix(row.x, row.y, share.y);
}

// Transmittance of a layer, 0 .. 1. at: place in the pattern, in tiles, modulo 4; px: a tile's side in pixels;
// q: 4^-m, m: 0 at this level .. 1 at the next; level: nesting level of the seeds.
float layer_paper(SeedLayer layer, vec2 at, float px, float q, int level)
{
    float paper = 1.0, base = fade.x * fade_front(q) + fade.y;
    vec2 tile = fract(0.25 * at) * 4.0;
    ivec2 whole = ivec2(tile), cell = ivec2(fract(tile) * float(layer.at.y));
    uvec2 bytes = uvec2(8 * ((whole & 1).x + 2 * (whole & 1).y), 8 * ((whole >> 1).x + 2 * (whole >> 1).y));
    int smaller = (floatBitsToInt(4.0 * px * px / layer.turn.z) >> 23) - 127;
    int size = clamp(smaller, 0, int(layer.tone.w));
    ivec2 list = texelFetch(lists, layer.at.x + (size * layer.at.y + cell.y) * layer.at.y + cell.x).xy;
    vec2 scale = px * layer.stroke.xy, along = scale.x * layer.turn.xy;
    vec2 across = scale.y * vec2(-layer.turn.y, layer.turn.x);
#ifdef STROKES_VARY
    int images = layer.at.w >> 16;
#endif
    tile = fract(tile);
    for (int i = list.x; i < list.y; i++) {
        uvec4 s = texelFetch(seeds, i);
        vec2 away = tile - uintBitsToFloat(s.xy);
        uvec2 lives = (s.zw >> bytes) & 255u;
        float weight = base + fade.z * float(lives.x);
        weight = lives.x == 255u ? base + fade.w + fade.z * float(lives.y) : weight;
        weight = lives == uvec2(255u) ? 1.0 : clamp(weight, 0.0, 1.0);
        vec2 place = vec2(dot(along, away), dot(across, away));
#ifdef STROKES_SHRINK
        vec2 size = max(vec2(sqrt(weight)), layer.thin.xy);
        place /= size;
        weight /= size.x * size.y;
#endif
        int row = 0;
#ifdef STROKES_VARY
        if (images > 0) {
            uint look = look_of(i, level, layer);
            row = (int(look) & (images - 1)) * (int(layer.stroke.w) + 1);
            place.y = look < 8u ? place.y : -place.y;
        }
#endif
        paper *= 1.0 - layer.turn.w * weight * stroke_alpha(place, row, layer);
    }
    return paper;
}
