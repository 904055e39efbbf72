#include "io/png/png.h"

#include <assert.h>
#include <math.h>
#include <png.h>
#include <setjmp.h>
#include <stdbool.h>
#include <string.h>

#define ZLIB_LEVEL 6
#define GUESSES 4096u /* table size for which a guess is at most one code too low */

/* Table for encoding 8 bits of sRGB without a power per pixel: code k stands for values from border[k - 1] up
 * to, but not including, border[k]. */
struct codes {
    float border[256];
    uint8_t guess[GUESSES + 1]; /* index: value * GUESSES; the code of the value or the one below it */
};

struct writing {
    const struct hatch_image *image;
    enum hatch_png_encoding encoding;
    uint32_t depth, channels;
    const char *comment;
    struct hatch_buffer *file;
    struct hatch_err *err;
    enum hatch_status status;
    struct codes *codes;
    uint8_t *row;
};

static void fail_encoding(png_structp png, png_const_charp message)
{
    struct writing *w = png_get_error_ptr(png);
    if (w->status == HATCH_OK)
        w->status = hatch_fail(w->err, HATCH_LIMIT, "PNG: %s", message);
    longjmp(png_jmpbuf(png), 1);
}

static void ignore_warning(png_structp png, png_const_charp message)
{
    (void)png;
    (void)message;
}

static void write_bytes(png_structp png, png_bytep bytes, size_t size)
{
    struct writing *w = png_get_io_ptr(png);
    w->status = hatch_buffer_add(w->file, bytes, size, w->err);
    if (w->status != HATCH_OK)
        png_error(png, "stopped");
}

static void flush(png_structp png)
{
    (void)png;
}

static void fill_codes(struct codes *codes)
{
    for (uint32_t k = 0; k < 255; k++)
        codes->border[k] = hatch_srgb_to_linear(((float)k + 0.5f) / 255.0f);
    codes->border[255] = INFINITY;
    uint32_t code = 0;
    for (uint32_t i = 0; i <= GUESSES; i++) {
        while ((float)i / GUESSES >= codes->border[code])
            code++;
        codes->guess[i] = (uint8_t)code;
    }
}

static uint32_t code_of(const struct writing *w, float value, bool is_alpha)
{
    float clamped = value > 0 ? (value < 1 ? value : 1) : 0; /* NaN becomes 0 */
    uint32_t top = w->depth == 16 ? 65535u : 255u;
    if (w->encoding == HATCH_PNG_RAW || is_alpha)
        return (uint32_t)(clamped * (float)top + 0.5f);
    if (w->depth == 16)
        return (uint32_t)(hatch_linear_to_srgb(clamped) * (float)top + 0.5f);
    uint32_t code = w->codes->guess[(uint32_t)(clamped * GUESSES)];
    while (clamped >= w->codes->border[code])
        code++;
    return code;
}

static void encode_row(const struct writing *w, uint32_t y)
{
    const struct hatch_image *image = w->image;
    const float *in = image->pixels + (size_t)y * image->width * image->channel_count;
    uint8_t *out = w->row;
    for (uint32_t x = 0; x < image->width; x++, in += image->channel_count)
        for (uint32_t c = 0; c < w->channels; c++) {
            bool is_alpha = w->channels % 2 == 0 && c == w->channels - 1;
            uint32_t code = code_of(w, in[c], is_alpha);
            if (w->depth == 16)
                *out++ = (uint8_t)(code >> 8);
            *out++ = (uint8_t)code;
        }
}

static void put_text(png_structp png, png_infop info, const char *comment)
{
    static char software_key[] = "Software", software[] = "hatch", comment_key[] = "Comment";
    char copy[1024] = {0};
    if (comment)
        strncat(copy, comment, sizeof copy - 1);
    png_text texts[] = {{.compression = PNG_TEXT_COMPRESSION_NONE, .key = software_key, .text = software},
                        {.compression = PNG_TEXT_COMPRESSION_NONE, .key = comment_key, .text = copy}};
    png_set_text(png, info, texts, comment ? 2 : 1);
}

static void write_all(png_structp png, png_infop info)
{
    static const int colors[] = {0, PNG_COLOR_TYPE_GRAY, PNG_COLOR_TYPE_GRAY_ALPHA, PNG_COLOR_TYPE_RGB,
                                 PNG_COLOR_TYPE_RGB_ALPHA};
    struct writing *w = png_get_error_ptr(png);
    png_set_write_fn(png, w, write_bytes, flush);
    png_set_compression_level(png, ZLIB_LEVEL);
    png_set_IHDR(png, info, w->image->width, w->image->height, (int)w->depth, colors[w->channels], PNG_INTERLACE_NONE,
                 PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
    if (w->encoding == HATCH_PNG_SRGB)
        png_set_sRGB(png, info, PNG_sRGB_INTENT_PERCEPTUAL);
    put_text(png, info, w->comment);
    png_write_info(png, info);
    for (uint32_t y = 0; y < w->image->height; y++) {
        encode_row(w, y);
        png_write_row(png, w->row);
    }
    png_write_end(png, NULL);
}

/* Writes the image. This function is the target of libpng's jumps and has no locals that a jump could invalidate. */
static void write_or_fail(png_structp png, png_infop info)
{
    if (setjmp(png_jmpbuf(png)) == 0)
        write_all(png, info);
}

static enum hatch_status encode(struct writing *w)
{
    png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, w, fail_encoding, ignore_warning);
    if (!png)
        return hatch_fail(w->err, HATCH_LIMIT, "out of memory for writing PNG");
    png_infop info = png_create_info_struct(png);
    if (info)
        write_or_fail(png, info);
    else
        w->status = hatch_fail(w->err, HATCH_LIMIT, "out of memory for writing PNG");
    png_destroy_write_struct(&png, &info);
    return w->status;
}

enum hatch_status hatch_png_write(const struct hatch_image *image, enum hatch_png_encoding encoding, uint32_t depth,
                                  const char *comment, struct hatch_arena *scratch, struct hatch_buffer *file,
                                  struct hatch_err *err)
{
    assert(depth == 8 || depth == 16);
    uint32_t channels = image->channel_count < 4 ? image->channel_count : 4;
    struct writing w = {image, encoding, depth, channels, comment, file, err, HATCH_OK, NULL, NULL};
    assert(file->arena != scratch);
    size_t before = file->size;
    struct hatch_arena_mark mark = hatch_arena_mark(scratch);
    w.codes = HATCH_NEW(scratch, struct codes, 1, err);
    w.row = w.codes ? HATCH_NEW(scratch, uint8_t, (size_t)image->width * channels * depth / 8, err) : NULL;
    enum hatch_status status = HATCH_LIMIT;
    if (w.row) {
        fill_codes(w.codes);
        status = encode(&w);
    }
    hatch_arena_rewind(scratch, mark);
    if (status != HATCH_OK)
        file->size = before;
    return status;
}
