#include "solid/equalize.h"

#include "arenas.h"
#include "base/random.h"
#include "fail_alloc.h"

#define COUNT 4096u

static float values[COUNT];
static uint8_t bytes[COUNT];

static void check_uniform(void)
{
    uint32_t counts[256] = {0};
    HATCH_TEST_OK(hatch_equalize(values, COUNT, NULL, &scratch, bytes, &err), &err);
    for (uint32_t i = 0; i < COUNT; i++)
        counts[bytes[i]]++;
    for (uint32_t i = 0; i < 256; i++)
        ck_assert_uint_eq(counts[i], COUNT / 256);
}

START_TEST(each_byte_occurs_equally_often_in_the_order_of_the_values)
{
    for (uint32_t i = 0; i < COUNT; i++) {
        float unit = 2 * hatch_random_unit(1, 1, i) - 1;
        values[i] = unit * unit * unit * 1e6f;
    }
    check_uniform();
    for (uint32_t i = 0; i < COUNT; i++) {
        uint32_t smaller = 0;
        for (uint32_t j = 0; j < COUNT; j++)
            smaller += values[j] < values[i];
        ck_assert_uint_eq(bytes[i], smaller / (COUNT / 256));
    }
}
END_TEST

START_TEST(ties_are_broken_at_random)
{
    for (uint32_t i = 0; i < COUNT; i++)
        values[i] = i % 2 ? 0.0f : -0.0f;
    check_uniform();
    uint32_t halves = 0, odd = 0;
    for (uint32_t i = 0; i < COUNT; i++) {
        halves += bytes[i] < 128 && i < COUNT / 2;
        odd += bytes[i] < 128 && i % 2;
    }
    ck_assert_uint_ge(halves, COUNT / 4 - COUNT / 32);
    ck_assert_uint_le(halves, COUNT / 4 + COUNT / 32);
    ck_assert_uint_ge(odd, COUNT / 4 - COUNT / 32);
    ck_assert_uint_le(odd, COUNT / 4 + COUNT / 32);
}
END_TEST

START_TEST(threads_do_not_change_ranks)
{
    static uint8_t other[COUNT];
    struct hatch_arena arena;
    struct hatch_pool *pool;
    hatch_arena_init(&arena, 1 << 20);
    HATCH_TEST_OK(hatch_pool_make(5, &arena, &pool, &err), &err);
    for (uint32_t i = 0; i < COUNT; i++)
        values[i] = (float)(i * 7919 % 100);
    check_uniform();
    HATCH_TEST_OK(hatch_equalize(values, COUNT, pool, &scratch, other, &err), &err);
    ck_assert_mem_eq(bytes, other, COUNT);
    hatch_pool_free(pool);
    hatch_arena_free(&arena);
}
END_TEST

static enum hatch_status equalize(void *context, struct hatch_arena *arena, struct hatch_arena *temporary,
                                  struct hatch_err *error)
{
    (void)context;
    float *room;
    HATCH_TRY(HATCH_ALLOC(arena, &room, 1, error));
    return hatch_equalize(values, COUNT, NULL, temporary, bytes, error);
}

START_TEST(equalizing_survives_every_failed_allocation)
{
    hatch_test_fail_alloc(equalize, NULL, NULL, 0);
}
END_TEST

static Suite *suite(void)
{
    Suite *suite = suite_create("solid equalize");
    TCase *tests = tcase_create("equalize");
    tcase_add_checked_fixture(tests, begin, end);
    tcase_add_test(tests, each_byte_occurs_equally_often_in_the_order_of_the_values);
    tcase_add_test(tests, ties_are_broken_at_random);
    tcase_add_test(tests, threads_do_not_change_ranks);
    tcase_add_test(tests, equalizing_survives_every_failed_allocation);
    suite_add_tcase(suite, tests);
    return suite;
}
HATCH_TEST_MAIN(suite)
