/* The surface that a picture is drawn on: colour in half floats, linear light, and depth; with several samples a pixel,
 * each shaded, whose mean is the picture. Supersampling rather than multisampling: strokes are texture, and thresholds
 * make edges inside of faces; and software renderers take as long for either. */
#ifndef RENDER_FRAME_CANVAS_H
#define RENDER_FRAME_CANVAS_H

#include "image/image.h"
#include "render-gl/gpu/program.h"
#include "render-gl/gpu/target.h"

/* Zeroed: no canvas. */
struct canvas {
    uint32_t width, height;           /* pixels */
    uint32_t side;                    /* samples along a side of a pixel, 1 .. 8 */
    struct gpu_target samples;        /* side * width by side * height; output 0: colour; depth: 1 near, 0 far away */
    struct gpu_target means;          /* width by height; not made where a pixel has one sample */
    const struct gpu_target *picture; /* the one of both that holds the picture once samples are averaged */
    const struct gpu_program *average, *present;
};

/* Makes a canvas. HATCH_LIMIT when the GPU has no memory for it. */
enum hatch_status canvas_make(uint32_t width, uint32_t height, uint32_t side, struct gpu_programs *programs,
                              struct canvas *canvas, struct hatch_err *err) HATCH_MUST_USE;

/* Averages the samples of each pixel. */
void canvas_resolve(const struct canvas *canvas);

/* Copies the picture into the window's framebuffer, encoded for the screen. */
void canvas_present(const struct canvas *canvas);

/* Copies a rectangle of the picture into an image.
 *   image  channels R G B
 *   x, y   column of the image, and row counted from the bottom, that receive the rectangle's lower left corner */
void canvas_read(const struct canvas *canvas, struct gpu_rectangle from, struct hatch_image *image, uint32_t x,
                 uint32_t y);

/* Copies all samples. rgba: out: 4 floats each, from the lower left corner. */
void canvas_read_samples(const struct canvas *canvas, float *rgba);

/* Leaves *canvas zeroed. */
void canvas_free(struct canvas *canvas);

#endif
