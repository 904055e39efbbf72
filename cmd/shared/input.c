#define _GNU_SOURCE
#include "shared/private.h"

#include <errno.h>
#include <fcntl.h>
#include <limits.h>
#include <math.h>
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

/* Returns whether the first FIRST_CAPACITY bytes of a stream could be text: XML in UTF-16 has zeros, but a mark. */
static bool is_text(const uint8_t *data)
{
    if ((data[0] == 0xff && data[1] == 0xfe) || (data[0] == 0xfe && data[1] == 0xff))
        return true;
    for (size_t i = 0; i < FIRST_CAPACITY; i++)
        if (data[i] < ' ' && (data[i] < '\t' || data[i] > '\r'))
            return false;
    return true;
}

/* Returns whether the bytes could begin a binary STL file, which has no signature: its first triangles have coordinates
 * that a mesh may have. Their normals may be anything. */
static bool is_stl(const uint8_t *data)
{
    const size_t header = 80, normal = 12, triangle = 50, triangles = 100;
    struct hatch_reader reader = hatch_reader_of((struct hatch_bytes){data, FIRST_CAPACITY});
    hatch_read_bytes(&reader, header);
    uint32_t count = hatch_read_u32(&reader);
    for (size_t t = 0; t < triangles && t < count; t++) {
        struct hatch_reader numbers = reader;
        hatch_read_bytes(&numbers, normal);
        for (int k = 0; k < 9; k++)
            if (!(fabsf(hatch_read_f32(&numbers)) < 1e15f))
                return false;
        hatch_read_bytes(&reader, triangle);
    }
    return count > 0;
}

/* Returns whether the bytes could begin a file of a format that any command reads. TGA has no signature, but types. */
static bool is_known(const uint8_t *data)
{
    static const struct {
        size_t at;
        const char *bytes;
    } signatures[] = {{0, "glTF"},     {0, "ply\n"},
                      {0, "ply\r"},    {0, "OFF"},
                      {0, "\x89PNG"},  {0, "\x76\x2f\x31\x01"},
                      {0, "\xabKTX"},  {0, "DDS "},
                      {0, "\xff\xd8"}, {0, "GIF8"},
                      {0, "BM"},       {0, "II"},
                      {0, "MM"},       {0, "RIFF"},
                      {0, "8BPS"},     {0, "SDPX"},
                      {0, "XPDS"},     {0, "#?"},
                      {4, "ftyp"},     {4, "jP  "},
                      {0, "SIMPLE"},   {0, "FOR4"},
                      {0, "\x01\xda"}, {0, "\x80\x2a\x5f\xd7"},
                      {0, "P4"},       {0, "P5"},
                      {0, "P6"},       {0, "P7"},
                      {0, "PF"},       {0, "Pf"},
                      {0, "\xff\x4f"}, {0, "\x53\x80\xf6\x34"}};
    for (size_t i = 0; i < sizeof signatures / sizeof *signatures; i++)
        if (memcmp(data + signatures[i].at, signatures[i].bytes, strlen(signatures[i].bytes)) == 0)
            return true;
    bool is_tga = data[1] <= 1 && data[2] > 0 && (data[2] & 7) <= 3 && data[2] <= 11 && data[16] > 0 && data[16] <= 32;
    return is_tga || is_stl(data) || is_text(data);
}

/* Reads to the end of a file. A stream of unknown length may never end, so it is given up after its first bytes if no
 * format begins with them.
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
        if (full && guess == 0 && size == FIRST_CAPACITY && !is_known(data))
            return hatch_fail(err, HATCH_BAD_INPUT, "a stream of no known format: its first %zu bytes begin none",
                              size);
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

struct hatch_bytes cmd_read_into(struct hatch_arena *arena, const char *path)
{
    static bool stdin_taken;
    if (is_standard_input(path) && stdin_taken)
        cmd_usage("two inputs come from standard input");
    stdin_taken = stdin_taken || is_standard_input(path);
    struct hatch_bytes bytes = {0};
    struct hatch_err err;
    cmd_check(cmd_try_read(arena, path, &bytes, &err), cmd_input_name(path), &err);
    return bytes;
}

struct hatch_bytes cmd_read(struct cmd_args *args, const char *path)
{
    return cmd_read_into(&args->keep, path);
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
