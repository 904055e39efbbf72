#include "run.h"

#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include "base/arena.h"
#include "base/budget.h"

START_TEST(objects_are_zeroed_and_aligned)
{
    struct hatch_arena arena;
    struct hatch_err err;
    hatch_arena_init(&arena, 1 << 20);
    for (size_t size = 0; size < 300; size += 7) {
        unsigned char *bytes = HATCH_NEW(&arena, unsigned char, size, &err);
        ck_assert_ptr_nonnull(bytes);
        ck_assert_uint_eq((uintptr_t)bytes % HATCH_ARENA_ALIGN, 0);
        for (size_t i = 0; i < size; i++)
            ck_assert_uint_eq(bytes[i], 0);
        memset(bytes, 0xff, size);
    }
    hatch_arena_free(&arena);
    ck_assert_uint_eq(arena.used_bytes, 0);
}
END_TEST

START_TEST(objects_do_not_overlap)
{
    enum { COUNT = 200 };
    struct hatch_arena arena;
    struct hatch_err err;
    unsigned char *objects[COUNT];
    hatch_arena_init(&arena, 1 << 24);
    for (int i = 0; i < COUNT; i++) {
        size_t size = 1 + (size_t)i * 97 % 5000;
        objects[i] = HATCH_NEW(&arena, unsigned char, size, &err);
        memset(objects[i], i, size);
    }
    for (int i = 0; i < COUNT; i++)
        for (size_t at = 0; at < 1 + (size_t)i * 97 % 5000; at++)
            ck_assert_uint_eq(objects[i][at], (unsigned)i);
    hatch_arena_free(&arena);
}
END_TEST

START_TEST(the_limit_holds)
{
    struct hatch_arena arena;
    struct hatch_err err;
    hatch_arena_init(&arena, 100000);
    ck_assert_ptr_null(HATCH_NEW(&arena, char, 100001, &err));
    ck_assert_int_eq(err.status, HATCH_LIMIT);
    ck_assert_ptr_nonnull(strstr(err.text, "100001"));
    size_t got = 0;
    while (HATCH_NEW(&arena, char, 1000, &err))
        got += 1000;
    ck_assert_uint_ge(got, 90000);
    ck_assert_uint_le(arena.peak_bytes, 100000);
    hatch_arena_free(&arena);
    ck_assert_ptr_nonnull(HATCH_NEW(&arena, char, 50000, &err));
    hatch_arena_free(&arena);
}
END_TEST

/* Makes two arenas with a budget of 100000 bytes. */
static void share(struct hatch_budget *budget, struct hatch_arena arenas[2])
{
    hatch_budget_init(budget, 100000);
    for (int i = 0; i < 2; i++)
        hatch_arena_init_shared(&arenas[i], budget);
}

/* Arenas with a budget have its limit together, and give back what they free. */
START_TEST(a_budget_holds_for_all_its_arenas)
{
    struct hatch_budget budget;
    struct hatch_arena arenas[2];
    struct hatch_err err;
    share(&budget, arenas);
    ck_assert_ptr_nonnull(HATCH_NEW(&arenas[0], char, 60000, &err));
    ck_assert_ptr_null(HATCH_NEW(&arenas[1], char, 60000, &err));
    ck_assert_int_eq(err.status, HATCH_LIMIT);
    ck_assert_ptr_nonnull(HATCH_NEW(&arenas[1], char, 30000, &err));
    ck_assert_uint_eq(budget.used_bytes, arenas[0].used_bytes + arenas[1].used_bytes);
    hatch_arena_free(&arenas[0]);
    ck_assert_uint_eq(budget.used_bytes, arenas[1].used_bytes);
    ck_assert_ptr_nonnull(HATCH_NEW(&arenas[1], char, 60000, &err));
    hatch_arena_free(&arenas[1]);
    ck_assert_uint_eq(budget.used_bytes, 0);
}
END_TEST

/* An arena asks for more than is needed, but does with that where a budget has no more. */
START_TEST(a_budget_can_be_used_up)
{
    struct hatch_budget budget;
    struct hatch_arena arenas[2];
    struct hatch_err err;
    share(&budget, arenas);
    ck_assert_ptr_nonnull(HATCH_NEW(&arenas[0], char, 50000, &err));
    ck_assert_ptr_nonnull(HATCH_NEW(&arenas[1], char, 45000, &err));
    ck_assert_ptr_nonnull(HATCH_NEW(&arenas[1], char, 4000, &err));
    ck_assert_ptr_null(HATCH_NEW(&arenas[1], char, 4000, &err));
    ck_assert_uint_le(budget.used_bytes, 100000);
    for (int i = 0; i < 2; i++)
        hatch_arena_free(&arenas[i]);
    ck_assert_uint_eq(budget.used_bytes, 0);
}
END_TEST

/* The arena that has too little left has used nothing itself. */
START_TEST(a_refusal_tells_what_the_budget_has_given)
{
    struct hatch_budget budget;
    struct hatch_arena arenas[2];
    struct hatch_err err;
    char want[200];
    share(&budget, arenas);
    ck_assert_ptr_nonnull(HATCH_NEW(&arenas[0], char, 60000, &err));
    ck_assert_ptr_null(hatch_arena_array(&arenas[1], 15000, 4, &err));
    snprintf(want, sizeof want, "out of memory: 15000 items of 4 bytes needed, %zu bytes in use, limit 100000",
             arenas[0].used_bytes);
    ck_assert_str_eq(err.text, want);
    hatch_arena_free(&arenas[0]);
}
END_TEST

START_TEST(sizes_that_overflow_are_refused)
{
    struct hatch_arena arena;
    struct hatch_err err;
    hatch_arena_init(&arena, SIZE_MAX);
    ck_assert_ptr_null(hatch_arena_array(&arena, SIZE_MAX / 4 + 2, 4, &err));
    ck_assert_int_eq(err.status, HATCH_LIMIT);
    for (size_t less = 0; less < 200; less++)
        ck_assert_ptr_null(hatch_arena_array(&arena, SIZE_MAX - less, 1, &err));
    ck_assert_uint_eq(arena.used_bytes, 0);
}
END_TEST

START_TEST(rewind_frees_later_allocations)
{
    struct hatch_arena arena;
    struct hatch_err err;
    hatch_arena_init(&arena, 1 << 20);
    struct hatch_arena_mark empty = hatch_arena_mark(&arena);
    char *kept = hatch_arena_text(&arena, "kept and more", 4, &err);
    size_t used = arena.used_bytes;
    for (int i = 0; i < 1000; i++) {
        struct hatch_arena_mark mark = hatch_arena_mark(&arena);
        ck_assert_ptr_nonnull(HATCH_NEW(&arena, char, 300000, &err));
        struct hatch_arena_mark inner = hatch_arena_mark(&arena);
        ck_assert_ptr_nonnull(HATCH_NEW(&arena, char, 300000, &err));
        hatch_arena_rewind(&arena, inner);
        ck_assert_ptr_nonnull(HATCH_NEW(&arena, char, 300000, &err));
        hatch_arena_rewind(&arena, mark);
    }
    ck_assert_str_eq(kept, "kept");
    ck_assert_uint_eq(arena.used_bytes, used);
    hatch_arena_rewind(&arena, empty);
    ck_assert_uint_eq(arena.used_bytes, 0);
}
END_TEST

START_TEST(reused_memory_is_zeroed)
{
    struct hatch_arena arena;
    struct hatch_err err;
    hatch_arena_init(&arena, 1 << 20);
    ck_assert_ptr_nonnull(HATCH_NEW(&arena, char, 10, &err));
    struct hatch_arena_mark mark = hatch_arena_mark(&arena);
    char *first = HATCH_NEW(&arena, char, 100, &err);
    memset(first, 'x', 100);
    hatch_arena_rewind(&arena, mark);
    char *second = HATCH_NEW(&arena, char, 100, &err);
#ifndef HATCH_ARENA_SEPARATE
    ck_assert_ptr_eq(second, first);
#endif
    for (int i = 0; i < 100; i++)
        ck_assert_int_eq(second[i], 0);
    hatch_arena_free(&arena);
}
END_TEST

START_TEST(the_nth_allocation_and_all_later_ones_fail)
{
    for (uint64_t n = 1; n < 10; n++) {
        struct hatch_arena arena;
        struct hatch_err err = {0};
        hatch_arena_init(&arena, 1 << 20);
        hatch_arena_fail_after(&arena, n);
        for (uint64_t i = 1; i < 20; i++)
            ck_assert_int_eq(HATCH_NEW(&arena, char, 8, &err) != NULL, i < n);
        ck_assert_int_eq(err.status, HATCH_LIMIT);
        hatch_arena_fail_after(&arena, 0);
        ck_assert_ptr_nonnull(HATCH_NEW(&arena, char, 8, &err));
        hatch_arena_free(&arena);
    }
}
END_TEST

static Suite *suite(void)
{
    Suite *suite = suite_create("base arena");
    TCase *tests = tcase_create("arena");
    tcase_add_test(tests, objects_are_zeroed_and_aligned);
    tcase_add_test(tests, objects_do_not_overlap);
    tcase_add_test(tests, the_limit_holds);
    tcase_add_test(tests, a_budget_holds_for_all_its_arenas);
    tcase_add_test(tests, a_budget_can_be_used_up);
    tcase_add_test(tests, a_refusal_tells_what_the_budget_has_given);
    tcase_add_test(tests, sizes_that_overflow_are_refused);
    tcase_add_test(tests, rewind_frees_later_allocations);
    tcase_add_test(tests, reused_memory_is_zeroed);
    tcase_add_test(tests, the_nth_allocation_and_all_later_ones_fail);
    suite_add_tcase(suite, tests);
    return suite;
}
HATCH_TEST_MAIN(suite)
