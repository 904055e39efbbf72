// Gives each narrow strip of paper to the nearest strip of the same item that is wide enough, so that borders do not
// merge into white specks.
layout(binding = UNIT_SOURCE) uniform sampler2D widths;
layout(location = UNIFORM_B) uniform float width; // of borders, in samples
layout(location = 0) out vec4 o_strip;            // number of the strip, twice; width of its border in samples, twice
layout(location = 1) out vec4 o_from;             // where its paper is taken from, in samples from here

void main()
{
    ivec2 here = ivec2(gl_FragCoord.xy), last = textureSize(widths, 0) - 1;
    vec4 own = texelFetch(widths, here, 0);
    o_strip = vec4(own.xx, own.z > 0.0 ? min(own.yy, own.ww) : own.yy);
    o_from = vec4(0.0);
    if (own.z == 0.0)
        return;
    int reach = int(ceil(6.0 * width));
    for (int i = 1; i <= reach; i++)
        for (int way = 0; way < 4; way++) {
            ivec2 towards = (way & 1) == 0 ? ivec2(way - 1, 0) : ivec2(0, way - 2), at = here + i * towards;
            vec4 near = texelFetch(widths, clamp(at, ivec2(0), last), 0);
            if (near.z == 0.0 && near.x > 0.0 && floor((near.x - 1.0) / 16.0) == floor((own.x - 1.0) / 16.0)) {
                o_strip = vec4(near.xx, near.yy);
                if (near.x != own.x)
                    o_from.xy = vec2(2 * i * towards); // as in a mirror at the edge of that strip
                return;
            }
        }
}
