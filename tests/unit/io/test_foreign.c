/* Images that the plugin would read are refused by the size in their header, before the plugin is opened. */
#include <math.h>
#include <string.h>

#include "arenas.h"
#include "io/exr/exr.h"
#include "io/foreign/foreign.h"
#include "io/foreign/header.h"

#define BMP_BYTES 26
#define SIDE_MAX (1u << 24)

/* Reads the header of a BMP file, with an arena of some bytes and without a plugin. */
static enum hatch_status read_bmp(uint32_t width, uint32_t height, size_t limit_bytes)
{
    uint8_t file[BMP_BYTES] = {'B', 'M', [14] = 40};
    struct hatch_arena arena;
    struct hatch_image image;
    for (int i = 0; i < 4; i++) {
        file[18 + i] = (uint8_t)(width >> (8 * i));
        file[22 + i] = (uint8_t)(height >> (8 * i));
    }
    hatch_arena_init(&arena, limit_bytes);
    enum hatch_status status = hatch_image_read_any((struct hatch_bytes){file, sizeof file}, "a.bmp", "/none/plugin.so",
                                                    &arena, &scratch, &image, &err);
    hatch_arena_free(&arena);
    return status;
}

static bool needs_plugin(void)
{
    return strstr(err.text, "/none/plugin.so") != NULL;
}

/* The fewest bytes that an image may need are one float per pixel. */
START_TEST(an_image_beyond_the_memory_is_refused)
{
    static const uint32_t sizes[][2] = {{1, 1}, {7, 5}, {640, 480}, {SIDE_MAX, 1}, {1, SIDE_MAX}};
    for (size_t i = 0; i < sizeof sizes / sizeof *sizes; i++) {
        size_t bytes = (size_t)sizes[i][0] * sizes[i][1] * sizeof(float);
        ck_assert_int_eq(read_bmp(sizes[i][0], sizes[i][1], bytes), HATCH_BAD_INPUT);
        ck_assert(needs_plugin());
        ck_assert_int_eq(read_bmp(sizes[i][0], sizes[i][1], bytes - 1), HATCH_LIMIT);
        ck_assert(!needs_plugin());
    }
}
END_TEST

START_TEST(an_image_with_a_huge_side_is_refused)
{
    for (int turned = 0; turned < 2; turned++) {
        uint32_t side = SIDE_MAX + 1;
        ck_assert_int_eq(read_bmp(turned ? 1 : side, turned ? side : 1, (size_t)1 << 30), HATCH_LIMIT);
    }
}
END_TEST

START_TEST(rows_may_run_from_the_top_down)
{
    ck_assert_int_eq(read_bmp(4, (uint32_t)-4, 64), HATCH_BAD_INPUT);
    ck_assert(needs_plugin());
    ck_assert_int_eq(read_bmp(4, (uint32_t)-4, 63), HATCH_LIMIT);
}
END_TEST

START_TEST(an_image_has_four_bytes_at_least)
{
    for (size_t size = 3; size <= 4; size++) {
        struct hatch_image image;
        ck_assert_int_eq(hatch_image_read_any((struct hatch_bytes){(const uint8_t *)"none", size}, "a.bmp",
                                              "/none/plugin.so", &keep, &scratch, &image, &err),
                         HATCH_BAD_INPUT);
        ck_assert_int_eq(needs_plugin(), size == 4);
    }
}
END_TEST

/* Headers of a width and a height in bytes. Their values end with the last byte, so that a shorter file has none. */
#define BYTES(...)                                                                                                     \
    (const uint8_t[]){__VA_ARGS__}, sizeof(const uint8_t[])                                                            \
    {                                                                                                                  \
        __VA_ARGS__                                                                                                    \
    }
#define TEXT(text) (const uint8_t *)(text), sizeof(text) - 1
#define TIFF_LITTLE(type, ...)                                                                                         \
    'I', 'I', '*', 0, 10, 0, 0, 0, 99, 99, /* the directory is at 10 */                                                \
        2, 0, 0, 1, type, 0, 1, 0, 0, 0, __VA_ARGS__, 1, 1, type, 0, 1, 0, 0, 0
#define WEBP(...) 'R', 'I', 'F', 'F', 9, 9, 9, 9, 'W', 'E', 'B', 'P', 'V', 'P', '8', __VA_ARGS__
/* The marker segment of sizes: right, bottom, left, top. */
#define J2K(...) 0xff, 0x4f, 0xff, 0x51, 9, 9, 9, 9, __VA_ARGS__
#define JP2(...)                                                                                                       \
    0, 0, 0, 12, 'j', 'P', ' ', ' ', '\r', '\n', 0x87, '\n', 0, 0, 0, 1, 'f', 't', 'y', 'p', 0, 0, 0, 0, 0, 0, 0, 17,  \
        9, __VA_ARGS__ /* a box with a size of 64 bits */
static const struct {
    const char *extension;
    const uint8_t *bytes;
    size_t size;
    uint32_t width, height;
    bool truncated, whole; /* whole: a shorter file is refused */
} headers[] = {
    {".gif", BYTES('G', 'I', 'F', '8', '9', 'a', 7, 1, 5, 2), 0x107, 0x205, false, true},
    {".bmp", BYTES('B', 'M', [14] = 40, [18] = 7, 1, 0, 0, 5, 2, 0, 0), 0x107, 0x205, false, true},
    {".bmp", BYTES('B', 'M', [14] = 41, [18] = 7, 0, 1, 0, 0xff, 0xff, 0xff, 0xff), 0x10007, 1, false, true},
    {".tiff", BYTES(TIFF_LITTLE(3, 7, 1, 9, 9), 5, 2, 9, 9), 0x107, 0x205, false, false},
    {".tiff", BYTES(TIFF_LITTLE(4, 7, 0, 1, 0), 5, 0, 0, 1), 0x10007, 0x1000005, false, false},
    /* An entry beyond those of the directory does not count. */
    {".tiff", BYTES(TIFF_LITTLE(3, 7, 1, 9, 9), 5, 2, 9, 9, 0, 1, 3, 0, 1, 0, 0, 0, 1, 0, 0, 0), 0x107, 0x205, false,
     false},
    {".tiff",
     BYTES('M', 'M', 0, '*', 0, 0, 0, 8, 0, 2, 1, 0, 0, 3, 0, 0, 0, 1, 1, 7, 9, 9, 1, 1, 0, 3, 0, 0, 0, 1, 2, 5), 0x107,
     0x205, false, false},
    /* A segment of 4 bytes, a filling byte, a frame, a scan, its end. */
    {".jpeg",
     BYTES(0xff, 0xd8, 0xff, 0xe0, 0, 4, 1, 1, 0xff, 0xff, 0xc0, 0, 7, 8, 2, 5, 1, 7, 0xff, 0xda, 0, 2, 3, 0xff, 0xd9),
     0x107, 0x205, false, false},
    {".jpeg", BYTES(0xff, 0xd8, 0xff, 0xcf, 0, 7, 8, 2, 5, 1, 7, 0xff, 0xda, 0, 2, 3, 0xff), 0x107, 0x205, true, false},
    {".jpeg", BYTES(0xff, 0xd8, 0xff, 0xc0, 0, 7, 8, 2, 5, 0, 1, 0xff, 0xda, 0, 2, 0xff, 0xd9), 1, 0x205, false, false},
    /* Files that end between two segments, and in the second one. */
    {".jpeg", BYTES(0xff, 0xd8, 0xff, 0xc0, 0, 7, 8, 2, 5, 0, 1), 1, 0x205, true, false},
    {".jpeg", BYTES(0xff, 0xd8, 0xff, 0xc0, 0, 7, 8, 2, 5, 0, 1, 0xff, 0xe0, 0, 9, 1), 1, 0x205, true, false},
    /* C4, C8 and CC begin other segments. */
    {".jpeg",
     BYTES(0xff, 0xd8, 0xff, 0xc4, 0, 7, 8, 9, 9, 9, 9, 0xff, 0xc8, 0, 7, 8, 9, 9, 9, 9, 0xff, 0xcc, 0, 7, 8, 9, 9, 9,
           9, 0xff, 0xc1, 0, 7, 8, 2, 5, 1, 7, 0xff, 0xda, 0, 2, 0xff, 0xd9),
     0x107, 0x205, false, false},
    {".webp", BYTES(WEBP('X', 10, 0, 0, 0, 16, 0, 0, 0, 6, 1, 1, 4, 2, 0)), 0x10107, 0x205, false, true},
    /* 14 bits of the width, 14 bits of the height, each less 1. */
    {".webp", BYTES(WEBP('L', 9, 9, 9, 9, 0x2f, 0x06, 0x01, 0x81, 0x10)), 0x107, 0x205, false, true},
    {".webp", BYTES(WEBP(' ', 9, 9, 9, 9, 9, 9, 9, 0x9d, 1, 0x2a, 7, 0x41, 5, 0x82)), 0x107, 0x205, false, true},
    {".j2k", BYTES(J2K(0, 0, 1, 9, 0, 0, 2, 6, 0, 0, 0, 2, 0, 0, 0, 1)), 0x107, 0x205, false, true},
    {".jp2", BYTES(JP2(0, 0, 0, 0, 'j', 'p', '2', 'c', J2K(0, 0, 1, 7, 0, 0, 2, 5, 0, 0, 0, 0, 0, 0, 0, 0))), 0x107,
     0x205, false, true},
    {".psd", BYTES('8', 'B', 'P', 'S', 0, 1, 9, 9, 9, 9, 9, 9, 9, 9, 0, 0, 2, 5, 0, 1, 0, 7), 0x10007, 0x205, false,
     true},
    {".dds", BYTES('D', 'D', 'S', ' ', 124, 0, 0, 0, 9, 9, 9, 9, 5, 2, 0, 0, 7, 0, 1, 0), 0x10007, 0x205, false, true},
    {".ppm", BYTES('P', '6', '\n', '2', '6', '3', ' ', '5', '1', '7', '\n'), 263, 517, false, false},
    {".ppm", BYTES('P', '1', '#', '7', '\n', '#', '\n', ' ', '2', '#', '9', '\n', '3', '\n'), 2, 3, false, false},
    {".ppm", BYTES('P', 'f', ' ', '9', '9', '9', '9', '9', '9', '9', '9', '9', '9', '9', ' ', '1'), UINT32_MAX, 1,
     false, false},
    {".hdr", TEXT("#?RADIANCE\nA=1\n\n-Y 517 +X 263\n"), 263, 517, false, false},
    {".hdr", TEXT("#?RGBE\n\n+X 263 -Y 517\n"), 263, 517, false, false},
};

START_TEST(headers_have_a_size)
{
    struct hatch_foreign_header header;
    ck_assert(hatch_foreign_header_read((struct hatch_bytes){headers[_i].bytes, headers[_i].size}, &header));
    ck_assert_str_eq(header.extension, headers[_i].extension);
    ck_assert_uint_eq(header.width, headers[_i].width);
    ck_assert_uint_eq(header.height, headers[_i].height);
    ck_assert_int_eq(header.truncated, headers[_i].truncated);
    if (headers[_i].whole)
        ck_assert(!hatch_foreign_header_read((struct hatch_bytes){headers[_i].bytes, headers[_i].size - 1}, &header));
}
END_TEST

static const struct {
    const uint8_t *bytes;
    size_t size;
} without_size[] = {
    {BYTES('G', 'I', 'F')},
    {BYTES('B', 'M', [14] = 39, [18] = 7, 0, 0, 0, 5, 0, 0, 0)},
    {BYTES(0xff, 0xd8, 0xff, 0xe0, 0, 2, 0xfe, 0xc0, 0, 7, 8, 2, 5, 1, 7, 0xff,
           0xda)}, /* no marker after the segment */
    {BYTES(0xff, 0xd8, 0xff, 0xda, 0, 2, 0xff, 0xd9)},
    {BYTES('I', 'I', '*', 0, 11, 0, 0, 0, 0, 0)},
    {BYTES(TIFF_LITTLE(3, 0, 0, 0, 0), 5, 2, 0, 0)},
    {BYTES(TIFF_LITTLE(3, 7, 1, 0, 0), 0, 0, 0, 0)},
    {BYTES(WEBP(' ', 9, 9, 9, 9, 9, 9, 9, 0x9e, 1, 0x2a, 7, 0, 5, 0))},
    {BYTES(WEBP(' ', 9, 9, 9, 9, 9, 9, 9, 0x9d, 1, 0x2a, 0, 0x40, 5, 0))},
    {BYTES(J2K(0, 0, 1, 7, 0, 0, 2, 5, 0, 0, 1, 7, 0, 0, 0, 0))},
    {BYTES(JP2(0, 0, 0, 7, 'j', 'p', '2', 'h', 0, 0, 0, 0))},
    {BYTES(JP2(0, 0, 0, 20, 'j', 'p'))}, /* ends within the next box's type */
    {BYTES(JP2(0xff, 0, 0, 0, 'j', 'p', '2', 'h', 0, 0, 0, 0))},
    {BYTES('P', '7', '\n', '2', ' ', '3', '\n')},
    {BYTES('P', '6', '\n', '2', ' ', 'x', '\n')},
    {TEXT("#?RADIANCE\n-Y 517 +X 263\n")},
    {TEXT("#?RADIANCE\n\n-Y 517 +Y 263\n")},
};

START_TEST(headers_may_lack_a_size)
{
    struct hatch_foreign_header header;
    ck_assert(!hatch_foreign_header_read((struct hatch_bytes){without_size[_i].bytes, without_size[_i].size}, &header));
}
END_TEST

/* Colours of OpenEXR files are multiplied by alpha; in memory they are not. Where alpha is 0 or not finite they stay.
 */
START_TEST(colours_of_exr_are_divided_by_alpha)
{
    static const float file_pixels[2][5][4] = {
        {{.25f, .125f, .0625f, .5f}, {.75f, .5f, .25f, 1}, {.5f, .25f, 2, 0}, {.5f, .25f, 1, INFINITY}, {0, 0, 0, .5f}},
        {{.25f, .5f}, {.75f, 1}, {2, 0}, {1, INFINITY}, {0, .5f}}};
    static const float want[2][5][4] = {
        {{.5f, .25f, .125f, .5f}, {.75f, .5f, .25f, 1}, {.5f, .25f, 2, 0}, {.5f, .25f, 1, INFINITY}, {0, 0, 0, .5f}},
        {{.5f, .5f}, {.75f, 1}, {2, 0}, {1, INFINITY}, {0, .5f}}};
    for (int grey = 0; grey < 2; grey++) {
        struct hatch_image image, got;
        struct hatch_mipmap part = {.level_count = 1, .levels = &image};
        struct hatch_buffer file = {.arena = &keep};
        HATCH_TEST_OK(hatch_image_make(&keep, 5, 1, grey ? "YA" : "RGBA", &image, &err), &err);
        for (uint32_t i = 0; i < 5 * image.channel_count; i++)
            image.pixels[i] = file_pixels[grey][i / image.channel_count][i % image.channel_count];
        HATCH_TEST_OK(hatch_exr_write(&part, &keep, &file, &err), &err);
        HATCH_TEST_OK(hatch_image_read_any((struct hatch_bytes){file.data, file.size}, "", "/none/plugin.so", &keep,
                                           &scratch, &got, &err),
                      &err);
        for (uint32_t i = 0; i < 5 * got.channel_count; i++)
            ck_assert_float_eq(got.pixels[i], want[grey][i / got.channel_count][i % got.channel_count]);
    }
}
END_TEST

/* Writes a picture of 3 x 2 pixels, whose values are 1 to 6, and changes its display window.
 *   window  least x and y, largest x and y */
static struct hatch_bytes framed(const int32_t window[4])
{
    struct hatch_image image;
    struct hatch_mipmap part = {.level_count = 1, .levels = &image};
    struct hatch_buffer file = {.arena = &keep};
    static const char key[] = "displayWindow\0box2i\0\20\0\0";
    HATCH_TEST_OK(hatch_image_make(&keep, 3, 2, "Y", &image, &err), &err);
    for (uint32_t i = 0; i < 6; i++)
        image.pixels[i] = (float)(i + 1);
    HATCH_TEST_OK(hatch_exr_write(&part, &keep, &file, &err), &err);
    size_t at = 0;
    while (memcmp(file.data + at, key, sizeof key) != 0)
        at++;
    for (size_t i = 0; i < 16; i++)
        file.data[at + sizeof key + i] = (uint8_t)((uint32_t)window[i / 4] >> i % 4 * 8);
    return (struct hatch_bytes){file.data, file.size};
}

static const struct {
    int32_t window[4];
    float want[12]; /* row by row */
} frames[] = {
    {{0, 0, 2, 1}, {1, 2, 3, 4, 5, 6}},
    {{-1, 0, 3, 1}, {0, 1, 2, 3, 0, 0, 4, 5, 6, 0}},
    {{0, -1, 2, 0}, {0, 0, 0, 1, 2, 3}},
    {{1, 0, 1, 2}, {2, 5, 0}},
    {{2, 1, 4, 3}, {6}},
    {{3, 0, 4, 1}, {0}},
    {{-4, -3, -1, -1}, {0}},
    {{0, 2, 1, 2}, {0}},
    {{1 << 29, 5, 1 << 29, 5}, {0}},
};

/* OpenEXR refuses windows whose largest coordinate is the smaller one, so that no picture is empty. */
START_TEST(pictures_of_exr_have_their_display_window)
{
    const int32_t *window = frames[_i].window;
    struct hatch_image got;
    HATCH_TEST_OK(hatch_image_read_any(framed(window), "", "/none/plugin.so", &keep, &scratch, &got, &err), &err);
    ck_assert_int_eq((int)got.width, window[2] - window[0] + 1);
    ck_assert_int_eq((int)got.height, window[3] - window[1] + 1);
    for (uint32_t i = 0; i < got.width * got.height; i++)
        ck_assert_float_eq(got.pixels[i], frames[_i].want[i]);
    const int32_t empty[] = {window[2], window[1], window[2] - 1, window[3]};
    ck_assert_int_eq(hatch_image_read_any(framed(empty), "", "", &keep, &scratch, &got, &err), HATCH_BAD_INPUT);
}
END_TEST

/* Up to 2^25 pixels are allowed; they need more memory than there is. */
START_TEST(display_windows_are_limited)
{
    static const int32_t allowed[] = {0, 0, 4095, 8191}, larger[] = {0, 0, 8191, 8191}, most[] = {0, 0, INT32_MAX, 0};
    struct hatch_image got;
    struct hatch_arena small;
    hatch_arena_init(&small, 1 << 16);
    ck_assert_int_eq(hatch_image_read_any(framed(allowed), "", "", &small, &scratch, &got, &err), HATCH_LIMIT);
    ck_assert_int_eq(hatch_image_read_any(framed(larger), "", "", &small, &scratch, &got, &err), HATCH_BAD_INPUT);
    ck_assert_str_eq(err.text, "a display window of 8192x8192 pixels, of which the file holds 3x2");
    ck_assert_int_ne(hatch_image_read_any(framed(most), "", "", &small, &scratch, &got, &err), HATCH_OK);
    ck_assert_uint_le(small.peak_bytes, 1 << 16);
    hatch_arena_free(&small);
}
END_TEST

static Suite *suite(void)
{
    Suite *suite = suite_create("io foreign");
    TCase *tests = tcase_create("foreign");
    tcase_add_checked_fixture(tests, begin, end);
    tcase_add_test(tests, an_image_beyond_the_memory_is_refused);
    tcase_add_test(tests, an_image_with_a_huge_side_is_refused);
    tcase_add_test(tests, rows_may_run_from_the_top_down);
    tcase_add_test(tests, an_image_has_four_bytes_at_least);
    tcase_add_test(tests, colours_of_exr_are_divided_by_alpha);
    tcase_add_loop_test(tests, pictures_of_exr_have_their_display_window, 0, sizeof frames / sizeof *frames);
    tcase_add_test(tests, display_windows_are_limited);
    tcase_add_loop_test(tests, headers_have_a_size, 0, sizeof headers / sizeof *headers);
    tcase_add_loop_test(tests, headers_may_lack_a_size, 0, sizeof without_size / sizeof *without_size);
    suite_add_tcase(suite, tests);
    return suite;
}
HATCH_TEST_MAIN(suite)
