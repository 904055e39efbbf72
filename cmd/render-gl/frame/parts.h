/* Draw calls for an item: for all its faces, for those that are not near the eye, or for the pieces of near faces. */
#ifndef RENDER_FRAME_PARTS_H
#define RENDER_FRAME_PARTS_H

#include "near/near.h"
#include "render-gl/gpu/program.h"
#include "render-gl/scene/scene.h"

/* Faces of an item that are drawn together. */
struct frame_part {
    GLuint vertex_array;
    uint32_t first, count;            /* range of indices to draw if cut is NULL */
    const struct hatch_near_cut *cut; /* kept by reference; NULL: no face of the item is near */
    bool pieces;                      /* true: the pieces of cut are drawn; false: its ranges of indices */
};

/* Makes a program current, binds an item's textures and sets the item's uniforms.
 *   index      index in scene->items
 *   lightness  factor for the light, 0 .. 1: luminance of the material's colour, or 1 */
void frame_use_item(const struct scene *scene, uint32_t index, float lightness, const struct gpu_program *program);

/* Returns the faces of an item's surface; for a lapped mesh, of the surface below its patches.
 *   index  index in scene->items
 *   near   the item's near faces, which the part leaves out; NULL: none */
struct frame_part frame_part_of_surface(const struct scene *scene, uint32_t index, const struct hatch_near_item *near);

/* Draws a part with the program in use. */
void frame_part_draw(struct frame_part part);

#endif
