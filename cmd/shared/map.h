/* Reading tonal art maps: what every command does that takes one. */
#ifndef HATCH_CMD_MAP_H
#define HATCH_CMD_MAP_H

#include "shared/cmd.h"
#include "tam/tam.h"

/* Reads and checks a map (tam(5)) from a file, or from standard input for "-" or NULL, into args->keep.
 * Dies with one line on what is wrong. map->columns are the file's parts. */
void cmd_read_map(struct cmd_args *args, const char *path, struct hatch_tam *map);

/* The same of a file that has been read. name: how messages call it. */
void cmd_parse_map(struct cmd_args *args, const char *name, struct hatch_bytes file, struct hatch_tam *map);

/* Warns when strokes of the map do not nest: for commands that show its images as they are. */
void cmd_warn_nesting(struct cmd_args *args, const char *name, const struct hatch_tam *map);

/* The seed that a map tells of, as text, or NULL. */
const char *cmd_map_seed(const struct hatch_tam *map);

#endif
