/* Solid textures that are the input of a command. A command that uses this links the packages texture and exr. */
#ifndef SHARED_SOLID_SOLID_H
#define SHARED_SOLID_SOLID_H

#include "shared/cmd.h"
#include "solid/solid.h"

/* Parses a file as a solid texture (solid(5)), or as a flat texture in KTX2. Dies on failure.
 *   name   of the file, for messages
 *   solid  out, in args->keep; numbers of slices that are not finite become 1, with a warning
 * Returns false if the file is neither KTX2 nor the slices of an OpenEXR file, so that it may be a picture. */
bool cmd_parse_solid(struct cmd_args *args, const char *name, struct hatch_bytes file, struct hatch_solid *solid);

#endif
