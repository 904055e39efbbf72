#include "render-gl/fine.h"

#include <string.h>

#include "image/blocks.h"
#include "io/texture/container.h"
#include "tam/thresholds.h"
#include "tam/volume.h"

bool fine_is(struct hatch_bytes file)
{
    static const uint8_t identifier[] = {0xab, 'K', 'T', 'X', ' ', '2', '0', 0xbb};
    return file.size >= sizeof identifier && memcmp(file.data, identifier, sizeof identifier) == 0;
}

/* The mean darkness when all steps are taken. */
static float darkest_of(const struct hatch_thresholds *thresholds)
{
    const struct hatch_texels *texels = &thresholds->texels;
    size_t count = (size_t)texels->width * texels->height;
    const uint8_t *dy0 = texels->texels[0] + 4 * count * HATCH_THRESHOLD_DY0;
    const uint8_t *dy1 = texels->texels[0] + 4 * count * HATCH_THRESHOLD_DY1;
    uint64_t sum = 0;
    for (size_t i = 0; i < 4 * count; i++)
        sum += dy0[i] + (i % 4 < 3 ? dy1[i] : 0u);
    return (float)((double)sum / (255.0 * (double)count));
}

static enum hatch_status read_thresholds(const char *const *key_values, struct fine *fine, struct hatch_err *err)
{
    struct hatch_thresholds thresholds;
    HATCH_TRY(hatch_thresholds_from_texels(&fine->texels, key_values, &thresholds, err));
    fine->form = COLUMNS_THRESHOLDS;
    fine->levels = thresholds.levels;
    fine->darkest = darkest_of(&thresholds);
    return HATCH_OK;
}

static enum hatch_status read_exact(struct fine *fine, struct hatch_err *err)
{
    HATCH_TRY(hatch_exact_from_texels(&fine->texels, &fine->exact, err));
    fine->form = COLUMNS_THRESHOLDS;
    fine->size_px = fine->exact.size_px;
    fine->levels = fine->exact.levels;
    fine->darkest = hatch_exact_tone(&fine->exact, fine->exact.columns - 1);
    return HATCH_OK;
}

/* Packed texels are unpacked once, which finds what is wrong with them, and go to the GPU as they are. */
static enum hatch_status read_volume(const char *const *key_values, struct hatch_arena *scratch, struct fine *fine,
                                     struct hatch_err *err)
{
    struct hatch_arena_mark mark = hatch_arena_mark(scratch);
    struct hatch_texels plain;
    struct hatch_volume volume;
    enum hatch_status status = hatch_texels_decompress(&fine->texels, scratch, &plain, err);
    if (status == HATCH_OK)
        status = hatch_volume_from_texels(&plain, key_values, &volume, err);
    hatch_arena_rewind(scratch, mark);
    HATCH_TRY(status);
    fine->form = COLUMNS_VOLUME;
    fine->levels = volume.levels;
    fine->darkest = volume.darkest;
    return HATCH_OK;
}

enum hatch_status fine_read(struct hatch_bytes file, struct hatch_arena *arena, struct hatch_arena *scratch,
                            struct fine *fine, struct hatch_err *err)
{
    struct fine made = {0};
    const char *const *key_values;
    HATCH_TRY(hatch_ktx2_read(file, arena, &made.texels, err));
    HATCH_TRY(hatch_ktx2_read_keys(file, arena, &key_values, err));
    made.size_px = made.texels.width;
    if (made.texels.code == HATCH_TEXELS_R32UI)
        HATCH_TRY(read_exact(&made, err));
    else if (hatch_texels_value(key_values, HATCH_THRESHOLD_KEY_BORDERS))
        HATCH_TRY(read_thresholds(key_values, &made, err));
    else if (hatch_texels_value(key_values, HATCH_VOLUME_KEY_DARKEST))
        HATCH_TRY(read_volume(key_values, scratch, &made, err));
    else
        return hatch_fail(err, HATCH_BAD_INPUT,
                          "a texture that is no volume, no thresholds and no exact runs: "
                          "tamvol or tamthresh makes them");
    *fine = made;
    return HATCH_OK;
}

static GLenum format_of(const struct hatch_texels *texels)
{
    static const GLenum plain[] = {0, GL_R8, GL_RG8, GL_RGB8, GL_RGBA8};
    if (texels->code == HATCH_TEXELS_BC1)
        return GL_COMPRESSED_RGB_S3TC_DXT1_EXT;
    if (texels->code == HATCH_TEXELS_BC4)
        return GL_COMPRESSED_RED_RGTC1;
    if (texels->code == HATCH_TEXELS_BC7)
        return GL_COMPRESSED_RGBA_BPTC_UNORM;
    return plain[texels->channels];
}

static void upload_level(const struct hatch_texels *texels, uint32_t level, GLuint texture)
{
    static const GLenum layouts[] = {0, GL_RED, GL_RG, GL_RGB, GL_RGBA};
    GLsizei width = (GLsizei)hatch_mip_size(texels->width, level);
    GLsizei height = (GLsizei)hatch_mip_size(texels->height, level);
    GLsizei slices = (GLsizei)(texels->depth ? hatch_mip_size(texels->depth, level) : texels->layers);
    if (texels->code == HATCH_TEXELS_PLAIN)
        glTextureSubImage3D(texture, (GLint)level, 0, 0, 0, width, height, slices, layouts[texels->channels],
                            GL_UNSIGNED_BYTE, texels->texels[level]);
    else
        glCompressedTextureSubImage3D(texture, (GLint)level, 0, 0, 0, width, height, slices, format_of(texels),
                                      (GLsizei)hatch_texels_level_size(texels, level), texels->texels[level]);
}

/* OpenGL has no blocks of S3TC of its own, though every GPU does, and volumes of BPTC alone. */
static enum hatch_status check_texels(const struct hatch_texels *texels, struct hatch_err *err)
{
    if (texels->code == HATCH_TEXELS_BC1 && !epoxy_has_gl_extension("GL_EXT_texture_compression_s3tc"))
        return hatch_fail(err, HATCH_LIMIT, "the GPU reads no blocks of BC1: tamvol --layout volume makes BC7");
    if (texels->depth && (texels->code == HATCH_TEXELS_BC1 || texels->code == HATCH_TEXELS_BC4))
        return hatch_fail(err, HATCH_BAD_INPUT, "a 3D texture of BC1 or BC4, which OpenGL has in layers alone");
    GLint side, slices;
    glGetIntegerv(texels->depth ? GL_MAX_3D_TEXTURE_SIZE : GL_MAX_TEXTURE_SIZE, &side);
    glGetIntegerv(texels->depth ? GL_MAX_3D_TEXTURE_SIZE : GL_MAX_ARRAY_TEXTURE_LAYERS, &slices);
    uint32_t count = texels->depth ? texels->depth : texels->layers;
    if (texels->width > (uint32_t)side || texels->height > (uint32_t)side || count > (uint32_t)slices)
        return hatch_fail(err, HATCH_LIMIT, "the texture is %u texels wide and %u deep, the GPU takes %d and %d",
                          texels->width, count, side, slices);
    return HATCH_OK;
}

/* As whole numbers in rows of HATCH_EXACT_WIDTH, which shaders fetch one by one. */
static enum hatch_status upload_exact(const struct fine *fine, struct gpu_columns *columns, struct hatch_err *err)
{
    const struct hatch_texels *texels = &fine->texels;
    GLsizei width = (GLsizei)texels->width, height = (GLsizei)texels->height;
    GLint side;
    glGetIntegerv(GL_MAX_TEXTURE_SIZE, &side);
    if (height > side)
        return hatch_fail(err, HATCH_LIMIT, "exact runs of %d rows, the GPU takes %d", (int)height, side);
    struct gpu_columns made = {.form = fine->form,
                               .size_px = fine->exact.size_px,
                               .levels = fine->levels,
                               .count = fine->exact.columns,
                               .map_count = fine->exact.columns,
                               .exact = true,
                               .whole = fine->darkest >= 1};
    for (uint32_t i = 0; i < made.count; i++)
        made.targets[i] = hatch_exact_tone(&fine->exact, i);
    glCreateTextures(GL_TEXTURE_2D, 1, &made.texture);
    glTextureStorage2D(made.texture, 1, GL_R32UI, width, height);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
    glTextureSubImage2D(made.texture, 0, 0, 0, width, height, GL_RED_INTEGER, GL_UNSIGNED_INT, texels->texels[0]);
    columns_make_sampler(&made, 1);
    glSamplerParameteri(made.sampler, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glSamplerParameteri(made.sampler, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    if (glGetError() == GL_OUT_OF_MEMORY) {
        columns_free(&made);
        return hatch_fail(err, HATCH_LIMIT, "the GPU has no memory for %d rows of exact runs", (int)height);
    }
    *columns = made;
    return HATCH_OK;
}

enum hatch_status fine_upload(const struct fine *fine, float anisotropy, struct gpu_columns *columns,
                              struct hatch_err *err)
{
    if (fine->exact.columns)
        return upload_exact(fine, columns, err);
    static const GLint grey[4] = {GL_RED, GL_RED, GL_RED, GL_ONE};
    const struct hatch_texels *texels = &fine->texels;
    uint32_t slices = texels->depth ? texels->depth : texels->layers;
    HATCH_TRY(check_texels(texels, err));
    struct gpu_columns made = {.form = fine->form,
                               .size_px = texels->width,
                               .levels = fine->levels,
                               .count = slices,
                               .map_count = slices,
                               .color = texels->channels > 1,
                               .layered = !texels->depth,
                               .whole = fine->darkest >= 1};
    glCreateTextures(texels->depth ? GL_TEXTURE_3D : GL_TEXTURE_2D_ARRAY, 1, &made.texture);
    glTextureStorage3D(made.texture, (GLsizei)texels->level_count, format_of(texels), (GLsizei)texels->width,
                       (GLsizei)texels->height, (GLsizei)slices);
    if (texels->channels == 1)
        glTextureParameteriv(made.texture, GL_TEXTURE_SWIZZLE_RGBA, grey);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    for (uint32_t level = 0; level < texels->level_count; level++)
        upload_level(texels, level, made.texture);
    columns_make_sampler(&made, anisotropy);
    if (glGetError() == GL_OUT_OF_MEMORY) {
        columns_free(&made);
        return hatch_fail(err, HATCH_LIMIT, "the GPU has no memory for a texture %u texels wide and %u deep",
                          texels->width, slices);
    }
    *columns = made;
    return HATCH_OK;
}
