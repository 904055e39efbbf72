#include "render-gl/renderer.h"

#include <assert.h>
#include <math.h>
#include <stddef.h>
#include <stdio.h>

#include "render-gl/draw.h"

/* Compiles what draws the surface below a technique's patches. */
static enum hatch_status compile_below(const struct renderer *renderer, bool geometry, GLuint *program,
                                       struct hatch_err *err)
{
    const struct shader_stages stages = {.vertex = "surface.vert",
                                         .geometry = geometry ? "surface.geom" : NULL,
                                         .fragment = "paper.frag"};
    return shader_program(&renderer->shaders, &stages, "", program, err);
}

static enum hatch_status compile(const struct renderer *renderer, const struct technique *technique,
                                 uint32_t variant, GLuint *program, struct hatch_err *err)
{
    char defines[256];
    snprintf(defines, sizeof defines, "%s%s%s%s%s%s%s", technique->defines,
             renderer->style.anisotropy > 1 ? "#define ANISOTROPIC 1\n" : "",
             renderer->style.inks.two ? "#define TWO_INKS 1\n" : "",
             variant ? "#define BASE_TEXTURE 1\n" : "",
             variant & DRAW_TONE ? "#define BASE_TONE 1\n" : "",
             variant & DRAW_HOLES ? "#define BASE_HOLES 1\n" : "",
             variant & DRAW_OUTLINE ? "#define OUTLINE 1\n" : "");
    return shader_program(&renderer->shaders, &technique->stages, defines, program, err);
}

static struct gpu_columns *columns_of(struct renderer *renderer, const struct technique *technique)
{
    return &renderer->columns[technique->columns];
}

enum hatch_status renderer_prepare(struct renderer *renderer, uint32_t technique,
                                   struct hatch_arena *scratch, struct hatch_err *err)
{
    const struct technique *chosen = techniques[technique];
    struct gpu_columns *columns = columns_of(renderer, chosen);
    assert(technique < TECHNIQUE_COUNT && (renderer->map || chosen->columns == COLUMNS_NONE));
    assert(renderer->rptam || !chosen->seeds);
    if (!renderer->block_buffer) {
        glCreateBuffers(1, &renderer->block_buffer);
        glNamedBufferStorage(renderer->block_buffer, sizeof renderer->block, NULL,
                             GL_DYNAMIC_STORAGE_BIT);
    }
    if (chosen->columns != COLUMNS_NONE && columns->form == COLUMNS_NONE)
        HATCH_TRY(columns_upload(renderer->map, chosen->columns, renderer->style.anisotropy,
                                 renderer->size_max_px, scratch, columns, err));
    if (chosen->seeds && !renderer->seeds.layers) {
        HATCH_TRY(seeds_upload(renderer->rptam, renderer->all_seeds, scratch, &renderer->seeds, err));
        HATCH_TRY(seeds_set_spans(renderer->scene, scratch, err));
    }
    if (technique == TECHNIQUE_PATCHES)
        HATCH_TRY(scene_tell_patches(renderer->scene, scratch, err));
    for (uint32_t i = 0; i < renderer->scene->item_count; i++) {
        uint32_t variant = draw_variant_of(renderer, technique, &renderer->scene->items[i]);
        GLuint *program = &renderer->programs[technique][variant];
        if (!*program)
            HATCH_TRY(compile(renderer, chosen, variant, program, err));
        bool geometry = chosen->stages.geometry != NULL;
        if (variant == DRAW_OUTLINE && !renderer->below_patches[geometry])
            HATCH_TRY(compile_below(renderer, geometry, &renderer->below_patches[geometry], err));
    }
    return HATCH_OK;
}

static void draw_surfaces(struct renderer *renderer, uint32_t technique, const float background[3],
                          const struct view *view, const struct tile *tile,
                          const struct target *target)
{
    const struct gpu_columns *columns = columns_of(renderer, techniques[technique]);
    const struct style *style = &renderer->style;
    frame_set_style(&renderer->block, &style->inks, &style->curve, columns);
    frame_set_hatch(&renderer->block, style->hatch_turn_rad, style->hatch_scale);
    frame_set_view(&renderer->block, view, tile, target->side);
    frame_set_lights(&renderer->block, &renderer->scene->pose, &renderer->scene->bounds, view,
                     &style->light, style->curve.exposure);
    if (renderer->clock)
        clock_begin_frame(renderer->clock);
    glNamedBufferSubData(renderer->block_buffer, 0, sizeof renderer->block, &renderer->block);
    glBindBufferBase(GL_UNIFORM_BUFFER, 0, renderer->block_buffer);
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
    target_resolve(target);
    clock_end_pass(renderer->clock, "resolve");
}

void renderer_draw_over(struct renderer *renderer, uint32_t technique, const float background[3],
                        const struct view *view, const struct tile *tile,
                        const struct target *target)
{
    draw_surfaces(renderer, technique, background, view, tile, target);
    if (renderer->clock)
        clock_end_frame(renderer->clock);
}

enum hatch_status renderer_draw(struct renderer *renderer, uint32_t technique,
                                const struct view *view, const struct tile *tile,
                                const struct target *target, struct hatch_err *err)
{
    bool strokes = technique_draws_strokes(techniques[technique]);
    enum hatch_status status = HATCH_OK;
    draw_surfaces(renderer, technique, renderer->style.inks.paper, view, tile, target);
    if (renderer->lines && (strokes || renderer->lines->style.asked)) {
        status = lines_draw(renderer->lines, view, tile, target, err);
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
        HATCH_TRY(compile_below(renderer, geometry, &fresh, err));
        glDeleteProgram(*program);
        *program = fresh;
    }
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
    for (uint32_t form = 0; form < 3; form++)
        columns_free(&renderer->columns[form]);
    seeds_free(&renderer->seeds);
    glDeleteBuffers(1, &renderer->block_buffer);
    renderer->block_buffer = 0;
}
