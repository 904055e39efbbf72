#include "render-gl/overlay/lines.h"

#include <stddef.h>
#include <stdio.h>

#include "render-gl/frame/items.h"
#include "render-gl/gpu/bindings.h"
#include "render-gl/gpu/buffer.h"
#include "render-gl/gpu/texture.h"

#define BATCH 1024u    /* samples in a row of the texture */
#define TEXELS 2u      /* of a sample */
#define ROWS_MAX 1024u /* rows of the texture; if there are more samples, they are tested in several passes */

static const struct gpu_stages test_stages = {.vertex = "canvas/screen.vert", .fragment = "overlay/line_test.frag"};

static enum hatch_status compile(struct line_overlay *overlay, struct gpu_programs *programs, struct hatch_err *err)
{
    static const struct gpu_stages stroke = {.vertex = "overlay/line_stroke.vert",
                                             .fragment = "overlay/line_stroke.frag"};
    static const struct gpu_stages over = {.vertex = "canvas/screen.vert", .fragment = "overlay/line_over.frag"};
    const char *defines = overlay->haloes ? "#define HALOES 1\n" : "";
    HATCH_TRY(gpu_program_get(programs, &test_stages, defines, &overlay->test, err));
    HATCH_TRY(gpu_program_get(programs, &stroke, defines, &overlay->stroke, err));
    return gpu_program_get(programs, &over, "", &overlay->over, err);
}

enum hatch_status line_overlay_make(struct line_overlay *overlay, struct scene *scene,
                                    const struct line_overlay_style *style, struct gpu_programs *programs,
                                    struct cmd_args *args, struct hatch_err *err)
{
    static const struct gpu_attribute attributes[] = {
        {ATTRIBUTE_LINE_ENDS, 4, GL_FLOAT, 0},
        {ATTRIBUTE_LINE_DEPTH, 3, GL_FLOAT, offsetof(struct hatch_line_segment, depth)},
        {ATTRIBUTE_LINE_BRUSH, 4, GL_FLOAT, offsetof(struct hatch_line_segment, width)}};
    struct line_overlay made = {.color = {style->color[0], style->color[1], style->color[2]}, .haloes = style->haloes};
    HATCH_TRY(hatch_lines_make(&scene->unit, &style->lines, &args->keep, &args->scratch, &made.lines, err));
    HATCH_TRY(compile(&made, programs, err));
    glCreateBuffers(1, &made.segments);
    glCreateVertexArrays(1, &made.array);
    gpu_array_attach(made.array, 0, made.segments, sizeof(struct hatch_line_segment), attributes, 3);
    glVertexArrayBindingDivisor(made.array, 0, 1);
    hatch_arena_init(&made.frame, args->max_memory);
    *overlay = made;
    return HATCH_OK;
}

/* Makes textures for a number of samples, of twice as many rows each time: most pictures have few. */
static enum hatch_status make_room(struct line_overlay *overlay, size_t sample_count, struct hatch_err *err)
{
    struct gpu_target_form form = {.width = BATCH, .height = 1, .outputs = {GL_R8UI}};
    while (form.height < ROWS_MAX && (size_t)form.height * BATCH < sample_count)
        form.height *= 2;
    if (form.height <= overlay->results.form.height)
        return HATCH_OK;
    gpu_target_free(&overlay->results);
    glDeleteTextures(1, &overlay->samples);
    overlay->samples = gpu_texture_2d(GL_RGBA32F, TEXELS * BATCH, form.height);
    return gpu_target_make(&form, &overlay->results, err);
}

/* Uploads samples row by row; the last row may be incomplete. */
static void upload(const struct line_overlay *overlay, const struct hatch_line_sample *samples, size_t count)
{
    GLsizei rows = (GLsizei)(count / BATCH), rest = (GLsizei)(count % BATCH);
    if (rows)
        glTextureSubImage2D(overlay->samples, 0, 0, 0, (GLsizei)(TEXELS * BATCH), rows, GL_RGBA, GL_FLOAT, samples);
    if (rest)
        glTextureSubImage2D(overlay->samples, 0, 0, rows, rest * (GLsizei)TEXELS, 1, GL_RGBA, GL_FLOAT,
                            samples + (size_t)rows * BATCH);
}

/* Tests the samples against the canvas's depth and haloes. A sample is visible if at least one of the depths around it
 * is not nearer than the sample's depth limit.
 *   seen  out: bits of enum hatch_line_seen per sample; room for sample_count, rounded up to a multiple of BATCH */
static void test_samples(const struct line_overlay *overlay, const struct gpu_program *test,
                         const struct canvas *canvas, const struct hatch_line_frame *lines, uint8_t *seen)
{
    const size_t most = (size_t)BATCH * ROWS_MAX;
    for (size_t done = 0; done < lines->sample_count; done += most) {
        size_t batch = lines->sample_count - done < most ? lines->sample_count - done : most;
        const struct gpu_rectangle rows = {0, 0, BATCH, (uint32_t)((batch + BATCH - 1) / BATCH)};
        upload(overlay, lines->samples + done, batch);
        frame_pass_begin(&(struct frame_pass){.target = &overlay->results});
        glViewport(0, 0, (GLsizei)rows.width, (GLsizei)rows.height);
        gpu_texture_bind(UNIT_TONES, canvas->samples.depth, 0);
        gpu_texture_bind(UNIT_SOURCE, overlay->samples, 0);
        glProgramUniform1f(test->name, UNIFORM_LINE_SAMPLES, (GLfloat)canvas->side);
        frame_pass_screen(test);
        gpu_target_read(&overlay->results, 0, rows, GL_RED_INTEGER, GL_UNSIGNED_BYTE, 0, seen + done);
    }
}

/* Sets how a program finds the places of pixels in the unit scene, and the light there. */
static void set_place(const struct frame *frame, const struct hatch_line_brush *brush, GLuint program)
{
    const struct hatch_view *view = &frame->view;
    const struct hatch_tile *tile = frame->request.tile;
    double high = 2 * view->half_height / tile->full_height;
    double wide = 2 * view->half_height * view->aspect / tile->full_width;
    double shift = hatch_view_depth_shift(view);
    float place[4][4] = {
        {[3] = (float)((1 + shift) * view->near)}, {[3] = (float)shift}, {0}, {[3] = (float)view->far}};
    for (int k = 0; k < 3; k++) {
        double corner = (tile->x - 0.5 * tile->full_width) * wide * view->right[k] +
                        (tile->y - 0.5 * tile->full_height) * high * view->up[k];
        place[0][k] = (float)view->eye[k];
        place[1][k] = (float)(wide * view->right[k]);
        place[2][k] = (float)(high * view->up[k]);
        place[3][k] = (float)(corner - (view->orthographic ? 0 : view->back[k]));
    }
    glProgramUniform4fv(program, UNIFORM_LINE_PLACE, 4, place[0]);
    glProgramUniform2f(program, UNIFORM_LINE_BRUSH, brush->depth, brush->tone);
}

/* Finds the program that tests samples: with a brush, it finds their weights, too. */
static enum hatch_status find_test(const struct line_overlay *overlay, struct frame *frame,
                                   const struct gpu_program **test, struct hatch_err *err)
{
    const struct hatch_line_brush *brush = &overlay->lines.style.brush;
    char light[FRAME_LIGHT_DEFINES_BYTES], defines[FRAME_LIGHT_DEFINES_BYTES + 64];
    *test = overlay->test;
    if (!hatch_line_brush_is_used(brush))
        return HATCH_OK;
    frame_light_defines(frame, true, light);
    snprintf(defines, sizeof defines, "%s#define BRUSH 1\n%s", light, overlay->haloes ? "#define HALOES 1\n" : "");
    HATCH_TRY(gpu_program_get(&frame->programs, &test_stages, defines, test, err));
    set_place(frame, brush, (*test)->name);
    return HATCH_OK;
}

/* Draws segments with round ends into a transient target of coverage, of which overlapping segments keep the maximum,
 * so that joints and crossings are no darker than the rest. Then draws the colour over the picture by that coverage. */
static enum hatch_status draw_segments(struct line_overlay *overlay, struct frame *frame,
                                       const struct hatch_line_segment *segments, size_t count, struct hatch_err *err)
{
    static const float none[4] = {0, 0, 0, 0};
    const struct canvas *canvas = frame->request.canvas;
    const struct gpu_target_form form = {.width = canvas->width, .height = canvas->height, .outputs = {GL_R16F}};
    const struct gpu_target *coverage;
    HATCH_TRY(frame_target(&frame->targets, &form, &coverage, err));
    frame_pass_begin(&(struct frame_pass){.target = coverage, .blend = FRAME_BLEND_MAX, .clear = none});
    glProgramUniform2f(overlay->stroke->name, UNIFORM_A, (GLfloat)form.width, (GLfloat)form.height);
    glProgramUniform1f(overlay->stroke->name, UNIFORM_B, (GLfloat)overlay->lines.style.width_px);
    glNamedBufferData(overlay->segments, (GLsizeiptr)(sizeof *segments * count), segments, GL_STREAM_DRAW);
    frame_pass_quads(overlay->stroke, overlay->array, (GLsizei)count);
    frame_pass_begin(&(struct frame_pass){.target = canvas->picture, .blend = FRAME_BLEND_OVER_COLOR});
    gpu_texture_bind(UNIT_TONES, coverage->outputs[0], 0);
    glProgramUniform3fv(overlay->over->name, UNIFORM_A, 1, overlay->color);
    bool brushed = hatch_line_brush_is_used(&overlay->lines.style.brush);
    glProgramUniform2f(overlay->over->name, UNIFORM_B, brushed ? overlay->lines.style.brush.ink : 1,
                       brushed ? overlay->lines.style.brush.grain : 0);
    glProgramUniform2f(overlay->over->name, UNIFORM_C, (GLfloat)frame->request.tile->x,
                       (GLfloat)frame->request.tile->y);
    frame_pass_screen(overlay->over);
    return HATCH_OK;
}

static enum hatch_status draw(struct line_overlay *overlay, struct frame *frame, struct hatch_err *err)
{
    struct hatch_line_frame lines;
    struct hatch_line_segment *segments;
    const struct gpu_program *test;
    size_t count;
    HATCH_TRY(hatch_lines_trace(&overlay->lines, &frame->view, frame->request.tile, &overlay->frame, &lines, err));
    if (!lines.sample_count)
        return HATCH_OK;
    uint8_t *seen = HATCH_NEW(&overlay->frame, uint8_t, lines.sample_count + BATCH, err);
    if (!seen)
        return HATCH_LIMIT;
    HATCH_TRY(find_test(overlay, frame, &test, err));
    HATCH_TRY(make_room(overlay, lines.sample_count, err));
    test_samples(overlay, test, frame->request.canvas, &lines, seen);
    HATCH_TRY(hatch_lines_join(&overlay->lines, &lines, seen, &overlay->frame, &segments, &count, err));
    return draw_segments(overlay, frame, segments, count, err);
}

enum hatch_status line_overlay_draw(struct line_overlay *overlay, struct frame *frame, struct hatch_err *err)
{
    struct hatch_arena_mark mark = hatch_arena_mark(&overlay->frame);
    enum hatch_status status = draw(overlay, frame, err);
    hatch_arena_rewind(&overlay->frame, mark);
    gpu_timer_end_pass(frame->timer, "lines");
    return status;
}

void line_overlay_free(struct line_overlay *overlay)
{
    glDeleteVertexArrays(1, &overlay->array);
    glDeleteBuffers(1, &overlay->segments);
    glDeleteTextures(1, &overlay->samples);
    gpu_target_free(&overlay->results);
    hatch_arena_free(&overlay->frame);
    *overlay = (struct line_overlay){.array = 0};
}
