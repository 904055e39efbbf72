#include "render-gl/draw.h"

/* What is drawn of an item at once. */
struct part {
    GLuint vertex_array;
    uint32_t first, count;      /* indices */
    const struct near_cut *cut; /* not NULL: its ranges of indices instead; or, with */
    bool pieces;                /* this, its pieces */
};

uint32_t draw_variant_of(const struct renderer *renderer, uint32_t technique, const struct gpu_item *item)
{
    const struct gpu_mesh *mesh = &renderer->scene->meshes[item->mesh];
    uint32_t variant = 0;
    if (mesh->patches)
        variant = techniques[technique]->patches == PATCHES_UNSEEN ? 0 : DRAW_OUTLINE;
    else if (item->base_texture)
        variant = (renderer->style.base_tone ? DRAW_TONE : 0u) | (item->alpha_cutoff > 0 ? DRAW_HOLES : 0u);
    if (item->normals && techniques[technique]->pixel_light && !techniques[technique]->seeds)
        variant |= DRAW_NORMALS;
    return variant;
}

static void use_item(const struct renderer *renderer, const struct gpu_item *item, GLuint program)
{
    glUseProgram(program);
    if (item->base_texture)
        glBindTextureUnit(3, item->base_texture);
    if (item->normals)
        glBindTextureUnit(9, item->normals);
    glUniform1f(6, item->normals_strength);
    glUniformMatrix4fv(0, 1, GL_FALSE, item->to_unit);
    glUniformMatrix3fv(1, 1, GL_FALSE, item->normal);
    glVertexAttrib2fv(REPEAT_ATTRIBUTE, item->repeat); /* where vertices have none */
    glUniform4f(5, renderer->style.base_tone ? item->base_lightness : 1.0f, item->base_lod, item->alpha_cutoff, 0.0f);
    glFrontFace(item->mirrored ? GL_CW : GL_CCW);
}

static void draw_part(struct part part)
{
    glBindVertexArray(part.vertex_array);
    if (part.pieces)
        glDrawArrays(GL_TRIANGLES, part.cut->first, part.cut->count);
    else if (part.cut)
        glMultiDrawElements(GL_TRIANGLES, part.cut->counts, GL_UNSIGNED_INT, part.cut->offsets,
                            (GLsizei)part.cut->range_count);
    else
        glDrawElements(GL_TRIANGLES, (GLsizei)part.count, GL_UNSIGNED_INT,
                       (const void *)(sizeof(uint32_t) * part.first));
}

/* Faces that may be seen from behind are drawn once for each side, because the light is per vertex
 * and a vertex has no side. */
static void draw_sides(const struct gpu_item *item, struct part part, uint32_t pass)
{
    glUniform1i(4, (GLint)pass);
    for (int behind = 0; behind <= (item->double_sided ? 1 : 0); behind++) {
        glCullFace(behind ? GL_FRONT : GL_BACK);
        glUniform1f(3, behind ? -1.0f : 1.0f);
        draw_part(part);
    }
}

static GLuint program_of(const struct renderer *renderer, uint32_t technique, const struct gpu_item *item,
                         uint32_t more)
{
    return renderer->programs[technique][draw_variant_of(renderer, technique, item) | more];
}

/* Makes ready to draw an item's pieces with a program. */
static struct part use_pieces(const struct renderer *renderer, const struct gpu_item *item, const struct near_cut *cut,
                              GLuint program)
{
    use_item(renderer, item, program);
    near_use(&renderer->near, renderer->scene, item);
    return (struct part){.vertex_array = renderer->near.array, .cut = cut, .pieces = true};
}

static bool shows_patches(const struct renderer *renderer, uint32_t technique, const struct gpu_item *item)
{
    return draw_variant_of(renderer, technique, item) & DRAW_OUTLINE;
}

static struct part surface_of(const struct gpu_mesh *mesh, const struct gpu_item *item, const struct near_item *near)
{
    return (struct part){.vertex_array = mesh->patches ? item->surface_array : item->vertex_array,
                         .count = 3 * mesh->surface->face_count,
                         .cut = near ? &near->surface : NULL};
}

static void draw_depths(const struct renderer *renderer, const GLuint programs[2])
{
    for (uint32_t i = 0; i < renderer->scene->item_count; i++) {
        const struct gpu_item *item = &renderer->scene->items[i];
        const struct gpu_mesh *mesh = &renderer->scene->meshes[item->mesh];
        bool holes = !mesh->patches && item->base_texture && item->alpha_cutoff > 0;
        use_item(renderer, item, programs[holes]);
        draw_part(surface_of(mesh, item, NULL));
    }
}

void draw_shadows(const struct renderer *renderer)
{
    const struct shadow *shadow = &renderer->shadow;
    for (uint32_t layer = 0; layer < shadow->layers; layer++) {
        shadow_begin_layer(shadow, layer);
        draw_depths(renderer, shadow->programs);
    }
}

static void set_usual(void)
{
    glDisable(GL_BLEND);
    glDepthFunc(GL_GREATER);
    glDepthMask(GL_TRUE);
}

/* Paper where patches will be, at the depth that their faces have: they are drawn on equal depth.
 * alone: nothing else has been drawn, so that paper is there already. */
static void draw_below_patches(const struct renderer *renderer, uint32_t technique, bool alone)
{
    const struct gpu_scene *scene = renderer->scene;
    const GLboolean colors = alone ? GL_FALSE : GL_TRUE;
    set_usual();
    glColorMask(colors, colors, colors, colors);
    for (uint32_t i = 0; i < scene->item_count; i++) {
        const struct gpu_item *item = &scene->items[i];
        if (!shows_patches(renderer, technique, item))
            continue;
        const struct near_item *near = near_find(&renderer->near, i);
        use_item(renderer, item, renderer->below_patches[techniques[technique]->stages.geometry != NULL]);
        glCullFace(GL_BACK);
        if (item->double_sided)
            glDisable(GL_CULL_FACE);
        draw_part(surface_of(&scene->meshes[item->mesh], item, near));
        if (near)
            draw_part(use_pieces(renderer, item, &near->surface, renderer->pieces_below));
        glEnable(GL_CULL_FACE);
    }
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    glDepthFunc(GL_EQUAL);
    glDepthMask(GL_FALSE);
}

/* The outline read by a texture unit in the technique's own pass: all patches at once, each blended over
 * those before it, since OpenGL keeps the order of faces. */
static void draw_patches_at_once(const struct gpu_mesh *mesh, const struct gpu_item *item, enum technique_patches way,
                                 const struct near_cut *cut)
{
    if (way == PATCHES_BLEND)
        glEnable(GL_BLEND);
    glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    draw_sides(item, (struct part){.vertex_array = item->vertex_array, .count = mesh->index_count, .cut = cut}, 0);
}

/* Real-time hatching §6: the outline goes into the destination's alpha; then each pass adds its share under
 * that alpha, the first one in place of what lies below. A layer of patches at a time. */
static void draw_patches_in_passes(const struct gpu_mesh *mesh, const struct gpu_item *item, uint32_t pass_count)
{
    uint32_t begin = 0;
    glEnable(GL_BLEND);
    for (uint32_t layer = 0; layer < mesh->patches->layer_count; layer++) {
        uint32_t end = mesh->patches->layer_end[layer];
        for (uint32_t pass = 0; pass < pass_count; pass++) {
            if (pass == 0)
                glBlendFuncSeparate(GL_ZERO, GL_ONE, GL_ONE, GL_ZERO);
            else
                glBlendFuncSeparate(GL_DST_ALPHA, pass == 1 ? GL_ONE_MINUS_DST_ALPHA : GL_ONE, GL_ZERO, GL_ONE);
            draw_sides(item, (struct part){.vertex_array = item->vertex_array, .first = begin, .count = end - begin},
                       pass);
        }
        begin = end;
    }
}

static void draw_patches(const struct renderer *renderer, uint32_t technique)
{
    const struct technique *chosen = techniques[technique];
    for (uint32_t i = 0; i < renderer->scene->item_count; i++) {
        const struct gpu_item *item = &renderer->scene->items[i];
        const struct gpu_mesh *mesh = &renderer->scene->meshes[item->mesh];
        if (!shows_patches(renderer, technique, item))
            continue;
        const struct near_item *near = near_find(&renderer->near, i);
        use_item(renderer, item, program_of(renderer, technique, item, 0));
        if (chosen->pass_count == 1)
            draw_patches_at_once(mesh, item, chosen->patches, near ? &near->patches : NULL);
        else
            draw_patches_in_passes(mesh, item, chosen->pass_count);
        if (near)
            draw_sides(item,
                       use_pieces(renderer, item, &near->patches, program_of(renderer, technique, item, DRAW_PIECES)),
                       0);
    }
}

static uint32_t draw_ordinary(const struct renderer *renderer, uint32_t technique, uint32_t pass)
{
    const struct gpu_scene *scene = renderer->scene;
    uint32_t drawn = 0;
    for (uint32_t i = 0; i < scene->item_count; i++) {
        const struct gpu_item *item = &scene->items[i];
        if (shows_patches(renderer, technique, item))
            continue;
        const struct near_item *near = near_find(&renderer->near, i);
        use_item(renderer, item, program_of(renderer, technique, item, 0));
        draw_sides(item, surface_of(&scene->meshes[item->mesh], item, near), pass);
        if (near)
            draw_sides(item,
                       use_pieces(renderer, item, &near->surface, program_of(renderer, technique, item, DRAW_PIECES)),
                       pass);
        drawn++;
    }
    return drawn;
}

void draw_items(const struct renderer *renderer, uint32_t technique)
{
    const struct technique *chosen = techniques[technique];
    uint32_t ordinary = 0;
    for (uint32_t pass = 0; pass < chosen->pass_count; pass++) {
        set_usual();
        if (chosen->begin_pass)
            chosen->begin_pass(pass);
        ordinary = draw_ordinary(renderer, technique, pass);
        if (ordinary)
            clock_end_pass(renderer->clock, chosen->pass_names[pass]);
    }
    if (ordinary < renderer->scene->item_count) {
        draw_below_patches(renderer, technique, ordinary == 0);
        clock_end_pass(renderer->clock, "surface");
        draw_patches(renderer, technique);
        clock_end_pass(renderer->clock, "patches");
    }
    set_usual();
    glDisable(GL_CULL_FACE);
}
