/* samples FOLDER: writes sample files of every kind beside NAME.raw, which holds the texels as
 * another program must read them: level after level; of EXR files part after part, as floats,
 * channels in the order that NAME.channels names. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/random.h"
#include "io/container.h"
#include "io/exr.h"

static struct hatch_arena arena;
static struct hatch_err err;

static void check(enum hatch_status status)
{
    if (status == HATCH_OK)
        return;
    fprintf(stderr, "samples: %s\n", err.text);
    exit((int)status);
}

static void save(const char *folder, const char *name, const char *ending, const void *data,
                 size_t size)
{
    char path[512];
    snprintf(path, sizeof path, "%s/%s%s", folder, name, ending);
    FILE *file = fopen(path, "wb");
    if (!file || fwrite(data, 1, size, file) != size || fclose(file) != 0) {
        fprintf(stderr, "samples: cannot write %s\n", path);
        exit(HATCH_IO);
    }
}

static const struct {
    const char *name;
    struct hatch_texels texels;
    bool dds;
} textures[] = {
    {"rgba", {.width = 64, .height = 64, .channels = 4, .level_count = 7}, true},
    {"rgb-odd", {.width = 37, .height = 11, .channels = 3, .level_count = 6}, false},
    {"r-array", {.width = 16, .height = 16, .layers = 6, .channels = 1, .level_count = 5}, true},
    {"rg-one", {.width = 9, .height = 7, .layers = 1, .channels = 2, .level_count = 3}, true},
    {"rgba-array", {.width = 8, .height = 8, .layers = 3, .channels = 4, .level_count = 4}, true},
    {"rgba-volume", {.width = 8, .height = 4, .depth = 19, .channels = 4, .level_count = 5}, true},
};

static void save_textures(const char *folder)
{
    for (size_t i = 0; i < sizeof textures / sizeof *textures; i++) {
        struct hatch_texels texture = textures[i].texels;
        struct hatch_buffer raw = {.arena = &arena}, file = {.arena = &arena}, dds = file;
        check(hatch_texels_make(&arena, &texture, &err));
        for (uint32_t level = 0; level < texture.level_count; level++) {
            size_t size = hatch_texels_level_size(&texture, level);
            for (size_t at = 0; at < size; at++)
                texture.texels[level][at] = (uint8_t)hatch_random_u64(i, level, at);
            check(hatch_buffer_add(&raw, texture.texels[level], size, &err));
        }
        check(hatch_ktx2_write(&texture, NULL, &file, &err));
        save(folder, textures[i].name, ".ktx2", file.data, file.size);
        save(folder, textures[i].name, ".ktx2.raw", raw.data, raw.size);
        if (!textures[i].dds)
            continue;
        check(hatch_dds_write(&texture, &dds, &err));
        save(folder, textures[i].name, ".dds", dds.data, dds.size);
        save(folder, textures[i].name, ".dds.raw", raw.data, raw.size);
    }
}

static const struct {
    const char *name, *letters, *channels;
    uint32_t width, height, parts;
    bool mips;
} pictures[] = {
    {"grey", "Y", "Y", 256, 256, 6, true},         {"grey-odd", "Y", "Y", 517, 300, 2, true},
    {"ids", "Yit", "Y id t", 300, 300, 3, true},   {"colour", "RGB", "R G B", 77, 130, 2, true},
    {"flat", "RGBA", "R G B A", 45, 33, 1, false}, {"dot", "Y", "Y", 1, 1, 2, true},
};

/* Halves of all sizes and signs, some of them alike; whole ids; floats. */
static float texel(const struct hatch_channel *channel, uint64_t stream, uint64_t index)
{
    uint64_t bits = hatch_random_u64(77, stream, index);
    if (channel->type == HATCH_UINT)
        return (float)(bits % 16777217u);
    if (channel->type == HATCH_FLOAT)
        return (float)((double)bits * 0x1p-64);
    return index % 7 < 3 ? 1 : hatch_float_from_half((uint16_t)(bits & 0xbfff));
}

static void fill_part(size_t kind, uint32_t part, struct hatch_mipmap *mipmap,
                      struct hatch_buffer *raw)
{
    uint32_t width = pictures[kind].width, height = pictures[kind].height;
    mipmap->level_count = pictures[kind].mips ? hatch_mip_chain_length(width, height) : 1;
    for (uint32_t l = 0; l < mipmap->level_count; l++) {
        struct hatch_image *level = &mipmap->levels[l];
        check(hatch_image_make(&arena, hatch_mip_size(width, l), hatch_mip_size(height, l),
                               pictures[kind].letters, level, &err));
        int id = hatch_image_channel(level, "i"), t = hatch_image_channel(level, "t");
        if (id >= 0)
            level->channels[id] = (struct hatch_channel){"id", HATCH_UINT};
        if (t >= 0)
            level->channels[t].type = HATCH_FLOAT;
        size_t count = (size_t)level->width * level->height * level->channel_count;
        for (size_t i = 0; i < count; i++)
            level->pixels[i] = texel(&level->channels[i % level->channel_count], part * 40 + l, i);
        check(hatch_buffer_add(raw, level->pixels, count * sizeof(float), &err));
    }
    snprintf(mipmap->name, sizeof mipmap->name, "part.%u", part);
    hatch_mipmap_set_number(mipmap, "hatch:tone", 0.25 * part, HATCH_ATTRIBUTE_FLOAT);
}

static void save_pictures(const char *folder)
{
    for (size_t i = 0; i < sizeof pictures / sizeof *pictures; i++) {
        struct hatch_buffer raw = {.arena = &arena}, file = {.arena = &arena};
        struct hatch_exr_writer *writer = NULL;
        for (uint32_t part = 0; part < pictures[i].parts; part++) {
            struct hatch_image levels[HATCH_MIP_LEVELS_MAX];
            struct hatch_mipmap mipmap = {.levels = levels};
            fill_part(i, part, &mipmap, &raw);
            if (!writer)
                check(hatch_exr_begin(&mipmap, pictures[i].parts, &arena, &writer, &err));
            check(hatch_exr_add_part(writer, part, &mipmap, &err));
        }
        check(hatch_exr_end(writer, &file, &err));
        save(folder, pictures[i].name, ".exr", file.data, file.size);
        save(folder, pictures[i].name, ".exr.raw", raw.data, raw.size);
        save(folder, pictures[i].name, ".exr.channels", pictures[i].channels,
             strlen(pictures[i].channels));
    }
}

int main(int argc, char **argv)
{
    if (argc != 2) {
        fprintf(stderr, "usage: samples FOLDER\n");
        return HATCH_USAGE;
    }
    hatch_arena_init(&arena, (size_t)1 << 30);
    save_textures(argv[1]);
    save_pictures(argv[1]);
    hatch_arena_free(&arena);
    return 0;
}
