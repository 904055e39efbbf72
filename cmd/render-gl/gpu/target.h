/* Render targets: several colour outputs and depth. */
#ifndef RENDER_GPU_TARGET_H
#define RENDER_GPU_TARGET_H

#include <epoxy/gl.h>
#include <stdbool.h>
#include <stdint.h>

#include "base/status.h"

#define GPU_OUTPUTS_MAX 4u

/* A target's size and formats: two of equal ones are interchangeable. */
struct gpu_target_form {
    uint32_t width, height;          /* texels, at least 1 */
    GLenum outputs[GPU_OUTPUTS_MAX]; /* internal formats of output 0 onwards; 0: no more */
    GLenum depth;                    /* internal format; 0: none */
};

/* Zeroed: no target. */
struct gpu_target {
    struct gpu_target_form form;
    uint32_t output_count;
    GLuint framebuffer;
    GLuint outputs[GPU_OUTPUTS_MAX], depth; /* textures */
};

/* Makes a target, unset. HATCH_LIMIT when the GPU has no memory for it. */
enum hatch_status gpu_target_make(const struct gpu_target_form *form, struct gpu_target *target,
                                  struct hatch_err *err) HATCH_MUST_USE;

/* A rectangle of texels, from the lower left corner. */
struct gpu_rectangle {
    uint32_t x, y, width, height;
};

/* Reads a rectangle of an output back; waits for the GPU.
 *   layout, type   as glReadPixels takes them (GL_RGBA, GL_FLOAT)
 *   row_length     texels from row to row in memory; 0: the rectangle's width
 *   texels         out: rows from the lowest up */
void gpu_target_read(const struct gpu_target *target, uint32_t output, struct gpu_rectangle from, GLenum layout,
                     GLenum type, uint32_t row_length, void *texels);

/* Reads the depth of one texel. */
float gpu_target_read_depth(const struct gpu_target *target, uint32_t x, uint32_t y);

/* Leaves *target zeroed. */
void gpu_target_free(struct gpu_target *target);

#endif
