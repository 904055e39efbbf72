// Blurs the wetness of the washes along one axis.
layout(binding = UNIT_SOURCE) uniform sampler2D from;
layout(location = UNIFORM_A) uniform ivec2 along;
layout(location = UNIFORM_B) uniform float radius; // pixels
out vec4 o_sum;

void main()
{
    ivec2 here = ivec2(gl_FragCoord.xy), last = textureSize(from, 0) - 1;
    vec2 sum = vec2(0.0);
    int reach = int(radius);
    for (int i = -reach; i <= reach; i++) {
        float x = float(i) / (radius + 1.0), weight = (1.0 - x * x) * (1.0 - x * x); // nearly a Gaussian
        sum += weight * vec2(texelFetch(from, clamp(here + i * along, ivec2(0), last), 0).w, 1.0);
    }
    o_sum = vec4(sum.x / sum.y);
}
