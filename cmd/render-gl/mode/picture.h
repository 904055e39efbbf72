/* Whole pictures, drawn tile by tile if they are larger than a canvas. */
#ifndef RENDER_MODE_PICTURE_H
#define RENDER_MODE_PICTURE_H

#include "render-gl/overlay/lines.h"
#include "render-gl/technique/technique.h"

#define PICTURE_CANVAS_MAX_PX 4096u /* greatest number of samples along a side of a canvas */

/* The technique and the lines with which pictures are drawn. */
struct picture {
    struct technique_context *context;
    struct technique_instance *instance; /* prepared */
    struct line_overlay *lines;          /* NULL: not made */
    bool draws_lines;                    /* whether lines are drawn; false if `lines` is NULL */
    uint32_t film;                       /* as in struct frame_request */
};

/* Makes a canvas for pictures of a size. It is as large as the picture, or smaller: then pictures are drawn in tiles.
 *   side    samples along a pixel's side, 1 .. 8
 *   canvas  out: owned by the caller */
enum hatch_status picture_canvas(struct frame *frame, uint32_t width, uint32_t height, uint32_t side,
                                 struct canvas *canvas, struct hatch_err *err) HATCH_MUST_USE;

/* Draws a tile of the posed scene: surfaces, then lines. HATCH_LIMIT when memory does not suffice.
 *   canvas  as large as the tile; holds the result */
enum hatch_status picture_draw_tile(const struct picture *picture, const struct hatch_view *view,
                                    const struct hatch_tile *tile, const struct canvas *canvas,
                                    struct hatch_err *err) HATCH_MUST_USE;

/* Finds in a frame of a film, the posed scene, what frames before it depend on.
 *   canvas         made by picture_canvas for a picture of that size
 *   width, height  of the picture */
enum hatch_status picture_foresee(const struct picture *picture, const struct hatch_view *view,
                                  const struct canvas *canvas, uint32_t width, uint32_t height,
                                  struct hatch_err *err) HATCH_MUST_USE;

/* Draws a whole picture of the posed scene.
 *   canvas  made by picture_canvas for the image's size
 *   image   channels R G B, linear light */
enum hatch_status picture_draw(const struct picture *picture, const struct hatch_view *view,
                               const struct canvas *canvas, struct hatch_image *image,
                               struct hatch_err *err) HATCH_MUST_USE;

#endif
