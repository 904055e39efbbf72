#include "run.h"

#include <string.h>
#include <zstd.h>

#include "base/random.h"
#include "fail_alloc.h"
#include "io/texture/container.h"

#define LIMIT ((size_t)64 << 20)

static struct hatch_arena keep;
static struct hatch_err err;

static void begin(void)
{
    hatch_arena_init(&keep, LIMIT);
}

static void end(void)
{
    hatch_arena_free(&keep);
}

static const struct hatch_texels kinds[] = {
    {.width = 64, .height = 64, .channels = 3, .level_count = 7},
    {.width = 37, .height = 11, .channels = 3, .level_count = 6},
    {.width = 16, .height = 16, .layers = 6, .channels = 1, .level_count = 5},
    {.width = 9, .height = 7, .layers = 1, .channels = 2, .level_count = 3},
    {.width = 8, .height = 8, .depth = 19, .channels = 4, .level_count = 5},
    {.width = 1, .height = 1, .channels = 1, .level_count = 1},
    {.width = 5, .height = 300, .channels = 4, .level_count = 1},
    {.width = 37, .height = 11, .layers = 3, .channels = 1, .level_count = 6, .code = HATCH_TEXELS_BC4},
    {.width = 37, .height = 11, .layers = 3, .channels = 3, .level_count = 6, .code = HATCH_TEXELS_BC1},
    {.width = 16, .height = 8, .depth = 6, .channels = 4, .level_count = 5, .code = HATCH_TEXELS_BC7},
    {.width = 33, .height = 5, .channels = 1, .level_count = 1, .code = HATCH_TEXELS_R32UI},
};
#define KINDS (sizeof kinds / sizeof *kinds)

static struct hatch_texels make(size_t kind)
{
    struct hatch_texels texture = kinds[kind];
    for (uint32_t level = 0; level < texture.level_count; level++) {
        size_t size = hatch_texels_level_size(&texture, level);
        texture.texels[level] = HATCH_NEW(&keep, uint8_t, size, &err);
        for (size_t i = 0; i < size; i++)
            texture.texels[level][i] = (uint8_t)hatch_random_u64(1, level, i);
    }
    return texture;
}

static struct hatch_bytes write_ktx2(const struct hatch_texels *texture)
{
    static const char *const pairs[] = {"hatch:seed", "1", "a", "", NULL};
    struct hatch_buffer file = {.arena = &keep};
    HATCH_TEST_OK(hatch_ktx2_write(texture, pairs, &file, &err), &err);
    return (struct hatch_bytes){file.data, file.size};
}

static void same(const struct hatch_texels *a, const struct hatch_texels *b)
{
    ck_assert(a->width == b->width && a->height == b->height && a->depth == b->depth);
    ck_assert(a->layers == b->layers && a->channels == b->channels && a->code == b->code && a->srgb == b->srgb);
    ck_assert_uint_eq(a->level_count, b->level_count);
    for (uint32_t level = 0; level < a->level_count; level++)
        ck_assert(memcmp(a->texels[level], b->texels[level], hatch_texels_level_size(a, level)) == 0);
}

START_TEST(files_survive_a_round_trip)
{
    struct hatch_texels texture = make((size_t)_i), got;
    HATCH_TEST_OK(hatch_ktx2_read(write_ktx2(&texture), &keep, &got, &err), &err);
    same(&got, &texture);
}
END_TEST

START_TEST(keys_are_read_in_order)
{
    struct hatch_texels texture = make((size_t)_i);
    struct hatch_bytes file = write_ktx2(&texture);
    const char *const *keys;
    HATCH_TEST_OK(hatch_ktx2_read_keys(file, &keep, &keys, &err), &err);
    static const char *const want[] = {"KTXorientation", NULL, "KTXwriter", "hatch", "a", "", "hatch:seed", "1"};
    for (size_t i = 0; i < 8; i++)
        ck_assert(want[i] == NULL || strcmp(keys[i], want[i]) == 0);
    ck_assert_ptr_null(keys[8]);
    ck_assert_str_eq(hatch_texels_value(keys, "hatch:seed"), "1");
    ck_assert_ptr_null(hatch_texels_value(keys, "b"));
    ck_assert_ptr_null(hatch_texels_value(NULL, "b"));
}
END_TEST

START_TEST(damaged_keys_are_refused_or_dropped)
{
    struct hatch_texels texture = make(0);
    struct hatch_bytes file = write_ktx2(&texture);
    const char *const *keys;
    uint8_t *bytes = HATCH_NEW(&keep, uint8_t, file.size, &err);
    for (size_t size = 0; size < 80; size++) {
        struct hatch_bytes truncated = {file.data, size};
        ck_assert_int_eq(hatch_ktx2_read_keys(truncated, &keep, &keys, &err), HATCH_BAD_INPUT);
    }
    size_t first = 56, where = file.data[first] | (size_t)file.data[first + 1] << 8;
    for (size_t at = first; at < where + 100; at++) {
        memcpy(bytes, file.data, file.size);
        bytes[at] = 0xff;
        enum hatch_status status = hatch_ktx2_read_keys((struct hatch_bytes){bytes, file.size}, &keep, &keys, &err);
        ck_assert(status == HATCH_OK || status == HATCH_BAD_INPUT);
        ck_assert(status == HATCH_OK || (at < where ? at < 64 : 1));
    }
    bytes[where + 4] = 0; /* the first key is empty, so that its value contains zeros */
    memcpy(bytes, file.data, where + 4);
    HATCH_TEST_OK(hatch_ktx2_read_keys((struct hatch_bytes){bytes, file.size}, &keep, &keys, &err), &err);
    ck_assert_str_ne(keys[0], "KTXorientation");
}
END_TEST

static void put(uint8_t *at, uint64_t value, size_t size)
{
    for (size_t i = 0; i < size; i++)
        at[i] = (uint8_t)(value >> (8 * i));
}

static uint64_t get(const uint8_t *at)
{
    uint64_t value = 0;
    for (size_t i = 8; i-- > 0;)
        value = value << 8 | at[i];
    return value;
}

/* The same texture with supercompressed levels, which are appended to the file. */
static struct hatch_bytes supercompress(struct hatch_bytes file, uint32_t levels)
{
    struct hatch_buffer out = {.arena = &keep};
    HATCH_TEST_OK(hatch_buffer_add(&out, file.data, file.size, &err), &err);
    put(out.data + 44, 2, 4);
    for (uint32_t level = 0; level < levels; level++) {
        size_t entry = 80 + 24 * level;
        size_t size = (size_t)get(file.data + entry + 8);
        uint8_t *packed = HATCH_NEW(&keep, uint8_t, ZSTD_compressBound(size), &err);
        size_t length = ZSTD_compress(packed, ZSTD_compressBound(size), file.data + get(file.data + entry), size, 3);
        put(out.data + entry, out.size, 8);
        put(out.data + entry + 8, length, 8);
        HATCH_TEST_OK(hatch_buffer_add(&out, packed, length, &err), &err);
    }
    return (struct hatch_bytes){out.data, out.size};
}

START_TEST(zstandard_is_decompressed)
{
    struct hatch_texels texture = make((size_t)_i), got;
    struct hatch_bytes file = supercompress(write_ktx2(&texture), texture.level_count);
    HATCH_TEST_OK(hatch_ktx2_read(file, &keep, &got, &err), &err);
    same(&got, &texture);
    for (size_t size = 0; size < file.size; size++) {
        struct hatch_bytes truncated = {file.data, size};
        ck_assert_int_eq(hatch_ktx2_read(truncated, &keep, &got, &err), HATCH_BAD_INPUT);
    }
}
END_TEST

START_TEST(a_truncated_file_is_refused)
{
    struct hatch_texels texture = make((size_t)_i), got;
    struct hatch_bytes file = write_ktx2(&texture);
    for (size_t size = 0; size < file.size; size++) {
        struct hatch_bytes truncated = {file.data, size};
        ck_assert_int_eq(hatch_ktx2_read(truncated, &keep, &got, &err), HATCH_BAD_INPUT);
    }
}
END_TEST

struct fault {
    size_t at;
    uint64_t value;
    size_t size;
    enum hatch_status want;
};

static const struct fault faults[] = {
    {0, 0, 1, HATCH_BAD_INPUT},            /* identifier */
    {12, 97, 4, HATCH_BAD_INPUT},          /* R16G16B16A16_SFLOAT */
    {16, 2, 4, HATCH_BAD_INPUT},           /* type size */
    {20, 0, 4, HATCH_BAD_INPUT},           /* width 0 */
    {20, 0xffffffffu, 4, HATCH_BAD_INPUT}, /* width too large */
    {24, 0, 4, HATCH_BAD_INPUT},           /* one-dimensional */
    {20, 1u << 24, 4, HATCH_LIMIT},        /* more than the arena */
    {28, 1u << 24, 4, HATCH_LIMIT},        /* depth */
    {32, 1u << 24, 4, HATCH_LIMIT},        /* layers */
    {20, 65, 4, HATCH_BAD_INPUT},          /* a level's length is wrong */
    {36, 6, 4, HATCH_BAD_INPUT},           /* a cube map */
    {40, 8, 4, HATCH_BAD_INPUT},           /* one level too many */
    {44, 1, 4, HATCH_BAD_INPUT},           /* BasisLZ */
    {44, 2, 4, HATCH_BAD_INPUT},           /* levels are not Zstandard */
    {80, UINT64_MAX, 8, HATCH_BAD_INPUT},  /* an offset that wraps */
    {88, UINT64_MAX, 8, HATCH_BAD_INPUT},  /* a length that wraps */
};

START_TEST(wrong_headers_are_refused)
{
    struct hatch_texels texture = make(0), got;
    struct hatch_bytes file = write_ktx2(&texture);
    const struct fault *fault = &faults[_i];
    put((uint8_t *)(uintptr_t)file.data + fault->at, fault->value, fault->size);
    ck_assert_int_eq(hatch_ktx2_read(file, &keep, &got, &err), fault->want);
    ck_assert(err.text[0]);
}
END_TEST

static const struct {
    uint32_t vk_format; /* as in vulkan_core.h */
    uint32_t channels;
    enum hatch_texels_code code;
    bool srgb;
} formats[] = {
    {9, 1, HATCH_TEXELS_PLAIN, false},  {15, 1, HATCH_TEXELS_PLAIN, true},  {16, 2, HATCH_TEXELS_PLAIN, false},
    {22, 2, HATCH_TEXELS_PLAIN, true},  {23, 3, HATCH_TEXELS_PLAIN, false}, {29, 3, HATCH_TEXELS_PLAIN, true},
    {37, 4, HATCH_TEXELS_PLAIN, false}, {43, 4, HATCH_TEXELS_PLAIN, true},  {98, 1, HATCH_TEXELS_R32UI, false},
    {131, 3, HATCH_TEXELS_BC1, false},  {132, 3, HATCH_TEXELS_BC1, true},   {139, 1, HATCH_TEXELS_BC4, false},
    {145, 4, HATCH_TEXELS_BC7, false},  {146, 4, HATCH_TEXELS_BC7, true},
};

/* Changes the orientation of a file, whose first key it is: its first or second letter. */
static void orient(struct hatch_bytes file, size_t letter, char direction)
{
    size_t pairs = file.data[56] | (size_t)file.data[57] << 8, value = pairs + 4 + sizeof "KTXorientation";
    ck_assert_uint_eq(file.data[value], 'r');
    ((uint8_t *)(uintptr_t)file.data)[value + letter] = (uint8_t)direction;
}

START_TEST(rows_from_the_bottom_up_are_turned)
{
    struct hatch_texels texture = make((size_t)_i), got;
    struct hatch_bytes file = write_ktx2(&texture);
    size_t texel = hatch_texels_block_bytes(texture.code, texture.channels);
    orient(file, 1, 'u');
    enum hatch_status status = hatch_ktx2_read(file, &keep, &got, &err);
    if (hatch_texels_block_side(texture.code) > 1) {
        ck_assert_int_eq(status, HATCH_BAD_INPUT);
        ck_assert_ptr_nonnull(strstr(err.text, "compressed blocks run from the bottom up"));
        return;
    }
    HATCH_TEST_OK(status, &err);
    for (uint32_t level = 0; level < texture.level_count; level++) {
        size_t row = texel * hatch_mip_size(texture.width, level), height = hatch_mip_size(texture.height, level);
        size_t rows = hatch_texels_level_size(&texture, level) / row;
        for (size_t y = 0; y < rows; y++) {
            size_t turned = y / height * height + height - 1 - y % height;
            ck_assert(memcmp(got.texels[level] + y * row, texture.texels[level] + turned * row, row) == 0);
        }
    }
}
END_TEST

START_TEST(other_orientations_are_refused)
{
    for (size_t kind = 0; kind < KINDS; kind++) {
        struct hatch_texels texture = make(kind), got;
        struct hatch_bytes file = write_ktx2(&texture);
        orient(file, 0, 'l');
        ck_assert_int_eq(hatch_ktx2_read(file, &keep, &got, &err), HATCH_BAD_INPUT);
        ck_assert_str_eq(err.text, texture.depth ? "KTXorientation ldi is not supported; want rdi or rui"
                                                 : "KTXorientation ld is not supported; want rd or ru");
    }
}
END_TEST

/* All other numbers near these are refused. */
START_TEST(formats_are_those_of_vulkan)
{
    for (uint32_t vk_format = 0, i = 0; vk_format < 256; vk_format++) {
        bool known = formats[i].vk_format == vk_format;
        struct hatch_texels got, want = {.width = 16, .height = 16, .level_count = 1};
        want.channels = known ? formats[i].channels : 1;
        want.code = known ? formats[i].code : HATCH_TEXELS_PLAIN;
        want.srgb = known && formats[i].srgb;
        HATCH_TEST_OK(hatch_texels_make(&keep, &want, &err), &err);
        struct hatch_bytes file = write_ktx2(&want);
        put((uint8_t *)(uintptr_t)file.data + 12, vk_format, 4);
        ck_assert_int_eq(hatch_ktx2_read(file, &keep, &got, &err), known ? HATCH_OK : HATCH_BAD_INPUT);
        if (known)
            same(&got, &want);
        i += known && i + 1 < sizeof formats / sizeof *formats;
    }
}
END_TEST

/* The texels may take all memory: a level of 1024 bytes. */
START_TEST(an_arena_as_large_as_the_texels_is_enough)
{
    struct hatch_texels texture = {.width = 16, .height = 16, .channels = 4, .level_count = 1}, got;
    HATCH_TEST_OK(hatch_texels_make(&keep, &texture, &err), &err);
    struct hatch_bytes file = write_ktx2(&texture);
    for (size_t missing = 0; missing < 2; missing++) {
        struct hatch_arena small;
        hatch_arena_init(&small, 1024 - missing);
        ck_assert_int_eq(hatch_ktx2_read(file, &small, &got, &err), missing ? HATCH_LIMIT : HATCH_OK);
        hatch_arena_free(&small);
    }
    ck_assert_ptr_nonnull(strstr(err.text, "1024 bytes of texels, more than the 1023 allowed"));
}
END_TEST

/* Entries at the end of the file: each message is that of the check that refuses them. */
START_TEST(entries_may_end_where_the_file_ends)
{
    struct hatch_texels texture = {.width = 256, .height = 256, .channels = 1, .level_count = 1}, got;
    HATCH_TEST_OK(hatch_texels_make(&keep, &texture, &err), &err);
    struct hatch_bytes plain = write_ktx2(&texture);
    uint8_t *bytes = (uint8_t *)(uintptr_t)plain.data;
    const char *const *keys;
    put(bytes + 56, plain.size, 4); /* no pairs, at the end */
    put(bytes + 60, 0, 4);
    HATCH_TEST_OK(hatch_ktx2_read_keys(plain, &keep, &keys, &err), &err);
    ck_assert_ptr_null(keys[0]);
    put(bytes + 56, plain.size - 8, 4); /* a pair of zeros, which has no value */
    put(bytes + 60, 8, 4);
    HATCH_TEST_OK(hatch_ktx2_read_keys(plain, &keep, &keys, &err), &err);
    put(bytes + 60, 9, 4);
    ck_assert_int_eq(hatch_ktx2_read_keys(plain, &keep, &keys, &err), HATCH_BAD_INPUT);
    ck_assert_ptr_nonnull(strstr(err.text, "pairs end after"));

    put(bytes + 80, plain.size, 8); /* a level of no bytes, at the end */
    put(bytes + 88, 0, 8);
    ck_assert_int_eq(hatch_ktx2_read(plain, &keep, &got, &err), HATCH_BAD_INPUT);
    ck_assert_ptr_nonnull(strstr(err.text, "level 0 is damaged: 0 bytes stored"));
    put(bytes + 80, plain.size - 2, 8); /* Zstandard packs up to 32768 bytes into one, but not into the first */
    for (uint64_t length = 1; length < 3; length++) {
        put(bytes + 44, 2, 4);
        put(bytes + 88, length, 8);
        ck_assert_int_eq(hatch_ktx2_read(plain, &keep, &got, &err), HATCH_BAD_INPUT);
        ck_assert_ptr_nonnull(strstr(err.text, length < 2 ? "level 0 is damaged: 1 bytes" : "level 0: "));
        ck_assert(length < 2 || strstr(err.text, "Zstandard"));
    }
}
END_TEST

/* The basic data format descriptor: Khronos Data Format Specification 1.3, chapter 5. */
START_TEST(ktx2_describes_its_texels)
{
    static const struct {
        uint32_t model, side, bytes, bits, upper;
    } codes[] = {
        [HATCH_TEXELS_PLAIN] = {1, 1, 1, 8, 255},         [HATCH_TEXELS_BC1] = {128, 4, 8, 64, UINT32_MAX},
        [HATCH_TEXELS_BC4] = {131, 4, 8, 64, UINT32_MAX}, [HATCH_TEXELS_BC7] = {134, 4, 16, 128, UINT32_MAX},
        [HATCH_TEXELS_R32UI] = {1, 1, 4, 32, 1},
    };
    static const uint32_t ids[] = {0, 1, 2, 15};
    struct hatch_texels texture = make((size_t)_i);
    struct hatch_bytes file = write_ktx2(&texture);
    bool plain = texture.code == HATCH_TEXELS_PLAIN;
    uint32_t side = codes[texture.code].side - 1, samples = plain ? texture.channels : 1, bytes = 28 + 16 * samples;
    uint32_t words[7 + 4 * 4] = {bytes,
                                 0,
                                 2 | (bytes - 4) << 16,
                                 codes[texture.code].model | 1 << 8 | 1 << 16,
                                 side | side << 8,
                                 codes[texture.code].bytes * samples};
    for (uint32_t c = 0; c < samples; c++) {
        words[7 + 4 * c] = 8 * c | (codes[texture.code].bits - 1) << 16 | ids[c] << 24;
        words[7 + 4 * c + 3] = codes[texture.code].upper;
    }
    const uint8_t *at = file.data + (uint32_t)get(file.data + 48);
    ck_assert_uint_eq((uint32_t)get(file.data + 52), bytes);
    for (uint32_t i = 0; i < bytes / 4; i++)
        ck_assert_msg((uint32_t)get(at + 4 * i) == words[i], "word %u: %x, not %x", i, (uint32_t)get(at + 4 * i),
                      words[i]);
}
END_TEST

START_TEST(dds_has_the_published_layout)
{
    struct hatch_texels texture = make(2);
    struct hatch_buffer file = {.arena = &keep};
    HATCH_TEST_OK(hatch_dds_write(&texture, &file, &err), &err);
    static const uint32_t want[][2] = {{4, 124}, {12, 16}, {16, 16}, {28, 5}, {76, 32}, {128, 61}, {132, 3}, {140, 6}};
    ck_assert(memcmp(file.data, "DDS ", 4) == 0 && memcmp(file.data + 84, "DX10", 4) == 0);
    for (size_t i = 0; i < sizeof want / sizeof *want; i++) {
        uint32_t value = (uint32_t)get(file.data + want[i][0]);
        ck_assert_uint_eq(value, want[i][1]);
    }
    const uint8_t *at = file.data + 148;
    for (uint32_t layer = 0; layer < 6; layer++)
        for (uint32_t level = 0; level < 5; level++) {
            size_t size = hatch_texels_level_size(&texture, level) / 6;
            ck_assert(memcmp(at, texture.texels[level] + layer * size, size) == 0);
            at += size;
        }
    ck_assert_ptr_eq(at, file.data + file.size);
}
END_TEST

struct reading {
    struct hatch_bytes file;
    struct hatch_texels texture;
};

static enum hatch_status read_ktx2(void *context, struct hatch_arena *arena, struct hatch_arena *scratch,
                                   struct hatch_err *error)
{
    struct reading *reading = context;
    (void)scratch;
    return hatch_ktx2_read(reading->file, arena, &reading->texture, error);
}

static enum hatch_status write_both(void *context, struct hatch_arena *arena, struct hatch_arena *scratch,
                                    struct hatch_err *error)
{
    struct hatch_buffer ktx2 = {.arena = arena}, dds = {.arena = arena};
    (void)scratch;
    enum hatch_status status = hatch_ktx2_write(context, NULL, &ktx2, error);
    ck_assert(status == HATCH_OK || ktx2.size == 0);
    if (status == HATCH_OK)
        status = hatch_dds_write(context, &dds, error);
    ck_assert(status == HATCH_OK || dds.size == 0);
    return status;
}

START_TEST(each_allocation_may_fail)
{
    struct hatch_texels texture = make(2);
    struct reading reading = {.file = write_ktx2(&texture)};
    hatch_test_fail_alloc(read_ktx2, &reading, &reading.texture, sizeof reading.texture);
    hatch_test_fail_alloc(write_both, &texture, NULL, 0);
}
END_TEST

static Suite *suite(void)
{
    Suite *suite = suite_create("io container");
    TCase *tests = tcase_create("container");
    tcase_add_checked_fixture(tests, begin, end);
    tcase_add_loop_test(tests, files_survive_a_round_trip, 0, KINDS);
    tcase_add_loop_test(tests, keys_are_read_in_order, 0, KINDS);
    tcase_add_test(tests, damaged_keys_are_refused_or_dropped);
    tcase_add_loop_test(tests, zstandard_is_decompressed, 0, KINDS);
    tcase_add_loop_test(tests, a_truncated_file_is_refused, 0, KINDS);
    tcase_add_loop_test(tests, wrong_headers_are_refused, 0, sizeof faults / sizeof *faults);
    tcase_add_loop_test(tests, ktx2_describes_its_texels, 0, KINDS);
    tcase_add_loop_test(tests, rows_from_the_bottom_up_are_turned, 0, KINDS);
    tcase_add_test(tests, other_orientations_are_refused);
    tcase_add_test(tests, formats_are_those_of_vulkan);
    tcase_add_test(tests, an_arena_as_large_as_the_texels_is_enough);
    tcase_add_test(tests, entries_may_end_where_the_file_ends);
    tcase_add_test(tests, dds_has_the_published_layout);
    tcase_add_test(tests, each_allocation_may_fail);
    suite_add_tcase(suite, tests);
    return suite;
}
HATCH_TEST_MAIN(suite)
