/* Sources of strokes: seed points, or a tonal art map with ids. */
#include "render-gl/gpu/bindings.h"
#include "render-gl/gpu/texture.h"
#include "render-gl/scene/attributes.h"
#include "render-gl/technique/strokes/strokes.h"

static const struct frame_shading map_shading = {
    .stages = {.vertex = "rptam/rptam.vert", .fragment = "strokes/gather_map.frag"},
    .defines = "#define GATHERS 1\n#define EXACT 1\n",
    .pixel_light = true,
    .patches = FRAME_PATCHES_COVER,
    .passes = {{.name = "gather", .depth = FRAME_DEPTH_EQUAL}}};

/* Draws which patch lies on top. */
static const struct frame_shading owner_shading = {
    .stages = {.vertex = "strokes/owner.vert", .fragment = "strokes/owner.frag"},
    .patches = FRAME_PATCHES_COVER,
    .passes = {{.name = "owners", .depth = FRAME_DEPTH_NEARER}}};

static bool has_patches(const struct scene *scene)
{
    for (uint32_t i = 0; i < scene->unit.item_count; i++)
        if (scene->unit.meshes[scene->unit.items[i].mesh].patches)
            return true;
    return false;
}

/* Draws which patch lies on top where, and binds the result for the shaders that gather.
 *   like    target of these shaders
 *   owners  out: the target that is bound; NULL: there are no patches */
static enum hatch_status draw_owners(struct technique_context *context, struct strokes_state *state,
                                     const struct gpu_target *like, const struct gpu_target **owners,
                                     struct hatch_err *err)
{
    static const float nothing[4] = {0}, far = 0;
    struct frame *frame = context->frame;
    struct gpu_target_form form = like->form;
    *owners = NULL;
    if (!has_patches(frame->scene))
        return HATCH_OK;
    form.outputs[0] = GL_RGBA32F;
    HATCH_TRY(frame_target(&frame->targets, &form, owners, err));
    const struct frame_pass clear = {.name = "clear", .target = *owners, .clear = nothing, .clear_depth = &far};
    frame_pass_begin(&clear);
    HATCH_TRY(frame_draw_items(frame, *owners, &owner_shading, "", &state->owners, err));
    gpu_texture_bind(UNIT_SOURCE, (*owners)->outputs[0], 0);
    return HATCH_OK;
}

enum hatch_status strokes_prepare_source(struct technique_context *context, struct technique_instance *instance,
                                         struct hatch_err *err)
{
    struct strokes_state *state = instance->state;
    HATCH_TRY(scene_set_charts(context->frame->scene, &context->args->scratch, err));
    if (has_patches(context->frame->scene))
        HATCH_TRY(frame_shader_prepare(context->frame, &owner_shading, "", &state->owners, err));
    if (!instance->tones)
        return rptam_prepare(context, instance, err);
    instance->places = HATCH_NEAR_NONE; /* near the eye a map shows its texels */
    return frame_shader_prepare(context->frame, &map_shading, "", &state->map, err);
}

enum hatch_status strokes_draw_source(struct technique_context *context, struct technique_instance *instance,
                                      const struct gpu_target *target, struct hatch_err *err)
{
    struct strokes_state *state = instance->state;
    const struct gpu_target *owners;
    HATCH_TRY(draw_owners(context, state, target, &owners, err));
    if (instance->tones) {
        HATCH_TRY(frame_draw_items(context->frame, target, &map_shading, "", &state->map, err));
    } else {
        seeds_use(&state->seeds.seeds);
        HATCH_TRY(frame_draw_items(context->frame, target, &instance->technique->shading, state->seeds.shaded.defines,
                                   &state->seeds.shaded.shader, err));
    }
    frame_target_release(&context->frame->targets, owners);
    return HATCH_OK;
}

struct strokes_look strokes_look(const struct technique_instance *instance)
{
    if (instance->tones)
        return (struct strokes_look){.width_px = instance->tones->stroke_px, .ink = instance->tones->stroke_ink};
    return (struct strokes_look){.width_px = (float)rptam_options.stroke_px[1],
                                 .ink = (float)rptam_options.ink,
                                 .length_px = (float)rptam_options.stroke_px[0]};
}
