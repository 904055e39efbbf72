// Reading the columns of the tonal art map, in the fragment stage: aim once, then read.
#include "frame.glsl"

layout(binding = 0) uniform sampler2DArray columns;

// Where a pixel covers more tiles than this, along any side of it, no stroke shows: only the mean of the
// tile is left, the coarsest level. An anisotropic read there would take samples by the thousand.
const float TILES_MAX = 8.0;

vec2 column_place;
float column_level;

// Strokes keep their width in pixels whatever the number of samples a pixel: the level goes by the
// pixel's footprint, not by the sample's. But where a pixel has several samples they see apart what lies
// along the footprint's longer axis, so that half of it counts there: anisotropic filtering by the ratio
// of two that costs nothing, and that is the same for every number of samples.
float level_of(vec2 texcoord)
{
    vec2 size = vec2(textureSize(columns, 0).xy);
    vec2 x = dFdx(texcoord) * size, y = dFdy(texcoord) * size;
    float sum = dot(x, x) + dot(y, y), cross = x.x * y.y - x.y * y.x;
    float apart = sqrt(max(sum * sum - 4.0 * cross * cross, 0.0));
    float longer = 0.5 * (sum + apart), shorter = 0.5 * (sum - apart);
    float level = max(longer / min(curve.w, 4.0), shorter) * curve.w;
    return 0.5 * log2(max(level, 1e-20));
}

void aim(vec2 texcoord)
{
    vec2 tiles = fwidth(texcoord);
    bool far = !(max(tiles.x, tiles.y) <= TILES_MAX);
    column_place = far ? vec2(0.0) : texcoord;
#ifdef ANISOTROPIC
    column_level = far ? 32.0 : -1.0; // the driver's filter finds the level itself
#else
    column_level = far ? 32.0 : level_of(texcoord);
#endif
}

vec3 read_columns(float layer)
{
#ifdef ANISOTROPIC
    vec3 near_texel = texture(columns, vec3(column_place, layer)).rgb;
    return column_level < 0.0 ? near_texel : textureLod(columns, vec3(column_place, layer), 32.0).rgb;
#else
    return textureLod(columns, vec3(column_place, layer), column_level).rgb;
#endif
}
