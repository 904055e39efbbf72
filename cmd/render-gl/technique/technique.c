#include "render-gl/technique/technique.h"

#include <stdio.h>
#include <string.h>

#include "render-gl/scene/attributes.h"

bool technique_has_option(const struct technique *technique, const char *name)
{
    const struct cmd_option *const tables[] = {technique->options, technique->shared};
    for (int i = 0; i < 2; i++)
        for (const struct cmd_option *row = tables[i]; row && row->name; row++)
            if (strcmp(row->name, name) == 0)
                return true;
    return false;
}

bool technique_has_pen_for(const struct technique *technique, const char *name)
{
    return technique->pen_option && strcmp(technique->pen_option, name) == 0;
}

bool technique_is_painted(const struct technique *technique)
{
    return !(technique->features & (TECHNIQUE_LOOKS | TECHNIQUE_NO_COLOR));
}

/* Returns the look that paints the pictures of a technique, or NULL. */
static struct look *look_of(const struct technique_context *context, const struct technique_instance *instance)
{
    return technique_is_painted(instance->technique) ? context->look : NULL;
}

const struct asset_kind *technique_asset(const struct technique *technique)
{
    return technique->asset ? technique->asset : technique->extra;
}

enum hatch_status technique_open(struct technique_instance *instance, const struct technique *technique,
                                 struct cmd_args *args, struct hatch_err *err)
{
    size_t size_bytes = technique->state_size ? technique->state_size : sizeof(struct shaded_state);
    void *state = HATCH_NEW(&args->keep, char, size_bytes, err);
    if (!state)
        return HATCH_LIMIT;
    *instance = (struct technique_instance){.technique = technique, .state = state, .places = technique->places};
    if (technique->features & TECHNIQUE_STROKES)
        instance->texcoords_for = "which strokes follow; add them with dirfield FILE | lapped-param -o NEW.glb";
    return HATCH_OK;
}

enum hatch_status technique_prepare(struct technique_context *context, struct technique_instance *instance,
                                    struct hatch_err *err)
{
    const struct technique *technique = instance->technique;
    const struct asset_kind *kind = technique_asset(technique);
    if (kind && (technique->asset || assets_have(context->assets, kind)))
        HATCH_TRY(assets_upload(context->assets, kind, &context->args->scratch, &instance->tones, err));
    scene_restore_repeats(context->frame->scene);
    HATCH_TRY((technique->prepare ? technique->prepare : shaded_prepare)(context, instance, err));
    struct look *look = look_of(context, instance);
    return look ? look_prepare(look, context->frame, context->view, context->height_px, context->side, context->args,
                               err)
                : HATCH_OK;
}

/* Begins a frame with the technique's tones. */
static enum hatch_status begin(struct technique_context *context, struct technique_instance *instance,
                               const struct frame_request *request, struct hatch_err *err)
{
    const struct technique *technique = instance->technique;
    struct frame *frame = context->frame;
    double high = frame->style.curve.high;
    if (technique->tone_scale > 0)
        frame->style.curve.high *= technique->tone_scale;
    if (instance->tones)
        asset_tones_use(instance->tones, frame->style.anisotropy, request->canvas->side, &frame->block);
    else
        frame_block_set_tones(&frame->block, NULL, 0, 0);
    enum hatch_status status = frame_begin(frame, request, instance->places, err);
    frame->style.curve.high = high;
    return status;
}

enum hatch_status technique_draw(struct technique_context *context, struct technique_instance *instance,
                                 const struct frame_request *request, struct hatch_err *err)
{
    const struct technique *technique = instance->technique;
    struct look *look = look_of(context, instance);
    HATCH_TRY(begin(context, instance, request, err));
    HATCH_TRY((technique->draw ? technique->draw : shaded_draw)(context, instance, err));
    if (look)
        HATCH_TRY(look_paint(look, context->frame, context->args, err));
    return frame_end(context->frame, !(technique->features & TECHNIQUE_NO_COLOR), err);
}

enum hatch_status technique_foresee(struct technique_context *context, struct technique_instance *instance,
                                    const struct frame_request *request, double pen_px, struct hatch_err *err)
{
    HATCH_TRY(begin(context, instance, request, err));
    return instance->technique->foresee(context, instance, pen_px, err);
}

enum hatch_status technique_find_curves(struct technique_context *context, struct technique_instance *instance,
                                        const struct frame_request *request, double pen_px, struct hatch_arena *arena,
                                        struct technique_curves *curves, struct hatch_err *err)
{
    HATCH_TRY(begin(context, instance, request, err));
    HATCH_TRY(instance->technique->curves(context, instance, pen_px, arena, curves, err));
    return frame_end(context->frame, false, err);
}

struct hatch_line_brush technique_line_brush(const struct technique_instance *instance)
{
    return instance->technique->line_brush ? instance->technique->line_brush(instance)
                                           : (struct hatch_line_brush){.taper_px = 0};
}

void technique_close(struct technique_instance *instance)
{
    if (instance->technique && instance->technique->free)
        instance->technique->free(instance);
    *instance = (struct technique_instance){.technique = NULL};
}

uint32_t technique_reach_px(const struct technique_context *context, const struct technique_instance *instance,
                            double line_px)
{
    uint32_t frame = frame_reach_px(context->frame, line_px), own = 0;
    if (instance->technique->reach_px)
        own = instance->technique->reach_px(instance);
    const struct look *look = look_of(context, instance);
    if (look)
        own += look_reach_px(look->kind);
    return frame > own ? frame : own;
}

enum hatch_status shaded_prepare_with(struct technique_context *context, struct technique_instance *instance,
                                      const char *defines, struct hatch_err *err)
{
    struct shaded_state *state = instance->state;
    const struct asset_tones *tones = instance->tones;
    bool anisotropic = tones && !tones->exact && context->frame->style.anisotropy > 1;
    char all[SHADED_DEFINES_BYTES] = "";
    snprintf(all, sizeof all, "%s%s%s%s", tones && tones->layered ? "#define LAYERED 1\n" : "",
             tones && tones->exact ? "#define EXACT 1\n" : "", anisotropic ? "#define ANISOTROPIC 1\n" : "", defines);
    if (strcmp(all, state->defines) != 0) {
        memset(&state->shader, 0, sizeof state->shader);
        memcpy(state->defines, all, sizeof all);
    }
    return frame_shader_prepare(context->frame, &instance->technique->shading, state->defines, &state->shader, err);
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
    return frame_draw_items(context->frame, &context->frame->request.canvas->samples, &instance->technique->shading,
                            state->defines, &state->shader, err);
}
