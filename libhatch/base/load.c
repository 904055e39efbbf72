#include "base/load.h"

#include <dlfcn.h>
#include <stdbool.h>
#include <stddef.h>
#include <string.h>

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

enum hatch_status hatch_load(const char *name, void **object, struct hatch_err *err)
{
    *object = dlopen(name, RTLD_NOW | RTLD_LOCAL);
    if (*object)
        return HATCH_OK;
    const char *message = dlerror();
    bool memory = !message || is_about_memory(message);
    return hatch_fail(err, memory ? HATCH_LIMIT : HATCH_IO, "%s", message ? message : "out of memory");
}
