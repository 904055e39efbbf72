#define _GNU_SOURCE
#include "shared/names/descriptor.h"

#include <limits.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#define LINKS_MAX 40 /* as many as Linux follows */

/* Joins a folder and a name, or takes the name alone if it is absolute; returns whether it fits. */
static bool join(const char *folder, const char *name, char path[PATH_MAX])
{
    int length = *name == '/' ? snprintf(path, PATH_MAX, "%s", name) : snprintf(path, PATH_MAX, "%s/%s", folder, name);
    return length < PATH_MAX;
}

/* The folder of descriptors resolves to itself, while the descriptors in it are links that resolve to their files: the
 * links are therefore followed one by one. */
int cmd_descriptor_of(const char *path)
{
    char descriptors[PATH_MAX], at[PATH_MAX], folder[PATH_MAX], link[PATH_MAX];
    bool fits = realpath("/proc/self/fd", descriptors) && join(".", path, at);
    for (int links = 0; fits && links < LINKS_MAX; links++) {
        char *name = strrchr(at, '/') + 1, first = *name;
        *name = '\0';
        if (!realpath(at, folder))
            return -1;
        *name = first;
        if (strcmp(folder, descriptors) == 0 && first >= '0' && first <= '9')
            return atoi(name);
        ssize_t length = readlink(at, link, sizeof link - 1);
        if (length < 0)
            return -1;
        link[length] = '\0';
        fits = join(folder, link, at);
    }
    return -1;
}
