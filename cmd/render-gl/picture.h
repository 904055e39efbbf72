/* Whole pictures: drawn tile by tile where they are larger than a target. */
#ifndef RENDER_PICTURE_H
#define RENDER_PICTURE_H

#include "render-gl/renderer.h"

#define PICTURE_TARGET_MAX_PX 4096u /* samples along a side of a target */

/* The target for pictures of that size: all of it, or a tile. side: see target.h. */
enum hatch_status picture_target(uint32_t width, uint32_t height, uint32_t side, const struct renderer *renderer,
                                 struct target *target, struct hatch_err *err) HATCH_MUST_USE;

/* Draws the view into an image with channels R G B. HATCH_LIMIT when memory does not suffice. */
enum hatch_status picture_draw(struct renderer *renderer, uint32_t technique, const struct hatch_view *view,
                               const struct target *target, struct hatch_image *image,
                               struct hatch_err *err) HATCH_MUST_USE;

#endif
