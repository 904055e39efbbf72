// Finds the distance of each pixel from the edge of its strip, along y and then, with these distances, along x: the
// exact distance within reach. Pixels at an edge count by the share that their strip covers, as in Gustavson and
// Strand, "Anti-aliased Euclidean distance transform" (2011).
layout(binding = UNIT_SOURCE) uniform sampler2D from;
layout(location = UNIFORM_A) uniform ivec2 along;
layout(location = UNIFORM_B) uniform float reach; // pixels
out vec4 o_strip; // number of the strip; distance along y, later from the edge, in pixels; share of the pixel that the
                  // strip covers; width of its border

void main()
{
    ivec2 here = ivec2(gl_FragCoord.xy), last = textureSize(from, 0) - 1;
    vec4 own = texelFetch(from, here, 0);
    int most = int(ceil(reach));
    float distance = reach + 1.0;
    for (int i = -most; i <= most; i++) {
        vec4 near = texelFetch(from, clamp(here + i * along, ivec2(0), last), 0);
        float covered = near.x == own.x ? near.z : 1.0 - near.z;
        if (near.x == own.x && along.x == 1)
            distance = min(distance, length(vec2(i, near.y)));
        else if (covered < 1.0)
            distance = min(distance, max(abs(float(i)) + covered - 0.5, 0.0));
    }
    o_strip = vec4(own.x, distance, own.zw);
}
