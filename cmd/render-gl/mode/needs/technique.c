#include "render-gl/mode/needs/technique.h"

struct needs_state {
    struct frame_shader shader;
    const struct gpu_target *target; /* of the last frame */
};

static enum hatch_status prepare(struct technique_context *context, struct technique_instance *instance,
                                 struct hatch_err *err)
{
    struct needs_state *state = instance->state;
    return frame_shader_prepare(context->frame, &needs_technique.shading, "", &state->shader, err);
}

/* Draws into a target of single floats, which hold numbers of items and faces exactly. */
static enum hatch_status draw(struct technique_context *context, struct technique_instance *instance,
                              struct hatch_err *err)
{
    static const float nothing[4] = {0}, far = 0;
    struct frame *frame = context->frame;
    struct needs_state *state = instance->state;
    struct gpu_target_form form = frame->request.canvas->samples.form;
    form.outputs[0] = form.outputs[1] = GL_RGBA32F;
    HATCH_TRY(frame_target(&frame->targets, &form, &state->target, err));
    const struct frame_pass clear = {.name = "clear", .target = state->target, .clear = nothing, .clear_depth = &far};
    frame_pass_begin(&clear);
    return frame_draw_items(frame, state->target, &needs_technique.shading, "", &state->shader, err);
}

const struct technique needs_technique = {
    .name = "needs",
    .summary = "tones, items and faces instead of colours",
    .features = TECHNIQUE_PIXEL_LIGHT | TECHNIQUE_NO_COLOR,
    .state_size = sizeof(struct needs_state),
    .shading = {.stages = {.vertex = "needs/needs.vert", .fragment = "needs/needs.frag"},
                .pixel_light = true,
                .patches = FRAME_PATCHES_UNSEEN,
                .passes = {{.name = "needs", .depth = FRAME_DEPTH_NEARER}}},
    .prepare = prepare,
    .draw = draw,
};

const struct gpu_target *needs_target(const struct technique_instance *instance)
{
    const struct needs_state *state = instance->state;
    return state->target;
}
