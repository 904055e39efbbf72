#include "shared/style.h"

#include <dirent.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "shared/picture.h"

#define INSTALLED_MAX 64 /* files of a kind that a message lists */

static bool is_path(const char *name)
{
    return strcmp(name, "-") == 0 || strpbrk(name, "/.");
}

/* Returns the path of an installed file, or NULL.
 *   kind  its ending */
static const char *installed_file(struct cmd_args *args, const char *name, const char *kind)
{
    struct hatch_err err;
    struct hatch_buffer relative = {.arena = &args->keep};
    cmd_check(hatch_buffer_print(&relative, &err, "share/hatch/styles/%s.%s%c", name, kind, '\0'), NULL, &err);
    const char *path = cmd_installed_path(args, (const char *)relative.data);
    return access(path, F_OK) == 0 ? path : NULL;
}

bool cmd_has_style(struct cmd_args *args, const char *name)
{
    return !is_path(name) && installed_file(args, name, "style");
}

static int compare_names(const void *a, const void *b)
{
    return strcmp(*(const char *const *)a, *(const char *const *)b);
}

/* Lists the installed files of a kind by name, NULL at the end.
 *   names  out, in args->keep */
static void list_installed(struct cmd_args *args, const char *kind, const char *names[INSTALLED_MAX + 1])
{
    struct hatch_err err;
    size_t count = 0;
    const struct dirent *entry;
    DIR *folder = opendir(cmd_installed_path(args, "share/hatch/styles"));
    while (folder && count < INSTALLED_MAX && (entry = readdir(folder))) {
        const char *dot = strrchr(entry->d_name, '.');
        if (!dot || dot == entry->d_name || strcmp(dot + 1, kind) != 0)
            continue;
        names[count] = hatch_arena_text(&args->keep, entry->d_name, (size_t)(dot - entry->d_name), &err);
        cmd_check(names[count++] ? HATCH_OK : HATCH_LIMIT, NULL, &err);
    }
    if (folder)
        closedir(folder);
    qsort(names, count, sizeof *names, compare_names);
    names[count] = NULL;
}

const char *cmd_find_style(struct cmd_args *args, const char *name, const char *kind)
{
    const char *installed[INSTALLED_MAX + 1];
    if (is_path(name))
        return name;
    const char *path = installed_file(args, name, kind);
    if (path)
        return path;
    if (access(name, F_OK) == 0)
        return name;
    list_installed(args, kind, installed);
    if (!installed[0])
        cmd_usage("no %s '%s': it is no file, and %s has none", kind, name,
                  cmd_installed_path(args, "share/hatch/styles"));
    cmd_refuse_name(kind, name, installed, "a file");
}

void cmd_name_style(const char *path, char name[HATCH_NAME_MAX])
{
    const char *slash = strrchr(path, '/'), *stem = slash ? slash + 1 : path;
    const char *dot = strrchr(stem, '.');
    int length = (int)(dot ? (size_t)(dot - stem) : strlen(stem));
    bool named = length > 0 && strcmp(path, "-") != 0;
    snprintf(name, HATCH_NAME_MAX, "%.*s", named ? length : 6, named ? stem : "custom");
}

struct hatch_bytes cmd_split_settings(struct cmd_args *args, const struct cmd_texts *settings)
{
    struct hatch_err err;
    struct hatch_buffer lines = {.arena = &args->keep};
    for (int i = 0; i < settings->count; i++)
        cmd_check(hatch_buffer_print(&lines, &err, "%s\n", settings->at[i]), NULL, &err);
    for (size_t i = 0; i < lines.size; i++)
        if (lines.data[i] == ';')
            lines.data[i] = '\n';
    return (struct hatch_bytes){lines.data, lines.size};
}

const char *cmd_path_beside(struct cmd_args *args, const char *path, const char *name)
{
    struct hatch_err err;
    const char *slash = strrchr(path, '/');
    if (name[0] == '/' || !slash)
        return name;
    struct hatch_buffer joined = {.arena = &args->keep};
    cmd_check(hatch_buffer_print(&joined, &err, "%.*s/%s%c", (int)(slash - path), path, name, '\0'), NULL, &err);
    return (const char *)joined.data;
}

void cmd_read_brush(struct cmd_args *args, const char *path, struct hatch_brush *brush)
{
    struct hatch_err err;
    struct hatch_image image;
    cmd_read_picture(args, path, 1, &args->keep, &image); /* numbers that are not finite become paper */
    cmd_check(hatch_brush_from_image(&image, &args->keep, brush, &err), cmd_input_name(path), &err);
}

void cmd_read_style(struct cmd_args *args, const char *name, const struct cmd_texts *settings, const char *brush_path,
                    struct hatch_style *style, struct hatch_brush *brush)
{
    struct hatch_err err;
    const char *path = cmd_find_style(args, name, "style");
    hatch_style_default(style);
    cmd_name_style(path, style->name);
    cmd_check(hatch_style_parse(cmd_read(args, path), style, &err), cmd_input_name(path), &err);
    if (settings && settings->count && hatch_style_parse(cmd_split_settings(args, settings), style, &err) != HATCH_OK)
        cmd_usage("--set: %s", err.text);
    if (!brush_path && style->brush == HATCH_BRUSH_IMAGE)
        brush_path = cmd_path_beside(args, path, style->brush_file);
    if (brush_path)
        cmd_read_brush(args, brush_path, brush);
    else
        cmd_check(hatch_brush_make(style->brush, &args->keep, brush, &err), NULL, &err);
}

void cmd_read_palette(struct cmd_args *args, const char *name, struct hatch_style *style)
{
    struct hatch_err err;
    const char *path = cmd_find_style(args, name, "palette");
    struct hatch_style read;
    hatch_style_default(&read);
    cmd_check(hatch_style_parse(cmd_read(args, path), &read, &err), cmd_input_name(path), &err);
    if (read.color_count == 0)
        cmd_die(cmd_input_name(path), &(struct hatch_err){HATCH_BAD_INPUT, "the palette has no color line"});
    style->color_count = read.color_count;
    memcpy(style->colors, read.colors, sizeof style->colors);
}
