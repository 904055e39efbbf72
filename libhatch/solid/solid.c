#include "solid/solid.h"

#include <assert.h>
#include <stdbool.h>

static bool is_size(uint32_t size)
{
    return size >= HATCH_SOLID_SIZE_MIN && size <= HATCH_SOLID_SIZE_MAX && (size & (size - 1)) == 0;
}

enum hatch_status hatch_solid_make(struct hatch_arena *arena, uint32_t size, uint32_t channels,
                                   struct hatch_solid *solid, struct hatch_err *err)
{
    assert(is_size(size));
    assert(channels == 1 || channels == 3);
    struct hatch_solid made = {.size = size, .channels = channels};
    HATCH_TRY(HATCH_ALLOC(arena, &made.texels, (size_t)size * size * size * channels, err));
    *solid = made;
    return HATCH_OK;
}

/* Fills a level with the means of eight texels of the finer one.
 *   size  texels along a side of the coarser level */
static void fill_level(const uint8_t *finer, uint32_t size, uint32_t channels, uint8_t *texels)
{
    size_t row = 2 * (size_t)size * channels, plane = row * 2 * size;
    for (uint32_t z = 0; z < size; z++)
        for (uint32_t y = 0; y < size; y++) {
            const uint8_t *from = finer + 2 * z * plane + 2 * y * row;
            for (uint32_t x = 0; x < size; x++, from += channels)
                for (uint32_t c = 0; c < channels; c++, from++) {
                    const uint8_t *next = from + plane;
                    unsigned sum = (unsigned)from[0] + from[channels] + from[row] + from[row + channels] + next[0] +
                                   next[channels] + next[row] + next[row + channels];
                    *texels++ = (uint8_t)((sum + 4) / 8);
                }
        }
}

enum hatch_status hatch_solid_mips(const struct hatch_solid *solid, struct hatch_arena *arena,
                                   struct hatch_texels *texture, struct hatch_err *err)
{
    struct hatch_texels made = {
        .width = solid->size, .height = solid->size, .depth = solid->size, .channels = solid->channels};
    made.level_count = hatch_texels_chain_length(&made);
    made.texels[0] = solid->texels;
    for (uint32_t level = 1; level < made.level_count; level++) {
        HATCH_TRY(HATCH_ALLOC(arena, &made.texels[level], hatch_texels_level_size(&made, level), err));
        fill_level(made.texels[level - 1], solid->size >> level, solid->channels, made.texels[level]);
    }
    *texture = made;
    return HATCH_OK;
}

enum hatch_status hatch_solid_take(const struct hatch_texels *texture, struct hatch_arena *arena,
                                   struct hatch_solid *solid, struct hatch_err *err)
{
    if (!texture->depth)
        return hatch_fail(err, HATCH_BAD_INPUT, "a 2D texture, want a 3D one (solidgen makes it)");
    if (texture->code != HATCH_TEXELS_PLAIN || texture->channels == 2)
        return hatch_fail(err, HATCH_BAD_INPUT, "texels of a format other than R8, RGB8 and RGBA8");
    if (texture->width != texture->height || texture->width != texture->depth)
        return hatch_fail(err, HATCH_BAD_INPUT, "%ux%ux%u texels, want a cube", texture->width, texture->height,
                          texture->depth);
    if (!is_size(texture->width))
        return hatch_fail(err, HATCH_BAD_INPUT, "%u texels along a side, want a power of two from %u to %u",
                          texture->width, HATCH_SOLID_SIZE_MIN, HATCH_SOLID_SIZE_MAX);
    if (texture->channels != 4) {
        *solid = (struct hatch_solid){texture->width, texture->channels, texture->texels[0]};
        return HATCH_OK;
    }
    HATCH_TRY(hatch_solid_make(arena, texture->width, 3, solid, err));
    size_t count = (size_t)solid->size * solid->size * solid->size;
    for (size_t i = 0; i < count; i++)
        memcpy(solid->texels + 3 * i, texture->texels[0] + 4 * i, 3);
    return HATCH_OK;
}
