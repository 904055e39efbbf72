/* Private to the EXR reader: decodes the chunks of one part. */
#ifndef HATCH_IO_EXR_CHUNK_H
#define HATCH_IO_EXR_CHUNK_H

#include "image/image.h"
#include "io/exr/stream.h"

/* Decoder of one part. The caller sets the members up to image_channel before hatch_exr_chunks_begin, and keeps the
 * memory that they point to until hatch_exr_chunks_end. */
struct hatch_exr_chunks {
    const struct hatch_exr_stream *stream;
    exr_context_t context;         /* opened on stream */
    int part;                      /* index of the part in the file */
    size_t raw_max;                /* at least the unpacked size of the part's largest chunk, bytes */
    const uint32_t *image_channel; /* [n]: index in the image of the n-th channel in the file */

    uint8_t *raw, *filtered; /* raw_max bytes each */
    struct libdeflate_decompressor *decompressor;
    exr_decode_pipeline_t pipeline; /* of OpenEXR's core, which decodes RLE and PIZ */
};

/* A rectangle of texels. */
struct hatch_exr_area {
    uint32_t left, top, width, height;
};

/* Allocates the decoder's buffers. Call hatch_exr_chunks_end even after a failure. */
enum hatch_status hatch_exr_chunks_begin(struct hatch_exr_chunks *chunks, struct hatch_arena *scratch,
                                         struct hatch_err *err) HATCH_MUST_USE;

/* Decodes one chunk into an area of an image.
 *   info  description of the chunk, from OpenEXR's core
 *   area  texels that the chunk covers; smaller at the right and lower edges of a level
 * HATCH_BAD_INPUT when the chunk is truncated or damaged. */
enum hatch_status hatch_exr_chunk_read(struct hatch_exr_chunks *chunks, const exr_chunk_info_t *info,
                                       const struct hatch_exr_area *area, struct hatch_image *image,
                                       struct hatch_err *err) HATCH_MUST_USE;

/* Frees the memory that the decoder has outside the arena. */
void hatch_exr_chunks_end(struct hatch_exr_chunks *chunks);

#endif
