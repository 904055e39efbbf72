/* Writes KTX2: KTX File Format Specification 2.0 (Khronos), sections 3 to 5, and, for the data format descriptor, the
 * Khronos Data Format Specification 1.3, section 5. */
#include <assert.h>

#include "io/texture/container.h"
#include "io/texture/parts.h"

#define PAIRS_MAX 16u
#define DESCRIPTOR_HEAD_BYTES 24u
#define SAMPLE_BYTES 16u

/* VkFormat by number of channels, 8 bits each, UNORM. */
static const uint32_t vk_formats[] = {0, 9, 16, 23, 37};

/* Values for each code: the VkFormat (of PLAIN: see vk_formats); colour model, bits and largest value of a sample, for
 * the data format descriptor; typeSize, for the header. PLAIN has one sample per channel, the others have one
 * sample. */
static const struct code {
    uint32_t vk_format, model, bits, upper, type_size;
} codes[] = {
    [HATCH_TEXELS_PLAIN] = {0, 1, 8, 255, 1},           [HATCH_TEXELS_BC1] = {131, 128, 64, UINT32_MAX, 1},
    [HATCH_TEXELS_BC4] = {139, 131, 64, UINT32_MAX, 1}, [HATCH_TEXELS_BC7] = {145, 134, 128, UINT32_MAX, 1},
    [HATCH_TEXELS_R32UI] = {98, 1, 32, 1, 4},
};

static uint32_t sample_count(const struct hatch_texels *texture)
{
    return texture->code == HATCH_TEXELS_PLAIN ? texture->channels : 1;
}

struct pair {
    const char *key, *value;
};

static size_t pair_bytes(const struct pair *pair)
{
    return strlen(pair->key) + 1 + strlen(pair->value) + 1;
}

/* Lists the file's keys and values, sorted by key as the format requires; returns the number of pairs. */
static uint32_t sort_pairs(const struct hatch_texels *texture, const char *const *key_values, struct pair *pairs)
{
    uint32_t count = 0;
    pairs[count++] = (struct pair){"KTXorientation", texture->depth ? "rdi" : "rd"};
    pairs[count++] = (struct pair){"KTXwriter", "hatch"};
    for (; key_values && key_values[0]; key_values += 2) {
        assert(count < PAIRS_MAX);
        pairs[count++] = (struct pair){key_values[0], key_values[1]};
    }
    for (uint32_t i = 1; i < count; i++) {
        struct pair pair = pairs[i];
        uint32_t at = i;
        for (; at > 0 && strcmp(pairs[at - 1].key, pair.key) > 0; at--)
            pairs[at] = pairs[at - 1];
        pairs[at] = pair;
    }
    return count;
}

static size_t to_multiple(size_t size, size_t alignment)
{
    return (size + alignment - 1) / alignment * alignment;
}

static enum hatch_status add_u32s(struct hatch_buffer *file, const uint32_t *values, uint32_t count,
                                  struct hatch_err *err)
{
    for (uint32_t i = 0; i < count; i++)
        HATCH_TRY(hatch_buffer_add_u32le(file, values[i], err));
    return HATCH_OK;
}

/* Adds the basic data format descriptor: one plane, linear, BT.709. */
static enum hatch_status add_descriptor(const struct hatch_texels *texture, struct hatch_buffer *file,
                                        struct hatch_err *err)
{
    static const uint32_t channel_ids[] = {0, 1, 2, 15}; /* red, green, blue, alpha */
    const uint32_t primaries_bt709 = 1, transfer_linear = 1;
    const struct code *code = &codes[texture->code];
    uint32_t samples = sample_count(texture), side = hatch_texels_block_side(texture->code);
    uint32_t block = DESCRIPTOR_HEAD_BYTES + SAMPLE_BYTES * samples;
    const uint32_t head[] = {
        4 + block,
        0,               /* vendor and type: the basic descriptor */
        2 | block << 16, /* version 1.3 */
        code->model | primaries_bt709 << 8 | transfer_linear << 16,
        (side - 1) | (side - 1) << 8,
        hatch_texels_block_bytes(texture->code, texture->channels), /* bytes of plane 0 */
        0,
    };
    HATCH_TRY(add_u32s(file, head, sizeof head / sizeof *head, err));
    for (uint32_t c = 0; c < samples; c++) {
        const uint32_t sample[] = {8 * c | (code->bits - 1) << 16 | channel_ids[c] << 24, 0, 0, code->upper};
        HATCH_TRY(add_u32s(file, sample, sizeof sample / sizeof *sample, err));
    }
    return HATCH_OK;
}

static enum hatch_status add_pairs(const struct pair *pairs, uint32_t count, struct hatch_buffer *file,
                                   struct hatch_err *err)
{
    for (uint32_t i = 0; i < count; i++) {
        HATCH_TRY(hatch_buffer_add_u32le(file, (uint32_t)pair_bytes(&pairs[i]), err));
        HATCH_TRY(hatch_buffer_add(file, pairs[i].key, strlen(pairs[i].key) + 1, err));
        HATCH_TRY(hatch_buffer_add(file, pairs[i].value, strlen(pairs[i].value) + 1, err));
        HATCH_TRY(hatch_buffer_pad(file, 4, err));
    }
    return HATCH_OK;
}

/* Computes the offsets of the levels. The smallest level comes first; each is aligned to 4 bytes and to a block.
 * Returns the end of the last one. */
static size_t place_levels(const struct hatch_texels *texture, size_t from, size_t *offsets)
{
    size_t block = hatch_texels_block_bytes(texture->code, texture->channels);
    size_t alignment = block == 3 ? 12 : block < 4 ? 4 : block;
    for (uint32_t level = texture->level_count; level-- > 0;) {
        offsets[level] = to_multiple(from, alignment);
        from = offsets[level] + hatch_texels_level_size(texture, level);
    }
    return from;
}

static enum hatch_status add_level_index(const struct hatch_texels *texture, const size_t *offsets,
                                         struct hatch_buffer *file, struct hatch_err *err)
{
    for (uint32_t level = 0; level < texture->level_count; level++) {
        uint64_t size = hatch_texels_level_size(texture, level);
        HATCH_TRY(hatch_buffer_add_u64le(file, offsets[level], err));
        HATCH_TRY(hatch_buffer_add_u64le(file, size, err));
        HATCH_TRY(hatch_buffer_add_u64le(file, size, err)); /* the uncompressed size, which is the same */
    }
    return HATCH_OK;
}

static enum hatch_status add_all(const struct hatch_texels *texture, const struct pair *pairs, uint32_t pair_count,
                                 struct hatch_buffer *file, struct hatch_err *err)
{
    static const uint8_t identifier[] = HATCH_KTX2_IDENTIFIER;
    size_t index = HATCH_KTX2_HEADER_BYTES;
    size_t descriptor = index + HATCH_KTX2_LEVEL_BYTES * texture->level_count;
    size_t descriptor_size = 4 + DESCRIPTOR_HEAD_BYTES + SAMPLE_BYTES * sample_count(texture);
    size_t values = descriptor + descriptor_size, values_size = 0;
    for (uint32_t i = 0; i < pair_count; i++)
        values_size += 4 + to_multiple(pair_bytes(&pairs[i]), 4);
    size_t offsets[HATCH_MIP_LEVELS_MAX];
    size_t end = place_levels(texture, values + values_size, offsets);
    const uint32_t header[] = {
        texture->code == HATCH_TEXELS_PLAIN ? vk_formats[texture->channels] : codes[texture->code].vk_format,
        codes[texture->code].type_size,
        texture->width,
        texture->height,
        texture->depth,
        texture->layers,
        1, /* faces */
        texture->level_count,
        0, /* no supercompression */
        (uint32_t)descriptor,
        (uint32_t)descriptor_size,
        (uint32_t)values,
        (uint32_t)values_size,
        0,
        0,
        0,
        0 /* no global data */
    };
    HATCH_TRY(hatch_buffer_reserve(file, end, err));
    HATCH_TRY(hatch_buffer_add(file, identifier, sizeof identifier, err));
    HATCH_TRY(add_u32s(file, header, sizeof header / sizeof *header, err));
    HATCH_TRY(add_level_index(texture, offsets, file, err));
    HATCH_TRY(add_descriptor(texture, file, err));
    HATCH_TRY(add_pairs(pairs, pair_count, file, err));
    for (uint32_t level = texture->level_count; level-- > 0;) {
        HATCH_TRY(hatch_buffer_add(file, NULL, offsets[level] - file->size, err));
        size_t size = hatch_texels_level_size(texture, level);
        HATCH_TRY(hatch_buffer_add(file, texture->texels[level], size, err));
    }
    assert(file->size == end);
    return HATCH_OK;
}

enum hatch_status hatch_ktx2_write(const struct hatch_texels *texture, const char *const *key_values,
                                   struct hatch_buffer *file, struct hatch_err *err)
{
    assert(file->size == 0 && texture->level_count >= 1);
    assert(texture->level_count <= hatch_texels_chain_length(texture));
    struct pair pairs[PAIRS_MAX];
    uint32_t pair_count = sort_pairs(texture, key_values, pairs);
    enum hatch_status status = add_all(texture, pairs, pair_count, file, err);
    if (status != HATCH_OK)
        file->size = 0;
    return status;
}
