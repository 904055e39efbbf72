/* Direction fields on the meshes of a scene: shared by dirfield and lapped-param. */
#ifndef SHARED_FIELD_H
#define SHARED_FIELD_H

#include "shared/scene.h"
#include "scene/scene.h"
#include "curvature/curvature.h"
#include "field/field.h"

/* Defaults of dirfield, which estimates curvature with adaptive support (struct hatch_curvature_options). */
#define CMD_FIELD_SMOOTH 0.35
#define CMD_FIELD_TOLERANCE 3e-5
#define CMD_FIELD_HARD_RAD 1.3089969389957472 /* 75 degrees: edges of a five-sided prism still count as round */
#define CMD_FIELD_ITERATIONS 10000

/* Completes estimated curvature and its frames before a field is solved: no confidence at sharp creases, the bend of
 * long faces at rims, the normals of the fits, and axes that go on.
 *   frames     in, out: of hatch_frames_begin
 *   curvature  in, out: of frames
 * HATCH_LIMIT when memory runs out. */
enum hatch_status cmd_finish_curvature(struct cmd_args *args, const struct hatch_surface *surface,
                                       struct hatch_frames *frames, struct hatch_curvature *curvature,
                                       struct hatch_err *err);

/* Replaces a mesh by the mesh of its surface; sets the attribute _HATCH_DIR, and adds NORMAL if the file had none.
 * Directions and confidences are rounded, so that the result does not depend on libm. Each direction gets the sign with
 * which its first component other than 0 is positive. Dies on failure.
 *   name        name of the input, for messages
 *   direction   3 per point of the surface
 *   confidence  1 per point of the surface
 *   mesh        in, out: the new arrays are in args->keep */
void cmd_attach_field(struct cmd_args *args, const char *name, const struct hatch_surface *surface,
                      const double *direction, const double *confidence, struct hatch_scene_mesh *mesh);

/* Computes the direction field with the defaults of dirfield and attaches it. Dies on failure. */
void cmd_add_field(struct cmd_args *args, const char *name, const struct hatch_surface *surface,
                   struct hatch_scene_mesh *mesh);

#endif
