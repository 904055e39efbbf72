/* Pictures of any format as input of a command. A command that uses this links the packages exr, png and foreign. */
#ifndef SHARED_PICTURE_H
#define SHARED_PICTURE_H

#include "shared/cmd.h"
#include "image/image.h"

/* Reads a picture. Replaces numbers that are not finite, colours by fallback and alpha by 0, and warns of them. Dies on
 * failure.
 *   path      NULL or "-": standard input
 *   fallback  value for colours that are not finite; NaN: for alpha, too
 *   arena     receives the pixels and the file */
void cmd_read_picture(struct cmd_args *args, const char *path, float fallback, struct hatch_arena *arena,
                      struct hatch_image *image);

/* Does the same with a file that has been read. */
void cmd_parse_picture(struct cmd_args *args, const char *path, struct hatch_bytes file, float fallback,
                       struct hatch_arena *arena, struct hatch_image *image);

/* Replaces numbers of an image that are not finite in the same way; returns how many. */
size_t cmd_replace_non_finite(const struct hatch_image *image, float fallback);

/* Warns of numbers of a file that were replaced; 0: no warning. */
void cmd_warn_replaced(const char *name, size_t replaced, float fallback);

#endif
