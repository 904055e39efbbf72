/* Writes DDS files with the DX10 header ("DDS File Layout" and "DDS_HEADER_DXT10", Microsoft). */
#include <assert.h>

#include "io/texture/container.h"

#define MAGIC 0x20534444u /* "DDS " */
#define HEADER_WORDS 37u  /* magic word and DX10 header included */
#define HEADER_BYTES 124u
#define FORMAT_BYTES 32u

#define HAS_CAPS 0x1u
#define HAS_HEIGHT 0x2u
#define HAS_WIDTH 0x4u
#define HAS_PITCH 0x8u
#define HAS_FORMAT 0x1000u
#define HAS_LEVELS 0x20000u
#define HAS_DEPTH 0x800000u
#define FORMAT_IS_FOURCC 0x4u
#define FOURCC_DX10 0x30315844u
#define CAPS_COMPLEX 0x8u
#define CAPS_TEXTURE 0x1000u
#define CAPS_LEVELS 0x400000u
#define CAPS2_VOLUME 0x200000u
#define DIMENSION_2D 3u
#define DIMENSION_3D 4u

/* DXGI_FORMAT by number of channels (1, 2 or 4), 8 bits each, UNORM. */
static const uint32_t dxgi_formats[] = {0, 61, 49, 0, 28};

static enum hatch_status add_header(const struct hatch_texels *texture, struct hatch_buffer *file,
                                    struct hatch_err *err)
{
    bool is_volume = texture->depth > 0;
    bool is_complex = is_volume || texture->layers > 1 || texture->level_count > 1;
    const uint32_t words[HEADER_WORDS] = {
        [0] = MAGIC,
        [1] = HEADER_BYTES,
        [2] = HAS_CAPS | HAS_HEIGHT | HAS_WIDTH | HAS_PITCH | HAS_FORMAT | HAS_LEVELS | (is_volume ? HAS_DEPTH : 0),
        [3] = texture->height,
        [4] = texture->width,
        [5] = texture->width * texture->channels,
        [6] = texture->depth,
        [7] = texture->level_count,
        [19] = FORMAT_BYTES,
        [20] = FORMAT_IS_FOURCC,
        [21] = FOURCC_DX10,
        [27] = CAPS_TEXTURE | (is_complex ? CAPS_COMPLEX : 0) | (texture->level_count > 1 ? CAPS_LEVELS : 0),
        [28] = is_volume ? CAPS2_VOLUME : 0,
        [32] = dxgi_formats[texture->channels],
        [33] = is_volume ? DIMENSION_3D : DIMENSION_2D,
        [35] = texture->layers ? texture->layers : 1,
    };
    for (uint32_t i = 0; i < HEADER_WORDS; i++)
        HATCH_TRY(hatch_buffer_add_u32le(file, words[i], err));
    return HATCH_OK;
}

/* Adds the texels layer by layer, each layer with all its levels; a volume is a single layer. */
static enum hatch_status add_texels(const struct hatch_texels *texture, struct hatch_buffer *file,
                                    struct hatch_err *err)
{
    uint32_t layers = texture->layers ? texture->layers : 1;
    for (uint32_t layer = 0; layer < layers; layer++)
        for (uint32_t level = 0; level < texture->level_count; level++) {
            size_t size = hatch_texels_level_size(texture, level) / layers;
            HATCH_TRY(hatch_buffer_add(file, texture->texels[level] + layer * size, size, err));
        }
    return HATCH_OK;
}

enum hatch_status hatch_dds_write(const struct hatch_texels *texture, struct hatch_buffer *file, struct hatch_err *err)
{
    assert(file->size == 0 && texture->channels != 3 && texture->level_count >= 1);
    assert(texture->level_count <= hatch_texels_chain_length(texture));
    enum hatch_status status = add_header(texture, file, err);
    if (status == HATCH_OK)
        status = add_texels(texture, file, err);
    if (status != HATCH_OK)
        file->size = 0;
    return status;
}
