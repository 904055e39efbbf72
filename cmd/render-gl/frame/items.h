/* Draws all items of a scene with one shading: the loop that techniques share, with lapped patches, near faces and the
 * variants of a shading's programs. */
#ifndef RENDER_FRAME_ITEMS_H
#define RENDER_FRAME_ITEMS_H

#include "render-gl/frame/frame.h"

#define FRAME_PASSES_MAX 4u
#define FRAME_VARIANTS 32u /* combinations of enum frame_variant */

/* A shading's way to draw the patches of lapped meshes. */
enum frame_patches {
    FRAME_PATCHES_BLEND, /* each over the earlier ones, by its outline, which the shaders write into alpha. In a shading
                            of several passes the first draws black and the others add */
    FRAME_PATCHES_COVER, /* the last one hides the earlier ones; for output that is no colour */
    FRAME_PATCHES_UNSEEN /* not at all: the surface below is drawn like an ordinary item */
};

/* One pass of a shading over the ordinary items (those not drawn as patches). Shaders read its index as `pass`. */
struct frame_item_pass {
    const char *name; /* for the report of --time */
    enum frame_blend blend;
    enum frame_depth depth;
};

/* A shading: the programs and passes that draw items. In addition to `defines`, shaders are compiled with those of
 * PIXEL_LIGHT, SHADOWS, SUN, HIGHLIGHTS, TWO_INKS, BASE_TEXTURE (with BASE_TONE, BASE_HOLES or OUTLINE), NORMAL_MAP and
 * PIECES that the style and the item require. */
struct frame_shading {
    struct gpu_stages stages;
    const char *defines; /* lines before each stage, NULL: none */
    bool pixel_light;    /* the shaders support PIXEL_LIGHT */
    bool pieces;         /* the shaders support PIECES: near faces are drawn as pieces, and normal maps are not used */
    enum frame_patches patches;
    struct frame_item_pass passes[FRAME_PASSES_MAX]; /* ended by one without a name, if fewer */
};

/* Features of an item that need a program of their own; bits. FRAME_OUTLINE excludes FRAME_TONE and FRAME_HOLES;
 * FRAME_PIECES and FRAME_NORMALS go with any. */
enum frame_variant {
    FRAME_TONE = 1,    /* the base texture counts as tone */
    FRAME_HOLES = 2,   /* the base texture has holes */
    FRAME_OUTLINE = 4, /* the base texture is the outline of patches */
    FRAME_PIECES = 8,  /* draws pieces of near faces */
    FRAME_NORMALS = 16 /* has a normal map */
};

/* The compiled programs of a shading. Zeroed before the first call. */
struct frame_shader {
    const struct gpu_program *programs[FRAME_VARIANTS]; /* by sum of enum frame_variant; NULL: not compiled */
    const struct gpu_program *below[2]; /* for the surface below patches: its faces, its pieces; NULL: not compiled */
};

/* Compiles the programs that the scene's items need. Repeated calls return at once.
 *   defines  lines of the asset and of the technique's options, in addition to the shading's; must be the same in all
 *            calls with one shader (zero the shader to change them) */
enum hatch_status frame_shader_prepare(struct frame *frame, const struct frame_shading *shading, const char *defines,
                                       struct frame_shader *shader, struct hatch_err *err) HATCH_MUST_USE;

/* Draws every item into a target, between frame_begin and frame_end and after frame_shader_prepare. Compiles the
 * variants for pieces itself, because most pictures have none. target   of the size of the canvas in samples: the
 * canvas's own, or one with depth that the caller has cleared defines  as in frame_shader_prepare */
enum hatch_status frame_draw_items(struct frame *frame, const struct gpu_target *target,
                                   const struct frame_shading *shading, const char *defines,
                                   struct frame_shader *shader, struct hatch_err *err) HATCH_MUST_USE;

#endif
