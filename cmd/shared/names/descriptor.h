/* Names of files that are open descriptors of this process, such as /dev/stdout. */
#ifndef SHARED_NAMES_DESCRIPTOR_H
#define SHARED_NAMES_DESCRIPTOR_H

/* Returns the descriptor that a path leads to, through symbolic links: 3 for /dev/fd/3 and for /proc/self/fd/3; -1 if
 * the path is that of a file. */
int cmd_descriptor_of(const char *path);

#endif
