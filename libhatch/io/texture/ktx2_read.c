#include <zstd.h>
#include <zstd_errors.h>

#include "io/texture/container.h"
#include "io/texture/parts.h"

#define SIDE_MAX (1u << 24)
#define PAIRS_ENTRY 56u /* position in the header of the offset and size of the key and value pairs */
#define SCHEME_NONE 0u
#define SCHEME_ZSTD 2u
/* Largest ratio of Zstandard: a block of at least four bytes holds at most 128 KiB. */
#define ZSTD_RATIO_MAX 32768u

static const uint8_t identifier[] = HATCH_KTX2_IDENTIFIER;

struct header {
    uint32_t vk_format, type_size, width, height, depth, layers, faces, levels, scheme;
};

/* The formats that are read. */
static const struct format {
    uint32_t vk_format, channels;
    enum hatch_texels_code code;
    bool srgb;
} formats[] = {
    {9, 1, HATCH_TEXELS_PLAIN, false},  {15, 1, HATCH_TEXELS_PLAIN, true},  {16, 2, HATCH_TEXELS_PLAIN, false},
    {22, 2, HATCH_TEXELS_PLAIN, true},  {23, 3, HATCH_TEXELS_PLAIN, false}, {29, 3, HATCH_TEXELS_PLAIN, true},
    {37, 4, HATCH_TEXELS_PLAIN, false}, {43, 4, HATCH_TEXELS_PLAIN, true},  {98, 1, HATCH_TEXELS_R32UI, false},
    {131, 3, HATCH_TEXELS_BC1, false},  {132, 3, HATCH_TEXELS_BC1, true},   {139, 1, HATCH_TEXELS_BC4, false},
    {145, 4, HATCH_TEXELS_BC7, false},  {146, 4, HATCH_TEXELS_BC7, true},
};

/* Returns the format of a VkFormat, or NULL. */
static const struct format *format_of(uint32_t vk_format)
{
    for (size_t i = 0; i < sizeof formats / sizeof *formats; i++)
        if (formats[i].vk_format == vk_format)
            return &formats[i];
    return NULL;
}

bool hatch_ktx2_is(struct hatch_bytes file)
{
    return file.size >= HATCH_KTX2_IDENTIFIER_BYTES && memcmp(file.data, identifier, HATCH_KTX2_IDENTIFIER_BYTES) == 0;
}

static enum hatch_status read_header(struct hatch_reader *reader, struct header *header, struct hatch_err *err)
{
    const uint8_t *first = hatch_read_bytes(reader, sizeof identifier);
    if (!first || memcmp(first, identifier, sizeof identifier) != 0)
        return hatch_fail(err, HATCH_BAD_INPUT, "not a KTX2 file");
    header->vk_format = hatch_read_u32(reader);
    header->type_size = hatch_read_u32(reader);
    header->width = hatch_read_u32(reader);
    header->height = hatch_read_u32(reader);
    header->depth = hatch_read_u32(reader);
    header->layers = hatch_read_u32(reader);
    header->faces = hatch_read_u32(reader);
    header->levels = hatch_read_u32(reader);
    header->scheme = hatch_read_u32(reader);
    hatch_read_bytes(reader, HATCH_KTX2_HEADER_BYTES - HATCH_KTX2_IDENTIFIER_BYTES - 9 * 4);
    if (reader->cut)
        return hatch_fail(err, HATCH_BAD_INPUT, "truncated in the header: %zu bytes, want %u", reader->size,
                          HATCH_KTX2_HEADER_BYTES);
    return HATCH_OK;
}

static enum hatch_status check_header(const struct header *header, struct hatch_texels *texture, struct hatch_err *err)
{
    const struct format *format = format_of(header->vk_format);
    if (!format)
        return hatch_fail(err, HATCH_BAD_INPUT,
                          "VkFormat %u is not supported; use 8 bits per channel, BC1, BC4, BC7 or R32UI",
                          header->vk_format);
    uint32_t type_size = format->code == HATCH_TEXELS_R32UI ? 4 : 1;
    if (header->type_size != type_size)
        return hatch_fail(err, HATCH_BAD_INPUT, "typeSize %u, want %u", header->type_size, type_size);
    if (header->faces != 1)
        return hatch_fail(err, HATCH_BAD_INPUT, "%u faces, want 1: cube maps are not supported", header->faces);
    if (header->scheme != SCHEME_NONE && header->scheme != SCHEME_ZSTD)
        return hatch_fail(err, HATCH_BAD_INPUT, "supercompression %u is not supported; use none or Zstandard",
                          header->scheme);
    if (header->width < 1 || header->width > SIDE_MAX || header->height < 1 || header->height > SIDE_MAX ||
        header->depth > SIDE_MAX || header->layers > SIDE_MAX)
        return hatch_fail(err, HATCH_BAD_INPUT, "%ux%ux%u texels, %u layers, want 1 to %u", header->width,
                          header->height, header->depth, header->layers, SIDE_MAX);
    if (header->depth && header->layers)
        return hatch_fail(err, HATCH_BAD_INPUT, "arrays of 3D textures are not supported");
    *texture = (struct hatch_texels){.width = header->width,
                                     .height = header->height,
                                     .depth = header->depth,
                                     .layers = header->layers,
                                     .channels = format->channels,
                                     .level_count = header->levels ? header->levels : 1,
                                     .code = format->code,
                                     .srgb = format->srgb};
    if (texture->level_count > hatch_texels_chain_length(texture))
        return hatch_fail(err, HATCH_BAD_INPUT, "%u levels, want at most %u", texture->level_count,
                          hatch_texels_chain_length(texture));
    return HATCH_OK;
}

/* Returns the bytes of a level; a double, since the product may overflow an integer. */
static double level_bytes(const struct hatch_texels *texture, uint32_t level)
{
    uint32_t side = hatch_texels_block_side(texture->code);
    double slices = texture->depth ? hatch_mip_size(texture->depth, level) : (texture->layers ? texture->layers : 1);
    double blocks = (double)((hatch_mip_size(texture->width, level) + side - 1) / side) *
                    ((hatch_mip_size(texture->height, level) + side - 1) / side);
    return slices * blocks * hatch_texels_block_bytes(texture->code, texture->channels);
}

static enum hatch_status check_memory(const struct hatch_texels *texture, const struct hatch_arena *arena,
                                      struct hatch_err *err)
{
    double total = 0;
    for (uint32_t level = 0; level < texture->level_count; level++)
        total += level_bytes(texture, level);
    size_t available = arena->limit_bytes - arena->used_bytes;
    if (total > (double)available)
        return hatch_fail(err, HATCH_LIMIT, "%.0f bytes of texels, more than the %zu allowed", total, available);
    return HATCH_OK;
}

static bool is_text(const uint8_t *bytes, size_t size)
{
    return size > 0 && memchr(bytes, 0, size) == bytes + size - 1;
}

/* A key and its value, which is text that ends with a zero, in the file; without value: it is no text. */
struct pair {
    const char *key, *value;
};

/* Opens the key and value pairs of a file. */
static enum hatch_status open_pairs(struct hatch_bytes file, struct hatch_reader *pairs, struct hatch_err *err)
{
    struct hatch_reader reader = hatch_reader_of(file);
    reader.at = PAIRS_ENTRY;
    uint32_t offset = hatch_read_u32(&reader), size = hatch_read_u32(&reader);
    if (offset > file.size || size > file.size - offset)
        return hatch_fail(err, HATCH_BAD_INPUT, "truncated: the key and value pairs end after the file's %zu bytes",
                          file.size);
    *pairs = hatch_reader_of((struct hatch_bytes){file.data + offset, size});
    return HATCH_OK;
}

/* Reads a key, its terminating zero and a value, padded to four bytes. */
static enum hatch_status read_pair(struct hatch_reader *reader, struct pair *pair, struct hatch_err *err)
{
    uint32_t size = hatch_read_u32(reader);
    const uint8_t *key = hatch_read_bytes(reader, size);
    if (reader->cut)
        return hatch_fail(err, HATCH_BAD_INPUT, "truncated in the key and value pairs");
    const uint8_t *end = size ? memchr(key, 0, size) : NULL;
    size_t padding = (4 - size % 4) % 4, key_size = end ? (size_t)(end - key) : 0;
    if (hatch_reader_left(reader) >= padding)
        hatch_read_bytes(reader, padding);
    bool has_text = end && is_text(end + 1, size - key_size - 1);
    *pair = (struct pair){(const char *)key, has_text ? (const char *)end + 1 : NULL};
    return HATCH_OK;
}

/* Returns the orientation of the axes in a file, "rd" or "rdi" if it names none; damaged pairs name none. */
static const char *orientation_of(struct hatch_bytes file, const struct hatch_texels *texture)
{
    struct hatch_reader pairs;
    struct pair pair;
    enum hatch_status status = open_pairs(file, &pairs, NULL);
    while (status == HATCH_OK && hatch_reader_left(&pairs) > 0) {
        status = read_pair(&pairs, &pair, NULL);
        if (status == HATCH_OK && pair.value && strcmp(pair.key, "KTXorientation") == 0)
            return pair.value;
    }
    return texture->depth ? "rdi" : "rd";
}

/* Finds out whether the rows of a file run from the bottom up. Fails for other orientations than the usual one. */
static enum hatch_status check_orientation(struct hatch_bytes file, const struct hatch_texels *texture, bool *turned,
                                           struct hatch_err *err)
{
    const char *orientation = orientation_of(file, texture);
    *turned = strcmp(orientation, texture->depth ? "rui" : "ru") == 0;
    if (!*turned && strcmp(orientation, texture->depth ? "rdi" : "rd") != 0)
        return hatch_fail(err, HATCH_BAD_INPUT, "KTXorientation %.8s is not supported; want %s", orientation,
                          texture->depth ? "rdi or rui" : "rd or ru");
    if (*turned && hatch_texels_block_side(texture->code) > 1)
        return hatch_fail(err, HATCH_BAD_INPUT,
                          "rows of compressed blocks run from the bottom up (KTXorientation %s): store them from the "
                          "top down",
                          orientation);
    return HATCH_OK;
}

/* Turns the rows of each slice of a level upside down. */
static void turn_rows(const struct hatch_texels *texture, uint32_t level)
{
    uint32_t height = hatch_mip_size(texture->height, level);
    size_t row =
        (size_t)hatch_mip_size(texture->width, level) * hatch_texels_block_bytes(texture->code, texture->channels);
    size_t slices = hatch_texels_level_size(texture, level) / (row * height);
    for (size_t slice = 0; slice < slices; slice++) {
        uint8_t *top = texture->texels[level] + slice * row * height;
        for (uint32_t y = 0; y < height / 2; y++)
            for (size_t i = 0; i < row; i++) {
                uint8_t *a = top + y * row + i, *b = top + (height - 1 - y) * row + i, kept = *a;
                *a = *b;
                *b = kept;
            }
    }
}

static enum hatch_status decompress(struct hatch_bytes packed, uint8_t *texels, size_t size, uint32_t level,
                                    struct hatch_err *err)
{
    size_t got = ZSTD_decompress(texels, size, packed.data, packed.size);
    if (ZSTD_getErrorCode(got) == ZSTD_error_memory_allocation)
        return hatch_fail(err, HATCH_LIMIT, "level %u: out of memory in Zstandard", level);
    if (ZSTD_isError(got))
        return hatch_fail_quoting(err, HATCH_BAD_INPUT, ZSTD_getErrorName(got),
                                  "level %u: its Zstandard data is damaged", level);
    if (got != size)
        return hatch_fail(err, HATCH_BAD_INPUT, "level %u: unpacked to %zu bytes, want %zu", level, got, size);
    return HATCH_OK;
}

static enum hatch_status read_level(struct hatch_reader *reader, const struct header *header, uint32_t level,
                                    struct hatch_arena *arena, struct hatch_texels *texture, struct hatch_err *err)
{
    uint64_t offset = hatch_read_u64(reader), length = hatch_read_u64(reader);
    uint64_t unpacked = hatch_read_u64(reader);
    if (reader->cut)
        return hatch_fail(err, HATCH_BAD_INPUT, "truncated in the level index");
    if (offset > reader->size || length > reader->size - offset)
        return hatch_fail(err, HATCH_BAD_INPUT, "truncated: level %u ends after the file's %zu bytes", level,
                          reader->size);
    size_t size = hatch_texels_level_size(texture, level);
    bool packed = header->scheme == SCHEME_ZSTD;
    if (unpacked != size || (!packed && length != size) || (packed && size / ZSTD_RATIO_MAX > length))
        return hatch_fail(err, HATCH_BAD_INPUT,
                          "level %u is damaged: %llu bytes stored, %llu unpacked, want %zu unpacked", level,
                          (unsigned long long)length, (unsigned long long)unpacked, size);
    uint8_t *texels;
    HATCH_TRY(HATCH_ALLOC(arena, &texels, size, err));
    texture->texels[level] = texels;
    const uint8_t *from = reader->data + offset;
    if (packed)
        return decompress((struct hatch_bytes){from, (size_t)length}, texels, size, level, err);
    memcpy(texels, from, size);
    return HATCH_OK;
}

static enum hatch_status read_levels(struct hatch_reader *reader, const struct header *header,
                                     struct hatch_arena *arena, struct hatch_texels *texture, struct hatch_err *err)
{
    for (uint32_t level = 0; level < texture->level_count; level++)
        HATCH_TRY(read_level(reader, header, level, arena, texture, err));
    return HATCH_OK;
}

enum hatch_status hatch_ktx2_read(struct hatch_bytes file, struct hatch_arena *arena, struct hatch_texels *texture,
                                  struct hatch_err *err)
{
    struct hatch_reader reader = hatch_reader_of(file);
    struct header header = {0};
    struct hatch_texels made;
    bool turned = false;
    HATCH_TRY(read_header(&reader, &header, err));
    HATCH_TRY(check_header(&header, &made, err));
    HATCH_TRY(check_memory(&made, arena, err));
    HATCH_TRY(check_orientation(file, &made, &turned, err));
    struct hatch_arena_mark mark = hatch_arena_mark(arena);
    enum hatch_status status = read_levels(&reader, &header, arena, &made, err);
    for (uint32_t level = 0; status == HATCH_OK && turned && level < made.level_count; level++)
        turn_rows(&made, level);
    if (status == HATCH_OK)
        *texture = made;
    else
        hatch_arena_rewind(arena, mark);
    return status;
}

enum hatch_status hatch_ktx2_read_keys(struct hatch_bytes file, struct hatch_arena *arena,
                                       const char *const **key_values, struct hatch_err *err)
{
    struct hatch_reader reader = hatch_reader_of(file), pairs;
    struct header header = {0};
    HATCH_TRY(read_header(&reader, &header, err));
    HATCH_TRY(open_pairs(file, &pairs, err));
    /* A pair takes at least eight bytes. */
    const char **made = HATCH_NEW(arena, const char *, pairs.size / 8 * 2 + 3, err);
    if (!made)
        return HATCH_LIMIT;
    uint32_t count = 0;
    while (hatch_reader_left(&pairs) > 0) {
        struct pair pair;
        HATCH_TRY(read_pair(&pairs, &pair, err));
        if (!pair.value)
            continue;
        made[count] = hatch_arena_text(arena, pair.key, strlen(pair.key), err);
        made[count + 1] = hatch_arena_text(arena, pair.value, strlen(pair.value), err);
        if (!made[count] || !made[count + 1])
            return HATCH_LIMIT;
        count += 2;
    }
    made[count] = NULL;
    *key_values = made;
    return HATCH_OK;
}
