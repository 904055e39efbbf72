/* An arena for results, a scratch arena and an error for test programs. Install the fixture with
 * tcase_add_checked_fixture(tests, begin, end). */
#ifndef HATCH_TEST_ARENAS_H
#define HATCH_TEST_ARENAS_H

#include "base/arena.h"
#include "run.h"

static struct hatch_arena keep, scratch;
static struct hatch_err err;

static inline void begin(void)
{
    hatch_arena_init(&keep, (size_t)1 << 30);
    hatch_arena_init(&scratch, (size_t)1 << 30);
    err = (struct hatch_err){0};
}

/* Checks that scratch has been rewound: functions leave it as it was. What a test itself keeps belongs in keep. */
static inline void end(void)
{
    ck_assert_ptr_null(hatch_arena_mark(&scratch).block);
    hatch_arena_free(&scratch);
    hatch_arena_free(&keep);
}

#endif
