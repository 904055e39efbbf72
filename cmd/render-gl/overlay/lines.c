#include "render-gl/overlay/lines.h"

#include <stddef.h>

#include "render-gl/gpu/bindings.h"
#include "render-gl/gpu/buffer.h"
#include "render-gl/gpu/texture.h"

#define BATCH 1024u /* samples in a row of the texture */
#define TEXELS 2u   /* of a sample */
#define ROWS 1024u  /* rows of the texture; if there are more samples, they are tested in several passes */

static enum hatch_status compile(struct line_overlay *overlay, struct gpu_programs *programs, struct hatch_err *err)
{
    static const struct gpu_stages test = {.vertex = "canvas/screen.vert", .fragment = "overlay/line_test.frag"};
    static const struct gpu_stages stroke = {.vertex = "overlay/line_stroke.vert",
                                             .fragment = "overlay/line_stroke.frag"};
    static const struct gpu_stages over = {.vertex = "canvas/screen.vert", .fragment = "overlay/line_over.frag"};
    const char *defines = overlay->haloes ? "#define HALOES 1\n" : "";
    HATCH_TRY(gpu_program_get(programs, &test, defines, &overlay->test, err));
    HATCH_TRY(gpu_program_get(programs, &stroke, defines, &overlay->stroke, err));
    return gpu_program_get(programs, &over, "", &overlay->over, err);
}

enum hatch_status line_overlay_make(struct line_overlay *overlay, struct scene *scene,
                                    const struct line_overlay_style *style, struct gpu_programs *programs,
                                    struct cmd_args *args, struct hatch_err *err)
{
    static const struct gpu_attribute attributes[] = {
        {ATTRIBUTE_LINE_ENDS, 4, GL_FLOAT, 0},
        {ATTRIBUTE_LINE_DEPTH, 3, GL_FLOAT, offsetof(struct hatch_line_segment, depth)}};
    const struct gpu_target_form results = {.width = BATCH, .height = ROWS, .outputs = {GL_R8UI}};
    struct line_overlay made = {.color = {style->color[0], style->color[1], style->color[2]}, .haloes = style->haloes};
    HATCH_TRY(hatch_lines_make(&scene->unit, &style->lines, &args->keep, &args->scratch, &made.lines, err));
    HATCH_TRY(compile(&made, programs, err));
    HATCH_TRY(gpu_target_make(&results, &made.results, err));
    made.samples = gpu_texture_2d(GL_RGBA32F, TEXELS * BATCH, ROWS);
    glCreateBuffers(1, &made.segments);
    glCreateVertexArrays(1, &made.array);
    gpu_array_attach(made.array, 0, made.segments, sizeof(struct hatch_line_segment), attributes, 2);
    glVertexArrayBindingDivisor(made.array, 0, 1);
    hatch_arena_init(&made.frame, args->max_memory);
    *overlay = made;
    return HATCH_OK;
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
static void test_samples(const struct line_overlay *overlay, const struct canvas *canvas,
                         const struct hatch_line_frame *lines, uint8_t *seen)
{
    const size_t most = (size_t)BATCH * ROWS;
    for (size_t done = 0; done < lines->sample_count; done += most) {
        size_t batch = lines->sample_count - done < most ? lines->sample_count - done : most;
        const struct gpu_rectangle rows = {0, 0, BATCH, (uint32_t)((batch + BATCH - 1) / BATCH)};
        upload(overlay, lines->samples + done, batch);
        frame_pass_begin(&(struct frame_pass){.target = &overlay->results});
        glViewport(0, 0, (GLsizei)rows.width, (GLsizei)rows.height);
        gpu_texture_bind(UNIT_TONES, canvas->samples.depth, 0);
        gpu_texture_bind(UNIT_SOURCE, overlay->samples, 0);
        glProgramUniform1f(overlay->test->name, UNIFORM_A, (GLfloat)canvas->side);
        frame_pass_screen(overlay->test);
        gpu_target_read(&overlay->results, 0, rows, GL_RED_INTEGER, GL_UNSIGNED_BYTE, 0, seen + done);
    }
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
    frame_pass_screen(overlay->over);
    return HATCH_OK;
}

static enum hatch_status draw(struct line_overlay *overlay, struct frame *frame, struct hatch_err *err)
{
    struct hatch_line_frame lines;
    struct hatch_line_segment *segments;
    size_t count;
    HATCH_TRY(hatch_lines_trace(&overlay->lines, &frame->view, frame->request.tile, &overlay->frame, &lines, err));
    if (!lines.sample_count)
        return HATCH_OK;
    uint8_t *seen = HATCH_NEW(&overlay->frame, uint8_t, lines.sample_count + BATCH, err);
    if (!seen)
        return HATCH_LIMIT;
    test_samples(overlay, frame->request.canvas, &lines, seen);
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
