/* What is drawn into: colour in half floats, linear light, and depth; with several samples a pixel,
 * each shaded, which are averaged afterwards. Supersampling rather than multisampling: strokes are
 * texture, and the edges that tam-threshold makes are inside faces; and software renderers take as
 * long for either. */
#ifndef RENDER_TARGET_H
#define RENDER_TARGET_H

#include "image/image.h"
#include "render-gl/shader.h"

struct target {
    uint32_t width, height;                /* pixels of the tile */
    uint32_t side;                         /* samples along a side of a pixel, 1 .. 8 */
    GLuint color, depth, framebuffer;      /* side * width by side * height */
    GLuint resolved, resolved_framebuffer; /* width by height; with one sample the same */
    GLuint average, present;               /* programs */
    GLuint no_vertices;
};

/* HATCH_LIMIT when the GPU has no memory for it. */
enum hatch_status target_make(uint32_t width, uint32_t height, uint32_t side, const struct shader_source *shaders,
                              struct target *target, struct hatch_err *err) HATCH_MUST_USE;

/* Binds it, clears colour to a linear rgb with alpha 0 and depth to far away, sets the usual state. */
void target_begin(const struct target *target, const float rgb[3]);

/* Averages the samples. */
void target_resolve(const struct target *target);

/* Copies the averages onto the window, encoded for the screen. */
void target_present(const struct target *target);

/* Copies the resolved rectangle of width × height pixels at column left and, counted from the bottom,
 * row below into a picture with channels R G B at column x and, counted from the bottom, row y. */
void target_read(const struct target *target, uint32_t left, uint32_t below, uint32_t width, uint32_t height,
                 struct hatch_image *image, uint32_t x, uint32_t y);

/* Copies all samples, four floats each, from the lower left corner. */
void target_read_samples(const struct target *target, float *rgba);

/* What the depth buffer holds in the picture's middle: 0 where nothing is. */
float target_middle_depth(const struct target *target);

void target_free(struct target *target);

#endif
