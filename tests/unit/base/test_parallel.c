#include "run.h"

#include <stdatomic.h>
#include <string.h>

#include "base/parallel.h"
#include "base/random.h"
#include "fail_alloc.h"

enum { COUNT = 1000, MOST_THREADS = 8 };

struct work {
    atomic_int calls[COUNT];
    uint64_t results[COUNT];
};

static void fill(void *context, uint32_t index)
{
    struct work *work = context;
    atomic_fetch_add(&work->calls[index], 1);
    uint64_t sum = 0;
    for (uint64_t i = 0; i < index % 50; i++)
        sum += hatch_random_u64(1, index, i);
    work->results[index] = sum;
}

static struct hatch_pool *make_pool(struct hatch_arena *arena, uint32_t threads)
{
    struct hatch_pool *pool = NULL;
    struct hatch_err err;
    hatch_arena_init(arena, 1 << 20);
    HATCH_TEST_OK(hatch_pool_make(threads, arena, &pool, &err), &err);
    ck_assert_uint_eq(hatch_pool_threads(pool), threads);
    return pool;
}

START_TEST(each_index_runs_once_on_any_number_of_threads)
{
    static struct work alone, together;
    memset(&alone, 0, sizeof alone);
    hatch_parallel_for(NULL, COUNT, fill, &alone);
    for (uint32_t threads = 1; threads <= MOST_THREADS; threads++) {
        struct hatch_arena arena;
        struct hatch_pool *pool = make_pool(&arena, threads);
        for (int round = 0; round < 20; round++) {
            memset(&together, 0, sizeof together);
            hatch_parallel_for(pool, COUNT, fill, &together);
            ck_assert_mem_eq(together.results, alone.results, sizeof alone.results);
            for (int i = 0; i < COUNT; i++)
                ck_assert_int_eq(atomic_load(&together.calls[i]), 1);
        }
        hatch_parallel_for(pool, 0, fill, NULL);
        hatch_pool_free(pool);
        hatch_arena_free(&arena);
    }
}
END_TEST

struct one {
    struct work *work;
    uint32_t index;
};

static void fill_one(void *context, uint32_t index)
{
    const struct one *one = context;
    ck_assert_uint_eq(index, 0);
    fill(one->work, one->index);
}

/* More tasks than the queue holds. */
START_TEST(wait_returns_when_submitted_tasks_are_done)
{
    static struct work alone, together;
    static struct one ones[COUNT];
    hatch_parallel_for(NULL, COUNT, fill, &alone);
    for (uint32_t threads = 1; threads <= MOST_THREADS; threads++) {
        struct hatch_arena arena;
        struct hatch_pool *pool = make_pool(&arena, threads);
        memset(&together, 0, sizeof together);
        for (uint32_t i = 0; i < COUNT; i++) {
            ones[i] = (struct one){&together, i};
            hatch_pool_submit(pool, fill_one, &ones[i]);
        }
        hatch_pool_wait(pool);
        ck_assert_mem_eq(together.results, alone.results, sizeof alone.results);
        hatch_pool_wait(pool);
        hatch_pool_free(pool);
        hatch_arena_free(&arena);
    }
}
END_TEST

START_TEST(a_null_pool_is_one_thread)
{
    static struct work work;
    struct one one = {&work, 3};
    hatch_pool_submit(NULL, fill_one, &one);
    ck_assert_int_eq(atomic_load(&work.calls[3]), 1);
    hatch_pool_wait(NULL);
    hatch_pool_free(NULL);
    ck_assert_uint_eq(hatch_pool_threads(NULL), 1);
}
END_TEST

START_TEST(workers_take_a_quarter_of_the_memory)
{
    struct hatch_arena arena, memory;
    struct hatch_pool *pool;
    struct hatch_err err;
    hatch_arena_init(&memory, 1 << 20);
    HATCH_TEST_OK(hatch_pool_make(8, &memory, &pool, &err), &err);
    hatch_arena_init(&arena, 4000);
    ck_assert_uint_eq(hatch_pool_workers(pool, 125, &arena), hatch_pool_threads(pool));
    ck_assert_uint_eq(hatch_pool_workers(pool, 333, &arena), 3);
    ck_assert_uint_eq(hatch_pool_workers(pool, 334, &arena), 2);
    ck_assert_uint_eq(hatch_pool_workers(pool, 5000, &arena), 1);
    ck_assert_uint_eq(hatch_pool_workers(NULL, 1, &arena), 1);
    hatch_pool_free(pool);
    hatch_arena_free(&memory);
}
END_TEST

static enum hatch_status make_and_free(void *context, struct hatch_arena *keep, struct hatch_arena *scratch,
                                       struct hatch_err *err)
{
    (void)scratch;
    struct hatch_pool **pool = context;
    HATCH_TRY(hatch_pool_make(3, keep, pool, err));
    hatch_pool_free(*pool);
    return HATCH_OK;
}

START_TEST(failed_allocations_are_reported)
{
    struct hatch_pool *pool = NULL;
    hatch_test_fail_alloc(make_and_free, &pool, &pool, sizeof pool);
}
END_TEST

static Suite *suite(void)
{
    Suite *suite = suite_create("base parallel");
    TCase *tests = tcase_create("parallel");
    tcase_add_test(tests, each_index_runs_once_on_any_number_of_threads);
    tcase_add_test(tests, wait_returns_when_submitted_tasks_are_done);
    tcase_add_test(tests, a_null_pool_is_one_thread);
    tcase_add_test(tests, workers_take_a_quarter_of_the_memory);
    tcase_add_test(tests, failed_allocations_are_reported);
    suite_add_tcase(suite, tests);
    return suite;
}
HATCH_TEST_MAIN(suite)
