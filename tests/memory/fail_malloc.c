/* A library to preload, which makes one allocation of a process fail:
 *
 *     FAIL_AT=7 LD_PRELOAD=build/tests/memory/fail_malloc.so meshgen sphere
 *
 * Allocations (malloc, calloc, realloc, aligned ones, and with them C++'s new) are counted from the start of main, on
 * all threads. The loader and the constructors of libraries, which come before main, are left alone: no command can
 * answer for them. So are allocations inside what a command loads and others have written: drivers of OpenGL, and the
 * libraries that OpenImageIO needs, many of which end the process when memory runs out.
 *
 *   FAIL_AT       number of the allocation that fails; 0 or unset: none
 *   FAIL_FOREVER  set: all later ones fail, too
 *   FAIL_COUNT    a file of 8 bytes, which takes the number of allocations made
 *   FAIL_TRACE    set: prints the calls that led to the failed allocation */
#define _GNU_SOURCE
#include <dlfcn.h>
#include <errno.h>
#include <execinfo.h>
#include <fcntl.h>
#include <link.h>
#include <stdatomic.h>
#include <stdbool.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <unistd.h>
#include <unwind.h>

#define FRAMES_MAX 200
#define NEW_BYTES 256u /* size of the code of operator new, at most */

void *__libc_malloc(size_t size);
void *__libc_calloc(size_t count, size_t size);
void *__libc_realloc(void *old, size_t size);
void *__libc_memalign(size_t alignment, size_t size);

static atomic_ullong own_count, *count = &own_count;
static unsigned long long fail_at;
static bool forever, trace, counting;
static _Thread_local bool walking;
static struct link_map *last_linked;      /* the last library that the command was linked with */
static const unsigned char *operator_new; /* in a command that has its own; drivers call it, too */

/* Libraries that serve commands, and also what commands load: whether an allocation in them counts depends on who has
 * called them. */
static const char *const followed[] = {"/libc.so",    "/ld-linux",    "/libm.so",      "/libgcc",         "/libstdc++",
                                       "/libpng",     "/libz.so",     "/libzstd",      "/libdeflate",     "/libexpat",
                                       "/libOpenEXR", "/libtinygltf", "/libOpenMesh",  "/libcholmod",     "/libamd",
                                       "/libcamd",    "/libcolamd",   "/libccolamd",   "/libsuitesparse", "/libblas",
                                       "/liblapack",  "/libmetis",    "/fail_malloc.", "/hatch-oiio."};

enum owner { COMMAND, EITHER, OTHER };

/* Returns whose code lies at an address. No library holds the code that a driver generates. */
static enum owner owner_of(void *address)
{
    struct dl_find_object found;
    if (operator_new && (unsigned char *)address >= operator_new && (unsigned char *)address < operator_new + NEW_BYTES)
        return EITHER;
    if (_dl_find_object(address, &found) != 0)
        return OTHER;
    const char *name = found.dlfo_link_map->l_name;
    for (size_t i = 0; i < sizeof followed / sizeof *followed; i++)
        if (strstr(name, followed[i]))
            return EITHER;
    return *name ? OTHER : COMMAND;
}

/* Called for each frame of the stack, innermost first: stops at the first that tells whose allocation it is. */
static _Unwind_Reason_Code find_owner(struct _Unwind_Context *context, void *found)
{
    enum owner *owner = found;
    *owner = owner_of((void *)_Unwind_GetIP(context));
    return *owner == EITHER ? _URC_NO_REASON : _URC_NORMAL_STOP;
}

/* Returns whether an allocation counts. Looking for its origin takes time, and nothing but what a command has loaded
 * since it began makes others. */
static bool counts(void *caller)
{
    if (!last_linked->l_next)
        return !walking;
    enum owner owner = owner_of(caller);
    if (owner != EITHER || walking)
        return owner == COMMAND;
    walking = true;
    _Unwind_Backtrace(find_owner, &owner);
    walking = false;
    return owner == COMMAND;
}

static bool fails(void *caller)
{
    if (!counting || !counts(caller))
        return false;
    unsigned long long number = atomic_fetch_add(count, 1) + 1;
    if (!fail_at || (number != fail_at && !(forever && number > fail_at)))
        return false;
    if (trace && number == fail_at) {
        void *frames[FRAMES_MAX];
        walking = true;
        backtrace_symbols_fd(frames, backtrace(frames, FRAMES_MAX), STDERR_FILENO);
        walking = false;
    }
    errno = ENOMEM;
    return true;
}

void *malloc(size_t size)
{
    return fails(__builtin_return_address(0)) ? NULL : __libc_malloc(size);
}

void *calloc(size_t items, size_t size)
{
    return fails(__builtin_return_address(0)) ? NULL : __libc_calloc(items, size);
}

void *realloc(void *old, size_t size)
{
    return fails(__builtin_return_address(0)) ? NULL : __libc_realloc(old, size);
}

void *memalign(size_t alignment, size_t size)
{
    return fails(__builtin_return_address(0)) ? NULL : __libc_memalign(alignment, size);
}

void *aligned_alloc(size_t alignment, size_t size)
{
    return fails(__builtin_return_address(0)) ? NULL : __libc_memalign(alignment, size);
}

int posix_memalign(void **out, size_t alignment, size_t size)
{
    void *made = fails(__builtin_return_address(0)) ? NULL : __libc_memalign(alignment, size);
    if (!made)
        return ENOMEM;
    *out = made;
    return 0;
}

static int (*real_main)(int argc, char **argv, char **environment);

static int counted_main(int argc, char **argv, char **environment)
{
    const char *at = getenv("FAIL_AT"), *file = getenv("FAIL_COUNT");
    void *frames[2];
    backtrace(frames, 2); /* its first call allocates */
    for (last_linked = _r_debug.r_map; last_linked->l_next;)
        last_linked = last_linked->l_next;
    operator_new = dlsym(RTLD_DEFAULT, "_Znwm");
    fail_at = at ? strtoull(at, NULL, 10) : 0;
    forever = getenv("FAIL_FOREVER");
    trace = getenv("FAIL_TRACE");
    int descriptor = file ? open(file, O_RDWR | O_CLOEXEC) : -1;
    if (descriptor >= 0) {
        void *map = mmap(NULL, sizeof *count, PROT_READ | PROT_WRITE, MAP_SHARED, descriptor, 0);
        count = map == MAP_FAILED ? count : map;
        close(descriptor);
    }
    counting = true;
    return real_main(argc, argv, environment);
}

int __libc_start_main(int (*main)(int, char **, char **), int argc, char **argv, void (*init)(void), void (*fini)(void),
                      void (*rtld_fini)(void), void *stack_end)
{
    __typeof__(&__libc_start_main) start;
    void *symbol = dlsym(RTLD_NEXT, "__libc_start_main");
    memcpy(&start, &symbol, sizeof start);
    real_main = main;
    return start(counted_main, argc, argv, init, fini, rtld_fini, stack_end);
}
