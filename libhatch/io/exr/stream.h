/* What the EXR reader and writer share: a context of OpenEXR's C core whose file is memory and
 * whose messages are kept. */
#ifndef HATCH_IO_EXR_STREAM_H
#define HATCH_IO_EXR_STREAM_H

#include <OpenEXR/openexr.h>

#include "base/bytes.h"

/* file: what is read, buffer: what is written; one of them is used. */
struct hatch_exr_stream {
    struct hatch_bytes file;
    struct hatch_buffer *buffer;
    struct hatch_err first; /* the first message of the core, or why the buffer did not grow */
};

/* Opens a context on the stream, which must live as long as the context does. */
exr_result_t hatch_exr_open_read(struct hatch_exr_stream *stream, exr_context_t *context);
exr_result_t hatch_exr_open_write(struct hatch_exr_stream *stream, exr_context_t *context);

/* Fills err from a result that is not EXR_ERR_SUCCESS: status, or HATCH_LIMIT when memory ran out.
 */
enum hatch_status hatch_exr_fail(const struct hatch_exr_stream *stream, exr_result_t result, enum hatch_status status,
                                 struct hatch_err *err);

#endif
