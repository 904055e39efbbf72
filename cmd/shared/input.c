#define _GNU_SOURCE
#include "shared/private.h"

#include <errno.h>
#include <fcntl.h>
#include <limits.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#define FIRST_CAPACITY ((size_t)64 << 10) /* first size of the memory for a file of unknown size, bytes */

static bool is_standard_input(const char *path)
{
    return !path || strcmp(path, "-") == 0;
}

const char *cmd_input_name(const char *path)
{
    return is_standard_input(path) ? "standard input" : path;
}

/* Reads to the end of a file.
 *   guess  expected size, 0 if unknown; it may be wrong, since regular files may grow and files in /proc have size 0 */
static enum hatch_status read_to_end(int descriptor, size_t guess, struct hatch_arena *arena, struct hatch_bytes *bytes,
                                     struct hatch_err *err)
{
    size_t capacity = guess ? guess : FIRST_CAPACITY, size = 0;
    uint8_t *data = HATCH_NEW(arena, uint8_t, capacity, err);
    while (data) {
        uint8_t beyond;
        bool full = size == capacity;
        ssize_t got = full ? read(descriptor, &beyond, 1) : read(descriptor, data + size, capacity - size);
        if (got < 0 && errno == EINTR)
            continue;
        if (got < 0)
            return cmd_fail_errno(err, "cannot read", errno);
        if (got == 0) {
            *bytes = (struct hatch_bytes){data, size};
            return HATCH_OK;
        }
        if (full) {
            uint8_t *larger;
            HATCH_TRY(HATCH_ALLOC(arena, &larger, 2 * capacity, err));
            memcpy(larger, data, size);
            larger[size] = beyond;
            data = larger;
            capacity *= 2;
        }
        size += (size_t)got;
    }
    return HATCH_LIMIT;
}

enum hatch_status cmd_try_read(struct hatch_arena *arena, const char *path, struct hatch_bytes *bytes,
                               struct hatch_err *err)
{
    bool standard = is_standard_input(path);
    int descriptor = standard ? STDIN_FILENO : open(path, O_RDONLY | O_CLOEXEC | O_NOCTTY);
    if (descriptor < 0)
        return cmd_fail_errno(err, "cannot open", errno);
    struct stat info;
    enum hatch_status status;
    if (fstat(descriptor, &info) < 0)
        status = cmd_fail_errno(err, "cannot read", errno);
    else if (S_ISDIR(info.st_mode))
        status = hatch_fail(err, HATCH_BAD_INPUT, "is a directory, not a file");
    else
        status = read_to_end(descriptor, S_ISREG(info.st_mode) ? (size_t)info.st_size : 0, arena, bytes, err);
    if (!standard)
        close(descriptor);
    return status;
}

struct hatch_bytes cmd_read(struct cmd_args *args, const char *path)
{
    static bool stdin_taken;
    if (is_standard_input(path) && stdin_taken)
        cmd_usage("two inputs come from standard input");
    stdin_taken = stdin_taken || is_standard_input(path);
    struct hatch_bytes bytes = {0};
    struct hatch_err err;
    cmd_check(cmd_try_read(&args->keep, path, &bytes, &err), cmd_input_name(path), &err);
    return bytes;
}

const char *cmd_installed_path(struct cmd_args *args, const char *relative)
{
    char executable[PATH_MAX];
    ssize_t length = readlink("/proc/self/exe", executable, sizeof executable);
    struct hatch_err err;
    if (length < 0)
        cmd_check(cmd_fail_errno(&err, "cannot find the folder of the command", errno), NULL, &err);
    for (int up = 0; up < 2; up++)
        while (length > 0 && executable[--length] != '/')
            continue;
    size_t size = (size_t)length + 1 + strlen(relative);
    char *path;
    cmd_check(HATCH_ALLOC(&args->keep, &path, size + 1, &err), NULL, &err);
    snprintf(path, size + 1, "%.*s/%s", (int)length, executable, relative);
    return path;
}
