/* Support for fuzz targets, tests/fuzz/fuzz_NAME.c (or .cc): each is one function that parses arbitrary bytes
 * and checks the result.
 *
 *     #include "fuzz.h"
 *
 *     int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
 *     {
 *         struct fuzz_arenas arenas = fuzz_arenas_make();
 *         struct hatch_thing thing;
 *         struct hatch_err err;
 *         enum hatch_status status = hatch_thing_read((struct hatch_bytes){data, size},
 *                                                     &arenas.keep, &arenas.scratch, &thing, &err);
 *         fuzz_check(status, &err, &arenas);
 *         fuzz_arenas_free(&arenas);
 *         return 0;
 *     }
 *
 * `make check` replays tests/fuzz/corpus/NAME; `make fuzz` builds build/fuzz/bin/NAME with clang and
 * libFuzzer; `make check-long` runs each a million times (RUNS=N for another number). Inputs that crashed
 * are added to the corpus, with the fix, named after the fault.
 */
#ifndef HATCH_TEST_FUZZ_H
#define HATCH_TEST_FUZZ_H

#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>

#include "base/arena.h"
#include "base/bytes.h"

#ifdef __cplusplus
extern "C"
#endif
    int
    LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

/* Small, so that a short input that claims a large size is refused soon. */
#define FUZZ_LIMIT_BYTES ((size_t)64 << 20)

struct fuzz_arenas {
    struct hatch_arena keep, scratch;
};

static inline struct fuzz_arenas fuzz_arenas_make(void)
{
    struct fuzz_arenas arenas;
    hatch_arena_init(&arenas.keep, FUZZ_LIMIT_BYTES);
    hatch_arena_init(&arenas.scratch, FUZZ_LIMIT_BYTES);
    return arenas;
}

static inline void fuzz_arenas_free(struct fuzz_arenas *arenas)
{
    hatch_arena_free(&arenas->scratch);
    hatch_arena_free(&arenas->keep);
}

/* Checks that a failure has a message and that scratch was rewound. */
static inline void fuzz_check(enum hatch_status status, const struct hatch_err *err, const struct fuzz_arenas *arenas)
{
    if (status != HATCH_OK && (err->status != status || !err->text[0]))
        abort();
    if (hatch_arena_mark(&arenas->scratch).block)
        abort();
}

/* Reads every byte, so that a sanitizer detects memory that is too small. */
static inline void fuzz_touch(const void *bytes, size_t size)
{
    const volatile uint8_t *at = (const volatile uint8_t *)bytes;
    for (size_t i = 0; i < size; i++)
        (void)at[i];
}

#endif
