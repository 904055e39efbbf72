// Reading the columns of the tonal art map, in the fragment stage.
layout(binding = 0) uniform sampler2DArray columns;

// Where a pixel covers more tiles than this, along any side of it, no stroke shows: only the mean of the
// tile is left, the coarsest level. An anisotropic read there would take samples by the thousand.
const float TILES_MAX = 8.0;

vec3 read_columns(vec2 texcoord, float layer)
{
    vec2 tiles = fwidth(texcoord);
    bool far = !(max(tiles.x, tiles.y) <= TILES_MAX);
    vec3 near_texel = texture(columns, vec3(far ? vec2(0.0) : texcoord, layer)).rgb;
    return far ? textureLod(columns, vec3(0.0, 0.0, layer), 32.0).rgb : near_texel;
}
