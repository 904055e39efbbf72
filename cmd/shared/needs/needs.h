/* Files of needs, needs(5), as input of a command. */
#ifndef SHARED_NEEDS_NEEDS_H
#define SHARED_NEEDS_NEEDS_H

#include "needs/needs.h"
#include "shared/cmd.h"

/* Read a file of needs, without or with its regions. Die on failure.
 *   path   NULL or "-": standard input
 *   needs  out: its regions, if they are read, are in args->keep */
void cmd_read_needs(struct cmd_args *args, const char *path, struct hatch_needs *needs);
void cmd_read_needs_and_regions(struct cmd_args *args, const char *path, struct hatch_needs *needs);

#endif
