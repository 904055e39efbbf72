/* What the strokes come from: seed points, or a tonal art map with ids. */
#include "render-gl/scene/attributes.h"
#include "render-gl/technique/strokes/strokes.h"

static const struct frame_shading map_shading = {
    .stages = {.vertex = "rptam/rptam.vert", .fragment = "strokes/gather_map.frag"},
    .defines = "#define GATHERS 1\n#define EXACT 1\n",
    .pixel_light = true,
    .patches = FRAME_PATCHES_UNSEEN,
    .passes = {{.name = "gather", .depth = FRAME_DEPTH_EQUAL}}};

enum hatch_status strokes_prepare_source(struct technique_context *context, struct technique_instance *instance,
                                         struct hatch_err *err)
{
    struct strokes_state *state = instance->state;
    HATCH_TRY(scene_set_charts(context->frame->scene, &context->args->scratch, err));
    if (!instance->tones)
        return rptam_prepare(context, instance, err);
    return frame_shader_prepare(context->frame, &map_shading, "", &state->map, err);
}

enum hatch_status strokes_draw_source(struct technique_context *context, struct technique_instance *instance,
                                      const struct gpu_target *target, struct hatch_err *err)
{
    struct strokes_state *state = instance->state;
    if (instance->tones)
        return frame_draw_items(context->frame, target, &map_shading, "", &state->map, err);
    seeds_use(&state->seeds.seeds);
    return frame_draw_items(context->frame, target, &instance->technique->shading, state->seeds.shaded.defines,
                            &state->seeds.shaded.shader, err);
}

struct strokes_look strokes_look(const struct technique_instance *instance)
{
    if (instance->tones)
        return (struct strokes_look){instance->tones->stroke_px, instance->tones->stroke_ink};
    return (struct strokes_look){(float)rptam_options.stroke_px[1], (float)rptam_options.ink};
}
