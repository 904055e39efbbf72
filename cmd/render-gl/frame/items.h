/* The loop over a scene's items, and how patches are drawn over one another: what techniques that shade surfaces share.
 */
#ifndef RENDER_FRAME_ITEMS_H
#define RENDER_FRAME_ITEMS_H

#include "render-gl/frame/frame.h"

#define FRAME_PASSES_MAX 4u
#define FRAME_VARIANTS 32u /* sums of enum frame_variant */

/* How a shading draws the patches of lapped meshes. */
enum frame_patches {
    FRAME_PATCHES_BLEND, /* each over those before it by its outline. A shading of several passes begins with black and
                            adds in the others; its shaders put the outline into alpha */
    FRAME_PATCHES_COVER, /* the uppermost hides the others: the output is no colour */
    FRAME_PATCHES_UNSEEN /* the surface is drawn instead, as if it had none */
};

/* One of a shading's passes over ordinary items. Shaders know its number as `pass`. */
struct frame_item_pass {
    const char *name; /* in the report of --time */
    enum frame_blend blend;
    enum frame_depth depth;
};

/* How items are shaded. Beside these definitions shaders get those that the style and the item ask for: PIXEL_LIGHT,
 * SHADOWS, SUN, HIGHLIGHTS, TWO_INKS, BASE_TEXTURE with BASE_TONE, BASE_HOLES or OUTLINE, NORMAL_MAP, PIECES. */
struct frame_shading {
    struct gpu_stages stages;
    const char *defines; /* lines before each stage, "" for none */
    bool pixel_light;    /* its shaders know PIXEL_LIGHT */
    bool pieces;         /* its shaders know PIECES: near faces are drawn as such, without normal maps */
    enum frame_patches patches;
    uint32_t pass_count; /* 1 .. FRAME_PASSES_MAX */
    struct frame_item_pass passes[FRAME_PASSES_MAX];
};

/* Differences between the programs that draw items; bits. */
enum frame_variant {
    FRAME_TONE = 1,    /* the material's texture is tone */
    FRAME_HOLES = 2,   /* and has holes */
    FRAME_OUTLINE = 4, /* the texture is the outline of patches, with neither */
    FRAME_PIECES = 8,  /* with each of these: pieces of near faces */
    FRAME_NORMALS = 16 /* with each of these: a normal map */
};

/* The programs of a shading, by variant; NULL where none was asked for. Zeroed to begin with. */
struct frame_shader {
    const struct gpu_program *programs[FRAME_VARIANTS];
    const struct gpu_program *below[2]; /* draw the surface below patches: its faces, its pieces */
};

/* Compiles what the scene's items need. Calling it again is cheap.
 *   defines  lines of the asset and of the technique's options, beside those of the shading; another text needs a
 *            zeroed shader */
enum hatch_status frame_shader_prepare(struct frame *frame, const struct frame_shading *shading, const char *defines,
                                       struct frame_shader *shader, struct hatch_err *err) HATCH_MUST_USE;

/* Draws every item into a target of the canvas's size in samples. Between frame_begin and frame_end; compiles variants
 * for pieces, which most pictures do without.
 *   target   the canvas's samples, or a target with depth that a technique has cleared
 *   defines  as before */
enum hatch_status frame_draw_items(struct frame *frame, const struct gpu_target *target,
                                   const struct frame_shading *shading, const char *defines,
                                   struct frame_shader *shader, struct hatch_err *err) HATCH_MUST_USE;

#endif
