#include "arenas.h"

#include <math.h>
#include <string.h>

#include "base/random.h"
#include "fail_alloc.h"
#include "io/png/png.h"

#define LIMIT ((size_t)64 << 20)

static struct hatch_image ramp(uint32_t width, uint32_t height, const char *names)
{
    struct hatch_image image;
    HATCH_TEST_OK(hatch_image_make(&keep, width, height, names, &image, &err), &err);
    size_t count = (size_t)width * height * image.channel_count;
    for (size_t i = 0; i < count; i++)
        image.pixels[i] = hatch_random_unit(3, image.channel_count, i);
    return image;
}

static struct hatch_bytes encode(const struct hatch_image *image, enum hatch_png_encoding encoding, uint32_t depth)
{
    struct hatch_buffer file = {.arena = &keep};
    HATCH_TEST_OK(hatch_png_write(image, encoding, depth, "seed 1", &scratch, &file, &err), &err);
    return (struct hatch_bytes){file.data, file.size};
}

static const char *const channel_sets[] = {"Y", "YA", "RGB", "RGBA"};

/* A read value is at most half a step of sRGB from the written one. */
START_TEST(colours_are_exact_to_half_a_step)
{
    const char *names = channel_sets[_i / 2];
    uint32_t depth = _i % 2 ? 16 : 8;
    struct hatch_image image = ramp(61, 43, names), got;
    struct hatch_bytes file = encode(&image, HATCH_PNG_SRGB, depth);
    HATCH_TEST_OK(hatch_png_read(file, &keep, &scratch, &got, &err), &err);
    ck_assert_uint_eq(got.width, 61);
    ck_assert_uint_eq(got.height, 43);
    ck_assert_uint_eq(got.channel_count, strlen(names));
    float step = depth == 16 ? 1.0f / 65535 : 1.0f / 255;
    for (size_t i = 0; i < 61 * 43 * strlen(names); i++) {
        bool alpha = strlen(names) % 2 == 0 && i % strlen(names) == strlen(names) - 1;
        float a = alpha ? image.pixels[i] : hatch_linear_to_srgb(image.pixels[i]);
        float b = alpha ? got.pixels[i] : hatch_linear_to_srgb(got.pixels[i]);
        ck_assert_msg(fabsf(a - b) <= 0.5001f * step, "%g became %g", (double)a, (double)b);
    }
    struct hatch_bytes again = encode(&got, HATCH_PNG_SRGB, depth);
    ck_assert_msg(again.size == file.size && memcmp(again.data, file.data, file.size) == 0,
                  "the image that was read encodes to other bytes");
}
END_TEST

/* Appends the texts of a file, each as "KEY=VALUE;". */
static void list_texts(struct hatch_bytes file, char *list)
{
    for (size_t at = 8, size; at < file.size; at += 12 + size) {
        const uint8_t *chunk = file.data + at;
        size = (size_t)chunk[2] << 8 | chunk[3];
        for (size_t i = 0; memcmp(chunk + 4, "tEXt", 4) == 0 && i < size; i++)
            *list++ = chunk[8 + i] ? (char)chunk[8 + i] : '=';
        if (memcmp(chunk + 4, "tEXt", 4) == 0)
            *list++ = ';';
    }
    *list = '\0';
}

START_TEST(a_file_has_the_comment_that_is_given_and_no_other)
{
    static const char *const comments[] = {"seed 1", "", NULL};
    static const char *const want[] = {"Software=hatch;Comment=seed 1;", "Software=hatch;Comment=;", "Software=hatch;"};
    struct hatch_image image = ramp(2, 1, "Y");
    for (int i = 0; i < 3; i++) {
        char list[200];
        struct hatch_buffer file = {.arena = &keep};
        HATCH_TEST_OK(hatch_png_write(&image, HATCH_PNG_SRGB, 8, comments[i], &scratch, &file, &err), &err);
        list_texts((struct hatch_bytes){file.data, file.size}, list);
        ck_assert_str_eq(list, want[i]);
    }
}
END_TEST

/* Pictures of one row, in kinds that are written by others. */
static const struct {
    uint8_t file[128];
    size_t size;
    uint32_t width, channels;
    float code[16]; /* sRGB, and alpha */
} expanded[] = {
    /* Two bits of a palette, two entries of which have an alpha. */
    {"\x89PNG\r\n\x1a\n\0\0\0\x0dIHDR\0\0\0\x03\0\0\0\x01\x02\x03\0\0\0\x66\x8e\xfc\x27\0\0\0\tPLTE\xff\0\0\0\x33\0\0\0"
     "\xff"
     "\x01\xaf\xc8\x50\0\0\0\x02tRNS\xff\x33\x5a\x67\x51\x5c\0\0\0\nIDAT\x78\xda\x63\x90\0\0\0\x1a\0\x19\x80\0\x8e\xbb"
     "\0\0\0\0IEND\xae\x42\x60\x82",
     102,
     3,
     4,
     {1, 0, 0, 1, 0, 0.2f, 0, 0.2f, 0, 0, 1, 1}},
    /* One bit of a palette. */
    {"\x89PNG\r\n\x1a\n\0\0\0\x0dIHDR\0\0\0\x02\0\0\0\x01\x01\x03\0\0\0\xce\xec\xed\xc9\0\0\0\x06PLTE\xff\0\0\0\x33\xff"
     "\x98\xca\x98\xbe\0\0\0\nIDAT\x78\xda\x63\x70\0\0\0\x42\0\x41\x84\xbf\x8e\x62\0\0\0\0IEND\xae\x42\x60\x82",
     85,
     2,
     3,
     {1, 0, 0, 0, 0.2f, 1}},
    /* Two bits of grey, the third of which is transparent. */
    {"\x89PNG\r\n\x1a\n\0\0\0\x0dIHDR\0\0\0\x04\0\0\0\x01\x02\0\0\0\0\x96\xe7\x48\xb0\0\0\0\x02tRNS\0\x02\x98\x9d\xac"
     "\x14"
     "\0\0\0\nIDAT\x78\xda\x63\x90\x06\0\0\x1d\0\x1c\x23\x7c\x8f\xac\0\0\0\0IEND\xae\x42\x60\x82",
     81,
     4,
     2,
     {0, 1, 1 / 3.0f, 1, 2 / 3.0f, 0, 1, 1}},
    /* Sixteen bits, and a transparent colour that differs from another by one step. */
    {"\x89PNG\r\n\x1a\n\0\0\0\x0dIHDR\0\0\0\x02\0\0\0\x01\x10\x02\0\0\0\x2b\xd0\x34\x9e\0\0\0\x06tRNS\xff\xff\0\0\0\x01"
     "\x37\x01\x5b\x47\0\0\0\x12IDAT\x78\xda\x63\xf8\xff\x9f\x81\x81\x81\x11\x4c\x32\0\0\x21\xf2\x03\xfe\x2b\x30\x16"
     "\x34"
     "\0\0\0\0IEND\xae\x42\x60\x82",
     93,
     2,
     4,
     {1, 0, 1 / 65535.0f, 0, 1, 0, 0, 1}},
};

START_TEST(palettes_and_transparent_colours_are_expanded)
{
    struct hatch_image got;
    HATCH_TEST_OK(
        hatch_png_read((struct hatch_bytes){expanded[_i].file, expanded[_i].size}, &keep, &scratch, &got, &err), &err);
    ck_assert_uint_eq(got.width, expanded[_i].width);
    ck_assert_uint_eq(got.channel_count, expanded[_i].channels);
    for (uint32_t i = 0; i < got.width * got.channel_count; i++) {
        bool alpha = got.channel_count % 2 == 0 && i % got.channel_count == got.channel_count - 1;
        float want = alpha ? expanded[_i].code[i] : hatch_srgb_to_linear(expanded[_i].code[i]);
        ck_assert_float_eq_tol(got.pixels[i], want, 1e-7f);
    }
}
END_TEST

START_TEST(raw_values_are_rounded_to_nearest_and_clamped)
{
    static const float values[] = {-1, 0, 0.49f / 255, 0.51f / 255, 0.5f, 1, 2, NAN};
    static const float want[] = {0, 0, 0, 1, 128, 255, 255, 0};
    struct hatch_image image = ramp(8, 1, "Y"), got;
    memcpy(image.pixels, values, sizeof values);
    HATCH_TEST_OK(hatch_png_read(encode(&image, HATCH_PNG_RAW, 8), &keep, &scratch, &got, &err), &err);
    for (int i = 0; i < 8; i++)
        ck_assert(got.pixels[i] == hatch_srgb_to_linear(want[i] / 255));
}
END_TEST

START_TEST(truncated_files_are_refused_and_damaged_ones_harmless)
{
    struct hatch_image image = ramp(20, 20, "RGB"), got;
    struct hatch_bytes file = encode(&image, HATCH_PNG_SRGB, 8);
    for (size_t size = 0; size < file.size; size++) {
        struct hatch_bytes truncated = {file.data, size};
        ck_assert_int_eq(hatch_png_read(truncated, &keep, &scratch, &got, &err), HATCH_BAD_INPUT);
    }
    uint8_t *copy = HATCH_NEW(&keep, uint8_t, file.size, &err);
    uint32_t accepted = 0;
    for (size_t i = 0; i < file.size; i++) {
        memcpy(copy, file.data, file.size);
        copy[i] ^= 0x55;
        struct hatch_bytes damaged = {copy, file.size};
        accepted += hatch_png_read(damaged, &keep, &scratch, &got, &err) == HATCH_OK;
    }
    ck_assert_msg(accepted < 80, "%u damaged files were accepted", accepted);
}
END_TEST

/* The header of 33 bytes claims 60,000 x 60,000 pixels; no image data follow. */
START_TEST(a_wrong_header_is_refused_before_any_allocation)
{
    static const uint8_t wrong_header[] = {0x89, 'P',  'N',  'G',  13,   10,   26, 10, 0,    0,    0,   13,  'I', 'H',
                                           'D',  'R',  0,    0,    0xea, 0x60, 0,  0,  0xea, 0x60, 8,   2,   0,   0,
                                           0,    0x0f, 0xb0, 0xe2, 0x15, 0,    0,  0,  1,    'I',  'D', 'A', 'T'};
    uint8_t file[100] = {0};
    memcpy(file, wrong_header, sizeof wrong_header);
    struct hatch_bytes bytes = {file, sizeof file};
    struct hatch_image got;
    struct hatch_arena small, large;
    hatch_arena_init(&small, LIMIT);
    hatch_arena_init(&large, SIZE_MAX);
    ck_assert_int_eq(hatch_png_read(bytes, &small, &scratch, &got, &err), HATCH_LIMIT);
    ck_assert_int_eq(hatch_png_read(bytes, &large, &scratch, &got, &err), HATCH_BAD_INPUT);
    ck_assert_uint_eq(small.peak_bytes + large.peak_bytes + scratch.peak_bytes, 0);
}
END_TEST

/* Four floats per pixel must fit, whatever the image has. */
START_TEST(an_image_may_take_all_memory)
{
    struct hatch_image image = ramp(64, 64, "Y"), got;
    struct hatch_bytes file = encode(&image, HATCH_PNG_SRGB, 8);
    for (size_t missing = 0; missing < 2; missing++) {
        struct hatch_arena small;
        hatch_arena_init(&small, 64 * 64 * 4 * sizeof(float) - missing);
        ck_assert_int_eq(hatch_png_read(file, &small, &scratch, &got, &err), missing ? HATCH_LIMIT : HATCH_OK);
        hatch_arena_free(&small);
    }
}
END_TEST

/* A flat picture of 344 x 200 in RGB has 1032 bytes per row, as many as deflate can pack into one byte; its file is cut
 * to one byte per row and to one less. The signature alone is eight bytes. */
START_TEST(a_file_may_be_as_short_as_deflate_can_make_it)
{
    struct hatch_image image, got;
    HATCH_TEST_OK(hatch_image_make(&keep, 344, 200, "RGB", &image, &err), &err);
    struct hatch_bytes file = encode(&image, HATCH_PNG_SRGB, 8);
    ck_assert_uint_gt(file.size, 200);
    for (size_t missing = 0; missing < 2; missing++) {
        file.size = 200 - missing;
        ck_assert_int_eq(hatch_png_read(file, &keep, &scratch, &got, &err), HATCH_BAD_INPUT);
        ck_assert_ptr_nonnull(strstr(err.text, missing ? "344x200 pixels in a file of 199 bytes" : "is damaged at"));
    }
    for (size_t missing = 0; missing < 2; missing++) {
        file.size = 8 - missing;
        ck_assert_int_eq(hatch_png_read(file, &keep, &scratch, &got, &err), HATCH_BAD_INPUT);
        ck_assert_ptr_nonnull(strstr(err.text, missing ? "not a PNG file" : "is damaged at byte 8 of 8"));
    }
}
END_TEST

struct reading {
    struct hatch_bytes file;
    struct hatch_image image;
};

static enum hatch_status read_file(void *context, struct hatch_arena *arena, struct hatch_arena *temporary,
                                   struct hatch_err *error)
{
    struct reading *reading = context;
    return hatch_png_read(reading->file, arena, temporary, &reading->image, error);
}

static enum hatch_status write_file(void *context, struct hatch_arena *arena, struct hatch_arena *temporary,
                                    struct hatch_err *error)
{
    struct hatch_buffer file = {.arena = arena};
    enum hatch_status status = hatch_png_write(context, HATCH_PNG_RAW, 16, NULL, temporary, &file, error);
    ck_assert(status == HATCH_OK || file.size == 0);
    return status;
}

START_TEST(each_allocation_may_fail)
{
    struct hatch_image image = ramp(5, 5, "YA");
    struct reading reading = {.file = encode(&image, HATCH_PNG_SRGB, 8)};
    hatch_test_fail_alloc(read_file, &reading, &reading.image, sizeof reading.image);
    hatch_test_fail_alloc(write_file, &image, NULL, 0);
}
END_TEST

static Suite *suite(void)
{
    Suite *suite = suite_create("io png");
    TCase *tests = tcase_create("png");
    tcase_add_checked_fixture(tests, begin, end);
    tcase_add_loop_test(tests, colours_are_exact_to_half_a_step, 0, 8);
    tcase_add_loop_test(tests, palettes_and_transparent_colours_are_expanded, 0, 4);
    tcase_add_test(tests, raw_values_are_rounded_to_nearest_and_clamped);
    tcase_add_test(tests, truncated_files_are_refused_and_damaged_ones_harmless);
    tcase_add_test(tests, a_wrong_header_is_refused_before_any_allocation);
    tcase_add_test(tests, each_allocation_may_fail);
    tcase_add_test(tests, a_file_has_the_comment_that_is_given_and_no_other);
    tcase_add_test(tests, an_image_may_take_all_memory);
    tcase_add_test(tests, a_file_may_be_as_short_as_deflate_can_make_it);
    suite_add_tcase(suite, tests);
    return suite;
}
HATCH_TEST_MAIN(suite)
