#include "io/container.h"

#include <assert.h>

#include "io/container_parts.h"

size_t hatch_texels_level_size(const struct hatch_texels *texture, uint32_t level)
{
    size_t plane = (size_t)hatch_mip_size(texture->width, level) *
                   hatch_mip_size(texture->height, level) * texture->channels;
    if (texture->depth)
        return plane * hatch_mip_size(texture->depth, level);
    return plane * (texture->layers ? texture->layers : 1);
}

uint32_t hatch_texels_chain_length(const struct hatch_texels *texture)
{
    uint32_t flat = hatch_mip_chain_length(texture->width, texture->height);
    uint32_t deep = texture->depth ? hatch_mip_chain_length(texture->depth, 1) : 1;
    return flat > deep ? flat : deep;
}

void hatch_texels_assert(const struct hatch_texels *texture)
{
    assert(texture->width > 0 && texture->height > 0);
    assert(texture->channels >= 1 && texture->channels <= 4);
    assert(!texture->depth || !texture->layers);
    assert(texture->level_count >= 1);
    assert(texture->level_count <= hatch_texels_chain_length(texture));
}
