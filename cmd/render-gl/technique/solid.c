/* Dynamic solid textures (Bénard, Bousseau & Thollot 2009): objects carved from a texture that keeps its size on the
 * screen. */
#include "render-gl/look/look.h"
#include "render-gl/technique/list.h"

static void read_files(struct technique_context *context, struct technique_instance *instance)
{
    struct look *look = instance->state;
    look_read(context->args, (enum look_kind)look_options.kind, false, look);
    instance->places = look->files.flat ? HATCH_NEAR_TEXCOORDS : HATCH_NEAR_REST;
    if (look->files.flat)
        instance->texcoords_for = "which 2D textures need; 3D textures, which solidgen makes, need none";
}

static enum hatch_status prepare(struct technique_context *context, struct technique_instance *instance,
                                 struct hatch_err *err)
{
    return look_prepare(instance->state, context->frame, context->view, context->height_px, context->side,
                        context->args, err);
}

static enum hatch_status draw(struct technique_context *context, struct technique_instance *instance,
                              struct hatch_err *err)
{
    return look_draw(instance->state, context->frame, context->args, err);
}

static uint32_t reach_px(const struct technique_instance *instance)
{
    const struct look *look = instance->state;
    return look_reach_px(look->kind);
}

static void free_state(struct technique_instance *instance)
{
    look_free(instance->state);
}

const struct technique technique_solid = {
    .name = "solid",
    .summary = "surfaces carved from a solid texture that has the same size at every distance",
    .features = TECHNIQUE_PIXEL_LIGHT | TECHNIQUE_LOOKS,
    .places = HATCH_NEAR_REST,
    .state_size = sizeof(struct look),
    .read = read_files,
    .prepare = prepare,
    .draw = draw,
    .reach_px = reach_px,
    .free = free_state,
};
