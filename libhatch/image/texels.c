#include "image/texels.h"

#include <assert.h>

size_t hatch_texels_level_size(const struct hatch_texels *texture, uint32_t level)
{
    size_t width = hatch_mip_size(texture->width, level), height = hatch_mip_size(texture->height, level);
    uint32_t side = hatch_texels_block_side(texture->code);
    size_t plane = (width + side - 1) / side * ((height + side - 1) / side) *
                   hatch_texels_block_bytes(texture->code, texture->channels);
    if (texture->depth)
        return plane * hatch_mip_size(texture->depth, level);
    return plane * (texture->layers ? texture->layers : 1);
}

uint32_t hatch_texels_block_side(enum hatch_texels_code code)
{
    return code == HATCH_TEXELS_PLAIN || code == HATCH_TEXELS_R32UI ? 1 : 4;
}

uint32_t hatch_texels_block_bytes(enum hatch_texels_code code, uint32_t channels)
{
    static const uint32_t bytes[] = {
        [HATCH_TEXELS_BC1] = 8, [HATCH_TEXELS_BC4] = 8, [HATCH_TEXELS_BC7] = 16, [HATCH_TEXELS_R32UI] = 4};
    return code == HATCH_TEXELS_PLAIN ? channels : bytes[code];
}

uint32_t hatch_texels_chain_length(const struct hatch_texels *texture)
{
    uint32_t flat = hatch_mip_chain_length(texture->width, texture->height);
    uint32_t deep = texture->depth ? hatch_mip_chain_length(texture->depth, 1) : 1;
    return flat > deep ? flat : deep;
}

enum hatch_status hatch_texels_make(struct hatch_arena *arena, struct hatch_texels *texture, struct hatch_err *err)
{
    assert(texture->width > 0 && texture->height > 0);
    assert(texture->channels >= 1 && texture->channels <= 4);
    assert(!texture->depth || !texture->layers);
    assert(texture->level_count >= 1);
    assert(texture->level_count <= hatch_texels_chain_length(texture));
    struct hatch_texels made = *texture;
    for (uint32_t level = 0; level < made.level_count; level++) {
        HATCH_TRY(HATCH_ALLOC(arena, &made.texels[level], hatch_texels_level_size(&made, level), err));
    }
    *texture = made;
    return HATCH_OK;
}

const char *hatch_texels_value(const char *const *key_values, const char *key)
{
    for (; key_values && key_values[0]; key_values += 2)
        if (strcmp(key_values[0], key) == 0)
            return key_values[1];
    return NULL;
}
