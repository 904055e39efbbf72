#include "render-gl/renderer.h"

#include <assert.h>
#include <math.h>
#include <stddef.h>
#include <stdio.h>

#include "render-gl/draw.h"

#define PIECES "#define PIECES 1\n"

/* Compiles what draws the surface below a technique's patches. */
static enum hatch_status compile_below(const struct renderer *renderer, bool geometry, const char *defines,
                                       GLuint *program, struct hatch_err *err)
{
    const struct shader_stages stages = {
        .vertex = "surface.vert", .geometry = geometry ? "surface.geom" : NULL, .fragment = "paper.frag"};
    return shader_program(&renderer->shaders, &stages, defines, program, err);
}

static enum hatch_status compile(const struct renderer *renderer, const struct technique *technique, uint32_t variant,
                                 GLuint *program, struct hatch_err *err)
{
    char defines[512];
    const struct gpu_columns *columns = &renderer->columns[technique->columns]; /* all unset for COLUMNS_NONE */
    bool pixel_light = renderer->style.pixel_light || renderer->style.shadows;
    snprintf(defines, sizeof defines, "%s%s%s%s%s%s%s%s%s%s%s%s%s%s%s%s%s", technique->defines,
             technique->pixel_light && pixel_light ? "#define PIXEL_LIGHT 1\n" : "",
             renderer->style.shadows ? "#define SHADOWS 1\n" : "",
             frame_has_lone_sun(renderer->scene->scene, &renderer->style.light) ? "#define SUN 1\n" : "",
             renderer->style.curve.specular > 0 ? "#define HIGHLIGHTS 1\n" : "",
             columns->layered ? "#define LAYERED 1\n" : "", columns->exact ? "#define EXACT 1\n" : "",
             renderer->style.anisotropy > 1 && !columns->exact ? "#define ANISOTROPIC 1\n" : "",
             renderer->style.inks.two ? "#define TWO_INKS 1\n" : "",
             technique->seeds && renderer->seeds.vary ? "#define STROKES_VARY 1\n" : "",
             technique->seeds && renderer->seeds.shrink ? "#define STROKES_SHRINK 1\n" : "",
             variant & DRAW_PIECES ? PIECES : "", variant & (DRAW_PIECES - 1u) ? "#define BASE_TEXTURE 1\n" : "",
             variant & DRAW_NORMALS ? "#define NORMAL_MAP 1\n" : "", variant & DRAW_TONE ? "#define BASE_TONE 1\n" : "",
             variant & DRAW_HOLES ? "#define BASE_HOLES 1\n" : "", variant & DRAW_OUTLINE ? "#define OUTLINE 1\n" : "");
    return shader_program(&renderer->shaders, &technique->stages, defines, program, err);
}

static struct gpu_columns *columns_of(struct renderer *renderer, const struct technique *technique)
{
    return &renderer->columns[technique->columns];
}

bool renderer_can(const struct renderer *renderer, uint32_t technique)
{
    enum columns_form form = techniques[technique]->columns;
    if (form == COLUMNS_VOLUME || form == COLUMNS_THRESHOLDS)
        return renderer->fine && renderer->fine->form == form;
    return renderer->map || form == COLUMNS_NONE;
}

static enum hatch_status upload_columns(struct renderer *renderer, enum columns_form form, struct hatch_arena *scratch,
                                        struct hatch_err *err)
{
    struct gpu_columns *columns = &renderer->columns[form];
    float anisotropy = renderer->style.anisotropy;
    if (form == COLUMNS_VOLUME || form == COLUMNS_THRESHOLDS)
        return fine_upload(renderer->fine, anisotropy, columns, err);
    return columns_upload(renderer->map, form, anisotropy, renderer->size_max_px, scratch, columns, err);
}

enum hatch_status renderer_prepare(struct renderer *renderer, uint32_t technique, struct hatch_arena *scratch,
                                   struct hatch_err *err)
{
    const struct technique *chosen = techniques[technique];
    assert(technique < TECHNIQUE_COUNT && renderer_can(renderer, technique));
    assert(renderer->rptam || !chosen->seeds);
    if (!renderer->block_buffer) {
        glCreateBuffers(1, &renderer->block_buffer);
        glNamedBufferStorage(renderer->block_buffer, sizeof renderer->block, NULL, GL_DYNAMIC_STORAGE_BIT);
    }
    if (chosen->columns != COLUMNS_NONE && columns_of(renderer, chosen)->form == COLUMNS_NONE)
        HATCH_TRY(upload_columns(renderer, chosen->columns, scratch, err));
    if (chosen->seeds && !renderer->seeds.layers) {
        HATCH_TRY(seeds_upload(renderer->rptam, renderer->all_seeds, scratch, &renderer->seeds, err));
        HATCH_TRY(seeds_set_spans(renderer->scene, scratch, err));
    }
    if (technique == TECHNIQUE_PATCHES)
        HATCH_TRY(scene_tell_patches(renderer->scene, scratch, err));
    if (renderer->style.shadows && !renderer->shadow.programs[0])
        HATCH_TRY(shadow_compile(&renderer->shaders, &renderer->shadow, err));
    if (renderer->style.halo_px > 0 && !renderer->halo.programs[0])
        HATCH_TRY(halo_compile(&renderer->shaders, &renderer->halo, err));
    for (uint32_t i = 0; i < renderer->scene->item_count; i++) {
        uint32_t variant = draw_variant_of(renderer, technique, &renderer->scene->items[i]);
        GLuint *program = &renderer->programs[technique][variant];
        if (!*program)
            HATCH_TRY(compile(renderer, chosen, variant, program, err));
        bool geometry = chosen->stages.geometry != NULL;
        if (variant & DRAW_OUTLINE && !renderer->below_patches[geometry])
            HATCH_TRY(compile_below(renderer, geometry, "", &renderer->below_patches[geometry], err));
    }
    return HATCH_OK;
}

enum hatch_status renderer_take_strokes(struct renderer *renderer, struct hatch_arena *scratch, struct hatch_err *err)
{
    struct gpu_seeds fresh;
    if (!renderer->seeds.layers)
        return HATCH_OK;
    HATCH_TRY(seeds_upload(renderer->rptam, renderer->all_seeds, scratch, &fresh, err));
    bool same = fresh.vary == renderer->seeds.vary && fresh.shrink == renderer->seeds.shrink;
    seeds_free(&renderer->seeds);
    renderer->seeds = fresh;
    return same ? HATCH_OK : renderer_reload(renderer, err);
}

/* The programs that draw what is near: most pictures need none. */
static enum hatch_status prepare_pieces(struct renderer *renderer, uint32_t technique, struct hatch_err *err)
{
    for (uint32_t i = 0; i < renderer->scene->item_count; i++) {
        uint32_t variant = draw_variant_of(renderer, technique, &renderer->scene->items[i]) | DRAW_PIECES;
        GLuint *program = &renderer->programs[technique][variant];
        if (!near_find(&renderer->near, i))
            continue;
        if (!*program)
            HATCH_TRY(compile(renderer, techniques[technique], variant, program, err));
        if (variant & DRAW_OUTLINE && !renderer->pieces_below)
            HATCH_TRY(compile_below(renderer, false, PIECES, &renderer->pieces_below, err));
    }
    return HATCH_OK;
}

/* Moves the view's near plane. */
static enum hatch_status find_near(struct renderer *renderer, uint32_t technique, struct hatch_view *view,
                                   const struct hatch_tile *tile, struct hatch_err *err)
{
    const float *hatch = renderer->block.hatch;
    const struct near_wish wish = {.pieces = techniques[technique]->seeds && !renderer->floats_alone,
                                   .hatch = {(double)hatch[0], (double)hatch[1]},
                                   .tile = tile};
    HATCH_TRY(near_begin(&renderer->near, renderer->scene, &wish, view, renderer->shaders.scratch->limit_bytes, err));
    return prepare_pieces(renderer, technique, err);
}

static bool draws_lines(const struct renderer *renderer, uint32_t technique)
{
    return renderer->lines && (technique_draws_strokes(techniques[technique]) || renderer->lines->style.asked);
}

/* Half of a nearer line lies over its halo. */
static double halo_reach_px(const struct renderer *renderer, uint32_t technique)
{
    double line_px = draws_lines(renderer, technique) ? renderer->lines->style.width_px : 0;
    return renderer->style.halo_px + 0.5 * line_px;
}

/* Lines look around themselves before they end; edges and slopes of depth take three samples more than haloes. */
uint32_t renderer_reach_px(const struct renderer *renderer, uint32_t technique)
{
    double lines = renderer->lines ? HATCH_LINES_REACH_PX : 0;
    double haloes = renderer->style.halo_px > 0 ? ceil(halo_reach_px(renderer, technique)) + 4 : 0;
    return (uint32_t)fmax(lines, haloes);
}

static enum hatch_status draw_surfaces(struct renderer *renderer, uint32_t technique, const float background[3],
                                       struct hatch_view *view, const struct hatch_tile *tile,
                                       const struct target *target, struct hatch_err *err)
{
    const struct gpu_columns *columns = columns_of(renderer, techniques[technique]);
    const struct style *style = &renderer->style;
    if (renderer->clock)
        clock_begin_frame(renderer->clock);
    frame_set_style(&renderer->block, &style->inks, &style->curve, columns);
    frame_set_hatch(&renderer->block, style->hatch_turn_rad, style->hatch_scale);
    HATCH_TRY(find_near(renderer, technique, view, tile, err));
    frame_set_view(&renderer->block, view, tile, target->side);
    frame_set_lights(&renderer->block, &renderer->scene->pose, &renderer->scene->bounds, view, &style->light,
                     style->curve.exposure);
    glNamedBufferSubData(renderer->block_buffer, 0, sizeof renderer->block, &renderer->block);
    glBindBufferBase(GL_UNIFORM_BUFFER, 0, renderer->block_buffer);
    if (style->shadows) {
        HATCH_TRY(shadow_begin(&renderer->block, renderer->scene, style->shadow_edge, &renderer->shadow, err));
        if (!renderer->shadow.drawn)
            draw_shadows(renderer);
        renderer->shadow.drawn = true;
        shadow_use(&renderer->shadow);
        clock_end_pass(renderer->clock, "shadows");
    }
    target_begin(target, background);
    clock_end_pass(renderer->clock, "clear");
    if (techniques[technique]->seeds)
        seeds_bind(&renderer->seeds);
    glBindTextureUnit(0, columns->texture);
    glBindSampler(0, columns->sampler);
    if (style->anisotropy > 1)
        columns_set_bias(columns, (float)log2(target->side));
    glEnable(GL_CULL_FACE);
    draw_items(renderer, technique);
    if (technique == TECHNIQUE_FIELD && renderer->field)
        field_draw(renderer->field, target);
    if (style->halo_px > 0 && techniques[technique]->patches != PATCHES_COVER) {
        HATCH_TRY(halo_find(&renderer->halo, target, view, halo_reach_px(renderer, technique), err));
        halo_draw(&renderer->halo, target, background);
        clock_end_pass(renderer->clock, "haloes");
    }
    target_resolve(target);
    clock_end_pass(renderer->clock, "resolve");
    return HATCH_OK;
}

enum hatch_status renderer_draw_over(struct renderer *renderer, uint32_t technique, const float background[3],
                                     const struct hatch_view *view, const struct hatch_tile *tile,
                                     const struct target *target, struct hatch_err *err)
{
    struct hatch_view shown = *view;
    HATCH_TRY(draw_surfaces(renderer, technique, background, &shown, tile, target, err));
    if (renderer->clock)
        clock_end_frame(renderer->clock);
    return HATCH_OK;
}

enum hatch_status renderer_draw(struct renderer *renderer, uint32_t technique, const struct hatch_view *view,
                                const struct hatch_tile *tile, const struct target *target, struct hatch_err *err)
{
    struct hatch_view shown = *view;
    HATCH_TRY(draw_surfaces(renderer, technique, renderer->style.inks.paper, &shown, tile, target, err));
    enum hatch_status status = HATCH_OK;
    if (draws_lines(renderer, technique)) {
        status = lines_draw(renderer->lines, &shown, tile, target, err);
        clock_end_pass(renderer->clock, "lines");
    }
    if (renderer->clock)
        clock_end_frame(renderer->clock);
    return status;
}

enum hatch_status renderer_reload(struct renderer *renderer, struct hatch_err *err)
{
    for (uint32_t technique = 0; technique < TECHNIQUE_COUNT; technique++)
        for (uint32_t variant = 0; variant < VARIANTS; variant++) {
            GLuint *program = &renderer->programs[technique][variant], fresh;
            if (!*program)
                continue;
            HATCH_TRY(compile(renderer, techniques[technique], variant, &fresh, err));
            glDeleteProgram(*program);
            *program = fresh;
        }
    for (int geometry = 0; geometry < 2; geometry++) {
        GLuint *program = &renderer->below_patches[geometry], fresh;
        if (!*program)
            continue;
        HATCH_TRY(compile_below(renderer, geometry, "", &fresh, err));
        glDeleteProgram(*program);
        *program = fresh;
    }
    if (renderer->pieces_below) {
        GLuint fresh;
        HATCH_TRY(compile_below(renderer, false, PIECES, &fresh, err));
        glDeleteProgram(renderer->pieces_below);
        renderer->pieces_below = fresh;
    }
    if (renderer->shadow.programs[0])
        HATCH_TRY(shadow_compile(&renderer->shaders, &renderer->shadow, err));
    if (renderer->halo.programs[0])
        HATCH_TRY(halo_compile(&renderer->shaders, &renderer->halo, err));
    if (renderer->lines)
        HATCH_TRY(line_gl_compile(&renderer->shaders, &renderer->lines->gl, err));
    return HATCH_OK;
}

void renderer_free(struct renderer *renderer)
{
    for (uint32_t technique = 0; technique < TECHNIQUE_COUNT; technique++)
        for (uint32_t variant = 0; variant < VARIANTS; variant++)
            glDeleteProgram(renderer->programs[technique][variant]);
    for (int geometry = 0; geometry < 2; geometry++)
        glDeleteProgram(renderer->below_patches[geometry]);
    glDeleteProgram(renderer->pieces_below);
    near_free(&renderer->near);
    shadow_free(&renderer->shadow);
    halo_free(&renderer->halo);
    for (uint32_t form = 0; form < COLUMNS_FORMS; form++)
        columns_free(&renderer->columns[form]);
    seeds_free(&renderer->seeds);
    glDeleteBuffers(1, &renderer->block_buffer);
    renderer->block_buffer = 0;
}
