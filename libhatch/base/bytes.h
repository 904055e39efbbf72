/* Reading and writing of binary data, little- and big-endian.
 *
 * A reader never passes its end: reads beyond it return 0 and set `cut`, which the caller checks once after a group of
 * reads. A buffer grows in an arena. */
#ifndef HATCH_BASE_BYTES_H
#define HATCH_BASE_BYTES_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "base/arena.h"

/* A byte string owned by the caller. */
struct hatch_bytes {
    const uint8_t *data;
    size_t size;
};

struct hatch_reader {
    const uint8_t *data;
    size_t size;
    size_t at;       /* offset of the next byte */
    bool big_endian; /* byte order of numbers */
    bool cut;        /* a read tried to go past the end */
};

/* Makes a little-endian reader at the first byte; the bytes must outlive it. */
struct hatch_reader hatch_reader_of(struct hatch_bytes bytes);

/* Returns the number of bytes not read yet. */
size_t hatch_reader_left(const struct hatch_reader *reader);

/* Read the next number, at any alignment; floats are IEEE 754. */
uint8_t hatch_read_u8(struct hatch_reader *reader);
uint16_t hatch_read_u16(struct hatch_reader *reader);
uint32_t hatch_read_u32(struct hatch_reader *reader);
uint64_t hatch_read_u64(struct hatch_reader *reader);
float hatch_read_f32(struct hatch_reader *reader);
double hatch_read_f64(struct hatch_reader *reader);

/* Returns a pointer to the next `size` bytes and moves past them. Where fewer remain it returns NULL, moves to the end
 * and sets cut. */
const uint8_t *hatch_read_bytes(struct hatch_reader *reader, size_t size);

/* A byte string that grows by doubling; its old copies stay in the arena. Initialize it with {.arena = a}. */
struct hatch_buffer {
    uint8_t *data;
    size_t size;
    size_t capacity;
    struct hatch_arena *arena;
};

/* Ensures that there is room for `more` bytes after the first `size` bytes. */
enum hatch_status hatch_buffer_reserve(struct hatch_buffer *buffer, size_t more, struct hatch_err *err) HATCH_MUST_USE;

/* Appends bytes.
 *   bytes  NULL: zeros are appended */
enum hatch_status hatch_buffer_add(struct hatch_buffer *buffer, const void *bytes, size_t size,
                                   struct hatch_err *err) HATCH_MUST_USE;
enum hatch_status hatch_buffer_add_u32le(struct hatch_buffer *buffer, uint32_t value,
                                         struct hatch_err *err) HATCH_MUST_USE;
enum hatch_status hatch_buffer_add_u64le(struct hatch_buffer *buffer, uint64_t value,
                                         struct hatch_err *err) HATCH_MUST_USE;

/* Appends formatted text without a terminating zero; numbers are in the C locale. */
enum hatch_status hatch_buffer_print(struct hatch_buffer *buffer, struct hatch_err *err, const char *format,
                                     ...) HATCH_MUST_USE HATCH_PRINTF(3, 4);

/* Appends zeros until size is a multiple of alignment. */
enum hatch_status hatch_buffer_pad(struct hatch_buffer *buffer, size_t alignment, struct hatch_err *err) HATCH_MUST_USE;

#endif
