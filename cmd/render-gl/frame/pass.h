/* A pass: draw calls into one target with one set of GL state. frame_pass_begin sets all of the state that drawing
 * depends on, so that no pass depends on the one before it. */
#ifndef RENDER_FRAME_PASS_H
#define RENDER_FRAME_PASS_H

#include "render-gl/gpu/program.h"
#include "render-gl/gpu/target.h"
#include "render-gl/gpu/timer.h"

/* How a shader's output is combined with the target's content. */
enum frame_blend {
    FRAME_BLEND_REPLACE,
    FRAME_BLEND_OVER,           /* colour is mixed by the shader's alpha; alpha becomes that of both layers together */
    FRAME_BLEND_OVER_COLOR,     /* colour is mixed by the shader's alpha; alpha is unchanged */
    FRAME_BLEND_ADD,            /* sum of colour and alpha */
    FRAME_BLEND_MAX,            /* maximum of colour and alpha */
    FRAME_BLEND_SET_ALPHA,      /* alpha is replaced; colour is unchanged */
    FRAME_BLEND_UNDER_ALPHA,    /* colour is mixed by the target's alpha; alpha is unchanged */
    FRAME_BLEND_ADD_UNDER_ALPHA /* colour is multiplied by the target's alpha and added; alpha is unchanged */
};

/* The depth test, and whether depth is written. Depth is 1 at the near plane and 0 far away; in shadow maps it is 0
 * near the light. */
enum frame_depth {
    FRAME_DEPTH_NONE,   /* no test; depth is not written */
    FRAME_DEPTH_NEARER, /* draws what is nearer, and writes depth */
    FRAME_DEPTH_EQUAL,  /* draws what has equal depth; does not write it */
    FRAME_DEPTH_BEFORE, /* draws what is nearer; does not write depth */
    FRAME_DEPTH_LOWER,  /* draws what has a lower depth, and writes it; for shadow maps */
    FRAME_DEPTH_REPLACE /* no test; depth is written, 0 too */
};

struct frame_pass {
    const char *name;                /* shown in the report of --time */
    const struct gpu_target *target; /* kept by reference until the pass ends */
    enum frame_blend blend;
    enum frame_depth depth;
    bool culls;               /* back faces are not drawn */
    bool masks_color;         /* colour and alpha are not written */
    const float *clear;       /* R G B A to which output 0 is cleared at the beginning; NULL: not cleared */
    const float *clear_depth; /* depth to which the target is cleared at the beginning; NULL: not cleared */
};

/* Binds the target, sets the viewport to all of it, clears it if the pass says so, and sets the state. */
void frame_pass_begin(const struct frame_pass *pass);

/* Changes the blending within a pass, of all outputs or of one. Outputs of integers are not blended: REPLACE. */
void frame_pass_blend(enum frame_blend blend);
void frame_pass_blend_output(uint32_t output, enum frame_blend blend);

/* Runs a program for every pixel of the target, by drawing one triangle that covers it. */
void frame_pass_screen(const struct gpu_program *program);

/* Draws instances of a quad: a strip of four vertices, which the vertex stage places by gl_VertexID.
 *   array  vertex array with attributes per instance; 0: none */
void frame_pass_quads(const struct gpu_program *program, GLuint array, GLsizei instances);

/* Draws points of one pixel.
 *   array  vertex array with attributes per point */
void frame_pass_points(const struct gpu_program *program, GLuint array, GLsizei count);

/* Ends a pass and takes its time.
 *   timer  NULL: nothing is timed */
void frame_pass_end(const struct frame_pass *pass, struct gpu_timer *timer);

/* A compute pass. */
struct frame_dispatch {
    const char *name; /* shown in the report of --time */
    const struct gpu_program *program;
    GLuint groups[3];   /* number of work groups along each axis, at least 1 */
    GLbitfield barrier; /* kinds of later access that wait for its writes, as for glMemoryBarrier */
};

/* Runs a compute pass. The caller has set the uniforms and bound the images.
 *   timer  NULL: nothing is timed */
void frame_dispatch(const struct frame_dispatch *dispatch, struct gpu_timer *timer);

/* Runs a compute pass over indices from 0, in as many work groups as they need: index_of() of shaders/frame/index.glsl.
 * The shader leaves out indices from the uniform UNIFORM_COUNT on, which is set here.
 *   dispatch  its groups are not used */
void frame_dispatch_over(const struct frame_dispatch *dispatch, uint32_t count, struct gpu_timer *timer);

#endif
