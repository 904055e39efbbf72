#include "render-gl/technique/rptam.h"

#include <stdio.h>

#include "render-gl/scene/attributes.h"
#include "render-gl/technique/list.h"

static const struct technique_param params[] = {
    {"stroke", true, 1.1},     {"stroke-ink", false, 0.05}, {"stroke-turn", false, 5}, {"seed-tile", true, 1.1},
    {"seed-layers", false, 1}, {"overlap", false, 0.1},     {NULL, false, 0}};

static enum hatch_status prepare_shader(struct technique_context *context, struct technique_instance *instance,
                                        struct hatch_err *err)
{
    const struct rptam_state *state = instance->state;
    char defines[64];
    snprintf(defines, sizeof defines, "%s%s", state->seeds.vary ? "#define STROKES_VARY 1\n" : "",
             state->seeds.shrink ? "#define STROKES_SHRINK 1\n" : "");
    return shaded_prepare_with(context, instance, defines, err);
}

enum hatch_status rptam_prepare(struct technique_context *context, struct technique_instance *instance,
                                struct hatch_err *err)
{
    struct rptam_state *state = instance->state;
    struct hatch_arena *scratch = &context->args->scratch;
    if (!state->seeds.layers)
        HATCH_TRY(seeds_upload(state->model, rptam_options.loop == 1, scratch, &state->seeds, err));
    HATCH_TRY(scene_set_uv_tangents(context->frame->scene, scratch, err));
    return prepare_shader(context, instance, err);
}

static enum hatch_status draw(struct technique_context *context, struct technique_instance *instance,
                              struct hatch_err *err)
{
    const struct rptam_state *state = instance->state;
    seeds_use(&state->seeds);
    return shaded_draw(context, instance, err);
}

enum hatch_status rptam_changed(struct technique_context *context, struct technique_instance *instance,
                                struct hatch_err *err)
{
    struct rptam_state *state = instance->state;
    struct seeds fresh;
    HATCH_TRY(rptam_make_model(context->args, state, err));
    if (!state->seeds.layers)
        return HATCH_OK;
    HATCH_TRY(seeds_upload(state->model, rptam_options.loop == 1, &context->args->scratch, &fresh, err));
    seeds_free(&state->seeds);
    state->seeds = fresh;
    return prepare_shader(context, instance, err);
}

double rptam_darkest(const struct technique_instance *instance)
{
    const struct rptam_state *state = instance->state;
    return state->model->darkest;
}

void rptam_free(struct technique_instance *instance)
{
    struct rptam_state *state = instance->state;
    seeds_free(&state->seeds);
    for (int i = 0; i < 2; i++)
        hatch_arena_free(&state->source.arenas[i]);
}

/* Recursive procedural tonal art maps (Szécsi & Szirányi 2014, Algorithm 2). */
const struct technique technique_rptam = {
    .name = "rptam",
    .summary = "strokes at seed points, without a map: the same size at every distance",
    .options = rptam_option_table,
    .params = params,
    .features = TECHNIQUE_STROKES | TECHNIQUE_PIXEL_LIGHT,
    .places = HATCH_NEAR_TEXCOORDS,
    .state_size = sizeof(struct rptam_state),
    .shading = {.stages = {.vertex = "rptam/rptam.vert", .fragment = "rptam/rptam.frag"},
                .pixel_light = true,
                .smooth = true,
                .passes = {{.name = "strokes", .depth = FRAME_DEPTH_NEARER}}},
    .read = rptam_read,
    .prepare = rptam_prepare,
    .draw = draw,
    .changed = rptam_changed,
    .darkest = rptam_darkest,
    .free = rptam_free,
};

const struct technique technique_rptam_places = {
    .name = "places",
    .summary = "",
    .features = TECHNIQUE_STROKES | TECHNIQUE_NO_COLOR,
    .places = HATCH_NEAR_TEXCOORDS,
    .state_size = sizeof(struct rptam_state),
    .shading = {.stages = {.vertex = "rptam/rptam.vert", .fragment = "rptam/places.frag"},
                .smooth = true,
                .patches = FRAME_PATCHES_COVER,
                .passes = {{.name = "places", .depth = FRAME_DEPTH_NEARER}}},
    .prepare = rptam_prepare,
    .draw = draw,
    .free = rptam_free,
};
