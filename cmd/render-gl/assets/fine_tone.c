/* Uploads volumes, threshold textures and exact runs in the format of their files, block-compressed or not. */
#include "render-gl/assets/asset.h"
#include "render-gl/gpu/buffer.h"
#include "render-gl/gpu/texture.h"

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

/* Fails if the GPU cannot read the texels. S3TC (BC1) is not in core OpenGL, but in an extension that desktop GPUs
 * have. Of the block formats, only BPTC (BC7) is allowed in 3D textures. */
static enum hatch_status check_texels(const struct hatch_texels *texels, struct hatch_err *err)
{
    if (texels->code == HATCH_TEXELS_BC1 && !epoxy_has_gl_extension("GL_EXT_texture_compression_s3tc"))
        return hatch_fail(err, HATCH_LIMIT, "the GPU cannot read BC1: tamvol --compress --layout volume writes BC7");
    if (texels->depth && (texels->code == HATCH_TEXELS_BC1 || texels->code == HATCH_TEXELS_BC4))
        return hatch_fail(err, HATCH_BAD_INPUT, "a 3D texture of BC1 or BC4, which OpenGL supports in 2D arrays only");
    GLint side, slices;
    glGetIntegerv(texels->depth ? GL_MAX_3D_TEXTURE_SIZE : GL_MAX_TEXTURE_SIZE, &side);
    glGetIntegerv(texels->depth ? GL_MAX_3D_TEXTURE_SIZE : GL_MAX_ARRAY_TEXTURE_LAYERS, &slices);
    uint32_t count = texels->depth ? texels->depth : texels->layers;
    if (texels->width > (uint32_t)side || texels->height > (uint32_t)side || count > (uint32_t)slices)
        return hatch_fail(err, HATCH_LIMIT, "the texture is %u texels wide and %u deep, the GPU's limits are %d and %d",
                          texels->width, count, side, slices);
    return HATCH_OK;
}

/* Uploads exact runs: integers in rows of HATCH_EXACT_WIDTH, which shaders fetch one by one. */
static enum hatch_status upload_runs(const struct asset *asset, struct asset_tones *tones, struct hatch_err *err)
{
    const struct hatch_exact *exact = &asset->texture.exact;
    const struct hatch_texels *texels = &asset->texture.texels;
    GLint side;
    glGetIntegerv(GL_MAX_TEXTURE_SIZE, &side);
    if (texels->height > (uint32_t)side)
        return hatch_fail(err, HATCH_LIMIT, "the exact runs have %u rows, the GPU's limit is %d", texels->height, side);
    tones->exact = true;
    tones->count = exact->columns;
    for (uint32_t i = 0; i < exact->columns; i++)
        tones->targets[i] = hatch_exact_tone(exact, i);
    tones->texture = gpu_texture_2d(GL_R32UI, texels->width, texels->height);
    glTextureSubImage2D(tones->texture, 0, 0, 0, (GLsizei)texels->width, (GLsizei)texels->height, GL_RED_INTEGER,
                        GL_UNSIGNED_INT, texels->texels[0]);
    return gpu_check_memory(err, "%u rows of exact runs", texels->height);
}

static enum hatch_status upload_texels(const struct asset *asset, struct asset_tones *tones, struct hatch_err *err)
{
    const struct hatch_texels *texels = &asset->texture.texels;
    uint32_t slices = texels->depth ? texels->depth : texels->layers;
    HATCH_TRY(check_texels(texels, err));
    tones->count = slices;
    tones->layered = !texels->depth;
    if (asset->texture.holds == TONE_TEXTURE_VOLUME) {
        const struct asset_part part = asset_part(asset);
        tones->targets[0] = (float)slices / asset->texture.top;
        tones->darkest = part.cut_tones ? part.last : asset->texture.darkest;
    }
    tones->texture = gpu_texture_make(texels->depth ? GL_TEXTURE_3D : GL_TEXTURE_2D_ARRAY, (GLsizei)texels->level_count,
                                      format_of(texels), texels->width, texels->height, slices);
    if (texels->channels == 1)
        gpu_texture_read_grey(tones->texture);
    for (uint32_t level = 0; level < texels->level_count; level++)
        upload_level(texels, level, tones->texture);
    return gpu_check_memory(err, "a texture %u texels wide and %u deep", texels->width, slices);
}

static enum hatch_status upload(const struct asset *asset, uint32_t size_max_px, struct hatch_arena *scratch,
                                struct asset_tones *tones, struct hatch_err *err)
{
    (void)size_max_px;
    (void)scratch;
    return asset->texture.holds == TONE_TEXTURE_RUNS ? upload_runs(asset, tones, err)
                                                     : upload_texels(asset, tones, err);
}

static bool is_volume(const struct asset *asset)
{
    return asset->texture.holds == TONE_TEXTURE_VOLUME;
}

static bool is_thresholds(const struct asset *asset)
{
    return asset->texture.holds == TONE_TEXTURE_THRESHOLDS || asset->texture.holds == TONE_TEXTURE_RUNS;
}

const struct asset_kind asset_volume = {"a volume (tamvol makes one)", is_volume, upload};
const struct asset_kind asset_thresholds = {"thresholds or exact runs (tamthresh makes them)", is_thresholds, upload};
