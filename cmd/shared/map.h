/* Reads tonal art maps that are the input of a command. */
#ifndef SHARED_MAP_H
#define SHARED_MAP_H

#include "shared/cmd.h"
#include "tam/tam.h"

/* Reads a map, tam(5). Dies on failure.
 *   path  NULL or "-": standard input
 *   map   out, in args->keep; its columns are the parts of the file */
void cmd_read_map(struct cmd_args *args, const char *path, struct hatch_tam *map);

/* Parses a file as a map. Dies on failure.
 *   name  of the file, for messages */
void cmd_parse_map(struct cmd_args *args, const char *name, struct hatch_bytes file, struct hatch_tam *map);

/* Warns if the strokes of a map do not nest, for commands that use its images as they are. */
void cmd_warn_nesting(struct cmd_args *args, const char *name, const struct hatch_tam *map);

/* Returns the random seed in the metadata of a map, as text, or NULL. */
const char *cmd_map_seed(const struct hatch_tam *map);

#endif
