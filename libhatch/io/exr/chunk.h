/* Reading: the texels of one chunk of an EXR part, from the file's bytes to their place. */
#ifndef HATCH_IO_EXR_CHUNK_H
#define HATCH_IO_EXR_CHUNK_H

#include "image/image.h"
#include "io/exr/stream.h"

/* The buffers of one part's chunks; begun and ended around them. */
struct hatch_exr_chunks {
    const struct hatch_exr_stream *stream;
    exr_context_t context;
    int part;
    size_t raw_max; /* bytes of the largest chunk */
    const uint32_t *place;
    uint8_t *raw, *filtered; /* raw_max each */
    struct libdeflate_decompressor *decompressor;
    exr_decode_pipeline_t pipeline; /* of the core: for what is neither raw nor ZIP */
};

/* raw_max: at least the bytes of the part's largest chunk. place[n]: where the file's n-th channel
 * stands in the image; it must live as long as chunks. Buffers come from scratch. */
enum hatch_status hatch_exr_chunks_begin(const struct hatch_exr_stream *stream, exr_context_t context, int part,
                                         size_t raw_max, const uint32_t *place, struct hatch_arena *scratch,
                                         struct hatch_exr_chunks *chunks, struct hatch_err *err) HATCH_MUST_USE;

/* Decodes the chunk that info tells of into the width x height texels of image from (left, top) on;
 * width and height are what the format says of this chunk. */
enum hatch_status hatch_exr_chunk_read(struct hatch_exr_chunks *chunks, const exr_chunk_info_t *info,
                                       struct hatch_image *image, uint32_t left, uint32_t top, uint32_t width,
                                       uint32_t height, struct hatch_err *err) HATCH_MUST_USE;

/* Frees what is not in the arena; also after a failed begin. */
void hatch_exr_chunks_end(struct hatch_exr_chunks *chunks);

#endif
