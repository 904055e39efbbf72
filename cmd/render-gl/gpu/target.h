/* Render targets: textures for colour outputs and for depth, with their framebuffer. */
#ifndef RENDER_GPU_TARGET_H
#define RENDER_GPU_TARGET_H

#include <epoxy/gl.h>
#include <stdint.h>

#include "base/status.h"

#define GPU_OUTPUTS_MAX 6u /* OpenGL promises 8 */

/* Size and formats of a target. Targets of equal form are interchangeable. */
struct gpu_target_form {
    uint32_t width, height;          /* texels, at least 1 */
    GLenum outputs[GPU_OUTPUTS_MAX]; /* internal formats of the outputs; the first 0 ends them */
    GLenum depth;                    /* internal format; 0: no depth */
};

/* Zeroed: no target. */
struct gpu_target {
    struct gpu_target_form form;
    uint32_t output_count;                  /* 0 .. GPU_OUTPUTS_MAX */
    GLuint framebuffer;                     /* 0: the window's */
    GLuint outputs[GPU_OUTPUTS_MAX], depth; /* textures; 0: none */
};

/* Makes a target with undefined content. HATCH_LIMIT when the GPU has no memory for it. */
enum hatch_status gpu_target_make(const struct gpu_target_form *form, struct gpu_target *target,
                                  struct hatch_err *err) HATCH_MUST_USE;

/* Clears an output.
 *   layout, type  of the texel in memory, as in glClearTexImage (GL_RGBA, GL_FLOAT)
 *   texel         NULL: zeros */
void gpu_target_clear(const struct gpu_target *target, uint32_t output, GLenum layout, GLenum type, const void *texel);

/* A rectangle of texels. x and y are those of its lower left corner; rows are counted from the bottom. */
struct gpu_rectangle {
    uint32_t x, y, width, height;
};

/* Reads back a rectangle of an output. Waits for the GPU.
 *   output        index of the output
 *   layout, type  of the texels in memory, as in glReadPixels (GL_RGBA, GL_FLOAT)
 *   row_length    texels from one row to the next in memory; 0: the rectangle's width
 *   texels        out: rows from bottom to top */
void gpu_target_read(const struct gpu_target *target, uint32_t output, struct gpu_rectangle from, GLenum layout,
                     GLenum type, uint32_t row_length, void *texels);

/* Reads back the depth of one texel, row y counted from the bottom. Waits for the GPU. */
float gpu_target_read_depth(const struct gpu_target *target, uint32_t x, uint32_t y);

/* Releases the textures; leaves *target zeroed. */
void gpu_target_free(struct gpu_target *target);

#endif
