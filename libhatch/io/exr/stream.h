/* Private to the EXR reader and writer: contexts of OpenEXR's C core that read from and write to memory and keep the
 * core's messages. */
#ifndef HATCH_IO_EXR_STREAM_H
#define HATCH_IO_EXR_STREAM_H

#include <OpenEXR/openexr.h>

#include "base/bytes.h"

struct hatch_exr_stream {
    struct hatch_bytes file;     /* input, when reading */
    struct hatch_buffer *buffer; /* output, when writing */
    struct hatch_err first;      /* the core's first message when reading, or why the buffer did not grow */
};

/* Open a context on a stream. The stream must outlive the context, and one thread uses both. */
exr_result_t hatch_exr_open_read(struct hatch_exr_stream *stream, exr_context_t *context);
exr_result_t hatch_exr_open_write(struct hatch_exr_stream *stream, exr_context_t *context);

/* Fills err with the stream's first message, or with the core's text for result.
 *   result  not EXR_ERR_SUCCESS
 *   status  status to return, unless memory ran out: then it is HATCH_LIMIT */
enum hatch_status hatch_exr_fail(const struct hatch_exr_stream *stream, exr_result_t result, enum hatch_status status,
                                 struct hatch_err *err);

#endif
