#include "io/exr/zip.h"

#include <libdeflate.h>
#include <string.h>

#define BLOCK 64u

static inline uint8_t step(uint8_t value, uint8_t previous)
{
    return (uint8_t)(value - previous + 128);
}

/* Sets out[i] to in[2 i] - in[2 i - 2] + 128. The length is fixed so that compilers vectorise the loop. */
static void step_block(const uint8_t *restrict in, uint8_t *restrict out)
{
    for (size_t i = 0; i < BLOCK; i++)
        out[i] = step(in[2 * i], in[2 * i - 2]);
}

/* Writes the differences between every second byte and the one before it in this sequence: in[2] - in[0], in[4] - in[2]
 * and so on, each plus 128.
 *   count  number of differences */
static void step_alternate(const uint8_t *in, size_t count, uint8_t *out)
{
    in += 2;
    for (; count >= BLOCK; count -= BLOCK, in += 2 * BLOCK, out += BLOCK)
        step_block(in, out);
    for (size_t i = 0; i < count; i++)
        out[i] = step(in[2 * i], in[2 * i - 2]);
}

/* Applies the format's filter ("OpenEXR File Layout", ZIP). First come the bytes at even places, then those at odd
 * places, which brings the high bytes of the numbers together; then each byte is replaced by its difference from the
 * previous one. */
static void filter(const uint8_t *raw, size_t size, uint8_t *filtered)
{
    size_t even = (size + 1) / 2;
    filtered[0] = raw[0];
    step_alternate(raw, even - 1, filtered + 1);
    filtered[even] = step(raw[1], raw[2 * (even - 1)]);
    step_alternate(raw + 1, size - even - 1, filtered + even + 1);
}

size_t hatch_exr_zip(struct libdeflate_compressor *compressor, const uint8_t *raw, size_t size, uint8_t *filtered,
                     uint8_t *packed)
{
    filter(raw, size, filtered);
    size_t packed_size = libdeflate_zlib_compress(compressor, filtered, size, packed, size - 1);
    if (packed_size)
        return packed_size;
    memcpy(packed, raw, size);
    return size;
}

static void unfilter(uint8_t *filtered, size_t size, uint8_t *raw)
{
    for (size_t i = 1; i < size; i++)
        filtered[i] = (uint8_t)(filtered[i] + filtered[i - 1] - 128);
    const uint8_t *even = filtered, *odd = filtered + (size + 1) / 2;
    for (size_t i = 0; i < size / 2; i++) {
        raw[2 * i] = even[i];
        raw[2 * i + 1] = odd[i];
    }
    if (size % 2)
        raw[size - 1] = even[size / 2];
}

bool hatch_exr_unzip(struct libdeflate_decompressor *decompressor, const uint8_t *packed, size_t packed_size,
                     uint8_t *filtered, uint8_t *raw, size_t size)
{
    if (libdeflate_zlib_decompress(decompressor, packed, packed_size, filtered, size, NULL) != LIBDEFLATE_SUCCESS)
        return false;
    unfilter(filtered, size, raw);
    return true;
}

size_t hatch_exr_channel_bytes(enum hatch_channel_type type)
{
    return type == HATCH_HALF ? 2 : 4;
}
