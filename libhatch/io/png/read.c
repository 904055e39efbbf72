#include "io/png/png.h"

#include <png.h>
#include <setjmp.h>
#include <stdlib.h>
#include <string.h>

#define SIDE_MAX (1u << 24)
#define PACK_RATIO_MAX 1032u       /* limit of deflate: unpacked bytes per packed byte */
#define CHUNK_BYTES_MAX (8u << 20) /* limit of ancillary chunks (ICC profiles, texts), which are not used */
#define SIGNATURE_BYTES 8u

/* State of reading. It is not kept in locals, which would be lost when libpng jumps. */
struct reading {
    struct hatch_bytes file;
    size_t at;
    struct hatch_arena *arena, *scratch;
    struct hatch_err *err;
    enum hatch_status status; /* HATCH_OK, or the status of the failure that err describes */
    bool out_of_memory;       /* an allocation of libpng has failed */
    struct hatch_image image;
    uint32_t depth, passes;
    uint8_t **rows;
};

static enum hatch_status fail_allocating(struct reading *r)
{
    return hatch_fail(r->err, HATCH_LIMIT, "out of memory for reading PNG");
}

static void *allocate_block(png_structp png, size_t size)
{
    struct reading *r = png_get_mem_ptr(png);
    void *block = malloc(size);
    r->out_of_memory |= !block;
    return block;
}

static void free_block(png_structp png, void *block)
{
    (void)png;
    free(block);
}

static void fail_decoding(png_structp png, png_const_charp message)
{
    struct reading *r = png_get_error_ptr(png);
    if (r->status == HATCH_OK && r->out_of_memory)
        r->status = fail_allocating(r);
    if (r->status == HATCH_OK)
        r->status = hatch_fail_quoting(r->err, HATCH_BAD_INPUT, message, "the PNG is damaged at byte %zu of %zu", r->at,
                                       r->file.size);
    longjmp(png_jmpbuf(png), 1);
}

/* Warnings concern ancillary chunks, which are not used. */
static void ignore_warning(png_structp png, png_const_charp message)
{
    (void)png;
    (void)message;
}

static void read_bytes(png_structp png, png_bytep out, size_t size)
{
    struct reading *r = png_get_io_ptr(png);
    if (size > r->file.size - r->at)
        png_error(png, "truncated");
    memcpy(out, r->file.data + r->at, size);
    r->at += size;
}

/* Ends decoding with the status of err. */
static void stop(png_structp png, enum hatch_status status)
{
    struct reading *r = png_get_error_ptr(png);
    r->status = status;
    png_error(png, "stopped");
}

static void check_size(png_structp png, png_infop info)
{
    struct reading *r = png_get_error_ptr(png);
    uint64_t width = png_get_image_width(png, info), height = png_get_image_height(png, info);
    uint64_t bits = (uint64_t)png_get_channels(png, info) * png_get_bit_depth(png, info);
    uint64_t floats = width * height * 4 * sizeof(float);
    size_t available = r->arena->limit_bytes - r->arena->used_bytes;
    if (floats > available)
        stop(png, hatch_fail(r->err, HATCH_LIMIT, "%llux%llu pixels need more than the %zu bytes allowed",
                             (unsigned long long)width, (unsigned long long)height, available));
    if (width * height * bits / 8 / PACK_RATIO_MAX > r->file.size)
        stop(png, hatch_fail(r->err, HATCH_BAD_INPUT,
                             "%llux%llu pixels in a file of %zu bytes: truncated, or the header is wrong",
                             (unsigned long long)width, (unsigned long long)height, r->file.size));
}

/* Expands palettes, low bit depths and transparent colours to channels of 8 or 16 bits. */
static void expand_channels(png_structp png, png_infop info)
{
    struct reading *r = png_get_error_ptr(png);
    png_set_expand(png);
    if (png_get_bit_depth(png, info) == 16)
        png_set_swap(png); /* to little-endian */
    r->passes = (uint32_t)png_set_interlace_handling(png);
    png_read_update_info(png, info);
    r->depth = png_get_bit_depth(png, info);
}

static void allocate(png_structp png, png_infop info)
{
    static const char *const names[] = {"", "Y", "YA", "RGB", "RGBA"};
    struct reading *r = png_get_error_ptr(png);
    uint32_t width = png_get_image_width(png, info), height = png_get_image_height(png, info);
    size_t row_bytes = png_get_rowbytes(png, info);
    enum hatch_status status =
        hatch_image_make(r->arena, width, height, names[png_get_channels(png, info)], &r->image, r->err);
    if (status != HATCH_OK)
        stop(png, status);
    r->rows = HATCH_NEW(r->scratch, uint8_t *, height, r->err);
    uint8_t *bytes = r->rows ? hatch_arena_array(r->scratch, height, row_bytes, r->err) : NULL;
    if (!bytes)
        stop(png, HATCH_LIMIT);
    for (uint32_t y = 0; y < height; y++)
        r->rows[y] = bytes + y * row_bytes;
}

static void read_all(png_structp png, png_infop info)
{
    struct reading *r = png_get_error_ptr(png);
    png_set_read_fn(png, r, read_bytes);
    png_set_user_limits(png, SIDE_MAX, SIDE_MAX);
    png_set_chunk_malloc_max(png, CHUNK_BYTES_MAX);
    png_set_crc_action(png, PNG_CRC_ERROR_QUIT, PNG_CRC_WARN_DISCARD);
    png_read_info(png, info);
    check_size(png, info);
    expand_channels(png, info);
    allocate(png, info);
    png_read_image(png, r->rows);
    png_read_end(png, NULL);
}

/* Reads the image. This function is the target of libpng's jumps and has no locals that a jump could invalidate. */
static void read_or_fail(png_structp png, png_infop info)
{
    if (setjmp(png_jmpbuf(png)) == 0)
        read_all(png, info);
}

static enum hatch_status convert_to_floats(struct reading *r)
{
    struct hatch_image *image = &r->image;
    uint32_t top = r->depth == 16 ? 65535u : 255u;
    float *linear;
    HATCH_TRY(HATCH_ALLOC(r->scratch, &linear, top + 1, r->err));
    for (uint32_t code = 0; code <= top; code++)
        linear[code] = hatch_srgb_to_linear((float)code / (float)top);
    uint32_t channels = image->channel_count;
    bool alpha = channels % 2 == 0;
    float *out = image->pixels;
    for (uint32_t y = 0; y < image->height; y++)
        for (size_t i = 0; i < (size_t)image->width * channels; i++, out++) {
            uint32_t code = r->depth == 16 ? ((const uint16_t *)(const void *)r->rows[y])[i] : r->rows[y][i];
            bool is_alpha = alpha && i % channels == channels - 1;
            *out = is_alpha ? (float)code / (float)top : linear[code];
        }
    return HATCH_OK;
}

static enum hatch_status decode(struct reading *r)
{
    png_structp png = png_create_read_struct_2(PNG_LIBPNG_VER_STRING, r, fail_decoding, ignore_warning, r,
                                               allocate_block, free_block);
    if (!png)
        return fail_allocating(r);
    png_infop info = png_create_info_struct(png);
    if (info)
        read_or_fail(png, info);
    /* libpng only warns of a chunk for which it had no memory, such as the transparent colours. */
    if (r->status == HATCH_OK && r->out_of_memory)
        r->status = fail_allocating(r);
    png_destroy_read_struct(&png, &info, NULL);
    return r->status == HATCH_OK ? convert_to_floats(r) : r->status;
}

enum hatch_status hatch_png_read(struct hatch_bytes file, struct hatch_arena *arena, struct hatch_arena *scratch,
                                 struct hatch_image *image, struct hatch_err *err)
{
    if (file.size < SIGNATURE_BYTES || png_sig_cmp(file.data, 0, SIGNATURE_BYTES))
        return hatch_fail(err, HATCH_BAD_INPUT, "not a PNG file");
    struct reading r = {.file = file, .arena = arena, .scratch = scratch, .err = err};
    struct hatch_arena_mark mark = hatch_arena_mark(arena), temporary = hatch_arena_mark(scratch);
    enum hatch_status status = decode(&r);
    hatch_arena_rewind(scratch, temporary);
    if (status == HATCH_OK)
        *image = r.image;
    else
        hatch_arena_rewind(arena, mark);
    return status;
}
