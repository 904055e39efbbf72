// Recursive procedural tonal art maps (libhatch/seed/rptam.h): computes the transmittance of a layer of strokes at
// seed points. A `way` is the progress from paper, 0, to the darkest tone, 1. The life of a stroke says how late it
// vanishes between two levels, 0 .. 254; 255: it stays. The reference is libhatch/seed/rptam.c; the arrays are those of
// seed/pack.h.
struct SeedLayer {
    vec4 turn;   // cosine, sine of the strokes' direction; square of the tile's side in pixels; ink of a stroke
    vec4 tone;   // amount = x * way + y; z: way at which the layer begins; w: number of grids of lists after the first,
                 // for smaller strokes
    vec4 stroke; // texels per pixel of the stroke's image, along and across; its width and height in texels, minus 1
    ivec4 at;    // first coverage list; lists along a side of the tile; first texel of the image; number of images
                 // times 2^16 plus number of seed points if strokes differ, else 0
    vec4 thin;   // x, y: smallest factors to which a stroke's length and width shrink; z: number of seed points
};

layout(std140, binding = BLOCK_TECHNIQUE) uniform SeedLayers {
    vec4 front;  // x: 2 p (1 - p) with the overlap p; between the shares y and 1 - y the front is share * z + w
    vec4 fade;   // weight = x * front + y + z * life; plus w for a stroke that stays, with its life in the next level
    vec4 law;    // x: 1: the front is m; y: 1: the share is 1 - m; z: unused; w: entries of `ways` per unit of ink
    ivec4 seed_layers; // x: number of layers
    SeedLayer layers[64];
};
// stroke_texels: alpha of a texel, and of its neighbours right, below and below right. seeds: u, v as bits of floats, 4
// lives, 4 lives in the next level. lists: first entry of a coverage list in seeds, one past its last. numbers:
// for an entry of seeds, seed_numbers of libhatch/seed/pack.h. ways: for a step of tone, its way and the difference to
// the next.
layout(binding = UNIT_TECHNIQUE) uniform samplerBuffer stroke_texels;
layout(binding = UNIT_TECHNIQUE + 1) uniform usamplerBuffer seeds;
layout(binding = UNIT_TECHNIQUE + 2) uniform isamplerBuffer lists;
layout(binding = UNIT_TECHNIQUE + 4) uniform usamplerBuffer numbers;
layout(binding = UNIT_TECHNIQUE + 3) uniform samplerBuffer ways;

// Returns the way at which all layers together have an amount of ink.
float way_to(float amount)
{
    float at = clamp(amount * law.w, 0.0, 255.9999);
    vec2 step = texelFetch(ways, int(at)).xy;
    return step.x + fract(at) * step.y;
}

// Returns the position of the fading front between two levels (hatch_fade_front in libhatch/seed/fade.h). q is 4^-m,
// where m is 0 at this level and 1 at the next.
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
// Returns the variant of the stroke at a seed point, 0 .. 15: bit 3 mirrors it, the other bits choose the image. It
// depends on the level, because a stroke is at another seed point of the set on each level and must not change.
uint look_of(int seed, int level, SeedLayer layer)
{
    int count = layer.at.w & 0xffff;
    return uint((int(texelFetch(numbers, seed).r & 0xffffu) + level + 128 * count) % count) * 2654435769u >> 28;
}
#endif

// Returns alpha in the image of a stroke. place: in texels from the image's middle; row_first: first row of the image.
// The border of images is transparent, so that clamping makes everything outside transparent.
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

#ifdef GATHERS
// Returns the alpha of four texels of a stroke's image, or 0 where none of them is inside its border.
vec4 alpha_of(ivec2 texel, int row_first, SeedLayer layer)
{
    ivec2 end = ivec2(layer.stroke.zw);
    if (any(lessThan(texel, ivec2(0))) || any(greaterThanEqual(texel, end)))
        return vec4(0.0);
    return texelFetch(stroke_texels, layer.at.z + (texel.y + row_first) * (end.x + 1) + texel.x);
}

// Does the same as stroke_alpha for a pixel with a single sample: images have up to two texels per pixel, of which this
// takes a mean across the stroke, with weights of 1, 2 and 1 over three texels and linear between them. The mean place
// of a stroke's pixels, weighted by alpha, is then that of the stroke, wherever it lies between pixels.
float stroke_alpha_of_pixel(vec2 place, int row_first, SeedLayer layer)
{
    place += 0.5 * layer.stroke.zw;
    ivec2 texel = ivec2(floor(place));
    vec2 share = place - vec2(texel);
    vec4 above = alpha_of(texel - ivec2(0, 1), row_first, layer);
    vec4 below = alpha_of(texel + ivec2(0, 1), row_first, layer);
    vec4 rows = mix(vec4(above.xz, below.xz), vec4(above.yw, below.yw), share.x); // texels -1 to 2 across
    return 0.25 * dot(rows, vec4(1.0 - share.y, 2.0 - share.y, 1.0 + share.y, share.y));
}

// Is called for each stroke that may cover the fragment. seed: its entry in seeds; tile: the one that its seed point is
// in; place: along its image, in texels from the middle; covered: share of the fragment
void gather(SeedLayer layer, int seed, ivec2 tile, float place, float covered, int level);
#endif

// Returns the transmittance of a layer, 0 .. 1. at: place in the pattern, in tiles; px: side of a tile in pixels; q:
// as in fade_front(); level: nesting level of the seed points.
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
#ifdef GATHERS
        float covered = weight * stroke_alpha_of_pixel(place, row, layer);
        gather(layer, i, ivec2(floor(at)) + ivec2(floor(uintBitsToFloat(s.xy))), place.x, covered, level);
#else
        float covered = weight * stroke_alpha(place, row, layer);
#endif
        paper *= 1.0 - layer.turn.w * covered;
    }
    return paper;
}
