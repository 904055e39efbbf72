// The infinite zoom on solid textures: Dynamic Solid Textures (2009), section 3, as solid/zoom.h writes it. SOLIDS is
// the number of textures, CHANNELS 1 or 3; with TABLES, struct hatch_zoom_table changes the blended values; UNION is
// HATCH_ZOOM_UNION; with INKS, --inks has colours; with QUADS, the samples of a pixel share reads.
// With FLAT they are 2D textures, whose places are texture coordinates.
#ifdef PIECES
#include "frame/fixed.glsl"
#endif
#ifdef FLAT
#include "rptam/place.glsl"
#else
in vec3 v_place;
#ifdef PIECES
flat in uvec4 v_origin_u, v_origin_v, v_origin_w;
#endif
#endif

struct Color {
    vec4 offset; // w: mean luminance
    vec4 axes[3]; // w: binary logarithm of the texels along a side; standard deviation and mean of the first value
};

layout(std140, binding = BLOCK_TECHNIQUE) uniform Solids {
    vec4 zoom;  // struct look_block of look/look.h
    vec4 marks;
    vec4 edges;
    vec4 inks[16];
    Color colors[8];
};

// Returns the ink of the item's material.
vec3 own_ink()
{
#ifdef INKS
    uint number = material == 0xffffffffu ? item : material;
    return inks[number % uint(edges.y)].rgb;
#else
    return ink.rgb;
#endif
}

// Returns the colour of paper under inks of an item. dark, light: coverage by each, in each colour channel
vec3 own_ink_on_paper(vec3 dark, vec3 light)
{
    return paper.rgb + dark * (own_ink() - paper.rgb) + light * (light_ink.rgb - paper.rgb);
}

layout(binding = UNIT_TECHNIQUE) uniform sampler2DArray tables;
#if defined(QUADS) && CHANNELS == 1
#define PAIRS // member pairs of struct solids_form
layout(binding = UNIT_SOLIDS) uniform sampler2DArray octaves[SOLIDS];
#else
layout(binding = UNIT_SOLIDS) uniform sampler3D octaves[SOLIDS];
#endif

// The zoom cycle of a fragment. place: in periods at the cycle's beginning; level: of a mip chain whose finest texels
// are one period wide, binary logarithm of the size of a fragment
struct Cycle {
    vec3 place;
    float s, level;
};

// The octave of a fragment is a real number; its fraction is s. place_in() returns the place in periods of a whole
// octave, and footprint() the binary logarithm of the size of a fragment in periods of octave 0.
#ifdef FLAT
#define v_from v_texcoord
#define PLACE vec2

float octave_here()
{
    mat2 pixels = pixels_along_both();
    return zoom.z - 0.5 * log2(clamp(abs(determinant(pixels)), 1e-36, 1e36));
}

vec3 place_in(float octave)
{
    return vec3(place_at(octave), 0.5);
}
#else
#define v_from v_place
#define PLACE vec3

float octave_here()
{
    return zoom.x - rest_log - log2(gl_FragCoord.w);
}

vec3 place_in(float octave)
{
    vec3 place = v_place * exp2(-octave);
#ifdef PIECES
    int depth = int(octave);
    place += vec3(bits_at(v_origin_u, depth), bits_at(v_origin_v, depth), bits_at(v_origin_w, depth));
#endif
    return place;
}
#endif

float footprint(PLACE x, PLACE y)
{
    return 0.5 * log2(max(max(dot(x, x), dot(y, y)), 1e-37));
}

Cycle cycle_here()
{
    float octave = octave_here(), whole = floor(octave);
    return Cycle(place_in(whole), octave - whole, footprint(dFdx(v_from), dFdy(v_from)) - whole);
}

vec3 texel_of(int solid, vec3 place, float level)
{
    vec3 texel = textureLod(octaves[0], place, level).rgb;
#if SOLIDS > 1
    for (int i = 1; i < SOLIDS; i++)
        if (i == solid)
            texel = textureLod(octaves[i], place, level).rgb;
#endif
    return texel;
}

// Returns a texture's values at a place. level: of its mip chain; with PAIRS, a whole number
vec3 octaves_at(int solid, vec3 place, float level)
{
#ifndef PAIRS
    return texel_of(solid, place, level);
#elif defined(FLAT)
    return texel_of(solid, vec3(place.xy, 0.0), level).rrr;
#else
    float slices = exp2(clamp(colors[solid].axes[0].w - level, 0.0, colors[solid].axes[0].w));
    float slice = place.z * slices - 0.5, below = floor(slice);
    vec2 pair = texel_of(solid, vec3(place.xy, below - slices * floor(below / slices)), level).rg;
    return vec3(mix(pair.r, pair.g, slice - below));
#endif
}

// Returns the tones at which places of such ranks appear: u of solid/zoom.h.
vec3 appears(vec3 rank, float s)
{
    vec3 above = 1.0 - max(rank, 1.0 / 510.0);
    return (1.0 - above * above) / (1.0 + above * (1.0 - 2.0 * s));
}

// Returns blended values, one per channel, that the tables have not changed. shift: of the place, in periods; coarser:
// octaves by which the texture is larger
vec3 raw_values(int solid, Cycle cycle, vec3 shift, float coarser)
{
    float level = cycle.level + colors[solid].axes[0].w - coarser;
    vec3 place = exp2(-coarser) * cycle.place + shift;
    vec3 fine = octaves_at(solid, place, level), coarse = octaves_at(solid, 0.5 * place, level - 1.0);
#ifdef UNION
    return min(appears(fine, cycle.s), appears(coarse, 1.0 - cycle.s));
#else
    return mix(fine, coarse, cycle.s);
#endif
}

// Returns the texture's first value as a variation around its mean, -1 .. 1. smoother: mip levels above that of a
// sample. The other arguments are those of raw_values().
float variation(int solid, Cycle cycle, vec3 shift, float coarser, float smoother)
{
    cycle.level += smoother;
    float away = raw_values(solid, cycle, shift, coarser).r - colors[solid].axes[2].w;
    return clamp(away / (2.5 * colors[solid].axes[1].w), -1.0, 1.0);
}

#ifdef TABLES
float changed(int solid, int channel, float s, float value)
{
    return texture(tables, vec3(value, (s * 16.0 + 0.5) / 17.0, float(solid * CHANNELS + channel))).r;
}
#endif

// Returns what the tables make of blended values.
vec3 table_values(int solid, float s, vec3 value)
{
#ifdef TABLES
    value.r = changed(solid, 0, s, value.r);
#if CHANNELS == 3
    value.g = changed(solid, 1, s, value.g);
    value.b = changed(solid, 2, s, value.b);
#endif
#endif
    return value;
}

#ifdef QUADS
#if CHANNELS == 1
#define VALUES float
#define CHANNELS_OF(texel) (texel).r
#else
#define VALUES vec3
#define CHANNELS_OF(texel) (texel)
#endif

// Returns the sum over the 2 by 2 samples of a quad. turn: 1 at its first samples along x and y, -1 at its second ones
VALUES quad_sum(VALUES value, vec2 turn)
{
    VALUES row = 2.0 * value + turn.x * dFdxFine(value);
    return 2.0 * row + turn.y * dFdyFine(row);
}

float quad_mean(float value, vec2 turn)
{
    float row = value + 0.5 * turn.x * dFdxFine(value);
    return row + 0.5 * turn.y * dFdyFine(row);
}

// Returns the whole number nearest to x among the even or, for odd = 1, the odd ones.
float nearest_of(float x, float odd)
{
    return 2.0 * floor(0.5 * (x - odd) + 0.5) + odd;
}

// Returns the blended values of the texture, the same ones at the 2 by 2 samples of a quad. Each sample reads one mip
// level of one octave at the middle of the quad: the even or the odd one. Weights fall to 0 where the nearest even or
// odd number changes, so that roundings that differ between samples do no harm.
vec3 values_here(int solid)
{
    vec2 odd = mod(floor(gl_FragCoord.xy), 2.0), turn = 1.0 - 2.0 * odd;
    PLACE x = dFdxFine(v_from), y = dFdyFine(v_from), middle = 0.5 * (turn.x * x + turn.y * y);
    float at = quad_mean(octave_here(), turn), octave = nearest_of(at, odd.y);
    float level = quad_mean(footprint(x, y), turn) + 1.0 - octave + colors[solid].axes[0].w;
    float whole = nearest_of(level, odd.x), weight = (1.0 - abs(at - octave)) * (1.0 - abs(level - whole));
    vec3 place = place_in(octave);
#ifdef FLAT
    place.xy += exp2(-octave) * middle;
#else
    place += exp2(-octave) * middle;
#endif
    VALUES sum = quad_sum(weight * CHANNELS_OF(octaves_at(solid, place, whole)), turn);
    return table_values(solid, fract(at), vec3(sum));
}
#else
// Returns the blended values of the texture, one per channel.
vec3 values_here(int solid)
{
    Cycle cycle = cycle_here();
    return table_values(solid, cycle.s, raw_values(solid, cycle, vec3(0.0), 0.0));
}
#endif

// Returns the colour of the texture, linear reflectance.
vec3 texture_color(int solid)
{
    vec3 value = values_here(solid);
#if CHANNELS == 3
    Color color = colors[solid];
    return clamp(color.offset.rgb + value.r * color.axes[0].rgb + value.g * color.axes[1].rgb +
                 value.b * color.axes[2].rgb, 0.0, 1.0);
#else
    return value.rrr;
#endif
}

// Returns the texture of the item's material.
int solid_of_material()
{
    return int((material == 0xffffffffu ? item : material) % uint(SOLIDS));
}
