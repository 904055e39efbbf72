// Reads an asset (a map, a volume, a threshold texture or exact runs) in the fragment stage. aim() must be called once,
// then read_columns() for each layer, or at each tone of a 3D texture.
#include "frame/frame.glsl"

#ifdef EXACT
layout(binding = UNIT_TONES) uniform usampler2D columns; // words of exact runs, 1024 per row, or of lists

#ifndef ROW_BITS
#define ROW_BITS 10
#endif

uint word(uint i)
{
    return texelFetch(columns, ivec2(i & (1u << ROW_BITS) - 1u, i >> ROW_BITS), 0).r;
}

vec2 columns_size()
{
    return vec2(float(word(1u)));
}
#else
#if defined(VOLUME) && !defined(LAYERED)
layout(binding = UNIT_TONES) uniform sampler3D columns;
#define ALONG_SURFACE(v) vec3(v, 0.0)
#else
layout(binding = UNIT_TONES) uniform sampler2DArray columns;
#define ALONG_SURFACE(v) v
#endif

vec2 columns_size()
{
    return vec2(textureSize(columns, 0).xy);
}
#endif

vec2 column_place;
float column_level;

#ifdef ANISOTROPIC
vec2 column_x, column_y;

// Where a pixel covers more tiles than this in any direction, no stroke is visible, and derivatives are replaced so
// that the coarsest level is read: with the true ones, the driver's anisotropic filter would read thousands of texels.
const float TILES_MAX = 8.0;

void aim(vec2 texcoord)
{
    vec2 tiles = fwidth(texcoord);
    bool far = !(max(tiles.x, tiles.y) <= TILES_MAX);
    column_place = texcoord;
    column_x = far ? vec2(1.0, 0.0) : dFdx(texcoord);
    column_y = far ? vec2(0.0, 1.0) : dFdy(texcoord);
    vec2 size = columns_size();
    float longer = max(dot(column_x * size, column_x * size), dot(column_y * size, column_y * size));
    float area = abs(column_x.x * column_y.y - column_x.y * column_y.x) * size.x * size.y;
    column_level = 0.5 * log2(max(area * area / max(longer, 1e-20), 1e-20) * curve.w);
}

vec4 read_columns(float layer)
{
    return textureGrad(columns, vec3(column_place, layer), ALONG_SURFACE(column_x), ALONG_SURFACE(column_y));
}
#else
// The longer axis of a pixel's footprint counts by one over this.
#ifndef RATIO
#define RATIO min(curve.w, 4.0)
#endif

// Chooses the mip level. It depends on the footprint of the pixel, not of the sample, so that strokes have the same
// width in pixels for any number of samples. With four samples or more per pixel, the longer axis of the footprint
// counts half, because the samples resolve the detail along it: this is anisotropic filtering with a ratio of 2 at no
// cost. Neighbouring levels are mixed only in the middle half between them. Strokes of a level nest in the next finer
// one, so nothing pops; more of the picture has strokes of full strength; and software renderers more often read only
// one level.
void aim(vec2 texcoord)
{
    vec2 size = columns_size();
    vec2 x = dFdx(texcoord) * size, y = dFdy(texcoord) * size;
    float area = x.x * y.y - x.y * y.x;
    float longer = max(max(dot(x, x), dot(y, y)), 1e-20), shorter = area * area / longer;
    column_place = texcoord;
    float level = 0.5 * log2(max(longer / RATIO, shorter) * curve.w);
    float part = fract(level);
    column_level = level - part + clamp(2.0 * part - 0.5, 0.0, 1.0);
}

#ifndef EXACT
vec4 read_columns(float layer)
{
    return textureLod(columns, vec3(column_place, layer), column_level);
}
#endif
#endif
