/* Whole pictures: drawn tile by tile where they are larger than a canvas. */
#ifndef RENDER_MODE_PICTURE_H
#define RENDER_MODE_PICTURE_H

#include "render-gl/overlay/lines.h"
#include "render-gl/technique/technique.h"

#define PICTURE_CANVAS_MAX_PX 4096u /* samples along a side of a canvas */

/* What pictures are drawn with. */
struct picture {
    struct technique_context *context;
    struct technique_instance *instance; /* prepared */
    struct line_overlay *lines;          /* NULL: none have been made */
    bool draws_lines;
};

/* A canvas for pictures of that size: for all of it, or for a tile. side: as in struct canvas. */
enum hatch_status picture_canvas(struct frame *frame, uint32_t width, uint32_t height, uint32_t side,
                                 struct canvas *canvas, struct hatch_err *err) HATCH_MUST_USE;

/* Draws a tile: surfaces, then lines. The scene is posed. HATCH_LIMIT when memory does not suffice. */
enum hatch_status picture_draw_tile(const struct picture *picture, const struct hatch_view *view,
                                    const struct hatch_tile *tile, const struct canvas *canvas,
                                    struct hatch_err *err) HATCH_MUST_USE;

/* Draws the view into an image with channels R G B. */
enum hatch_status picture_draw(const struct picture *picture, const struct hatch_view *view,
                               const struct canvas *canvas, struct hatch_image *image,
                               struct hatch_err *err) HATCH_MUST_USE;

#endif
