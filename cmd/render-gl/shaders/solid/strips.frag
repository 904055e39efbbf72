// Finds along one axis whether strips of paper meet near a sample: two samples meet if neither is farther from the
// other than the width of its border.
layout(binding = UNIT_SOURCE) uniform sampler2D from;
layout(location = UNIFORM_A) uniform ivec2 along;
out vec4 o_strip; // least and greatest number of a strip; widest border of other strips, or its own; its own

void main()
{
    ivec2 here = ivec2(gl_FragCoord.xy), last = textureSize(from, 0) - 1;
    vec4 own = texelFetch(from, here, 0);
    vec2 range = own.xy;
    float widest = own.x == own.y ? 0.0 : own.z;
    int reach = int(own.w);
    for (int i = -reach; i <= reach; i++) {
        vec4 near = texelFetch(from, clamp(here + i * along, ivec2(0), last), 0);
        vec2 joined = vec2(min(range.x, near.x), max(range.y, near.y));
        if (joined != own.xy && float(abs(i)) <= near.z) {
            range = joined;
            widest = max(widest, near.z);
        }
    }
    o_strip = vec4(range, range.x == range.y ? own.w : widest, own.w);
}
