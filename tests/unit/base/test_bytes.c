#include "run.h"

#include <math.h>
#include <string.h>

#include "base/bytes.h"
#include "fail_alloc.h"

static const uint8_t digits[] = {1, 2, 3, 4, 5, 6, 7, 8};

static struct hatch_reader reader_of_digits(bool big_endian)
{
    struct hatch_reader reader = hatch_reader_of((struct hatch_bytes){digits, sizeof digits});
    reader.big_endian = big_endian;
    return reader;
}

START_TEST(numbers_are_read_in_both_byte_orders)
{
    struct hatch_reader little = reader_of_digits(false), big = reader_of_digits(true);
    ck_assert_uint_eq(hatch_read_u8(&little), 1);
    ck_assert_uint_eq(hatch_read_u16(&little), 0x0302);
    ck_assert_uint_eq(hatch_read_u32(&little), 0x07060504);
    ck_assert_uint_eq(hatch_reader_left(&little), 1);
    ck_assert_uint_eq(hatch_read_u64(&big), 0x0102030405060708);
    little = reader_of_digits(false);
    ck_assert_uint_eq(hatch_read_u64(&little), 0x0807060504030201);
    ck_assert(!little.cut && !big.cut);
}
END_TEST

START_TEST(floats_keep_their_bits)
{
    static const uint8_t bytes[] = {0, 0, 0xc0, 0x3f, 0x40, 9, 0x21, 0xfb, 0x54, 0x44, 0x2d, 0x18};
    struct hatch_reader reader = hatch_reader_of((struct hatch_bytes){bytes, sizeof bytes});
    ck_assert(hatch_read_f32(&reader) == 1.5f);
    reader.big_endian = true;
    ck_assert(hatch_read_f64(&reader) == 3.141592653589793);
}
END_TEST

START_TEST(a_read_beyond_the_end_returns_zero_and_sets_cut)
{
    struct hatch_reader reader = reader_of_digits(false);
    reader.at = 6;
    ck_assert_uint_eq(hatch_read_u32(&reader), 0);
    ck_assert(reader.cut);
    ck_assert_uint_eq(hatch_reader_left(&reader), 0);
    ck_assert_uint_eq(hatch_read_u8(&reader), 0);
    reader = reader_of_digits(false);
    ck_assert_ptr_null(hatch_read_bytes(&reader, SIZE_MAX));
    ck_assert(reader.cut);
    reader = reader_of_digits(false);
    ck_assert_ptr_eq(hatch_read_bytes(&reader, sizeof digits), digits);
    ck_assert(!reader.cut);
}
END_TEST

START_TEST(a_buffer_grows_and_keeps_its_bytes)
{
    struct hatch_arena arena;
    struct hatch_err err;
    hatch_arena_init(&arena, 1 << 24);
    struct hatch_buffer buffer = {.arena = &arena};
    for (uint32_t i = 0; i < 100000; i++)
        HATCH_TEST_OK(hatch_buffer_add_u32le(&buffer, i, &err), &err);
    ck_assert_uint_eq(buffer.size, 400000);
    struct hatch_reader reader = hatch_reader_of((struct hatch_bytes){buffer.data, buffer.size});
    for (uint32_t i = 0; i < 100000; i++)
        ck_assert_uint_eq(hatch_read_u32(&reader), i);
    hatch_arena_free(&arena);
}
END_TEST

START_TEST(text_zeros_and_padding_are_appended)
{
    struct hatch_arena arena;
    struct hatch_err err;
    hatch_arena_init(&arena, 1 << 20);
    struct hatch_buffer buffer = {.arena = &arena};
    HATCH_TEST_OK(hatch_buffer_print(&buffer, &err, "%d %s", 42, "x"), &err);
    HATCH_TEST_OK(hatch_buffer_pad(&buffer, 8, &err), &err);
    HATCH_TEST_OK(hatch_buffer_pad(&buffer, 8, &err), &err);
    HATCH_TEST_OK(hatch_buffer_add_u64le(&buffer, 0x0102030405060708, &err), &err);
    HATCH_TEST_OK(hatch_buffer_add(&buffer, NULL, 2, &err), &err);
    HATCH_TEST_OK(hatch_buffer_add(&buffer, NULL, 0, &err), &err);
    static const uint8_t want[] = "42 x\0\0\0\0\10\7\6\5\4\3\2\1\0";
    ck_assert_uint_eq(buffer.size, sizeof want);
    ck_assert_mem_eq(buffer.data, want, sizeof want);
    hatch_arena_free(&arena);
}
END_TEST

START_TEST(a_failed_append_leaves_the_buffer_unchanged)
{
    struct hatch_arena arena;
    struct hatch_err err;
    hatch_arena_init(&arena, 10000);
    struct hatch_buffer buffer = {.arena = &arena};
    HATCH_TEST_OK(hatch_buffer_add(&buffer, digits, sizeof digits, &err), &err);
    ck_assert_int_eq(hatch_buffer_add(&buffer, NULL, 20000, &err), HATCH_LIMIT);
    ck_assert_int_eq(hatch_buffer_add(&buffer, NULL, SIZE_MAX, &err), HATCH_LIMIT);
    ck_assert_uint_eq(buffer.size, sizeof digits);
    ck_assert_mem_eq(buffer.data, digits, sizeof digits);
    hatch_arena_free(&arena);
}
END_TEST

static enum hatch_status add_numbers(void *context, struct hatch_arena *keep, struct hatch_arena *scratch,
                                     struct hatch_err *err)
{
    (void)scratch;
    struct hatch_buffer buffer = {.arena = keep};
    for (uint32_t i = 0; i < 10000; i++)
        HATCH_TRY(hatch_buffer_print(&buffer, err, "%u\n", i));
    *(size_t *)context = buffer.size;
    return HATCH_OK;
}

START_TEST(failed_allocations_are_reported)
{
    size_t size = 7;
    /* 48890 bytes: 4096 doubled four times */
    ck_assert_uint_eq(hatch_test_fail_alloc(add_numbers, &size, &size, sizeof size), 5);
    ck_assert_uint_eq(size, 48890);
}
END_TEST

static Suite *suite(void)
{
    Suite *suite = suite_create("base bytes");
    TCase *tests = tcase_create("bytes");
    tcase_add_test(tests, numbers_are_read_in_both_byte_orders);
    tcase_add_test(tests, floats_keep_their_bits);
    tcase_add_test(tests, a_read_beyond_the_end_returns_zero_and_sets_cut);
    tcase_add_test(tests, a_buffer_grows_and_keeps_its_bytes);
    tcase_add_test(tests, text_zeros_and_padding_are_appended);
    tcase_add_test(tests, a_failed_append_leaves_the_buffer_unchanged);
    tcase_add_test(tests, failed_allocations_are_reported);
    suite_add_tcase(suite, tests);
    return suite;
}
HATCH_TEST_MAIN(suite)
