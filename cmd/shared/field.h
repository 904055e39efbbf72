/* Direction fields on the meshes of a scene: what dirfield and lapped-param share. */
#ifndef HATCH_CMD_FIELD_H
#define HATCH_CMD_FIELD_H

#include "shared/scene.h"
#include "scene/scene.h"
#include "curvature/curvature.h"
#include "field/field.h"

/* What dirfield does unless it is told otherwise: curvature as noise asks, and this. */
#define CMD_FIELD_SMOOTH 0.5
#define CMD_FIELD_TOLERANCE 3e-5
#define CMD_FIELD_HARD_RAD 1.3089969389957472 /* 75 degrees: a tube of five sides is still round */
#define CMD_FIELD_ITERATIONS 10000

/* Makes a mesh what its surface is, with _HATCH_DIR, and NORMAL where the file had none. Directions and
 * confidences are rounded, so that no byte depends on a processor's libm; each line's first number that is
 * not 0 is positive. name: of the input, for messages. direction, confidence: per point. Memory:
 * args->keep. Dies on failure. */
void cmd_attach_field(struct cmd_args *args, const char *name, const struct hatch_surface *surface,
                      const double *direction, const double *confidence, struct hatch_scene_mesh *mesh);

/* Computes the field with dirfield's defaults and attaches it. Dies on failure. */
void cmd_add_field(struct cmd_args *args, const char *name, const struct hatch_surface *surface,
                   struct hatch_scene_mesh *mesh);

#endif
