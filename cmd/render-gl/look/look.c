#include "render-gl/look/look.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/text.h"
#include "image/color.h"
#include "math/angle.h"
#include "render-gl/gpu/bindings.h"
#include "render-gl/gpu/buffer.h"
#include "render-gl/scene/attributes.h"

/* Reads the colours of --inks. */
static void read_inks(struct look_block *block)
{
    size_t count = 0;
    for (const char *at = look_options.inks; at;) {
        const char *comma = strchr(at, ',');
        const struct hatch_text name = {at, comma ? (size_t)(comma - at) : strlen(at)};
        if (count == LOOK_INKS_MAX)
            cmd_usage("--inks: more than %u colours", LOOK_INKS_MAX);
        if (!hatch_color_parse(name, block->inks[count++]))
            cmd_usage("--inks: '%.*s' is neither the name of a colour nor #rrggbb", (int)name.length, name.at);
        at = comma ? comma + 1 : NULL;
    }
    block->edges[1] = (float)count;
}

void look_choose(struct look *look, enum look_kind kind)
{
    static const struct {
        const char *name, *fragment;
        enum frame_patches patches; /* of flat textures */
    } looks[] = {[LOOK_PLAIN] = {"plain", "solid/plain.frag", FRAME_PATCHES_BLEND},
                 [LOOK_BINARY] = {"binary", "solid/binary.frag", FRAME_PATCHES_BLEND},
                 [LOOK_WATERCOLOR] = {"marks", "solid/marks.frag", FRAME_PATCHES_COVER},
                 [LOOK_COLLAGE] = {"strips", "collage/bands.frag", FRAME_PATCHES_COVER}};
    bool flat = look->files.flat;
    look->kind = kind;
    look->shading = (struct frame_shading){
        .stages = {.vertex = flat ? "rptam/rptam.vert" : "solid/solid.vert", .fragment = looks[kind].fragment},
        .defines = look->paints          ? "#define PICTURE 1\n"
                   : !flat               ? NULL
                   : kind == LOOK_BINARY ? "#define FLAT 1\n#define THRESHOLD 1\n"
                                         : "#define FLAT 1\n",
        .pixel_light = true,
        .smooth = true,
        .colors = kind != LOOK_BINARY,
        .patches = flat ? looks[kind].patches : FRAME_PATCHES_UNSEEN,
        .passes = {{.name = looks[kind].name, .depth = FRAME_DEPTH_NEARER}}};
}

struct look *look_read(struct cmd_args *args, enum look_kind kind, bool paints, struct look *look)
{
    solid_files_read(args, look_options.files, &look->files);
    if (look->files.flat && paints)
        cmd_usage("--solid %s: a 2D texture paints no pictures of a technique; want a 3D one, which solidgen makes",
                  look_options.files);
    if (kind == LOOK_BINARY &&
        (look_options.blend == HATCH_ZOOM_CONTRAST || look_options.blend == HATCH_ZOOM_HISTOGRAM))
        cmd_usage("--blend: --look binary draws thresholds; want linear or union");
    if (kind != LOOK_BINARY && look_options.blend == HATCH_ZOOM_UNION)
        cmd_usage("--blend union needs --look binary");
    const uint32_t bands = (uint32_t)look_options.bands;
    if (kind == LOOK_COLLAGE && look->files.count > bands)
        cmd_warn(NULL, "--solid: %u textures, of which --bands %u uses %u", look->files.count, bands, bands);
    read_inks(&look->block);
    look->paints = paints;
    look_choose(look, kind);
    return look;
}

/* Turns the textures against the meshes: by --solid-turn or, if they have no direction, so that surfaces along the axes
 * of a mesh do not show the same slice over and over. */
static void turn_textures(const struct solid_files *files, struct scene *scene)
{
    static const double aligned[3] = {0, 0, 0}, between_slices[3] = {23, 37, 11};
    const char *text = look_options.turn;
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

/* Returns whether the four samples of each quad share the reads of the texture: a texture that mips have smoothed is
 * the same at all of a pixel's samples. Thresholds are not. */
static bool shares_reads(const struct look *look, uint32_t side)
{
    return look->kind == LOOK_PLAIN && side % 2 == 0;
}

static struct solids_form wanted_form(const struct look *look, uint32_t side)
{
    static const enum hatch_zoom_blend usual[] = {[LOOK_PLAIN] = HATCH_ZOOM_HISTOGRAM,
                                                  [LOOK_BINARY] = HATCH_ZOOM_UNION,
                                                  [LOOK_WATERCOLOR] = HATCH_ZOOM_RANK,
                                                  [LOOK_COLLAGE] = HATCH_ZOOM_HISTOGRAM};
    bool ranks = look->kind == LOOK_BINARY || look->kind == LOOK_WATERCOLOR;
    enum hatch_zoom_blend blend = look_options.blend < 0 || look->kind == LOOK_WATERCOLOR
                                      ? usual[look->kind]
                                      : (enum hatch_zoom_blend)look_options.blend;
    double period_px = look_options.period_px > 0 ? look_options.period_px : 2.0 * look->files.solids[0].size;
    return (struct solids_form){.period_px = period_px,
                                .samples = look->kind == LOOK_COLLAGE ? 1 /* its papers are drawn for pixels */
                                           : shares_reads(look, side) ? side / 2
                                                                      : side,
                                .grey = ranks,
                                .pairs = shares_reads(look, side),
                                .blend = ranks && blend == HATCH_ZOOM_LINEAR ? HATCH_ZOOM_RANK : blend};
}

static bool is_same_form(const struct solids_form *form, const struct solids_form *other)
{
    return form->period_px == other->period_px && form->samples == other->samples && form->grey == other->grey &&
           form->pairs == other->pairs && form->blend == other->blend;
}

/* Uploads the textures unless they are there in the form that the look and the options want. */
static enum hatch_status upload(struct look *look, uint32_t side, struct cmd_args *args, struct hatch_err *err)
{
    const struct solids_form form = wanted_form(look, side);
    struct solids fresh;
    if (look->solids.count && is_same_form(&form, &look->form))
        return HATCH_OK;
    HATCH_TRY(solids_upload(&look->files, &form, cmd_pool(args), &args->scratch, &fresh, err));
    solids_free(&look->solids);
    look->solids = fresh;
    look->form = form;
    memcpy(look->block.colors, fresh.colors, sizeof fresh.colors);
    return HATCH_OK;
}

enum hatch_status look_prepare(struct look *look, struct frame *frame, const struct hatch_view *view, double height_px,
                               uint32_t side, struct cmd_args *args, struct hatch_err *err)
{
    const struct hatch_uv_repeat how = {
        .view = view, .height_px = height_px, .size_px = look->files.solids[0].size, .levels = 1};
    char defines[LOOK_DEFINES_BYTES];
    HATCH_TRY(upload(look, side, args, err));
    if (look->files.flat) {
        HATCH_TRY(scene_replace_repeats(frame->scene, &how, &args->keep, &args->scratch, err));
        HATCH_TRY(scene_set_uv_tangents(frame->scene, &args->scratch, err));
    } else {
        scene_set_rest(frame->scene);
    }
    turn_textures(&look->files, frame->scene);
    snprintf(defines, sizeof defines, "#define SOLIDS %u\n#define CHANNELS %u\n%s%s%s%s%s", look->solids.count,
             look->solids.channels, look->form.blend != HATCH_ZOOM_LINEAR ? "#define TABLES 1\n" : "",
             look->form.blend == HATCH_ZOOM_UNION ? "#define UNION 1\n" : "",
             look_options.inks ? "#define INKS 1\n" : "", look_options.colors ? "#define COLORS 1\n" : "",
             shares_reads(look, side) ? "#define QUADS 1\n" : "");
    if (strcmp(defines, look->defines) != 0) {
        memset(&look->shader, 0, sizeof look->shader);
        memset(&look->papers, 0, sizeof look->papers);
        memcpy(look->defines, defines, sizeof defines);
    }
    HATCH_TRY(look_passes_prepare(look, frame, err));
    return frame_shader_prepare(frame, &look->shading, look->defines, &look->shader, err);
}

/* Writes the values that depend on the view and on the options. */
static void set_block(struct look *look, const struct frame *frame)
{
    const uint32_t side = frame->request.canvas->side;
    const struct solids_form form = wanted_form(look, side);
    double unit_px = frame->request.tile->full_height / (2 * frame->view.half_height);
    const float marks[4] = {(float)look_options.grain, (float)(look_options.wobble_px * side), (float)look_options.dry,
                            (float)look_options.darkening};
    look->block.zoom[0] = (float)log2(form.period_px / unit_px);
    look->block.zoom[1] = (float)form.period_px;
    look->block.zoom[2] = (float)log2(form.period_px);
    look->block.zoom[3] = (float)look_options.wet;
    look->block.edges[0] = (float)look_options.bands;
    look->block.edges[2] = (float)look_options.paper_grain;
    memcpy(look->block.marks, marks, sizeof marks);
    gpu_block_update(&look->block_buffer, BLOCK_TECHNIQUE, &look->block, sizeof look->block);
}

enum hatch_status look_draw(struct look *look, struct frame *frame, struct cmd_args *args, struct hatch_err *err)
{
    HATCH_TRY(upload(look, frame->request.canvas->side, args, err));
    set_block(look, frame);
    solids_use(&look->solids);
    return look_passes_draw(look, frame, err);
}

enum hatch_status look_paint(struct look *look, struct frame *frame, struct cmd_args *args, struct hatch_err *err)
{
    if (frame->near.found.items)
        HATCH_TRY(frame_cut_near(frame, HATCH_NEAR_REST, err));
    return look_draw(look, frame, args, err);
}

void look_free(struct look *look)
{
    solids_free(&look->solids);
    glDeleteBuffers(1, &look->block_buffer);
    look->block_buffer = 0;
}
