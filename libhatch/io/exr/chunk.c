#include "io/exr/chunk.h"

#include <assert.h>
#include <libdeflate.h>
#include <string.h>

#include "io/exr/zip.h"

enum hatch_status hatch_exr_chunks_begin(struct hatch_exr_chunks *chunks, struct hatch_arena *scratch,
                                         struct hatch_err *err)
{
    HATCH_TRY(HATCH_ALLOC(scratch, &chunks->raw, chunks->raw_max, err));
    HATCH_TRY(HATCH_ALLOC(scratch, &chunks->filtered, chunks->raw_max, err));
    chunks->decompressor = libdeflate_alloc_decompressor();
    return chunks->decompressor ? HATCH_OK : hatch_fail(err, HATCH_LIMIT, "out of memory for decompression");
}

void hatch_exr_chunks_end(struct hatch_exr_chunks *chunks)
{
    if (chunks->decompressor)
        libdeflate_free_decompressor(chunks->decompressor);
    if (chunks->pipeline.context)
        exr_decoding_destroy(chunks->context, &chunks->pipeline);
}

/* Unpacks an RLE or PIZ chunk with OpenEXR's core; *raw then points into the core's buffer. */
static enum hatch_status unpack_by_core(struct hatch_exr_chunks *chunks, const exr_chunk_info_t *info,
                                        const uint8_t **raw, struct hatch_err *err)
{
    exr_decode_pipeline_t *pipeline = &chunks->pipeline;
    exr_result_t result;
    if (pipeline->context) {
        result = exr_decoding_update(chunks->context, chunks->part, info, pipeline);
    } else {
        result = exr_decoding_initialize(chunks->context, chunks->part, info, pipeline);
        if (result == EXR_ERR_SUCCESS)
            result = exr_decoding_choose_default_routines(chunks->context, chunks->part, pipeline);
        pipeline->unpack_and_convert_fn = NULL;
    }
    if (result == EXR_ERR_SUCCESS)
        result = exr_decoding_run(chunks->context, chunks->part, pipeline);
    if (result != EXR_ERR_SUCCESS)
        return hatch_exr_fail(chunks->stream, result, HATCH_BAD_INPUT, err);
    *raw = pipeline->unpacked_buffer;
    return HATCH_OK;
}

/* Reads and decompresses a chunk.
 *   size  decompressed size in bytes
 *   raw   out: decompressed bytes, aligned for halves */
static enum hatch_status unpack(struct hatch_exr_chunks *chunks, const exr_chunk_info_t *info, size_t size,
                                const uint8_t **raw, struct hatch_err *err)
{
    size_t file_size = chunks->stream->file.size;
    if (info->data_offset > file_size || info->packed_size > file_size - info->data_offset)
        return hatch_fail(err, HATCH_BAD_INPUT, "truncated: the chunk at byte %llu has %llu bytes, the file %zu",
                          (unsigned long long)info->data_offset, (unsigned long long)info->packed_size, file_size);
    const uint8_t *packed = chunks->stream->file.data + info->data_offset;
    *raw = chunks->raw;
    if (info->packed_size == size) {
        memcpy(chunks->raw, packed, size);
        return HATCH_OK;
    }
    if (info->compression == EXR_COMPRESSION_ZIP || info->compression == EXR_COMPRESSION_ZIPS) {
        if (hatch_exr_unzip(chunks->decompressor, packed, (size_t)info->packed_size, chunks->filtered, chunks->raw,
                            size))
            return HATCH_OK;
        return hatch_fail(err, HATCH_BAD_INPUT, "the ZIP chunk at byte %llu is damaged",
                          (unsigned long long)info->data_offset);
    }
    if (info->unpacked_size != size || info->compression == EXR_COMPRESSION_NONE)
        return hatch_fail(err, HATCH_BAD_INPUT, "the chunk at byte %llu unpacks to %llu bytes, want %zu",
                          (unsigned long long)info->data_offset, (unsigned long long)info->unpacked_size, size);
    return unpack_by_core(chunks, info, raw, err);
}

static void convert_row(const uint8_t *raw, enum hatch_channel_type type, uint32_t count, float *values, size_t stride)
{
    if (type == HATCH_HALF) {
        hatch_floats_from_halves((const uint16_t *)(const void *)raw, count, values, stride);
        return;
    }
    for (uint32_t i = 0; i < count; i++) {
        uint32_t bits;
        memcpy(&bits, raw + 4 * (size_t)i, sizeof bits);
        if (type == HATCH_FLOAT)
            memcpy(&values[i * stride], &bits, sizeof bits);
        else /* 2^24 + 1 would be rounded to 2^24, which is allowed */
            values[i * stride] = bits == (1u << 24) + 1 ? 0x1p24f + 2 : (float)bits;
    }
}

enum hatch_status hatch_exr_chunk_read(struct hatch_exr_chunks *chunks, const exr_chunk_info_t *info,
                                       const struct hatch_exr_area *area, struct hatch_image *image,
                                       struct hatch_err *err)
{
    size_t texel_bytes = 0, stride = image->channel_count;
    for (uint32_t c = 0; c < image->channel_count; c++)
        texel_bytes += hatch_exr_channel_bytes(image->channels[c].type);
    assert(texel_bytes * area->width * area->height <= chunks->raw_max);
    const uint8_t *raw = NULL;
    HATCH_TRY(unpack(chunks, info, texel_bytes * area->width * area->height, &raw, err));
    for (uint32_t row = 0; row < area->height; row++) {
        float *first = image->pixels + ((size_t)(area->top + row) * image->width + area->left) * stride;
        for (uint32_t i = 0; i < image->channel_count; i++) {
            uint32_t c = chunks->image_channel[i];
            convert_row(raw, image->channels[c].type, area->width, first + c, stride);
            raw += hatch_exr_channel_bytes(image->channels[c].type) * area->width;
        }
    }
    return HATCH_OK;
}
