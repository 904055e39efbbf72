#include "io/foreign/header.h"

#include <stdio.h>
#include <string.h>

#define JPEG_START_OF_SCAN 0xda
#define JPEG_END 0xd9
#define TIFF_WIDTH 256
#define TIFF_HEIGHT 257
#define TIFF_SHORT 3
#define WEBP_START 0x2a019du  /* start code of a lossy key frame */
#define JP2_SIZES 0xff4fff51u /* markers SOC and SIZ, with which a codestream of JPEG 2000 begins */
#define LINE_MAX_BYTES 64u    /* size of a buffer for the line of a Radiance file that holds its size */

static bool has_magic(struct hatch_bytes file, size_t at, const void *magic, size_t size)
{
    return file.size >= at + size && memcmp(file.data + at, magic, size) == 0;
}

/* Returns whether a marker begins a frame header, which holds the image's size: C0 .. CF except C4, C8 and CC. */
static bool is_frame(uint8_t marker)
{
    return marker >= 0xc0 && marker <= 0xcf && marker != 0xc4 && marker != 0xc8 && marker != 0xcc;
}

static bool has_jpeg_end(struct hatch_bytes file, size_t from)
{
    for (size_t i = from; i + 1 < file.size; i++)
        if (file.data[i] == 0xff && file.data[i + 1] == JPEG_END)
            return true;
    return false;
}

/* Reads the marker segments up to the first scan (ITU-T T.81, annex B). */
static bool read_jpeg(struct hatch_bytes file, struct hatch_foreign_header *header)
{
    struct hatch_reader reader = hatch_reader_of(file);
    reader.big_endian = true;
    hatch_read_u16(&reader);
    while (!reader.cut) {
        if (hatch_read_u8(&reader) != 0xff && !reader.cut)
            return false;
        uint8_t marker = hatch_read_u8(&reader);
        while (marker == 0xff && !reader.cut)
            marker = hatch_read_u8(&reader);
        size_t body = reader.at;
        uint16_t length = hatch_read_u16(&reader);
        if (is_frame(marker)) {
            hatch_read_u8(&reader); /* skips the precision */
            header->height = hatch_read_u16(&reader);
            header->width = hatch_read_u16(&reader);
        }
        if (marker == JPEG_START_OF_SCAN) {
            header->truncated = !has_jpeg_end(file, reader.at);
            return header->width > 0;
        }
        reader.at = body;
        hatch_read_bytes(&reader, length < 2 ? 2 : length);
    }
    header->truncated = true;
    return header->width > 0;
}

/* Reads the entries of the first directory (TIFF 6.0, section 2). */
static bool read_tiff(struct hatch_bytes file, struct hatch_foreign_header *header)
{
    struct hatch_reader reader = hatch_reader_of(file);
    reader.big_endian = file.data[0] == 'M';
    hatch_read_bytes(&reader, 4);
    uint32_t at = hatch_read_u32(&reader);
    if (at > file.size)
        return false;
    reader.at = at;
    uint16_t count = hatch_read_u16(&reader);
    for (uint16_t i = 0; i < count && !reader.cut; i++) {
        uint16_t tag = hatch_read_u16(&reader), type = hatch_read_u16(&reader);
        hatch_read_u32(&reader);
        struct hatch_reader field = reader;
        uint32_t value = type == TIFF_SHORT ? hatch_read_u16(&field) : hatch_read_u32(&field);
        hatch_read_bytes(&reader, 4);
        if (tag == TIFF_WIDTH)
            header->width = value;
        if (tag == TIFF_HEIGHT)
            header->height = value;
    }
    return header->width > 0 && header->height > 0;
}

static bool read_gif(struct hatch_bytes file, struct hatch_foreign_header *header)
{
    struct hatch_reader reader = hatch_reader_of(file);
    hatch_read_bytes(&reader, 6);
    header->width = hatch_read_u16(&reader);
    header->height = hatch_read_u16(&reader);
    return !reader.cut;
}

static bool read_bmp(struct hatch_bytes file, struct hatch_foreign_header *header)
{
    struct hatch_reader reader = hatch_reader_of(file);
    hatch_read_bytes(&reader, 14);
    if (hatch_read_u32(&reader) < 40)
        return false; /* the short header of OS/2 is not supported */
    header->width = hatch_read_u32(&reader);
    uint32_t height = hatch_read_u32(&reader);
    header->height = height > INT32_MAX ? 0u - height : height; /* negative when rows run from the top down */
    return !reader.cut;
}

static uint32_t read_u24(struct hatch_reader *reader)
{
    uint32_t low = hatch_read_u16(reader);
    return low | (uint32_t)hatch_read_u8(reader) << 16;
}

/* Reads the first chunk of a RIFF file (RFC 9649): that of an extended file, of lossless or of lossy pixels. */
static bool read_webp(struct hatch_bytes file, struct hatch_foreign_header *header)
{
    struct hatch_reader reader = hatch_reader_of(file);
    hatch_read_bytes(&reader, 12);
    const uint8_t *chunk = hatch_read_bytes(&reader, 4);
    hatch_read_u32(&reader);
    if (!chunk)
        return false;
    if (memcmp(chunk, "VP8X", 4) == 0) {
        hatch_read_u32(&reader);
        header->width = read_u24(&reader) + 1;
        header->height = read_u24(&reader) + 1;
    } else if (memcmp(chunk, "VP8L", 4) == 0) {
        hatch_read_u8(&reader); /* skips the signature */
        uint32_t sizes = hatch_read_u32(&reader);
        header->width = (sizes & 0x3fff) + 1;
        header->height = (sizes >> 14 & 0x3fff) + 1;
    } else {
        read_u24(&reader); /* skips the frame's tag */
        if (read_u24(&reader) != WEBP_START)
            return false;
        header->width = hatch_read_u16(&reader) & 0x3fff;
        header->height = hatch_read_u16(&reader) & 0x3fff;
    }
    return !reader.cut && header->width > 0 && header->height > 0;
}

/* Reads the sizes of a codestream of JPEG 2000 (ITU-T T.800, A.5.1). */
static bool read_j2k(struct hatch_bytes file, struct hatch_foreign_header *header)
{
    struct hatch_reader reader = hatch_reader_of(file);
    reader.big_endian = true;
    if (hatch_read_u32(&reader) != JP2_SIZES)
        return false;
    hatch_read_u32(&reader); /* skips the segment's length and the capabilities */
    uint32_t right = hatch_read_u32(&reader), bottom = hatch_read_u32(&reader);
    uint32_t left = hatch_read_u32(&reader), top = hatch_read_u32(&reader);
    header->width = right - left;
    header->height = bottom - top;
    return !reader.cut && right > left && bottom > top;
}

/* Finds the codestream among the boxes of a JP2 file (ITU-T T.800, annex I). */
static bool read_jp2(struct hatch_bytes file, struct hatch_foreign_header *header)
{
    struct hatch_reader reader = hatch_reader_of(file);
    reader.big_endian = true;
    while (hatch_reader_left(&reader) > 0) {
        size_t begin = reader.at;
        uint64_t size = hatch_read_u32(&reader);
        const uint8_t *type = hatch_read_bytes(&reader, 4);
        if (size == 1)
            size = hatch_read_u64(&reader);
        if (reader.cut)
            return false;
        if (memcmp(type, "jp2c", 4) == 0)
            return read_j2k((struct hatch_bytes){file.data + reader.at, file.size - reader.at}, header);
        if (size < reader.at - begin || size > file.size - begin)
            return false;
        reader.at = begin + (size_t)size;
    }
    return false;
}

static bool read_psd(struct hatch_bytes file, struct hatch_foreign_header *header)
{
    struct hatch_reader reader = hatch_reader_of(file);
    reader.big_endian = true;
    hatch_read_bytes(&reader, 14);
    header->height = hatch_read_u32(&reader);
    header->width = hatch_read_u32(&reader);
    return !reader.cut;
}

static bool read_dds(struct hatch_bytes file, struct hatch_foreign_header *header)
{
    struct hatch_reader reader = hatch_reader_of(file);
    hatch_read_bytes(&reader, 12);
    header->height = hatch_read_u32(&reader);
    header->width = hatch_read_u32(&reader);
    return !reader.cut;
}

/* Reads a decimal number after white space and comments. */
static uint32_t read_decimal(struct hatch_reader *reader)
{
    uint8_t byte = hatch_read_u8(reader);
    while (!reader->cut && (byte == ' ' || (byte >= '\t' && byte <= '\r') || byte == '#')) {
        while (byte == '#' && !reader->cut)
            while (byte != '\n' && !reader->cut)
                byte = hatch_read_u8(reader);
        byte = hatch_read_u8(reader);
    }
    uint32_t number = 0;
    for (; byte >= '0' && byte <= '9'; byte = hatch_read_u8(reader))
        number = number > UINT32_MAX / 10 - 1 ? UINT32_MAX : 10 * number + (byte - '0');
    reader->at -= reader->cut ? 0 : 1; /* the byte that ends it may begin a comment */
    return number;
}

/* Reads the header of a netpbm file, P1 .. P6, or of a PFM file, PF or Pf. */
static bool read_pnm(struct hatch_bytes file, struct hatch_foreign_header *header)
{
    struct hatch_reader reader = hatch_reader_of(file);
    hatch_read_u8(&reader);
    uint8_t kind = hatch_read_u8(&reader);
    if ((kind < '1' || kind > '6') && kind != 'F' && kind != 'f')
        return false;
    header->width = read_decimal(&reader);
    header->height = read_decimal(&reader);
    return header->width > 0 && header->height > 0;
}

/* Reads the line after the first empty one of a Radiance file, such as "-Y 480 +X 640". */
static bool read_hdr(struct hatch_bytes file, struct hatch_foreign_header *header)
{
    struct hatch_reader reader = hatch_reader_of(file);
    char line[LINE_MAX_BYTES] = "", axes[2];
    unsigned sides[2];
    uint8_t byte = 0, before = 0;
    do {
        before = byte;
        byte = hatch_read_u8(&reader);
    } while (!reader.cut && (byte != '\n' || before != '\n'));
    for (size_t i = 0; i + 1 < sizeof line && (i == 0 || line[i - 1] != '\n') && !reader.cut; i++)
        line[i] = (char)hatch_read_u8(&reader);
    if (sscanf(line, "%*1[+-]%c %9u %*1[+-]%c %9u", &axes[0], &sides[0], &axes[1], &sides[1]) != 4)
        return false;
    bool rows = axes[0] == 'Y' && axes[1] == 'X', columns = axes[0] == 'X' && axes[1] == 'Y';
    header->width = sides[rows ? 1 : 0];
    header->height = sides[rows ? 0 : 1];
    return (rows || columns) && header->width > 0 && header->height > 0;
}

bool hatch_foreign_header_read(struct hatch_bytes file, struct hatch_foreign_header *header)
{
    static const struct {
        const char *extension, *magic;
        size_t at, size; /* of magic */
        bool (*read)(struct hatch_bytes file, struct hatch_foreign_header *header);
    } formats[] = {
        {".jpeg", "\xff\xd8\xff", 0, 3, read_jpeg},
        {".tiff", "II*\0", 0, 4, read_tiff},
        {".tiff", "MM\0*", 0, 4, read_tiff},
        {".gif", "GIF8", 0, 4, read_gif},
        {".bmp", "BM", 0, 2, read_bmp},
        {".webp", "WEBPVP8", 8, 7, read_webp},
        {".jp2", "jP  \r\n\x87\n", 4, 8, read_jp2},
        {".j2k", "\xff\x4f\xff\x51", 0, 4, read_j2k},
        {".psd", "8BPS", 0, 4, read_psd},
        {".dds", "DDS ", 0, 4, read_dds},
        {".hdr", "#?R", 0, 3, read_hdr},
        {".ppm", "P", 0, 1, read_pnm},
    };
    for (size_t i = 0; i < sizeof formats / sizeof *formats; i++)
        if (has_magic(file, formats[i].at, formats[i].magic, formats[i].size)) {
            *header = (struct hatch_foreign_header){.extension = formats[i].extension};
            return formats[i].read(file, header);
        }
    return false;
}
