// Is a point of a line hidden? One result per point. Depth around the point counts, not only at it: a
// silhouette's own surface may rise before it on one side, never on both.
layout(binding = 0) uniform sampler2D depths;
layout(binding = 1) uniform sampler2D points; // pixels, and the depth over which a surface hides it
layout(location = 0) uniform float samples_per_pixel;

out uint o_visible;

const float REACH_PX = 1.25;

void main()
{
    vec3 point = texelFetch(points, ivec2(gl_FragCoord.xy), 0).xyz;
    ivec2 last = textureSize(depths, 0) - 1;
    float least = 1.0;
    for (int y = -1; y <= 1; y++)
        for (int x = -1; x <= 1; x++) {
            vec2 at = (point.xy + REACH_PX * vec2(x, y)) * samples_per_pixel;
            least = min(least, texelFetch(depths, clamp(ivec2(floor(at)), ivec2(0), last), 0).r);
        }
    o_visible = uint(least <= point.z);
}
