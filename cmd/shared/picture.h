/* Pictures of any format as input of a command. A command that uses this links the packages exr, png and foreign. */
#ifndef SHARED_PICTURE_H
#define SHARED_PICTURE_H

#include "shared/cmd.h"
#include "image/image.h"

/* Reads a picture. Numbers that are not finite are replaced, by 0 in the alpha channel, with a warning. Dies on
 * failure.
 *   path      NULL or "-": standard input
 *   fallback  replaces colours that are not finite
 *   arena     receives the pixels and the file */
void cmd_read_picture(struct cmd_args *args, const char *path, float fallback, struct hatch_arena *arena,
                      struct hatch_image *image);

#endif
