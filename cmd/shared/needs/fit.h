/* Meshes with direction fields that views need: shared by strokegen and lapped-param, which link cholmod. */
#ifndef SHARED_NEEDS_FIT_H
#define SHARED_NEEDS_FIT_H

#include "shared/needs/meshes.h"

/* Makes the meshes that views need, with direction fields: no finer, and divided as cmd_split_unseen does. Meshes that
 * have a field already stay as fine as they are, with all meshes of their nodes. Dies on failure.
 *   input  path of the scene
 *   path   of the needs
 *   scene  in, out: new arrays are in args->keep */
void cmd_fit_meshes(struct cmd_args *args, const char *input, const char *path, const struct hatch_needs *needs,
                    struct hatch_scene *scene);

#endif
