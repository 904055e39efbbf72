#include "render-gl/mode/show.h"

#include "render-gl/overlay/marks.h"
#include "render-gl/scene/attributes.h"

#define FIELD_SHADE 0.2 /* factor for the tone of the surface, so that marks stand out */

static enum hatch_status check_patches(const struct hatch_scene *scene, const struct hatch_patch_mesh *patches,
                                       struct hatch_err *err)
{
    for (uint32_t i = 0; i < scene->mesh_count; i++)
        if (patches[i].patch_count)
            return HATCH_OK;
    return hatch_fail(err, HATCH_BAD_INPUT,
                      "the scene has no patches; add them with dirfield FILE | lapped-param -o NEW.glb");
}

static enum hatch_status prepare_patches(struct technique_context *context, struct technique_instance *instance,
                                         struct hatch_err *err)
{
    HATCH_TRY(scene_set_patch_tones(context->frame->scene, &context->args->scratch, err));
    return shaded_prepare(context, instance, err);
}

/* Draws each patch in its own tone (Real-Time Hatching §6). */
static const struct technique show_patches = {
    .name = "patches",
    .shading = {.stages = {.vertex = "show/patches.vert", .fragment = "show/patches.frag"},
                .passes = {{.name = "tone", .depth = FRAME_DEPTH_NEARER}}},
    .check = check_patches,
    .prepare = prepare_patches,
};

/* State of show_field, which draws direction marks over the tone. */
struct field_state {
    struct shaded_state shaded;
    struct mark_overlay marks;
};

static enum hatch_status check_field(const struct hatch_scene *scene, const struct hatch_patch_mesh *patches,
                                     struct hatch_err *err)
{
    (void)patches;
    for (uint32_t i = 0; i < scene->mesh_count; i++)
        if (hatch_mesh_find(&scene->meshes[i].mesh, "_HATCH_DIR", 4))
            return HATCH_OK;
    return hatch_fail(err, HATCH_BAD_INPUT, "no mesh has directions; add them with dirfield FILE -o NEW.glb");
}

static enum hatch_status prepare_field(struct technique_context *context, struct technique_instance *instance,
                                       struct hatch_err *err)
{
    struct field_state *state = instance->state;
    if (!state->marks.array)
        HATCH_TRY(mark_overlay_make(&state->marks, context->frame, context->view, context->height_px,
                                    &context->args->keep, err));
    return shaded_prepare(context, instance, err);
}

static enum hatch_status draw_field(struct technique_context *context, struct technique_instance *instance,
                                    struct hatch_err *err)
{
    struct field_state *state = instance->state;
    HATCH_TRY(shaded_draw(context, instance, err));
    mark_overlay_draw(&state->marks, context->frame);
    return HATCH_OK;
}

static void free_field(struct technique_instance *instance)
{
    struct field_state *state = instance->state;
    mark_overlay_free(&state->marks);
}

static const struct technique show_field = {
    .name = "field",
    .state_size = sizeof(struct field_state),
    .tone_scale = FIELD_SHADE,
    .shading = {.stages = {.vertex = "frame/tone.vert", .fragment = "frame/tone.frag"},
                .patches = FRAME_PATCHES_UNSEEN,
                .passes = {{.name = "tone", .depth = FRAME_DEPTH_NEARER}}},
    .check = check_field,
    .prepare = prepare_field,
    .draw = draw_field,
    .free = free_field,
};

const struct technique *const show_techniques[] = {&show_patches, &show_field, NULL};
