#include "base/load.h"

#include <dlfcn.h>
#include <stdbool.h>
#include <stdint.h>
#include <string.h>

#include "base/arena.h"

/* Returns whether a message of the loader is about memory; the loader gives no number. "failed to map segment" is not
 * among them: it may be for lack of memory, and on a file system without programs (noexec). */
static bool is_about_memory(const char *message)
{
    static const char *const phrases[] = {"annot allocate", "out of memory", "cannot create shared object descriptor"};
    for (size_t i = 0; i < sizeof phrases / sizeof *phrases; i++)
        if (strstr(message, phrases[i]))
            return true;
    return false;
}

/* Fails when no memory is left at all. */
static enum hatch_status probe_memory(struct hatch_err *err)
{
    struct hatch_arena arena;
    uint8_t *byte;
    hatch_arena_init(&arena, SIZE_MAX);
    enum hatch_status status = HATCH_ALLOC(&arena, &byte, 1, err);
    hatch_arena_free(&arena);
    return status;
}

/* The loader tells of some failed allocations as of missing files. So a failure that is not about memory is tried once
 * more, and memory that is used up is noticed whatever the loader says. */
enum hatch_status hatch_load(const char *name, void **object, struct hatch_err *err)
{
    for (int attempt = 0; attempt < 2; attempt++) {
        *object = dlopen(name, RTLD_NOW | RTLD_LOCAL);
        if (*object)
            return HATCH_OK;
        const char *message = dlerror();
        if (!message || is_about_memory(message))
            return hatch_fail(err, HATCH_LIMIT, "%s", message ? message : "out of memory");
        hatch_fail(err, HATCH_IO, "%s", message);
    }
    HATCH_TRY(probe_memory(err));
    return HATCH_IO;
}
