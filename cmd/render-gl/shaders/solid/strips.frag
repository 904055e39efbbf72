// Finds along one axis whether strips of paper meet near a sample.
layout(binding = UNIT_SOURCE) uniform sampler2D from;
layout(location = UNIFORM_A) uniform ivec2 along;
layout(location = UNIFORM_B) uniform float width; // samples
out vec4 o_strip; // least and greatest number of a strip; width of the border relative to the usual

void main()
{
    ivec2 here = ivec2(gl_FragCoord.xy), last = textureSize(from, 0) - 1;
    vec4 own = texelFetch(from, here, 0);
    float relative = along.x == 0 ? own.y : own.z;
    vec2 range = vec2(own.x, along.x == 0 ? own.x : own.y);
    int reach = int(width * relative);
    for (int i = -reach; i <= reach; i++) {
        vec2 near = texelFetch(from, clamp(here + i * along, ivec2(0), last), 0).xy;
        range = vec2(min(range.x, near.x), max(range.y, along.x == 0 ? near.x : near.y));
    }
    o_strip = vec4(range, relative, 0.0);
}
