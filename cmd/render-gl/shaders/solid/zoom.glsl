// The infinite zoom on solid textures: Dynamic Solid Textures (2009), section 3, as solid/zoom.h writes it. SOLIDS is
// the number of textures, CHANNELS 1 or 3; with TABLES, struct hatch_zoom_table changes the blended values; UNION is
// HATCH_ZOOM_UNION.
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
    vec4 axes[3]; // w: texels along a side; standard deviation and mean of the first value
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
    uint number = material == 0xffffffffu ? item : material, count = uint(edges.y);
    return count == 0u ? ink.rgb : inks[number % count].rgb;
}

// Returns the colour of paper under inks of an item. dark, light: coverage by each, in each colour channel
vec3 own_ink_on_paper(vec3 dark, vec3 light)
{
    return paper.rgb + dark * (own_ink() - paper.rgb) + light * (light_ink.rgb - paper.rgb);
}

layout(binding = UNIT_TECHNIQUE) uniform sampler2DArray tables;
layout(binding = UNIT_SOLIDS) uniform sampler3D octaves[SOLIDS];

// The zoom cycle of a fragment. place: in periods at the cycle's beginning; level: of a mip chain whose finest texels
// are one period wide, binary logarithm of the size of a fragment
struct Cycle {
    vec3 place;
    float s, level;
};

#ifdef FLAT
Cycle cycle_here()
{
    Cycle cycle;
    mat2 pixels = pixels_along_both();
    float far = zoom.z - 0.5 * log2(clamp(abs(determinant(pixels)), 1e-36, 1e36)), whole = floor(far);
    vec2 x = dFdx(v_texcoord), y = dFdy(v_texcoord);
    cycle.s = far - whole;
    cycle.place = vec3(place_at(whole), 0.5);
    cycle.level = 0.5 * log2(max(max(dot(x, x), dot(y, y)), 1e-37)) - whole;
    return cycle;
}
#else
Cycle cycle_here()
{
    Cycle cycle;
    float far = zoom.x - rest_log - log2(gl_FragCoord.w), whole = floor(far);
    vec3 x = dFdx(v_place), y = dFdy(v_place);
    cycle.s = far - whole;
    cycle.place = v_place * exp2(-whole);
#ifdef PIECES
    int depth = int(whole);
    cycle.place += vec3(bits_at(v_origin_u, depth), bits_at(v_origin_v, depth), bits_at(v_origin_w, depth));
#endif
    cycle.level = 0.5 * log2(max(max(dot(x, x), dot(y, y)), 1e-37)) - whole;
    return cycle;
}
#endif

vec3 octaves_at(int solid, vec3 place, float level)
{
    vec3 texel = textureLod(octaves[0], place, level).rgb;
#if SOLIDS > 1
    for (int i = 1; i < SOLIDS; i++)
        if (i == solid)
            texel = textureLod(octaves[i], place, level).rgb;
#endif
    return texel;
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
    float level = cycle.level + log2(colors[solid].axes[0].w) - coarser;
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
float changed(int solid, int channel, Cycle cycle, float value)
{
    return texture(tables, vec3(value, (cycle.s * 16.0 + 0.5) / 17.0, float(solid * CHANNELS + channel))).r;
}
#endif

// Returns the blended values of the texture, one per channel.
vec3 values_here(int solid, Cycle cycle)
{
    vec3 value = raw_values(solid, cycle, vec3(0.0), 0.0);
#ifdef TABLES
    value.r = changed(solid, 0, cycle, value.r);
#if CHANNELS == 3
    value.g = changed(solid, 1, cycle, value.g);
    value.b = changed(solid, 2, cycle, value.b);
#endif
#endif
    return value;
}

// Returns the colour of the texture, linear reflectance.
vec3 texture_color(int solid, Cycle cycle)
{
    vec3 value = values_here(solid, cycle);
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
