/* The canvas: the render target of a picture, with colour (half floats, linear light) and depth. It supersamples: every
 * sample is shaded, and a pixel of the picture is the mean of its samples. Multisampling would smooth only the edges of
 * faces, but strokes have their edges inside faces; and software renderers need the same time for both. */
#ifndef RENDER_FRAME_CANVAS_H
#define RENDER_FRAME_CANVAS_H

#include "image/image.h"
#include "render-gl/gpu/program.h"
#include "render-gl/gpu/target.h"

/* Zeroed: no canvas. */
struct canvas {
    uint32_t width, height;           /* pixels */
    uint32_t side;                    /* samples along a pixel's side, 1 .. 8 */
    struct gpu_target samples;        /* side * width by side * height; output 0: colour; depth: 1 near, 0 far */
    struct gpu_target means;          /* width by height; zeroed if side is 1 */
    const struct gpu_target *picture; /* holds the picture after canvas_resolve: means, or samples if side is 1 */
    const struct gpu_program *average, *present; /* programs of canvas_resolve and canvas_present */
};

/* Makes a canvas.
 *   width, height  pixels, at least 1
 *   side           samples along a pixel's side, 1 .. 8
 * HATCH_LIMIT when the GPU has no memory for it. */
enum hatch_status canvas_make(uint32_t width, uint32_t height, uint32_t side, struct gpu_programs *programs,
                              struct canvas *canvas, struct hatch_err *err) HATCH_MUST_USE;

/* Computes the picture: the mean of each pixel's samples. */
void canvas_resolve(const struct canvas *canvas);

/* Copies the picture into the window's framebuffer, encoded as sRGB. */
void canvas_present(const struct canvas *canvas);

/* Copies a rectangle of the picture into an image.
 *   from   the rectangle of the picture
 *   image  channels R G B, linear light; must have room for the rectangle at x, y
 *   x, y   where the rectangle's lower left corner is put in the image: column, and row counted from the bottom */
void canvas_read(const struct canvas *canvas, struct gpu_rectangle from, struct hatch_image *image, uint32_t x,
                 uint32_t y);

/* Copies all samples.
 *   rgba  out: side * width by side * height times 4 floats, rows from bottom to top */
void canvas_read_samples(const struct canvas *canvas, float *rgba);

/* Releases the targets; leaves *canvas zeroed. */
void canvas_free(struct canvas *canvas);

#endif
