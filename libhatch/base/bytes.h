/* Byte strings: bounded reading and growing writing, little- and big-endian.
 *
 * A reader never passes its end: a read beyond it returns 0 and sets `cut`, which the caller looks
 * at once, after a group of reads. A buffer grows in an arena.
 */
#ifndef HATCH_BASE_BYTES_H
#define HATCH_BASE_BYTES_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "base/arena.h"

/* Bytes that somebody else owns. */
struct hatch_bytes {
    const uint8_t *data;
    size_t size;
};

struct hatch_reader {
    const uint8_t *data;
    size_t size;
    size_t at;
    bool big_endian;
    bool cut; /* a read went past the end */
};

/* At the first byte, little-endian; the bytes stay the caller's and must outlive the reader. */
struct hatch_reader hatch_reader_of(struct hatch_bytes bytes);
/* Bytes that are not read yet. */
size_t hatch_reader_left(const struct hatch_reader *reader);
/* The next number in the order that big_endian says, unaligned; floats are IEEE 754. */
uint8_t hatch_read_u8(struct hatch_reader *reader);
uint16_t hatch_read_u16(struct hatch_reader *reader);
uint32_t hatch_read_u32(struct hatch_reader *reader);
uint64_t hatch_read_u64(struct hatch_reader *reader);
float hatch_read_f32(struct hatch_reader *reader);
double hatch_read_f64(struct hatch_reader *reader);
/* A pointer to the next size bytes, or NULL (and cut) when fewer are left. */
const uint8_t *hatch_read_bytes(struct hatch_reader *reader, size_t size);

/* A byte string that grows at its end, doubling, in arena; the old copies stay in the arena until
 * it is freed. Start from {.arena = a}. */
struct hatch_buffer {
    uint8_t *data;
    size_t size;
    size_t capacity;
    struct hatch_arena *arena;
};

/* Makes room for more bytes at once, for a writer that knows what is coming. */
enum hatch_status hatch_buffer_reserve(struct hatch_buffer *buffer, size_t more, struct hatch_err *err) HATCH_MUST_USE;
/* Appends size bytes; bytes may be NULL for zeros. */
enum hatch_status hatch_buffer_add(struct hatch_buffer *buffer, const void *bytes, size_t size,
                                   struct hatch_err *err) HATCH_MUST_USE;
enum hatch_status hatch_buffer_add_u32le(struct hatch_buffer *buffer, uint32_t value,
                                         struct hatch_err *err) HATCH_MUST_USE;
enum hatch_status hatch_buffer_add_u64le(struct hatch_buffer *buffer, uint64_t value,
                                         struct hatch_err *err) HATCH_MUST_USE;
/* Appends formatted text without its terminating zero; numbers are always written in the C locale. */
enum hatch_status hatch_buffer_print(struct hatch_buffer *buffer, struct hatch_err *err, const char *format,
                                     ...) HATCH_MUST_USE HATCH_PRINTF(3, 4);
/* Appends zeros until size is a multiple of alignment. */
enum hatch_status hatch_buffer_pad(struct hatch_buffer *buffer, size_t alignment, struct hatch_err *err) HATCH_MUST_USE;

#endif
