// Places a square for each block of cells that the halo of an edge may reach; other squares are clipped.
#include "halo/halo.glsl"

flat out float v_nearest; // depth of the nearest edge whose halo may reach the block

void main()
{
    ivec2 blocks = textureSize(halo_blocks, 0), block = ivec2(gl_InstanceID % blocks.x, gl_InstanceID / blocks.x);
    int reach = (int(halo_sizes.x / halo_sizes.y) + 2 + BLOCK - 1) / BLOCK;
    float nearest = 0.0;
    for (int y = max(block.y - reach, 0); y <= min(block.y + reach, blocks.y - 1); y++)
        for (int x = max(block.x - reach, 0); x <= min(block.x + reach, blocks.x - 1); x++)
            nearest = max(nearest, texelFetch(halo_blocks, ivec2(x, y), 0).r);
    vec2 corner = float(BLOCK) * halo_sizes.y * vec2(block + ivec2(gl_VertexID & 1, gl_VertexID >> 1));
    gl_Position = vec4(corner / vec2(textureSize(halo_depths, 0)) * 2.0 - 1.0, 0.0, 1.0);
    v_nearest = nearest;
    if (nearest <= 0.0)
        gl_Position = vec4(0.0, 0.0, -1.0, 1.0);
}
