#include <string.h>
#include <sys/stat.h>

#include "layout.h"

static bool is_folder(const char *path)
{
    struct stat info;
    size_t length = strlen(path);
    return (length && path[length - 1] == '/') || (stat(path, &info) == 0 && S_ISDIR(info.st_mode));
}

static const char *after_last_slash(const char *path)
{
    const char *slash = strrchr(path, '/');
    return slash ? slash + 1 : path;
}

/* The length of a name without its ending; a leading dot does not begin an ending. */
static size_t stem_length(const char *name)
{
    const char *dot = strrchr(name, '.');
    return dot && dot != name ? (size_t)(dot - name) : strlen(name);
}

static const char *input_stem(const char *input)
{
    bool is_standard = !input || strcmp(input, "-") == 0;
    return is_standard ? "tam" : after_last_slash(input);
}

const char *pack_file_name(struct cmd_args *args, const char *path, const char *input, const char *suffix,
                           const char *ending)
{
    struct hatch_buffer name = {.arena = &args->keep};
    struct hatch_err err;
    const char *file = after_last_slash(path);
    bool folder = is_folder(path);
    const char *stem = folder ? input_stem(input) : file;
    size_t stem_size = stem_length(stem);
    bool has_ending = !folder && stem[stem_size];
    int before = folder ? (int)strlen(path) : (int)(file - path);
    bool needs_slash = folder && path[strlen(path) - 1] != '/';
    cmd_check(hatch_buffer_print(&name, &err, "%.*s%s%.*s%s%s", before, path, needs_slash ? "/" : "", (int)stem_size,
                                 stem, suffix, has_ending ? stem + stem_size : ending),
              NULL, &err);
    return (const char *)name.data;
}
