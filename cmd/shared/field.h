/* Direction fields on the meshes of a scene: shared by dirfield and lapped-param. */
#ifndef SHARED_FIELD_H
#define SHARED_FIELD_H

#include "shared/scene.h"
#include "scene/scene.h"
#include "curvature/curvature.h"
#include "field/field.h"

/* Defaults of dirfield; the support of curvature follows the noise. */
#define CMD_FIELD_SMOOTH 0.5
#define CMD_FIELD_TOLERANCE 3e-5
#define CMD_FIELD_HARD_RAD 1.3089969389957472 /* 75 degrees: a prism of five sides still counts as round */
#define CMD_FIELD_ITERATIONS 10000

/* Replaces a mesh by that of its surface with the attribute _HATCH_DIR, and NORMAL if the file had none. Directions and
 * confidences are rounded, so that the result does not depend on libm; the first component of each direction that is
 * not 0 is positive. Dies on failure.
 *   name        of the input, for messages
 *   direction   three numbers per point of the surface
 *   confidence  one per point
 *   mesh        out: its arrays are in args->keep */
void cmd_attach_field(struct cmd_args *args, const char *name, const struct hatch_surface *surface,
                      const double *direction, const double *confidence, struct hatch_scene_mesh *mesh);

/* Computes the direction field with the defaults of dirfield and attaches it. Dies on failure. */
void cmd_add_field(struct cmd_args *args, const char *name, const struct hatch_surface *surface,
                   struct hatch_scene_mesh *mesh);

#endif
