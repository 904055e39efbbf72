/* Projects the faces of a posed scene. */
#ifndef HATCH_VECTOR_PROJECT_H
#define HATCH_VECTOR_PROJECT_H

#include "vector/occluders.h"

/* Projects all faces of a posed scene that a renderer would draw: faces seen from behind only if their item is
 * double-sided, and no faces of items with cut_out set, whose shape is unknown.
 *   width_px, height_px  of the picture, over 0
 *   arena                for the result; not the scratch arena */
enum hatch_status hatch_occluders_make(const struct hatch_unit_scene *scene, const struct hatch_view *view,
                                       double width_px, double height_px, struct hatch_arena *arena,
                                       struct hatch_arena *scratch, struct hatch_occluders *occluders,
                                       struct hatch_err *err) HATCH_MUST_USE;

#endif
