#include "io/exr/stream.h"

#include <stdlib.h>
#include <string.h>

/* Largest width and height of an image; small enough that 32-bit arithmetic on a side cannot overflow. */
#define SIDE_MAX (1 << 24)

/* Whether an allocation of the core has failed on this thread since it last opened a context. The core passes its
 * allocators no context, and it takes some failures for the end of a list: a file then has fewer parts. */
static _Thread_local bool out_of_memory;

static void *allocate(size_t size)
{
    void *block = malloc(size);
    out_of_memory |= !block;
    return block;
}

static void keep_message(exr_const_context_t context, exr_result_t result, const char *message)
{
    void *data = NULL;
    (void)result;
    if (exr_get_user_data(context, &data) != EXR_ERR_SUCCESS || !data)
        return;
    struct hatch_exr_stream *stream = data;
    if (stream->first.status == HATCH_OK)
        hatch_fail(&stream->first, HATCH_BAD_INPUT, "%s", message);
}

/* A context that writes cannot be asked for its stream here: the core calls this with the context locked. */
static void ignore_message(exr_const_context_t context, exr_result_t result, const char *message)
{
    (void)context;
    (void)result;
    (void)message;
}

static int64_t size_of_file(exr_const_context_t context, void *data)
{
    (void)context;
    const struct hatch_exr_stream *stream = data;
    return (int64_t)stream->file.size;
}

static int64_t read_at(exr_const_context_t context, void *data, void *out, uint64_t size, uint64_t offset,
                       exr_stream_error_func_ptr_t report)
{
    (void)context;
    (void)report;
    const struct hatch_exr_stream *stream = data;
    if (offset >= stream->file.size)
        return 0;
    size_t available = stream->file.size - (size_t)offset;
    size_t count = size < available ? (size_t)size : available;
    memcpy(out, stream->file.data + offset, count);
    return (int64_t)count;
}

/* The core writes nothing but a header here, from its first byte to its last: chunks and their offsets are added by
 * write.c. */
static int64_t write_at(exr_const_context_t context, void *data, const void *bytes, uint64_t size, uint64_t offset,
                        exr_stream_error_func_ptr_t report)
{
    (void)context;
    (void)report;
    struct hatch_exr_stream *stream = data;
    bool added = offset == stream->buffer->size &&
                 hatch_buffer_add(stream->buffer, bytes, (size_t)size, &stream->first) == HATCH_OK;
    return added ? (int64_t)size : -1;
}

static exr_context_initializer_t settings(struct hatch_exr_stream *stream)
{
    exr_context_initializer_t set = EXR_DEFAULT_CONTEXT_INITIALIZER;
    set.alloc_fn = allocate;
    set.free_fn = free;
    out_of_memory = false;
    set.user_data = stream;
    set.max_image_width = SIDE_MAX;
    set.max_image_height = SIDE_MAX;
    return set;
}

exr_result_t hatch_exr_open_read(struct hatch_exr_stream *stream, exr_context_t *context)
{
    exr_context_initializer_t set = settings(stream);
    set.error_handler_fn = keep_message;
    set.read_fn = read_at;
    set.size_fn = size_of_file;
    set.flags = EXR_CONTEXT_FLAG_DISABLE_CHUNK_RECONSTRUCTION;
    exr_result_t result = exr_start_read(context, "memory", &set);
    if (result != EXR_ERR_SUCCESS || (stream->first.status == HATCH_OK && !out_of_memory))
        return result;
    /* The core has reported an invalid attribute and replaced it by a default, such as unknown compression by ZIP, or
     * has left out what it had no memory for. */
    exr_finish(context);
    return EXR_ERR_INVALID_ATTR;
}

exr_result_t hatch_exr_open_write(struct hatch_exr_stream *stream, exr_context_t *context)
{
    exr_context_initializer_t set = settings(stream);
    set.error_handler_fn = ignore_message;
    set.write_fn = write_at;
    return exr_start_write(context, "memory", EXR_WRITE_FILE_DIRECTLY, &set);
}

enum hatch_status hatch_exr_fail(const struct hatch_exr_stream *stream, exr_result_t result, enum hatch_status status,
                                 struct hatch_err *err)
{
    if (stream->first.status == HATCH_LIMIT)
        status = HATCH_LIMIT;
    else if (out_of_memory)
        return hatch_fail(err, HATCH_LIMIT, "out of memory in OpenEXR");
    const char *text = stream->first.text;
    return hatch_fail_quoting(err, status, *text ? text : exr_get_default_error_message(result),
                              status == HATCH_LIMIT ? "the OpenEXR file needs too much memory"
                                                    : "the OpenEXR file is damaged");
}
