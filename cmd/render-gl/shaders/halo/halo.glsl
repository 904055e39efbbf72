// Computes how much of a place is covered by the haloes of nearer edges. Places are measured in samples from the lower
// left corner of the depth buffer.
#ifdef HALOES
layout(std140, binding = BLOCK_HALOES) uniform Halo {
    vec4 halo_sizes; // width of haloes, a cell's side, a pixel's side
    vec4 halo_depth; // factors from differences and ratios of depth to half heights of the picture; smallest jump;
                     // shift of depth (view/view.h)
};
layout(binding = UNIT_HALO_BLOCKS) uniform sampler2D halo_blocks;  // depth of the nearest edge in 8 by 8 cells
layout(binding = UNIT_HALO_DEPTHS) uniform sampler2D halo_depths; // 1 near .. 0 far; 0: no surface
layout(binding = UNIT_HALO_CELLS) uniform sampler2D halo_cells;  // x, y, depth of the nearest edge; depth 0: none

const int BLOCK = 8;         // cells along a block's side
const float BESIDE_PX = 1.5; // edges nearer than this to a feature line are those that the line itself runs along

float depth_of(ivec2 at)
{
    return texelFetch(halo_depths, clamp(at, ivec2(0), textureSize(halo_depths, 0) - 1), 0).r;
}

// Returns the distance between the points at two depths, in half heights of the picture at the nearer one.
float jump_between(float nearer, float farther)
{
    float inverse = nearer + halo_depth.w; // of the distance, but for a factor
    return halo_depth.x * (nearer - farther) +
           halo_depth.y * (inverse / max(farther + halo_depth.w, max(1e-3 * inverse, 1e-30)) - 1.0);
}

const float STEEP = 3.0; // least ratio of a jump to the change by slope; at the rim of a ball the ratio is only 2.4

// Returns whether the neighbour of a sample in direction `way` lies behind it by much more than the slope
// explains.
bool is_edge(ivec2 at, float depth, ivec2 way)
{
    ivec2 last = textureSize(halo_depths, 0) - 1;
    bool known = all(equal(clamp(at - way, ivec2(0), last) + 3 * way, clamp(at + 2 * way, ivec2(0), last)));
    float behind = depth_of(at + way), slope = max(depth_of(at - way) - depth, behind - depth_of(at + 2 * way));
    return known && behind < depth && depth - behind > STEEP * slope && jump_between(depth, behind) > halo_depth.z;
}

const float NO_DEPTH = 2.0; // nearer than any edge

// Returns the depth of the nearest sample that is on the surface at a place and beside that place, because at a rim the
// sample itself lies far behind the others. Returns NO_DEPTH if not asked: software renderers continue after `discard`,
// and this keeps their later loops empty.
float depth_around(ivec2 at, bool asked)
{
    float nearest = asked ? depth_of(at) : NO_DEPTH;
    int count = asked ? 9 : 0;
    for (int i = 0; i < count; i++) {
        ivec2 way = ivec2(i % 3, i / 3) - 1;
        float depth = depth_of(at + way);
        nearest = depth > nearest && !is_edge(at + way, depth, -way) ? depth : nearest;
    }
    return nearest;
}

// Returns the slope of depth along x or y: the smaller of the two differences, since the other may cross an edge.
float slope_along(ivec2 at, ivec2 way)
{
    float depth = depth_of(at), after = depth_of(at + way) - depth, before = depth - depth_of(at - way);
    return abs(after) < abs(before) ? after : before;
}

vec2 slope_of(ivec2 at)
{
    return vec2(slope_along(at, ivec2(1, 0)), slope_along(at, ivec2(0, 1)));
}

// Returns the share, 0 .. 1, of a place that haloes cover. depth, slope: those of the surface there. The surface is
// continued by its slope to each edge; the edge has a halo if it lies far enough in front of it. along: unit direction
// of a feature line through the place, where edges that the line itself runs along do not count; 0: no line.
float halo_over(vec2 at, float depth, vec2 slope, vec2 along)
{
    float share = 0.0, reach = halo_sizes.x, cell = halo_sizes.y;
    ivec2 last = textureSize(halo_cells, 0) - 1;
    ivec2 low = clamp(ivec2(floor((at - reach) / cell)) - 1, ivec2(0), last);
    ivec2 high = clamp(ivec2(floor((at + reach) / cell)) + 1, ivec2(0), last);
    for (int by = low.y / BLOCK; by <= high.y / BLOCK; by++)
        for (int bx = low.x / BLOCK; bx <= high.x / BLOCK; bx++) {
            if (jump_between(texelFetch(halo_blocks, ivec2(bx, by), 0).r, depth) <= halo_depth.z)
                continue;
            ivec2 from = max(low, BLOCK * ivec2(bx, by)), to = min(high, BLOCK * ivec2(bx, by) + BLOCK - 1);
            for (int y = from.y; y <= to.y; y++)
                for (int x = from.x; x <= to.x; x++) {
                    vec3 edge = texelFetch(halo_cells, ivec2(x, y), 0).xyz;
                    vec2 away = edge.xy - at;
                    float jump = jump_between(edge.z, max(depth, depth + dot(slope, away)));
                    float cover = clamp(reach + 1.0 - length(away), 0.0, 1.0); // 0.5 at half a sample beyond the reach
                    bool own = along != vec2(0.0) &&
                               abs(along.x * away.y - along.y * away.x) < BESIDE_PX * halo_sizes.z;
                    cover *= own || edge.z <= depth ? 0.0 : clamp(jump / halo_depth.z - 1.0, 0.0, 1.0);
                    share = max(share, cover);
                }
        }
    return share;
}

// Does the same for a point of a feature line, given in pixels. Of the samples around the point, the one with the most
// similar depth is taken for the line's surface.
float halo_over_line(vec2 at_px, float depth, vec2 along)
{
    vec2 at = at_px * halo_sizes.z;
    ivec2 middle = ivec2(floor(at)), best = middle;
    for (int y = -1; y <= 1; y++)
        for (int x = -1; x <= 1; x++) {
            ivec2 other = middle + ivec2(x, y) * int(halo_sizes.z);
            if (abs(depth_of(other) - depth) < abs(depth_of(best) - depth))
                best = other;
        }
    return halo_over(at, depth, slope_of(best), along / max(length(along), 1e-6));
}
#endif
