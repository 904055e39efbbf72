#include "base/bytes.h"

#include <stdarg.h>
#include <stdio.h>
#include <string.h>

struct hatch_reader hatch_reader_of(struct hatch_bytes bytes)
{
    return (struct hatch_reader){.data = bytes.data, .size = bytes.size};
}

size_t hatch_reader_left(const struct hatch_reader *reader)
{
    return reader->size - reader->at;
}

const uint8_t *hatch_read_bytes(struct hatch_reader *reader, size_t size)
{
    if (size > hatch_reader_left(reader)) {
        reader->at = reader->size;
        reader->cut = true;
        return NULL;
    }
    const uint8_t *bytes = reader->data + reader->at;
    reader->at += size;
    return bytes;
}

static uint64_t read_unsigned(struct hatch_reader *reader, size_t size)
{
    const uint8_t *bytes = hatch_read_bytes(reader, size);
    uint64_t value = 0;
    for (size_t i = 0; bytes && i < size; i++) {
        size_t most_significant_first = reader->big_endian ? i : size - 1 - i;
        value = value << 8 | bytes[most_significant_first];
    }
    return value;
}

uint8_t hatch_read_u8(struct hatch_reader *reader)
{
    return (uint8_t)read_unsigned(reader, 1);
}

uint16_t hatch_read_u16(struct hatch_reader *reader)
{
    return (uint16_t)read_unsigned(reader, 2);
}

uint32_t hatch_read_u32(struct hatch_reader *reader)
{
    return (uint32_t)read_unsigned(reader, 4);
}

uint64_t hatch_read_u64(struct hatch_reader *reader)
{
    return read_unsigned(reader, 8);
}

float hatch_read_f32(struct hatch_reader *reader)
{
    uint32_t bits = hatch_read_u32(reader);
    float value;
    memcpy(&value, &bits, sizeof value);
    return value;
}

double hatch_read_f64(struct hatch_reader *reader)
{
    uint64_t bits = hatch_read_u64(reader);
    double value;
    memcpy(&value, &bits, sizeof value);
    return value;
}

enum hatch_status hatch_buffer_reserve(struct hatch_buffer *buffer, size_t more, struct hatch_err *err)
{
    if (more <= buffer->capacity - buffer->size)
        return HATCH_OK;
    size_t needed = buffer->size + more;
    if (needed < more)
        return hatch_fail(err, HATCH_LIMIT, "the output is larger than memory can hold");
    size_t capacity = buffer->capacity > SIZE_MAX / 2 ? needed : buffer->capacity * 2;
    if (capacity < needed)
        capacity = needed;
    if (capacity < 4096)
        capacity = 4096;
    uint8_t *data;
    HATCH_TRY(HATCH_ALLOC_UNSET(buffer->arena, &data, capacity, err));
    if (buffer->size)
        memcpy(data, buffer->data, buffer->size);
    buffer->data = data;
    buffer->capacity = capacity;
    return HATCH_OK;
}

enum hatch_status hatch_buffer_add(struct hatch_buffer *buffer, const void *bytes, size_t size, struct hatch_err *err)
{
    HATCH_TRY(hatch_buffer_reserve(buffer, size, err));
    if (bytes && size)
        memcpy(buffer->data + buffer->size, bytes, size);
    else if (size)
        memset(buffer->data + buffer->size, 0, size);
    buffer->size += size;
    return HATCH_OK;
}

static enum hatch_status add_little_endian(struct hatch_buffer *buffer, uint64_t value, size_t size,
                                           struct hatch_err *err)
{
    uint8_t bytes[8];
    for (size_t i = 0; i < size; i++)
        bytes[i] = (uint8_t)(value >> (8 * i));
    return hatch_buffer_add(buffer, bytes, size, err);
}

enum hatch_status hatch_buffer_add_u32le(struct hatch_buffer *buffer, uint32_t value, struct hatch_err *err)
{
    return add_little_endian(buffer, value, 4, err);
}

enum hatch_status hatch_buffer_add_u64le(struct hatch_buffer *buffer, uint64_t value, struct hatch_err *err)
{
    return add_little_endian(buffer, value, 8, err);
}

enum hatch_status hatch_buffer_print(struct hatch_buffer *buffer, struct hatch_err *err, const char *format, ...)
{
    va_list args, again;
    va_start(args, format);
    va_copy(again, args);
    /* Usually the text fits into the present capacity and is formatted once. */
    size_t room = buffer->capacity - buffer->size;
    int length = vsnprintf(room ? (char *)buffer->data + buffer->size : NULL, room, format, args);
    va_end(args);
    enum hatch_status status = length < 0 ? hatch_fail(err, HATCH_LIMIT, "a text is too long to format")
                                          : hatch_buffer_reserve(buffer, (size_t)length + 1, err);
    if (status == HATCH_OK) {
        if ((size_t)length >= room)
            vsnprintf((char *)buffer->data + buffer->size, (size_t)length + 1, format, again);
        buffer->size += (size_t)length;
    }
    va_end(again);
    return status;
}

enum hatch_status hatch_buffer_pad(struct hatch_buffer *buffer, size_t alignment, struct hatch_err *err)
{
    size_t over = buffer->size % alignment;
    return over ? hatch_buffer_add(buffer, NULL, alignment - over, err) : HATCH_OK;
}
