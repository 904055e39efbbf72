#include "shared/texels.h"

#include <stdio.h>
#include <strings.h>

#include "io/texture/container.h"
#include "io/exr/exr.h"

/* State of making the parts of an EXR in parallel. */
struct parts {
    const struct cmd_texture *texture;
    struct hatch_exr_writer *writer;
    uint32_t level_count;
    size_t max_memory;
    struct result {
        enum hatch_status status;
        struct hatch_err err;
    } * results;
};

bool cmd_is_exr_path(const char *path)
{
    size_t length = path ? strlen(path) : 0;
    return length >= 4 && strcasecmp(path + length - 4, ".exr") == 0;
}

static void unpack_slice(const struct hatch_texels *texels, uint32_t level, uint32_t slice, struct hatch_image *image)
{
    size_t count = (size_t)image->width * image->height * image->channel_count;
    const uint8_t *from = texels->texels[level] + slice * count;
    for (size_t i = 0; i < count; i++)
        image->pixels[i] = (float)from[i] / 255;
}

static enum hatch_status make_part(const struct parts *parts, uint32_t part, struct hatch_arena *arena,
                                   struct hatch_image *levels, struct hatch_mipmap *mipmap, struct hatch_err *err)
{
    static const char *const letters[] = {"", "Y", "RG", "RGB", "RGBA"};
    const struct cmd_texture *texture = parts->texture;
    const struct hatch_texels *texels = texture->texels;
    *mipmap = (struct hatch_mipmap){.level_count = parts->level_count, .levels = levels};
    if (texture->layer_names)
        snprintf(mipmap->name, sizeof mipmap->name, "%s", texture->layer_names[part]);
    else
        snprintf(mipmap->name, sizeof mipmap->name, "slice.%03u", part);
    for (const char *const *pair = texture->key_values; pair[0]; pair += 2)
        hatch_mipmap_set_text(mipmap, pair[0], pair[1]);
    for (uint32_t level = 0; level < parts->level_count; level++) {
        HATCH_TRY(hatch_image_make(arena, hatch_mip_size(texels->width, level), hatch_mip_size(texels->height, level),
                                   letters[texels->channels], &levels[level], err));
        uint32_t last = texels->depth ? hatch_mip_size(texels->depth, level) - 1 : part;
        uint32_t slice = texels->depth ? part >> level : part;
        unpack_slice(texels, level, slice < last ? slice : last, &levels[level]);
    }
    return HATCH_OK;
}

static void add_part(void *context, uint32_t part)
{
    const struct parts *parts = context;
    struct result *result = &parts->results[part];
    struct hatch_image levels[HATCH_MIP_LEVELS_MAX];
    struct hatch_mipmap mipmap;
    struct hatch_arena arena;
    hatch_arena_init(&arena, parts->max_memory);
    result->status = make_part(parts, part, &arena, levels, &mipmap, &result->err);
    if (result->status == HATCH_OK)
        result->status = hatch_exr_add_part(parts->writer, part, &mipmap, &result->err);
    hatch_arena_free(&arena);
}

static enum hatch_status encode_exr(struct cmd_args *args, const struct cmd_texture *texture, struct hatch_buffer *file,
                                    struct hatch_err *err)
{
    const struct hatch_texels *texels = texture->texels;
    uint32_t count = texels->depth ? texels->depth : texels->layers ? texels->layers : 1;
    struct hatch_image levels[HATCH_MIP_LEVELS_MAX];
    struct hatch_mipmap base;
    struct parts parts = {.texture = texture,
                          .max_memory = args->max_memory,
                          .level_count = hatch_mip_chain_length(texels->width, texels->height)};
    struct hatch_arena_mark mark = hatch_arena_mark(&args->scratch);
    HATCH_TRY(make_part(&parts, 0, &args->scratch, levels, &base, err));
    HATCH_TRY(hatch_exr_begin(&base, count, &args->keep, &parts.writer, err));
    hatch_arena_rewind(&args->scratch, mark);
    parts.results = HATCH_NEW(&args->keep, struct result, count, err);
    enum hatch_status status = parts.results ? HATCH_OK : HATCH_LIMIT;
    if (status == HATCH_OK)
        hatch_parallel_for(cmd_pool(args), count, add_part, &parts);
    for (uint32_t i = 0; i < count && status == HATCH_OK; i++) {
        status = parts.results[i].status;
        if (status != HATCH_OK)
            *err = parts.results[i].err;
    }
    if (status == HATCH_OK)
        return hatch_exr_end(parts.writer, file, err);
    hatch_exr_abandon(parts.writer);
    return status;
}

void cmd_encode_texture(struct cmd_args *args, const struct cmd_texture *texture, const char *path,
                        struct hatch_buffer *file)
{
    struct hatch_err err;
    enum hatch_status status = cmd_is_exr_path(path)
                                   ? encode_exr(args, texture, file, &err)
                                   : hatch_ktx2_write(texture->texels, texture->key_values, file, &err);
    cmd_check(status, path, &err);
}
