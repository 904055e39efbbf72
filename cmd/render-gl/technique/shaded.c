#include "render-gl/technique/shaded.h"

#include <string.h>

enum hatch_status shaded_prepare_with(struct technique_context *context, struct technique_instance *instance,
                                      const char *defines, struct hatch_err *err)
{
    struct shaded_state *state = instance->state;
    char all[SHADED_DEFINES_BYTES] = "";
    if (instance->tones)
        asset_tones_defines(instance->tones, context->frame->style.anisotropy, all, sizeof all);
    strncat(all, defines, sizeof all - strlen(all) - 1);
    if (strcmp(all, state->defines) != 0) {
        memset(&state->shader, 0, sizeof state->shader);
        memcpy(state->defines, all, sizeof all);
    }
    return frame_shader_prepare(context->frame, instance->technique->shading, state->defines, &state->shader, err);
}

enum hatch_status shaded_prepare(struct technique_context *context, struct technique_instance *instance,
                                 struct hatch_err *err)
{
    return shaded_prepare_with(context, instance, "", err);
}

enum hatch_status shaded_draw(struct technique_context *context, struct technique_instance *instance,
                              struct hatch_err *err)
{
    struct shaded_state *state = instance->state;
    return frame_draw_items(context->frame, &context->frame->request.canvas->samples, instance->technique->shading,
                            state->defines, &state->shader, err);
}
