/* Uploads tonal art maps, with the mip levels of their files: up to six columns in grey, or all columns. */
#include <math.h>

#include "image/color.h"
#include "render-gl/assets/asset.h"
#include "render-gl/gpu/buffer.h"
#include "render-gl/gpu/texture.h"

/* Returns the ink of one texel in a channel, 0 .. 255. Of a coloured map, channels 0 to 2 are R G B, and channel 3 is
 * computed from the luminance. */
static uint8_t ink_of(const struct hatch_image *image, size_t texel, uint32_t channel, bool color)
{
    const float *at = image->pixels + texel * image->channel_count;
    float light = channel < 3 && color ? at[channel] : at[0];
    if (channel == 3 && color)
        light = hatch_color_luminance(at);
    float ink = 255.0f * (1.0f - light);
    return ink <= 0.0f ? 0 : ink >= 255.0f ? 255 : (uint8_t)lrintf(ink);
}

/* Returns the index of the slot-th column when `of` columns of the whole map are chosen at even distances; the darkest
 * one is always among them. Of a map that is not whole, the last column stands for those that it lacks. */
static uint32_t chosen_column(const struct hatch_tam *map, uint32_t of, uint32_t slot)
{
    uint32_t column = (slot + 1) * map->whole.tones / of - 1;
    return column < map->tones ? column : map->tones - 1;
}

/* Returns how many of them the map has. */
static uint32_t count_chosen(const struct hatch_tam *map, uint32_t of)
{
    uint32_t count = 1;
    while (chosen_column(map, of, count - 1) < map->tones - 1)
        count++;
    return count;
}

/* One mip level of one layer of the texture. */
struct image {
    const struct hatch_tam *map;
    uint32_t count; /* columns on the GPU */
    uint32_t of;    /* columns that would be on the GPU if the map were whole */
    uint32_t layer, level, channels;
    size_t texel_count;
    uint8_t *texels; /* out: texel_count * channels */
};

/* Fills the four channels of one of two layers. The first layer holds columns 1 to 4 and the second 3 to 6, so that two
 * neighbouring columns, which shaders blend, are always in one layer. */
static void fill_six(const struct image *image)
{
    for (uint32_t c = 0; c < 4 && 2 * image->layer + c < image->count; c++) {
        uint32_t column = chosen_column(image->map, image->of, 2 * image->layer + c);
        const struct hatch_image *from = &image->map->columns[column].levels[image->level];
        for (size_t i = 0; i < image->texel_count; i++)
            image->texels[4 * i + c] = ink_of(from, i, 3, image->map->color);
    }
}

static void fill_column(const struct image *image)
{
    const struct hatch_image *from = &image->map->columns[image->layer].levels[image->level];
    for (size_t i = 0; i < image->channels * image->texel_count; i++)
        image->texels[i] = ink_of(from, i / image->channels, (uint32_t)(i % image->channels), image->map->color);
}

/* How a map is laid out in a texture. */
struct form {
    uint32_t of; /* as in struct image */
    uint32_t layers, channels;
    void (*fill)(const struct image *image); /* computes the texels of one image */
};

static enum hatch_status fill_layers(const struct hatch_tam *map, const struct form *form, GLuint texture,
                                     struct hatch_arena *scratch, struct hatch_err *err)
{
    uint32_t count = count_chosen(map, form->of);
    for (uint32_t layer = 0; layer < form->layers; layer++)
        for (uint32_t level = 0; level < map->columns[0].level_count; level++) {
            struct hatch_arena_mark mark = hatch_arena_mark(scratch);
            GLsizei size = (GLsizei)hatch_mip_size(map->size_px, level);
            struct image image = {.map = map,
                                  .count = count,
                                  .of = form->of,
                                  .layer = layer,
                                  .level = level,
                                  .channels = form->channels,
                                  .texel_count = (size_t)size * (size_t)size};
            image.texels = HATCH_NEW(scratch, uint8_t, image.channels * image.texel_count, err);
            if (!image.texels)
                return HATCH_LIMIT;
            form->fill(&image);
            glTextureSubImage3D(texture, (GLint)level, 0, 0, (GLint)layer, size, size, 1,
                                image.channels == 4 ? GL_RGBA : GL_RED, GL_UNSIGNED_BYTE, image.texels);
            hatch_arena_rewind(scratch, mark);
        }
    return HATCH_OK;
}

static enum hatch_status upload(const struct hatch_tam *map, const struct form *form, uint32_t size_max_px,
                                struct hatch_arena *scratch, struct asset_tones *tones, struct hatch_err *err)
{
    tones->layered = true;
    tones->count = count_chosen(map, form->of);
    if (map->size_px > size_max_px)
        return hatch_fail(err, HATCH_LIMIT, "the map is %u texels wide, the GPU's limit is %u", map->size_px,
                          size_max_px);
    for (uint32_t i = 0; i < tones->count; i++)
        tones->targets[i] = map->target[chosen_column(map, form->of, i)];
    tones->texture = gpu_texture_make(GL_TEXTURE_2D_ARRAY, (GLsizei)map->columns[0].level_count,
                                      form->channels == 1 ? GL_R8 : GL_RGBA8, map->size_px, map->size_px, form->layers);
    if (form->channels == 1)
        gpu_texture_read_grey(tones->texture);
    HATCH_TRY(fill_layers(map, form, tones->texture, scratch, err));
    return gpu_check_memory(err, "%u columns of %u texels", tones->count, map->size_px);
}

static enum hatch_status upload_six(const struct asset *asset, uint32_t size_max_px, struct hatch_arena *scratch,
                                    struct asset_tones *tones, struct hatch_err *err)
{
    uint32_t whole = asset->map.whole.tones, of = whole < ASSET_SIX_COLUMNS_MAX ? whole : ASSET_SIX_COLUMNS_MAX;
    return upload(&asset->map, &(struct form){of, 2, 4, fill_six}, size_max_px, scratch, tones, err);
}

static enum hatch_status upload_columns(const struct asset *asset, uint32_t size_max_px, struct hatch_arena *scratch,
                                        struct asset_tones *tones, struct hatch_err *err)
{
    const struct hatch_tam *map = &asset->map;
    return upload(map, &(struct form){map->whole.tones, map->tones, map->color ? 4 : 1, fill_column}, size_max_px,
                  scratch, tones, err);
}

#define MAP_NAME "a tonal art map (tamgen makes one)"
const struct asset_kind asset_six_columns = {MAP_NAME, asset_is_map, upload_six};
const struct asset_kind asset_columns = {MAP_NAME, asset_is_map, upload_columns};
