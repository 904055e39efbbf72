/* The part of feature lines that the GPU does: which pieces surfaces hide, and ink. */
#ifndef RENDER_LINES_GL_H
#define RENDER_LINES_GL_H

#include "line/strip.h"
#include "render-gl/target.h"

#define LINE_PROGRAMS 3

struct line_gl {
    bool haloes;
    GLuint programs[LINE_PROGRAMS];
    GLuint array, segments;
    GLuint samples;                        /* a texel per sample */
    GLuint result, result_framebuffer;     /* the same */
    GLuint coverage, coverage_framebuffer; /* share of each pixel that lines cover */
    uint32_t width, height;                /* of coverage */
};

/* haloes: lines end at those of the frame's halo, which has been found before. */
enum hatch_status line_gl_make(const struct shader_source *shaders, bool haloes, struct line_gl *gl,
                               struct hatch_err *err) HATCH_MUST_USE;

/* Compiles anew; the old programs stay when the new ones have an error. */
enum hatch_status line_gl_compile(const struct shader_source *shaders, struct line_gl *gl,
                                  struct hatch_err *err) HATCH_MUST_USE;

/* Finds which samples the surfaces in the target's depth leave visible: those where at least one
 * texel around is not nearer than the limit; and those that haloes lie over. seen: per sample, sums of enum
 * line_seen; room for count rounded up to LINE_BATCH. */
#define LINE_BATCH 1024u
void line_gl_test(const struct line_gl *gl, const struct target *target, const struct hatch_line_sample *samples,
                  size_t count, uint8_t *seen);

/* Empty coverage of the target's size. HATCH_LIMIT when the GPU has no memory for it. */
enum hatch_status line_gl_begin(struct line_gl *gl, const struct target *target, struct hatch_err *err) HATCH_MUST_USE;

/* Draws segments with round ends into the coverage. Where they meet or cross the larger coverage counts, so
 * that joints are no darker than the rest. */
void line_gl_stroke(const struct line_gl *gl, const struct hatch_line_segment *segments, size_t count, double width_px);

/* Puts a colour, in linear light, over the target's resolved picture where coverage says. */
void line_gl_end(const struct line_gl *gl, const struct target *target, const float rgb[3]);

void line_gl_free(struct line_gl *gl);

#endif
