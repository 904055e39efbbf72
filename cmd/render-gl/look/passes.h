/* Passes of looks over the image; included by the looks' own files. */
#ifndef RENDER_LOOK_PASSES_H
#define RENDER_LOOK_PASSES_H

#include "render-gl/look/look.h"

/* Uniforms of a pass; bits. */
enum look_uniform {
    LOOK_ALONG = 1,  /* UNIFORM_A */
    LOOK_RADIUS = 2, /* UNIFORM_B */
    LOOK_NUMBER = 4  /* UNIFORM_C */
};

/* A pass over the image. */
struct look_pass {
    const char *name, *fragment;
    GLenum outputs[3]; /* formats of its transient target; 0: it draws into the canvas */
    bool pixels;       /* the target has texels for pixels; false: for samples */
    uint32_t uniforms; /* bits of enum look_uniform: those that its shader has */
};

/* A frame that is drawn in a look. */
struct look_drawing {
    struct look *look;
    struct frame *frame;
};

/* Values of the uniforms of a pass; those that its shader does not have are not read. */
struct look_uniforms {
    GLint along[2]; /* direction */
    double radius;  /* a length in texels of the pass */
    GLint number;
};

/* Compiles the programs of `count` passes. */
enum hatch_status look_passes_compile(const struct look *look, struct frame *frame, const struct look_pass *passes,
                                      uint32_t count, struct hatch_err *err) HATCH_MUST_USE;

/* Supplies a transient target for a pass. */
enum hatch_status look_pass_target(struct look_drawing drawing, const struct look_pass *pass,
                                   const struct gpu_target **target, struct hatch_err *err) HATCH_MUST_USE;

/* Runs a pass.
 *   uniforms  NULL: it has none
 *   target    of look_pass_target; NULL for passes that draw into the canvas */
enum hatch_status look_pass_run(struct look_drawing drawing, const struct look_pass *pass,
                                const struct look_uniforms *uniforms, const struct gpu_target *target,
                                struct hatch_err *err) HATCH_MUST_USE;

/* Does both, for passes that have a target.
 *   target  out */
enum hatch_status look_pass_add(struct look_drawing drawing, const struct look_pass *pass,
                                const struct look_uniforms *uniforms, const struct gpu_target **target,
                                struct hatch_err *err) HATCH_MUST_USE;

/* Runs a pass with a direction along y and, from that result, along x.
 *   from    texture that the first run reads from unit UNIT_SOURCE
 *   target  out: the result */
enum hatch_status look_pass_both(struct look_drawing drawing, const struct look_pass *pass, GLuint from, double radius,
                                 const struct gpu_target **target, struct hatch_err *err) HATCH_MUST_USE;

/* Draws the items with a shading into a transient target of their own.
 *   form    its width and height are those of the canvas, or of its pixels
 *   target  out */
enum hatch_status look_draw_items(struct look_drawing drawing, const struct gpu_target_form *form,
                                  const struct frame_shading *shading, struct frame_shader *shader,
                                  const struct gpu_target **target, struct hatch_err *err) HATCH_MUST_USE;

/* The looks that have passes over the image: watercolor.c, collage.c. */
enum hatch_status look_watercolor_prepare(const struct look *look, struct frame *frame,
                                          struct hatch_err *err) HATCH_MUST_USE;
enum hatch_status look_watercolor_draw(struct look_drawing drawing, struct hatch_err *err) HATCH_MUST_USE;
enum hatch_status look_collage_prepare(struct look *look, struct frame *frame, struct hatch_err *err) HATCH_MUST_USE;
enum hatch_status look_collage_draw(struct look_drawing drawing, struct hatch_err *err) HATCH_MUST_USE;

/* How far from a pixel these looks change it, in pixels. */
uint32_t look_watercolor_reach_px(void);
uint32_t look_collage_reach_px(void);

#endif
