#include "solid/solid.h"

#include <assert.h>
#include <math.h>
#include <stdbool.h>

static bool is_size(uint32_t size)
{
    return size >= HATCH_SOLID_SIZE_MIN && size <= HATCH_SOLID_SIZE_MAX && (size & (size - 1)) == 0;
}

enum hatch_status hatch_solid_make_like(struct hatch_arena *arena, const struct hatch_solid *like, uint32_t size,
                                        uint32_t channels, struct hatch_solid *solid, struct hatch_err *err)
{
    assert(is_size(size));
    assert(channels == 1 || channels == 3);
    struct hatch_solid made = {.size = size, .channels = channels, .depth = like->depth > 1 ? size : 1};
    HATCH_TRY(HATCH_ALLOC(arena, &made.texels, hatch_solid_count(&made) * channels, err));
    *solid = made;
    return HATCH_OK;
}

enum hatch_status hatch_solid_make(struct hatch_arena *arena, uint32_t size, uint32_t channels,
                                   struct hatch_solid *solid, struct hatch_err *err)
{
    return hatch_solid_make_like(arena, &(struct hatch_solid){.depth = size}, size, channels, solid, err);
}

/* Computes a row of a flat texture: means over the image's pixels under each texel. */
static void fill_row(const struct hatch_image *image, const struct hatch_solid *solid, uint32_t y)
{
    double down = (double)image->height / solid->size, across = (double)image->width / solid->size;
    for (uint32_t x = 0; x < solid->size; x++) {
        double sum[3] = {0}, area = 0;
        double left = x * across, right = left + across, top = y * down, bottom = top + down;
        for (uint32_t row = (uint32_t)top; row < image->height && row < bottom; row++)
            for (uint32_t column = (uint32_t)left; column < image->width && column < right; column++) {
                double part =
                    (fmin(row + 1.0, bottom) - fmax(row, top)) * (fmin(column + 1.0, right) - fmax(column, left));
                const float *pixel = image->pixels + ((size_t)row * image->width + column) * image->channel_count;
                for (uint32_t c = 0; c < solid->channels; c++)
                    sum[c] += part * (double)pixel[c];
                area += part;
            }
        for (uint32_t c = 0; c < solid->channels; c++)
            solid->texels[((size_t)y * solid->size + x) * solid->channels + c] = hatch_unorm8((float)(sum[c] / area));
    }
}

enum hatch_status hatch_solid_of_image(const struct hatch_image *image, struct hatch_arena *arena,
                                       struct hatch_solid *solid, struct hatch_err *err)
{
    uint32_t size = HATCH_SOLID_SIZE_MIN, longer = image->width > image->height ? image->width : image->height;
    while (size < longer && size < HATCH_SOLID_SIZE_MAX)
        size *= 2;
    HATCH_TRY(hatch_solid_make_like(arena, &(struct hatch_solid){.depth = 1}, size, image->channel_count >= 3 ? 3 : 1,
                                    solid, err));
    for (uint32_t y = 0; y < size; y++)
        fill_row(image, solid, y);
    return HATCH_OK;
}

/* Fills a level with the means of the texels of the finer one.
 *   coarser  size and depth of the level
 *   flat     the texture is flat: what lies below a texel is the texel itself */
static void fill_level(const uint8_t *finer, const struct hatch_solid *coarser, bool flat, uint8_t *texels)
{
    size_t channels = coarser->channels, row = 2 * (size_t)coarser->size * channels, plane = row * 2 * coarser->size;
    size_t next = flat ? 0 : plane;
    for (uint32_t z = 0; z < coarser->depth; z++)
        for (uint32_t y = 0; y < coarser->size; y++) {
            const uint8_t *from = finer + 2 * z * next + 2 * y * row;
            for (uint32_t x = 0; x < coarser->size; x++, from += channels)
                for (uint32_t c = 0; c < channels; c++, from++) {
                    const uint8_t *deep = from + next;
                    unsigned sum = (unsigned)from[0] + from[channels] + from[row] + from[row + channels] + deep[0] +
                                   deep[channels] + deep[row] + deep[row + channels];
                    *texels++ = (uint8_t)((sum + 4) / 8);
                }
        }
}

enum hatch_status hatch_solid_mips(const struct hatch_solid *solid, struct hatch_arena *arena,
                                   struct hatch_texels *texture, struct hatch_err *err)
{
    struct hatch_texels made = {
        .width = solid->size, .height = solid->size, .depth = solid->depth, .channels = solid->channels};
    made.level_count = hatch_texels_chain_length(&made);
    made.texels[0] = solid->texels;
    for (uint32_t level = 1; level < made.level_count; level++) {
        const struct hatch_solid coarser = {
            .size = solid->size >> level, .channels = solid->channels, .depth = hatch_mip_size(solid->depth, level)};
        HATCH_TRY(HATCH_ALLOC(arena, &made.texels[level], hatch_texels_level_size(&made, level), err));
        fill_level(made.texels[level - 1], &coarser, solid->depth == 1, made.texels[level]);
    }
    *texture = made;
    return HATCH_OK;
}

static enum hatch_status check_shape(uint32_t width, uint32_t height, uint32_t depth, struct hatch_err *err)
{
    if (width != height || (depth > 1 && width != depth))
        return hatch_fail(err, HATCH_BAD_INPUT, "%ux%ux%u texels, want a cube or a square", width, height, depth);
    if (!is_size(width))
        return hatch_fail(err, HATCH_BAD_INPUT, "%u texels along a side, want a power of two from %u to %u", width,
                          HATCH_SOLID_SIZE_MIN, HATCH_SOLID_SIZE_MAX);
    return HATCH_OK;
}

bool hatch_solid_is_slices(const struct hatch_mipmap *parts, uint32_t count)
{
    return count > 1 && strcmp(parts[0].name, "slice.000") == 0;
}

/* Copies a slice.
 *   names  a letter for each channel of the solid texture */
static enum hatch_status copy_slice(const struct hatch_image *image, uint32_t slice, const char *names,
                                    struct hatch_solid *solid, struct hatch_err *err)
{
    size_t count = (size_t)solid->size * solid->size;
    if (image->width != solid->size || image->height != solid->size)
        return hatch_fail(err, HATCH_BAD_INPUT, "slice %u: %ux%u texels, the first one has %ux%u", slice, image->width,
                          image->height, solid->size, solid->size);
    for (uint32_t c = 0; c < solid->channels; c++) {
        int from = hatch_image_channel(image, (const char[]){names[c], '\0'});
        if (from < 0)
            return hatch_fail(err, HATCH_BAD_INPUT, "slice %u: no channel %c, want Y, or R, G and B", slice, names[c]);
        for (size_t i = 0; i < count; i++)
            solid->texels[(slice * count + i) * solid->channels + c] =
                hatch_unorm8(image->pixels[i * image->channel_count + (size_t)from]);
    }
    return HATCH_OK;
}

enum hatch_status hatch_solid_of_slices(const struct hatch_mipmap *parts, uint32_t count, struct hatch_arena *arena,
                                        struct hatch_solid *solid, struct hatch_err *err)
{
    const struct hatch_image *first = &parts[0].levels[0];
    const struct hatch_attribute *isotropic = hatch_mipmap_attribute(&parts[0], HATCH_SOLID_KEY_ISOTROPIC);
    const char *names = hatch_image_channel(first, "Y") >= 0 ? "Y" : "RGB";
    struct hatch_solid made;
    HATCH_TRY(check_shape(first->width, first->height, count, err));
    struct hatch_arena_mark mark = hatch_arena_mark(arena);
    HATCH_TRY(hatch_solid_make(arena, first->width, (uint32_t)strlen(names), &made, err));
    enum hatch_status status = HATCH_OK;
    for (uint32_t slice = 0; slice < count && status == HATCH_OK; slice++)
        status = copy_slice(&parts[slice].levels[0], slice, names, &made, err);
    if (status != HATCH_OK) {
        hatch_arena_rewind(arena, mark);
        return status;
    }
    made.isotropic = isotropic && isotropic->type == HATCH_ATTRIBUTE_TEXT && strcmp(isotropic->text, "yes") == 0;
    *solid = made;
    return HATCH_OK;
}

enum hatch_status hatch_solid_take(const struct hatch_texels *texture, struct hatch_arena *arena,
                                   struct hatch_solid *solid, struct hatch_err *err)
{
    uint32_t depth = texture->depth ? texture->depth : 1;
    if (texture->layers)
        return hatch_fail(err, HATCH_BAD_INPUT, "an array of %u textures, want one texture (solidgen makes it)",
                          texture->layers);
    if (texture->code != HATCH_TEXELS_PLAIN || texture->channels == 2)
        return hatch_fail(err, HATCH_BAD_INPUT, "texels of a format other than R8, RGB8 and RGBA8");
    HATCH_TRY(check_shape(texture->width, texture->height, depth, err));
    if (texture->channels != 4 && !texture->srgb) {
        *solid = (struct hatch_solid){
            .size = texture->width, .channels = texture->channels, .texels = texture->texels[0], .depth = depth};
        return HATCH_OK;
    }
    uint8_t values[256]; /* of each code */
    for (unsigned code = 0; code < 256; code++)
        values[code] = texture->srgb ? hatch_unorm8(hatch_srgb_to_linear((float)code / 255)) : (uint8_t)code;
    HATCH_TRY(hatch_solid_make_like(arena, &(struct hatch_solid){.depth = depth}, texture->width,
                                    texture->channels == 1 ? 1 : 3, solid, err));
    for (size_t i = 0; i < hatch_solid_count(solid); i++)
        for (uint32_t c = 0; c < solid->channels; c++)
            solid->texels[i * solid->channels + c] = values[texture->texels[0][i * texture->channels + c]];
    return HATCH_OK;
}
