/* A picture of any format, as every command reads one. A command that uses this links the packages exr,
 * png and foreign. */
#ifndef HATCH_CMD_PICTURE_H
#define HATCH_CMD_PICTURE_H

#include "shared/cmd.h"
#include "image/image.h"

/* Reads path ("-" or NULL: standard input) into arena: args->keep or one of the caller's. Colours that
 * are not finite become fallback, such alphas 0, and the user hears of it: they would spoil whatever is
 * computed. Dies on failure. */
void cmd_read_picture(struct cmd_args *args, const char *path, float fallback, struct hatch_arena *arena,
                      struct hatch_image *image);

#endif
