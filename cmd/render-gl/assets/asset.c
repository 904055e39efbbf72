#include "render-gl/assets/asset.h"

#include <assert.h>
#include <math.h>
#include <string.h>

#include "io/texture/container.h"
#include "render-gl/gpu/bindings.h"
#include "render-gl/gpu/texture.h"
#include "shared/map.h"
#include "stroke/script.h"
#include "tam/volume.h"

/* Reads the list of a map's strokes. Without one, those that no texel names are not drawn. */
static enum hatch_status read_strokes(struct asset *asset, struct hatch_arena *arena, struct hatch_err *err)
{
    const struct hatch_mipmap *last = &asset->map.columns[asset->map.tones - 1];
    const struct hatch_attribute *list = hatch_mipmap_attribute(last, HATCH_TAM_ATTR_STROKES);
    if (!list || list->type != HATCH_ATTRIBUTE_TEXT)
        return HATCH_OK;
    const struct hatch_bytes text = {(const uint8_t *)list->text, strlen(list->text)};
    if (hatch_script_parse(text, asset->map.size_px, arena, &asset->strokes, err) != HATCH_OK)
        return hatch_fail_at(err, HATCH_TAM_ATTR_STROKES ": ");
    return HATCH_OK;
}

void asset_read(struct cmd_args *args, const char *path, struct asset *asset)
{
    const char *name = cmd_input_name(path);
    struct hatch_bytes file = cmd_read(args, path);
    struct hatch_err err;
    *asset = (struct asset){.map.tones = 0};
    if (hatch_ktx2_is(file))
        cmd_check(tone_texture_read(file, &args->keep, &args->scratch, &asset->texture, &err), name, &err);
    else {
        cmd_parse_map(args, name, file, &asset->map);
        cmd_check(read_strokes(asset, &args->keep, &err), name, &err);
    }
}

bool asset_is_map(const struct asset *asset)
{
    return asset->map.tones > 0;
}

bool asset_is_colored(const struct asset *asset)
{
    const struct tone_texture *texture = &asset->texture;
    return asset_is_map(asset) ? asset->map.color
                               : texture->holds == TONE_TEXTURE_VOLUME && texture->texels.channels >= 3;
}

float asset_darkest(const struct asset *asset)
{
    return asset_is_map(asset) ? asset->map.whole.darkest : asset->texture.darkest;
}

uint32_t asset_size_px(const struct asset *asset)
{
    return asset_is_map(asset) ? asset->map.size_px : asset->texture.size_px;
}

uint32_t asset_levels(const struct asset *asset)
{
    return asset_is_map(asset) ? asset->map.levels : asset->texture.levels;
}

uint32_t asset_dense_levels(const struct asset *asset)
{
    if (asset->texture.holds == TONE_TEXTURE_VOLUME && asset->texture.texels.depth)
        return hatch_volume_dense_levels(&asset->texture.texels, asset->texture.levels, (double)asset->texture.top);
    return asset_levels(asset);
}

struct asset_part asset_part(const struct asset *asset)
{
    const struct hatch_tam *map = &asset->map;
    const struct tone_texture *texture = &asset->texture;
    if (asset_is_map(asset) && hatch_tam_is_whole(map))
        return (struct asset_part){.tolerance = 0};
    if (asset_is_map(asset))
        return (struct asset_part){map->tones < map->whole.tones, map->size_px < map->whole.size_px,
                                   map->target[map->tones - 1], map->whole.tolerance};
    return (struct asset_part){texture->whole.tolerance > 0 && texture->last < texture->whole.darkest,
                               texture->size_px < texture->whole.size_px, texture->last, texture->whole.tolerance};
}

uint32_t asset_whole_size_px(const struct asset *asset)
{
    return asset_is_map(asset) ? asset->map.whole.size_px : asset->texture.whole.size_px;
}

uint32_t asset_whole_levels(const struct asset *asset)
{
    uint32_t finer = 0, size_px = asset_size_px(asset);
    while (size_px && size_px << finer < asset_whole_size_px(asset))
        finer++;
    return asset_levels(asset) + finer;
}

bool assets_have(const struct assets *assets, const struct asset_kind *kind)
{
    return !kind || (assets->asset && kind->is(assets->asset));
}

/* Makes the sampler, which repeats the texture along u and v and clamps it along tone. */
static void make_sampler(struct asset_tones *tones, float anisotropy)
{
    GLint filter = tones->exact ? GL_NEAREST : GL_LINEAR;
    glCreateSamplers(1, &tones->sampler);
    glSamplerParameteri(tones->sampler, GL_TEXTURE_MIN_FILTER, tones->exact ? filter : GL_LINEAR_MIPMAP_LINEAR);
    glSamplerParameteri(tones->sampler, GL_TEXTURE_MAG_FILTER, filter);
    glSamplerParameteri(tones->sampler, GL_TEXTURE_WRAP_S, GL_REPEAT);
    glSamplerParameteri(tones->sampler, GL_TEXTURE_WRAP_T, GL_REPEAT);
    glSamplerParameteri(tones->sampler, GL_TEXTURE_WRAP_R, GL_CLAMP_TO_EDGE);
    if (anisotropy > 1.0f && !tones->exact)
        glSamplerParameterf(tones->sampler, GL_TEXTURE_MAX_ANISOTROPY, anisotropy);
}

static void free_tones(struct asset_tones *tones)
{
    glDeleteTextures(1, &tones->texture);
    glDeleteSamplers(1, &tones->sampler);
    *tones = (struct asset_tones){.count = 0};
}

enum hatch_status assets_upload(struct assets *assets, const struct asset_kind *kind, struct hatch_arena *scratch,
                                const struct asset_tones **tones, struct hatch_err *err)
{
    size_t i = 0;
    while (assets->uploaded[i].kind && assets->uploaded[i].kind != kind)
        i++;
    assert(i < sizeof assets->uploaded / sizeof *assets->uploaded);
    if (!assets->uploaded[i].kind) {
        struct asset_tones made = {.count = 0};
        enum hatch_status status = kind->upload(assets->asset, assets->limits.size_max_px, scratch, &made, err);
        if (status != HATCH_OK) {
            free_tones(&made);
            return status;
        }
        make_sampler(&made, assets->limits.anisotropy);
        assets->uploaded[i].tones = made;
        assets->uploaded[i].kind = kind;
    }
    *tones = &assets->uploaded[i].tones;
    return HATCH_OK;
}

void assets_free(struct assets *assets)
{
    for (size_t i = 0; i < sizeof assets->uploaded / sizeof *assets->uploaded; i++) {
        free_tones(&assets->uploaded[i].tones);
        assets->uploaded[i].kind = NULL;
    }
}

void asset_tones_use(const struct asset_tones *tones, float anisotropy, uint32_t side, struct frame_block *block)
{
    frame_block_set_tones(block, tones->targets, tones->count, tones->darkest);
    gpu_texture_bind(UNIT_TONES, tones->texture, tones->sampler);
    if (anisotropy > 1) /* the driver chooses the level; a bias in the shader would slow down software renderers */
        glSamplerParameterf(tones->sampler, GL_TEXTURE_LOD_BIAS, (float)log2(side));
}
