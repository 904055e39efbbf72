/* Dynamic solid textures (Bénard, Bousseau & Thollot 2009): objects carved from a texture that keeps its size on the
 * screen. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/text.h"
#include "image/color.h"
#include "math/angle.h"
#include "render-gl/gpu/bindings.h"
#include "render-gl/gpu/buffer.h"
#include "render-gl/scene/attributes.h"
#include "render-gl/technique/list.h"
#include "render-gl/technique/solid/solid.h"

static const struct technique_param params[] = {
    {"solid-size", true, 1.1},    {"grain", false, 0.05}, {"bands", false, 1},
    {"wobble", false, 0.5},       {"dry", false, 0.05},   {"edge-darkening", false, 0.05},
    {"paper-grain", false, 0.05}, {"border", false, 0.5}, {NULL, false, 0}};

static enum solid_look look(void)
{
    return (enum solid_look)solid_options.look;
}

/* Reads the colours of --inks. */
static void read_inks(struct solid_block *block)
{
    size_t count = 0;
    for (const char *at = solid_options.inks; at;) {
        const char *comma = strchr(at, ',');
        const struct hatch_text name = {at, comma ? (size_t)(comma - at) : strlen(at)};
        if (count == SOLID_INKS_MAX)
            cmd_usage("--inks: more than %u colours", SOLID_INKS_MAX);
        if (!hatch_color_parse(name, block->inks[count++]))
            cmd_usage("--inks: '%.*s' is neither the name of a colour nor #rrggbb", (int)name.length, name.at);
        at = comma ? comma + 1 : NULL;
    }
    block->edges[1] = (float)count;
}

static void read_files(struct technique_context *context, struct technique_instance *instance)
{
    struct solid_state *state = instance->state;
    solid_files_read(context->args, solid_options.files, &state->files);
    read_inks(&state->block);
    state->shading = solid_look_shading(look(), state->files.flat);
    instance->places = state->files.flat ? HATCH_NEAR_TEXCOORDS : HATCH_NEAR_REST;
    if (state->files.flat)
        instance->texcoords_for = "which 2D textures need; 3D textures, which solidgen makes, need none";
}

/* Turns the textures against the meshes: by --solid-turn or, if they have no direction, so that surfaces along the axes
 * of a mesh do not show the same slice over and over. */
static void turn_textures(const struct solid_files *files, struct scene *scene)
{
    static const double aligned[3] = {0, 0, 0}, between_slices[3] = {23, 37, 11};
    const char *text = solid_options.turn;
    double turn[3];
    memcpy(turn, files->isotropic ? between_slices : aligned, sizeof turn);
    if (text && files->flat)
        cmd_usage("--solid-turn: 2D textures lie on the surface");
    if (text && !(hatch_text_vector((struct hatch_text){text, strlen(text)}, turn) &&
                  fmax(fmax(fabs(turn[0]), fabs(turn[1])), fabs(turn[2])) <= 360))
        cmd_usage("--solid-turn %s: want X,Y,Z, angles from -360 to 360 degrees", text);
    for (int k = 0; k < 3; k++)
        turn[k] *= HATCH_RADIANS;
    hatch_unit_scene_turn_rest(&scene->unit, turn);
}

static struct solids_form wanted_form(const struct solid_state *state, uint32_t side)
{
    bool ranks = look() == SOLID_BINARY || look() == SOLID_WATERCOLOR;
    double period_px = solid_options.period_px > 0 ? solid_options.period_px : 2.0 * state->files.solids[0].size;
    return (struct solids_form){.period_px = period_px,
                                .samples = side,
                                .grey = ranks,
                                .blend = ranks ? HATCH_ZOOM_RANK : (enum hatch_zoom_blend)solid_options.blend};
}

static enum hatch_status upload(struct technique_context *context, struct solid_state *state, struct hatch_err *err)
{
    const struct solids_form form = wanted_form(state, context->side);
    struct solids fresh;
    if (state->solids.count && form.grey == state->form.grey && form.blend == state->form.blend)
        return HATCH_OK;
    HATCH_TRY(solids_upload(&state->files, &form, cmd_pool(context->args), &context->args->scratch, &fresh, err));
    solids_free(&state->solids);
    state->solids = fresh;
    state->form = form;
    memcpy(state->block.colors, fresh.colors, sizeof fresh.colors);
    return HATCH_OK;
}

/* Prepares the attributes of vertices that flat textures need. */
static enum hatch_status prepare_flat(struct technique_context *context, const struct solid_state *state,
                                      struct hatch_err *err)
{
    struct scene *scene = context->frame->scene;
    struct hatch_arena *scratch = &context->args->scratch;
    const struct hatch_uv_repeat how = {
        .view = context->view, .height_px = context->height_px, .size_px = state->files.solids[0].size, .levels = 1};
    HATCH_TRY(scene_set_repeats(scene, &how, &context->args->keep, scratch, err));
    return scene_set_uv_tangents(scene, scratch, err);
}

static enum hatch_status prepare(struct technique_context *context, struct technique_instance *instance,
                                 struct hatch_err *err)
{
    struct solid_state *state = instance->state;
    struct shaded_state *shaded = &state->shaded;
    char defines[SHADED_DEFINES_BYTES];
    HATCH_TRY(upload(context, state, err));
    if (state->files.flat)
        HATCH_TRY(prepare_flat(context, state, err));
    else
        scene_set_rest(context->frame->scene);
    turn_textures(&state->files, context->frame->scene);
    snprintf(defines, sizeof defines, "#define SOLIDS %u\n#define CHANNELS %u\n%s", state->solids.count,
             state->solids.channels, state->form.blend != HATCH_ZOOM_LINEAR ? "#define TABLES 1\n" : "");
    if (strcmp(defines, shaded->defines) != 0) {
        memset(&shaded->shader, 0, sizeof shaded->shader);
        memcpy(shaded->defines, defines, sizeof defines);
    }
    HATCH_TRY(solid_look_prepare(context->frame, look(), err));
    return frame_shader_prepare(context->frame, &state->shading, shaded->defines, &shaded->shader, err);
}

/* Writes the values that depend on the view and on the options. */
static void set_block(const struct frame *frame, struct solid_state *state)
{
    const uint32_t side = frame->request.canvas->side;
    const struct solids_form form = wanted_form(state, side);
    double unit_px = frame->request.tile->full_height / (2 * frame->view.half_height);
    const float marks[4] = {(float)solid_options.grain, (float)(solid_options.wobble_px * side),
                            (float)solid_options.dry, (float)solid_options.darkening};
    state->block.zoom[0] = (float)log2(form.period_px / unit_px);
    state->block.zoom[1] = (float)form.period_px;
    state->block.zoom[2] = (float)log2(form.period_px);
    state->block.edges[0] = (float)solid_options.bands;
    state->block.edges[2] = (float)solid_options.paper_grain;
    memcpy(state->block.marks, marks, sizeof marks);
    gpu_block_update(&state->block_buffer, BLOCK_TECHNIQUE, &state->block, sizeof state->block);
}

static enum hatch_status draw(struct technique_context *context, struct technique_instance *instance,
                              struct hatch_err *err)
{
    struct solid_state *state = instance->state;
    struct frame *frame = context->frame;
    set_block(frame, state);
    solids_use(&state->solids);
    return solid_look_draw(frame, look(), &state->shaded, &state->shading, err);
}

static uint32_t reach_px(const struct technique_instance *instance)
{
    (void)instance;
    return solid_look_reach_px(look());
}

static void free_state(struct technique_instance *instance)
{
    struct solid_state *state = instance->state;
    solids_free(&state->solids);
    glDeleteBuffers(1, &state->block_buffer);
    state->block_buffer = 0;
}

const struct technique technique_solid = {
    .name = "solid",
    .summary = "surfaces carved from a solid texture that has the same size at every distance",
    .options = solid_option_table,
    .params = params,
    .features = TECHNIQUE_PIXEL_LIGHT,
    .places = HATCH_NEAR_REST,
    .state_size = sizeof(struct solid_state),
    .read = read_files,
    .prepare = prepare,
    .draw = draw,
    .reach_px = reach_px,
    .free = free_state,
};
