/* Runs a function again and again, with its n-th allocation failing, for n = 1, 2, .. until it succeeds.
 *
 *     static enum hatch_status make(void *context, struct hatch_arena *keep,
 *                                   struct hatch_arena *scratch, struct hatch_err *err)
 *     {
 *         return hatch_thing_make(keep, scratch, 7, context, err);
 *     }
 *     START_TEST(thing_survives_every_failed_allocation)
 *     {
 *         struct hatch_thing thing = {0};
 *         hatch_test_fail_alloc(make, &thing, &thing, sizeof thing);
 *     } END_TEST
 *
 * Each run gets new arenas. First the allocations of keep fail, then those of scratch. Every failure must be
 * HATCH_LIMIT with a message and leave the outputs unchanged (outputs may be NULL); scratch must be empty after every
 * return; and at least one run must fail. Returns the number of failures.
 */
#ifndef HATCH_TEST_FAIL_ALLOC_H
#define HATCH_TEST_FAIL_ALLOC_H

#include <check.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "base/arena.h"

typedef enum hatch_status (*hatch_test_call)(void *context, struct hatch_arena *keep, struct hatch_arena *scratch,
                                             struct hatch_err *err);

static inline uint64_t hatch_test_fail_alloc(hatch_test_call call, void *context, void *outputs, size_t outputs_size)
{
    uint64_t failures = 0;
    unsigned char *before = malloc(outputs_size + 1);
    ck_assert_ptr_nonnull(before);
    for (int which = 0; which < 2; which++) {
        enum hatch_status status = HATCH_LIMIT;
        for (uint64_t n = 1; status != HATCH_OK; n++) {
            struct hatch_arena arenas[2];
            struct hatch_err error = {0};
            hatch_arena_init(&arenas[0], (size_t)1 << 32);
            hatch_arena_init(&arenas[1], (size_t)1 << 32);
            hatch_arena_fail_after(&arenas[which], n);
            if (outputs_size)
                memcpy(before, outputs, outputs_size);
            status = call(context, &arenas[0], &arenas[1], &error);
            ck_assert_msg(hatch_arena_mark(&arenas[1]).block == NULL,
                          "scratch was not rewound (allocation %d of arena %d)", (int)n, which);
            if (status != HATCH_OK) {
                ck_assert_msg(status == HATCH_LIMIT && error.status == HATCH_LIMIT && error.text[0],
                              "allocation %d of arena %d: status %d, message '%s'", (int)n, which, (int)status,
                              error.text);
                ck_assert_msg(!outputs_size || memcmp(before, outputs, outputs_size) == 0,
                              "outputs changed by a failure (allocation %d of arena %d)", (int)n, which);
                failures++;
            }
            hatch_arena_free(&arenas[1]);
            hatch_arena_free(&arenas[0]);
            ck_assert_msg(n < 1000000, "no success after a million allocations");
        }
    }
    free(before);
    ck_assert_msg(failures > 0, "nothing was allocated");
    return failures;
}

#endif
