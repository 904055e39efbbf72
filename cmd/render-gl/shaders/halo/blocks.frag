// Finds the depth of the edge nearest to the eye in a block of cells.
#include "halo/halo.glsl"

out float o_depth;

void main()
{
    ivec2 corner = BLOCK * ivec2(gl_FragCoord.xy), after = min(corner + BLOCK, textureSize(halo_cells, 0));
    o_depth = 0.0;
    for (int y = corner.y; y < after.y; y++)
        for (int x = corner.x; x < after.x; x++)
            o_depth = max(o_depth, texelFetch(halo_cells, ivec2(x, y), 0).z);
}
