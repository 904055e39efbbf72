#include "render-gl/columns.h"

#include <math.h>

#include "image/color.h"

const char *columns_name(enum columns_form form)
{
    if (form == COLUMNS_VOLUME)
        return "a volume (tamvol makes one)";
    return form == COLUMNS_THRESHOLDS ? "thresholds or exact runs (tamthresh makes them)"
                                      : "a tonal art map (tamgen makes one)";
}

/* Darkness of one texel as a byte. A coloured map seen in grey gives its luminance. */
static uint8_t ink_of(const struct hatch_image *image, size_t texel, uint32_t channel, bool color)
{
    const float *at = image->pixels + texel * image->channel_count;
    float light = channel < 3 && color ? at[channel] : at[0];
    if (channel == 3 && color)
        light = hatch_color_luminance(at);
    float ink = 255.0f * (1.0f - light);
    return ink <= 0.0f ? 0 : ink >= 255.0f ? 255 : (uint8_t)lrintf(ink);
}

/* Which columns of the map the six are. */
static uint32_t chosen_column(const struct gpu_columns *columns, uint32_t slot)
{
    return (slot + 1) * columns->map_count / columns->count - 1;
}

void columns_make_sampler(struct gpu_columns *columns, float anisotropy)
{
    glCreateSamplers(1, &columns->sampler);
    glSamplerParameteri(columns->sampler, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
    glSamplerParameteri(columns->sampler, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    glSamplerParameteri(columns->sampler, GL_TEXTURE_WRAP_S, GL_REPEAT);
    glSamplerParameteri(columns->sampler, GL_TEXTURE_WRAP_T, GL_REPEAT);
    glSamplerParameteri(columns->sampler, GL_TEXTURE_WRAP_R, GL_CLAMP_TO_EDGE);
    if (anisotropy > 1.0f)
        glSamplerParameterf(columns->sampler, GL_TEXTURE_MAX_ANISOTROPY, anisotropy);
}

static enum hatch_status upload_six(const struct hatch_tam *map, struct hatch_arena *scratch,
                                    struct gpu_columns *columns, struct hatch_err *err)
{
    GLsizei chain = (GLsizei)map->columns[0].level_count;
    glCreateTextures(GL_TEXTURE_2D_ARRAY, 1, &columns->texture);
    glTextureStorage3D(columns->texture, chain, GL_RGBA8, (GLsizei)map->size_px, (GLsizei)map->size_px, 2);
    for (uint32_t half = 0; half < 2; half++) {
        for (GLsizei level = 0; level < chain; level++) {
            struct hatch_arena_mark mark = hatch_arena_mark(scratch);
            uint32_t size = hatch_mip_size(map->size_px, (uint32_t)level);
            size_t count = (size_t)size * size;
            uint8_t *texels = HATCH_NEW(scratch, uint8_t, 4 * count, err);
            if (!texels)
                return HATCH_LIMIT;
            for (uint32_t c = 0; c < 4 && 2 * half + c < columns->count; c++) {
                uint32_t column = chosen_column(columns, 2 * half + c);
                const struct hatch_image *image = &map->columns[column].levels[level];
                for (size_t i = 0; i < count; i++)
                    texels[4 * i + c] = ink_of(image, i, 3, map->color);
            }
            glTextureSubImage3D(columns->texture, level, 0, 0, (GLint)half, (GLsizei)size, (GLsizei)size, 1, GL_RGBA,
                                GL_UNSIGNED_BYTE, texels);
            hatch_arena_rewind(scratch, mark);
        }
    }
    return HATCH_OK;
}

static enum hatch_status upload_array(const struct hatch_tam *map, struct hatch_arena *scratch,
                                      struct gpu_columns *columns, struct hatch_err *err)
{
    static const GLint grey[4] = {GL_RED, GL_RED, GL_RED, GL_ONE};
    GLsizei chain = (GLsizei)map->columns[0].level_count;
    uint32_t channels = map->color ? 4 : 1;
    glCreateTextures(GL_TEXTURE_2D_ARRAY, 1, &columns->texture);
    glTextureStorage3D(columns->texture, chain, map->color ? GL_RGBA8 : GL_R8, (GLsizei)map->size_px,
                       (GLsizei)map->size_px, (GLsizei)map->tones);
    if (!map->color)
        glTextureParameteriv(columns->texture, GL_TEXTURE_SWIZZLE_RGBA, grey);
    for (uint32_t tone = 0; tone < map->tones; tone++)
        for (GLsizei level = 0; level < chain; level++) {
            struct hatch_arena_mark mark = hatch_arena_mark(scratch);
            uint32_t size = hatch_mip_size(map->size_px, (uint32_t)level);
            size_t count = (size_t)size * size;
            uint8_t *texels = HATCH_NEW(scratch, uint8_t, channels * count, err);
            if (!texels)
                return HATCH_LIMIT;
            for (size_t i = 0; i < channels * count; i++)
                texels[i] =
                    ink_of(&map->columns[tone].levels[level], i / channels, (uint32_t)(i % channels), map->color);
            glTextureSubImage3D(columns->texture, level, 0, 0, (GLint)tone, (GLsizei)size, (GLsizei)size, 1,
                                map->color ? GL_RGBA : GL_RED, GL_UNSIGNED_BYTE, texels);
            hatch_arena_rewind(scratch, mark);
        }
    return HATCH_OK;
}

enum hatch_status columns_upload(const struct hatch_tam *map, enum columns_form form, float anisotropy,
                                 uint32_t size_max_px, struct hatch_arena *scratch, struct gpu_columns *columns,
                                 struct hatch_err *err)
{
    if (map->size_px > size_max_px)
        return hatch_fail(err, HATCH_LIMIT, "the map is %u texels wide, the GPU takes %u", map->size_px, size_max_px);
    struct gpu_columns made = {.form = form,
                               .size_px = map->size_px,
                               .levels = map->levels,
                               .count = map->tones,
                               .map_count = map->tones,
                               .layered = true,
                               .color = map->color && form == COLUMNS_ARRAY};
    if (form == COLUMNS_SIX && made.count > COLUMNS_SIX_MOST)
        made.count = COLUMNS_SIX_MOST;
    for (uint32_t i = 0; i < made.count; i++)
        made.targets[i] = map->target[chosen_column(&made, i)];
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    enum hatch_status status = HATCH_OK;
    if (form == COLUMNS_SIX)
        status = upload_six(map, scratch, &made, err);
    else if (form == COLUMNS_ARRAY)
        status = upload_array(map, scratch, &made, err);
    if (status == HATCH_OK && glGetError() == GL_OUT_OF_MEMORY)
        status =
            hatch_fail(err, HATCH_LIMIT, "the GPU has no memory for %u columns of %u texels", made.count, made.size_px);
    columns_make_sampler(&made, anisotropy);
    if (status == HATCH_OK)
        *columns = made;
    else
        columns_free(&made);
    return status;
}

/* In the sampler and not in the shader, where software renderers pay for it at each read. */
void columns_set_bias(const struct gpu_columns *columns, float levels)
{
    if (columns->sampler)
        glSamplerParameterf(columns->sampler, GL_TEXTURE_LOD_BIAS, levels);
}

void columns_free(struct gpu_columns *columns)
{
    glDeleteTextures(1, &columns->texture);
    glDeleteSamplers(1, &columns->sampler);
    *columns = (struct gpu_columns){0};
}
