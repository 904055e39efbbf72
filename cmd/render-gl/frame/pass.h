/* A pass: drawing into one target under one state. frame_pass_begin sets all of the state that drawing depends on, so
 * that no pass depends on the one before it. */
#ifndef RENDER_FRAME_PASS_H
#define RENDER_FRAME_PASS_H

#include "render-gl/gpu/compute.h"
#include "render-gl/gpu/target.h"
#include "render-gl/gpu/timer.h"

/* How outputs combine with the target's: source, destination. */
enum frame_blend {
    FRAME_BLEND_REPLACE,
    FRAME_BLEND_OVER,           /* by alpha; alpha too */
    FRAME_BLEND_OVER_COLOR,     /* by alpha; the target's alpha stays */
    FRAME_BLEND_ADD,            /* the sum, alpha too */
    FRAME_BLEND_MAX,            /* the larger of both */
    FRAME_BLEND_SET_ALPHA,      /* alpha alone is replaced */
    FRAME_BLEND_UNDER_ALPHA,    /* mixed by the target's alpha, which stays */
    FRAME_BLEND_ADD_UNDER_ALPHA /* added, times the target's alpha, which stays */
};

/* Depth is 1 at the near plane and 0 far away. */
enum frame_depth {
    FRAME_DEPTH_NONE,
    FRAME_DEPTH_NEARER, /* draws what is nearer, and writes its depth */
    FRAME_DEPTH_EQUAL,  /* draws at equal depth */
    FRAME_DEPTH_BEFORE, /* draws what is nearer, and leaves depth */
    FRAME_DEPTH_LOWER   /* draws and writes what has a lower depth: for maps whose depth rises with distance */
};

enum frame_cull { FRAME_CULL_NONE, FRAME_CULL_BACK, FRAME_CULL_FRONT };

struct frame_pass {
    const char *name;                /* in the report of --time */
    const struct gpu_target *target; /* kept by reference until the pass ends */
    enum frame_blend blend;
    enum frame_depth depth;
    enum frame_cull cull;
    bool masks_color;         /* colours stay as they are */
    const float *clear;       /* 4: output 0 is cleared to it first; NULL: it stays */
    const float *clear_depth; /* depth is cleared to it first; NULL: it stays */
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

/* Ends a pass, for its time. timer may be NULL. */
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
