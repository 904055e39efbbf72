/* A pass: drawing into one target under one state. frame_pass_begin sets all of the state that drawing depends on, so
 * that no pass depends on the one before it. */
#ifndef RENDER_FRAME_PASS_H
#define RENDER_FRAME_PASS_H

#include "render-gl/gpu/program.h"
#include "render-gl/gpu/target.h"
#include "render-gl/gpu/timer.h"

/* Combination of a shader's outputs with the target's content. */
enum frame_blend {
    FRAME_BLEND_REPLACE,
    FRAME_BLEND_OVER,           /* colour and alpha mixed by the shader's alpha */
    FRAME_BLEND_OVER_COLOR,     /* colour mixed by the shader's alpha; the target's alpha is unchanged */
    FRAME_BLEND_ADD,            /* sum of colour and alpha */
    FRAME_BLEND_MAX,            /* maximum of colour and alpha */
    FRAME_BLEND_SET_ALPHA,      /* alpha replaced, colour unchanged */
    FRAME_BLEND_UNDER_ALPHA,    /* colour mixed by the target's alpha, which is unchanged */
    FRAME_BLEND_ADD_UNDER_ALPHA /* colour times the target's alpha added; alpha is unchanged */
};

/* Depth is 1 at the near plane and 0 far away. */
enum frame_depth {
    FRAME_DEPTH_NONE,
    FRAME_DEPTH_NEARER, /* draws where nearer, and writes depth */
    FRAME_DEPTH_EQUAL,  /* draws where depth is equal; does not write it */
    FRAME_DEPTH_BEFORE, /* draws where nearer; does not write depth */
    FRAME_DEPTH_LOWER   /* draws where depth is lower, and writes it: for shadow maps, where 0 is near */
};

struct frame_pass {
    const char *name;                /* in the report of --time */
    const struct gpu_target *target; /* kept by reference until the pass ends */
    enum frame_blend blend;
    enum frame_depth depth;
    bool culls;               /* back faces are not drawn */
    bool masks_color;         /* colour and alpha are not written */
    const float *clear;       /* 4 numbers to which output 0 is cleared first; NULL: not cleared */
    const float *clear_depth; /* depth is cleared to this first; NULL: not cleared */
};

/* Binds the target, all of it as viewport, and sets the state. */
void frame_pass_begin(const struct frame_pass *pass);

/* Changes the blending within a pass. */
void frame_pass_blend(enum frame_blend blend);

/* Draws one triangle that covers the target. */
void frame_pass_screen(const struct gpu_program *program);

/* Draws instances of a strip of four vertices, which shaders place by gl_VertexID.
 *   array  vertex array with attributes per instance; 0: none */
void frame_pass_quads(const struct gpu_program *program, GLuint array, GLsizei instances);

/* Ends a pass, so that its time is taken.
 *   timer  NULL: nothing is timed */
void frame_pass_end(const struct frame_pass *pass, struct gpu_timer *timer);

/* A compute pass. */
struct frame_dispatch {
    const char *name; /* in the report of --time */
    const struct gpu_program *program;
    GLuint groups[3];   /* work groups along each axis, at least 1 */
    GLbitfield barrier; /* reads that wait for its writes: GL_TEXTURE_FETCH_BARRIER_BIT and so on */
};

/* Runs a compute pass, whose uniforms and images are set. timer may be NULL. */
void frame_dispatch(const struct frame_dispatch *dispatch, struct gpu_timer *timer);

#endif
