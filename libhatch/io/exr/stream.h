/* Private to the EXR reader and writer: contexts of OpenEXR's C core on files in memory, with the core's
 * messages kept. */
#ifndef HATCH_IO_EXR_STREAM_H
#define HATCH_IO_EXR_STREAM_H

#include <OpenEXR/openexr.h>

#include "base/bytes.h"

struct hatch_exr_stream {
    struct hatch_bytes file;     /* input, when reading */
    struct hatch_buffer *buffer; /* output, when writing */
    struct hatch_err first;      /* the core's first message, or why the buffer did not grow */
};

/* Open a context on the stream, which must outlive it. */
exr_result_t hatch_exr_open_read(struct hatch_exr_stream *stream, exr_context_t *context);
exr_result_t hatch_exr_open_write(struct hatch_exr_stream *stream, exr_context_t *context);

/* Fills err with the stream's first message, or the core's text for result.
 *   result  not EXR_ERR_SUCCESS
 *   status  returned unless memory ran out: then HATCH_LIMIT */
enum hatch_status hatch_exr_fail(const struct hatch_exr_stream *stream, exr_result_t result, enum hatch_status status,
                                 struct hatch_err *err);

#endif
