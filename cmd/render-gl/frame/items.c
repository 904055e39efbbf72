#include "render-gl/frame/items.h"

#include <stdio.h>

#include "render-gl/frame/parts.h"
#include "render-gl/gpu/bindings.h"

/* An item to draw, and the programs for it. */
struct drawing {
    const struct frame *frame;
    const struct frame_shading *shading;
    const struct frame_shader *shader;
    uint32_t index;
    const struct hatch_item *unit;
    const struct scene_item *item;
    const struct hatch_near_item *near; /* NULL: none of its faces is near */
    uint32_t variant;                   /* bits of enum frame_variant */
};

static bool draws_colors(const struct frame *frame, const struct frame_shading *shading)
{
    return frame->style.base_color && shading->colors;
}

static uint32_t variant_of(const struct frame *frame, const struct frame_shading *shading, uint32_t index)
{
    const struct hatch_item *unit = &frame->scene->unit.items[index];
    const struct scene_item *item = &frame->scene->items[index];
    uint32_t variant = 0;
    if (frame->scene->unit.meshes[unit->mesh].patches)
        variant = shading->patches == FRAME_PATCHES_UNSEEN ? 0 : FRAME_OUTLINE;
    else if (item->base_texture)
        variant = (frame->style.base_tone || draws_colors(frame, shading) ? FRAME_TONE : 0u) |
                  (unit->alpha_cutoff > 0 ? FRAME_HOLES : 0u);
    if (item->normals && shading->pixel_light && !shading->smooth)
        variant |= FRAME_NORMALS;
    return variant;
}

static uint32_t count_passes(const struct frame_shading *shading)
{
    uint32_t count = 0;
    while (count < FRAME_PASSES_MAX && shading->passes[count].name)
        count++;
    return count;
}

static struct drawing drawing_of(const struct frame *frame, const struct frame_shading *shading,
                                 const struct frame_shader *shader, uint32_t index)
{
    const struct hatch_item *unit = &frame->scene->unit.items[index];
    return (struct drawing){.frame = frame,
                            .shading = shading,
                            .shader = shader,
                            .index = index,
                            .unit = unit,
                            .item = &frame->scene->items[index],
                            .near = hatch_near_item_at(&frame->near.found, index),
                            .variant = variant_of(frame, shading, index)};
}

void frame_light_defines(const struct frame *frame, bool pixel_light, char text[FRAME_LIGHT_DEFINES_BYTES])
{
    const struct frame_style *style = &frame->style;
    snprintf(text, FRAME_LIGHT_DEFINES_BYTES, "%s%s%s%s%s",
             pixel_light && (style->pixel_light || style->shadows) ? "#define PIXEL_LIGHT 1\n" : "",
             style->shadows ? "#define SHADOWS 1\n" : "",
             hatch_lights_are_key_alone(frame->scene->unit.scene, &style->light) ? "#define SUN 1\n" : "",
             style->curve.specular > 0 ? "#define HIGHLIGHTS 1\n" : "", style->inks.two ? "#define TWO_INKS 1\n" : "");
}

static enum hatch_status compile(struct frame *frame, const struct frame_shading *shading, const char *defines,
                                 uint32_t variant, const struct gpu_program **program, struct hatch_err *err)
{
    char light[FRAME_LIGHT_DEFINES_BYTES], all[512];
    if (*program)
        return HATCH_OK;
    frame_light_defines(frame, shading->pixel_light, light);
    snprintf(all, sizeof all, "%s%s%s%s%s%s%s%s%s", shading->defines ? shading->defines : "", defines, light,
             variant & FRAME_PIECES ? "#define PIECES 1\n" : "",
             variant & (FRAME_TONE | FRAME_HOLES | FRAME_OUTLINE) ? "#define BASE_TEXTURE 1\n" : "",
             variant & FRAME_NORMALS ? "#define NORMAL_MAP 1\n" : "",
             !(variant & FRAME_TONE)        ? ""
             : draws_colors(frame, shading) ? "#define BASE_COLOR 1\n"
                                            : "#define BASE_TONE 1\n",
             variant & FRAME_HOLES ? "#define BASE_HOLES 1\n" : "",
             variant & FRAME_OUTLINE ? "#define OUTLINE 1\n" : "");
    return gpu_program_get(&frame->programs, &shading->stages, all, program, err);
}

/* Compiles the program for the surface below patches, or the one for its pieces. */
static enum hatch_status compile_below(struct frame *frame, const struct frame_shading *shading, bool pieces,
                                       const struct gpu_program **program, struct hatch_err *err)
{
    const struct gpu_stages stages = {.vertex = "frame/surface.vert",
                                      .geometry = shading->stages.geometry && !pieces ? "frame/surface.geom" : NULL,
                                      .fragment = "frame/paper.frag"};
    if (*program)
        return HATCH_OK;
    return gpu_program_get(&frame->programs, &stages, pieces ? "#define PIECES 1\n" : "", program, err);
}

/* Returns the variant that draws the pieces of an item. */
static uint32_t pieces_variant(uint32_t variant)
{
    return (variant & ~(uint32_t)FRAME_NORMALS) | FRAME_PIECES;
}

/* Compiles the programs that the items need.
 *   pieces  true: those for the pieces of near faces; false: the others */
static enum hatch_status compile_all(struct frame *frame, const struct frame_shading *shading, const char *defines,
                                     bool pieces, struct frame_shader *shader, struct hatch_err *err)
{
    for (uint32_t i = 0; i < frame->scene->unit.item_count; i++) {
        uint32_t whole = variant_of(frame, shading, i), variant = pieces ? pieces_variant(whole) : whole;
        if (pieces && !hatch_near_item_at(&frame->near.found, i))
            continue;
        HATCH_TRY(compile(frame, shading, defines, variant, &shader->programs[variant], err));
        if (variant & FRAME_OUTLINE)
            HATCH_TRY(compile_below(frame, shading, pieces, &shader->below[pieces], err));
    }
    return HATCH_OK;
}

enum hatch_status frame_shader_prepare(struct frame *frame, const struct frame_shading *shading, const char *defines,
                                       struct frame_shader *shader, struct hatch_err *err)
{
    return compile_all(frame, shading, defines, false, shader, err);
}

static void use(const struct drawing *drawing, const struct gpu_program *program)
{
    static const float white[3] = {1, 1, 1};
    frame_use_item(drawing->frame->scene, drawing->index,
                   drawing->frame->style.base_tone ? drawing->item->base_lightness : 1.0f, program);
    if (drawing->shading->colors)
        glUniform3fv(UNIFORM_TINT, 1,
                     draws_colors(drawing->frame, drawing->shading) ? drawing->item->base_color : white);
}

/* Draws a part. Double-sided faces are drawn once for each side, because light is computed at vertices, which do not
 * know the side that is seen. */
static void draw_sides(const struct drawing *drawing, struct frame_part part, uint32_t pass)
{
    glUniform1i(UNIFORM_PASS, (GLint)pass);
    for (int behind = 0; behind <= (drawing->unit->double_sided ? 1 : 0); behind++) {
        glCullFace(behind ? GL_FRONT : GL_BACK);
        glUniform1f(UNIFORM_SIDE, behind ? -1.0f : 1.0f);
        frame_part_draw(part);
    }
}

/* Makes a program current for an item's pieces, and returns them as a part. */
static struct frame_part use_pieces(const struct drawing *drawing, const struct hatch_near_cut *cut,
                                    const struct gpu_program *program)
{
    use(drawing, program);
    near_use(&drawing->frame->near, drawing->frame->scene, drawing->index);
    return (struct frame_part){.vertex_array = drawing->frame->near.array, .cut = cut, .pieces = true};
}

/* Draws the surface below patches as bare paper, and writes its depth: patches are drawn where their depth is equal. */
static void draw_below_patches(const struct drawing *drawing)
{
    const struct hatch_near_item *near = drawing->near;
    use(drawing, drawing->shader->below[0]);
    glCullFace(GL_BACK);
    if (drawing->unit->double_sided)
        glDisable(GL_CULL_FACE);
    frame_part_draw(frame_part_of_surface(drawing->frame->scene, drawing->index, near));
    if (near)
        frame_part_draw(use_pieces(drawing, &near->surface, drawing->shader->below[1]));
    glEnable(GL_CULL_FACE);
}

/* Draws all patches in one call. OpenGL keeps the order of faces, so each patch is blended over the earlier ones. */
static void draw_patches_at_once(const struct drawing *drawing)
{
    const struct hatch_near_item *near = drawing->near;
    bool blends = drawing->shading->patches == FRAME_PATCHES_BLEND;
    frame_pass_blend(blends ? FRAME_BLEND_OVER : FRAME_BLEND_REPLACE);
    draw_sides(drawing,
               (struct frame_part){.vertex_array = drawing->item->vertex_array,
                                   .count = drawing->frame->scene->meshes[drawing->unit->mesh].index_count,
                                   .cut = near ? &near->patches : NULL},
               0);
}

/* Draws patches with a shading of several passes (Real-Time Hatching §6), one layer of patches at a time; patches of
 * one layer do not overlap. Pass 0 writes the outlines into the target's alpha. Pass 1 mixes its colour with the
 * target's by that alpha, and later passes add theirs times that alpha. */
static void draw_patches_in_passes(const struct drawing *drawing)
{
    const struct hatch_patch_mesh *patches = drawing->frame->scene->unit.meshes[drawing->unit->mesh].patches;
    uint32_t begin = 0;
    for (uint32_t layer = 0; layer < patches->layer_count; layer++) {
        uint32_t end = patches->layer_end[layer];
        const struct frame_part part = {
            .vertex_array = drawing->item->vertex_array, .first = begin, .count = end - begin};
        for (uint32_t pass = 0; pass < count_passes(drawing->shading); pass++) {
            frame_pass_blend(pass == 0   ? FRAME_BLEND_SET_ALPHA
                             : pass == 1 ? FRAME_BLEND_UNDER_ALPHA
                                         : FRAME_BLEND_ADD_UNDER_ALPHA);
            draw_sides(drawing, part, pass);
        }
        begin = end;
    }
}

static void draw_patches(const struct drawing *drawing)
{
    use(drawing, drawing->shader->programs[drawing->variant]);
    if (count_passes(drawing->shading) == 1)
        draw_patches_at_once(drawing);
    else
        draw_patches_in_passes(drawing);
    if (drawing->near)
        draw_sides(
            drawing,
            use_pieces(drawing, &drawing->near->patches, drawing->shader->programs[pieces_variant(drawing->variant)]),
            0);
}

static void draw_ordinary(const struct drawing *drawing, uint32_t pass)
{
    use(drawing, drawing->shader->programs[drawing->variant]);
    draw_sides(drawing, frame_part_of_surface(drawing->frame->scene, drawing->index, drawing->near), pass);
    if (drawing->near)
        draw_sides(
            drawing,
            use_pieces(drawing, &drawing->near->surface, drawing->shader->programs[pieces_variant(drawing->variant)]),
            pass);
}

/* Draws one kind of items.
 *   like     all members except those of an item
 *   patches  true: the items that are shown as patches; false: the others
 *   pass     index of the pass, for the others
 *   below    true: the surfaces below patches instead of the patches */
static void draw_all(const struct drawing *like, bool patches, uint32_t pass, bool below)
{
    for (uint32_t i = 0; i < like->frame->scene->unit.item_count; i++) {
        const struct drawing drawing = drawing_of(like->frame, like->shading, like->shader, i);
        bool shows_patches = drawing.variant & FRAME_OUTLINE;
        if (shows_patches != patches)
            continue;
        if (below)
            draw_below_patches(&drawing);
        else if (patches)
            draw_patches(&drawing);
        else
            draw_ordinary(&drawing, pass);
    }
}

static uint32_t count_lapped(const struct frame *frame, const struct frame_shading *shading)
{
    uint32_t count = 0;
    for (uint32_t i = 0; i < frame->scene->unit.item_count; i++)
        count += (variant_of(frame, shading, i) & FRAME_OUTLINE) != 0;
    return count;
}

enum hatch_status frame_draw_items(struct frame *frame, const struct gpu_target *target,
                                   const struct frame_shading *shading, const char *defines,
                                   struct frame_shader *shader, struct hatch_err *err)
{
    const struct drawing all = {.frame = frame, .shading = shading, .shader = shader};
    uint32_t lapped = count_lapped(frame, shading);
    bool ordinary = lapped < frame->scene->unit.item_count;
    HATCH_TRY(compile_all(frame, shading, defines, true, shader, err));
    for (uint32_t i = 0; i < count_passes(shading) && ordinary; i++) {
        const struct frame_item_pass *from = &shading->passes[i];
        const struct frame_pass pass = {.name = from->name,
                                        .target = target,
                                        .blend = from->blend,
                                        .depth = from->depth,
                                        .culls = true,
                                        .masks_color = from->masks_color};
        frame_pass_begin(&pass);
        draw_all(&all, false, i, false);
        frame_pass_end(&pass, frame->timer);
    }
    if (!lapped)
        return HATCH_OK;
    /* Without ordinary items the canvas still shows paper everywhere, so only depth is written. */
    const struct frame_pass below = {
        .name = "surface", .target = target, .depth = FRAME_DEPTH_NEARER, .culls = true, .masks_color = !ordinary};
    const struct frame_pass patches = {.name = "patches", .target = target, .depth = FRAME_DEPTH_EQUAL, .culls = true};
    frame_pass_begin(&below);
    draw_all(&all, true, 0, true);
    frame_pass_end(&below, frame->timer);
    frame_pass_begin(&patches);
    draw_all(&all, true, 0, false);
    frame_pass_end(&patches, frame->timer);
    return HATCH_OK;
}
