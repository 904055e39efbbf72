#include "io/foreign/header.h"

#include <string.h>

#define JPEG_START_OF_SCAN 0xda
#define JPEG_END 0xd9
#define TIFF_WIDTH 256
#define TIFF_HEIGHT 257
#define TIFF_SHORT 3

static bool has_magic(struct hatch_bytes file, const void *magic, size_t size)
{
    return file.size >= size && memcmp(file.data, magic, size) == 0;
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

bool hatch_foreign_header_read(struct hatch_bytes file, struct hatch_foreign_header *header)
{
    static const struct {
        const char *extension, *magic;
        size_t size; /* size of magic */
        bool (*read)(struct hatch_bytes file, struct hatch_foreign_header *header);
    } formats[] = {
        {".jpeg", "\xff\xd8\xff", 3, read_jpeg}, {".tiff", "II*\0", 4, read_tiff}, {".tiff", "MM\0*", 4, read_tiff},
        {".gif", "GIF8", 4, read_gif},           {".bmp", "BM", 2, read_bmp},
    };
    for (size_t i = 0; i < sizeof formats / sizeof *formats; i++)
        if (has_magic(file, formats[i].magic, formats[i].size)) {
            *header = (struct hatch_foreign_header){.extension = formats[i].extension};
            return formats[i].read(file, header);
        }
    return false;
}
