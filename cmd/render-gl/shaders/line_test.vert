// Is a point of a line hidden? One result texel per point. Depth around the point counts, not only at
// it: a silhouette's own surface may rise before it on one side, never on both.
layout(binding = 0) uniform sampler2D depths;
layout(location = 0) uniform float samples_per_pixel;

layout(location = 0) in vec3 a_point; // pixels, and the depth over which a surface hides it

flat out uint v_visible;

const float REACH_PX = 1.25;
const ivec2 RESULT = ivec2(1024, 1024);

void main()
{
    ivec2 last = textureSize(depths, 0) - 1;
    float least = 1.0;
    for (int y = -1; y <= 1; y++)
        for (int x = -1; x <= 1; x++) {
            vec2 at = (a_point.xy + REACH_PX * vec2(x, y)) * samples_per_pixel;
            least = min(least, texelFetch(depths, clamp(ivec2(floor(at)), ivec2(0), last), 0).r);
        }
    v_visible = uint(least <= a_point.z);
    ivec2 texel = ivec2(gl_VertexID % RESULT.x, gl_VertexID / RESULT.x);
    gl_Position = vec4((vec2(texel) + 0.5) / vec2(RESULT) * 2.0 - 1.0, 0.5, 1.0);
}
