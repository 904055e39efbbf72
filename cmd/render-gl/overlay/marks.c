#include "render-gl/overlay/marks.h"

#include <stddef.h>

#include "render-gl/gpu/bindings.h"
#include "render-gl/gpu/buffer.h"

#define WIDTH_PX 1.5 /* width of marks */

enum hatch_status mark_overlay_make(struct mark_overlay *overlay, struct frame *frame, const struct hatch_view *view,
                                    double height_px, struct hatch_arena *arena, struct hatch_err *err)
{
    static const struct gpu_stages stages = {.vertex = "overlay/mark.vert", .fragment = "overlay/mark.frag"};
    static const struct gpu_attribute attributes[] = {
        {ATTRIBUTE_MARK_MIDDLE, 3, GL_FLOAT, offsetof(struct hatch_mark_line, middle)},
        {ATTRIBUTE_MARK_HALF, 3, GL_FLOAT, offsetof(struct hatch_mark_line, half)},
        {ATTRIBUTE_MARK_CONFIDENCE, 1, GL_FLOAT, offsetof(struct hatch_mark_line, confidence)}};
    struct mark_overlay made = {.array = 0};
    struct hatch_arena *scratch = frame->programs.scratch;
    HATCH_TRY(hatch_marks_make(&frame->scene->unit, view, height_px, arena, scratch, &made.marks, err));
    HATCH_TRY(gpu_program_get(&frame->programs, &stages, "", &made.program, err));
    made.buffer = gpu_buffer_make(NULL, sizeof *made.marks.lines * made.marks.count);
    glCreateVertexArrays(1, &made.array);
    gpu_array_attach(made.array, 0, made.buffer, sizeof *made.marks.lines, attributes, 3);
    glVertexArrayBindingDivisor(made.array, 0, 1);
    *overlay = made;
    return HATCH_OK;
}

void mark_overlay_draw(struct mark_overlay *overlay, struct frame *frame)
{
    const struct canvas *canvas = frame->request.canvas;
    hatch_marks_place(&overlay->marks);
    gpu_buffer_update(overlay->buffer, overlay->marks.lines, sizeof *overlay->marks.lines * overlay->marks.count);
    frame_pass_begin(&(struct frame_pass){.target = &canvas->samples, .depth = FRAME_DEPTH_BEFORE});
    glProgramUniform2f(overlay->program->name, UNIFORM_MARK_WIDTH, (float)(WIDTH_PX / canvas->width),
                       (float)(WIDTH_PX / canvas->height));
    frame_pass_quads(overlay->program, overlay->array, (GLsizei)overlay->marks.count);
}

void mark_overlay_free(struct mark_overlay *overlay)
{
    glDeleteVertexArrays(1, &overlay->array);
    glDeleteBuffers(1, &overlay->buffer);
    *overlay = (struct mark_overlay){.array = 0};
}
