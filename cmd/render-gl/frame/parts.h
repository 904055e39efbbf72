/* The parts of an item that one call draws. */
#ifndef RENDER_FRAME_PARTS_H
#define RENDER_FRAME_PARTS_H

#include "near/near.h"
#include "render-gl/gpu/program.h"
#include "render-gl/scene/scene.h"

struct frame_part {
    GLuint vertex_array;
    uint32_t first, count;            /* range of indices */
    const struct hatch_near_cut *cut; /* if not NULL: its ranges of indices instead; or, with */
    bool pieces;                      /* this, its pieces */
};

/* Uses a program for an item: its transform, textures and uniforms.
 *   index      of the item
 *   lightness  factor of the material's colour, 0 .. 1 */
void frame_use_item(const struct scene *scene, uint32_t index, float lightness, const struct gpu_program *program);

/* An item's surface, each face once.
 *   near  the item's near faces, which the part leaves out, or NULL */
struct frame_part frame_part_of_surface(const struct scene *scene, uint32_t index, const struct hatch_near_item *near);

/* Draws with the program in use. */
void frame_part_draw(struct frame_part part);

/* Draws the depths of all items, in the pass that has begun.
 *   programs  for whole items, for items with holes */
void frame_draw_depths(const struct scene *scene, const struct gpu_program *const programs[2]);

#endif
