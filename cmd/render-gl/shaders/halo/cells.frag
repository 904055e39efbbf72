// Finds the edge nearest to the eye in a cell. An edge is a sample with a neighbour that lies behind it by much more
// than the slope of the surfaces explains.
#include "halo/halo.glsl"

out vec4 o_edge;

// Returns whether depth may jump anywhere in a range of samples or next to it. Each read returns four depths.
bool jumps(ivec2 corner, ivec2 after)
{
    vec2 size = vec2(textureSize(halo_depths, 0));
    float nearest = 0.0, farthest = 1.0;
    for (int y = corner.y; y <= after.y; y += 2)
        for (int x = corner.x; x <= after.x; x += 2) {
            vec4 depths = textureGather(halo_depths, vec2(x, y) / size);
            nearest = max(nearest, max(max(depths.x, depths.y), max(depths.z, depths.w)));
            farthest = min(farthest, min(min(depths.x, depths.y), min(depths.z, depths.w)));
        }
    return jump_between(nearest, farthest) > halo_depth.z;
}

void main()
{
    ivec2 corner = ivec2(gl_FragCoord.xy) * int(halo_sizes.y), size = textureSize(halo_depths, 0);
    ivec2 after = min(corner + int(halo_sizes.y), size);
    vec3 edge = vec3(0.0);
    if (!jumps(corner, after))
        after = corner; // instead of an `if`: software renderers execute both branches, but skip empty loops
    for (int y = corner.y; y < after.y; y++)
        for (int x = corner.x; x < after.x; x++) {
            ivec2 at = ivec2(x, y);
            float depth = depth_of(at);
            if (depth > edge.z && (is_edge(at, depth, ivec2(1, 0)) || is_edge(at, depth, ivec2(-1, 0)) ||
                                   is_edge(at, depth, ivec2(0, 1)) || is_edge(at, depth, ivec2(0, -1))))
                edge = vec3(vec2(at) + 0.5, depth);
        }
    o_edge = vec4(edge, 0.0);
}
