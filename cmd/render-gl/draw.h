/* The loop over passes and items that all techniques share, and how patches go over one another. */
#ifndef RENDER_DRAW_H
#define RENDER_DRAW_H

#include "render-gl/renderer.h"

/* Which of a technique's programs draws an item; bits. */
enum draw_variant {
    DRAW_TONE = 1,    /* the material's texture is tone */
    DRAW_HOLES = 2,   /* and has holes */
    DRAW_OUTLINE = 4, /* the texture is the outline of patches, with neither */
    DRAW_PIECES = 8,  /* with each of these: pieces of near faces */
    DRAW_NORMALS = 16 /* with each of these: a normal map */
};

uint32_t draw_variant_of(const struct renderer *renderer, uint32_t technique, const struct gpu_item *item);

/* Draws what each light sees into its maps, and binds them. */
void draw_shadows(const struct renderer *renderer);

/* Draws every item into the target that is bound, with programs that are compiled. */
void draw_items(const struct renderer *renderer, uint32_t technique);

#endif
