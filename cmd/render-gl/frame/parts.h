/* Draw calls for an item: its faces, or some of them, or pieces of near faces. */
#ifndef RENDER_FRAME_PARTS_H
#define RENDER_FRAME_PARTS_H

#include "near/near.h"
#include "render-gl/gpu/program.h"
#include "render-gl/scene/scene.h"

/* Faces that one call draws. */
struct frame_part {
    GLuint vertex_array;
    uint32_t first, count;            /* range of indices, if cut is NULL */
    const struct hatch_near_cut *cut; /* kept by reference; NULL: no face of the item is near */
    bool pieces;                      /* draws the pieces of cut; false: its ranges of indices */
};

/* Makes a program current, and binds an item's textures and sets its uniforms.
 *   index      in scene->items
 *   lightness  factor for the light, 0 .. 1: luminance of the material's colour */
void frame_use_item(const struct scene *scene, uint32_t index, float lightness, const struct gpu_program *program);

/* Returns the faces of an item's surface, without patches.
 *   index  in scene->items
 *   near   the item's near faces, which the part leaves out; NULL: none */
struct frame_part frame_part_of_surface(const struct scene *scene, uint32_t index, const struct hatch_near_item *near);

/* Draws a part with the program in use. */
void frame_part_draw(struct frame_part part);

#endif
