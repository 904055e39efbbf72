/* Draws all items of a scene with one shading (struct frame_shading: programs and passes). Techniques share this loop.
 * It also draws lapped patches and pieces of near faces, and picks the program variant that each item needs. */
#ifndef RENDER_FRAME_ITEMS_H
#define RENDER_FRAME_ITEMS_H

#include "render-gl/frame/frame.h"

#define FRAME_PASSES_MAX 4u
#define FRAME_LIGHT_DEFINES_BYTES 128u
#define FRAME_VARIANTS 32u /* number of combinations of enum frame_variant */

/* How a shading draws the patches of lapped meshes. */
enum frame_patches {
    FRAME_PATCHES_BLEND, /* each patch is blended over the earlier ones by its outline, which shaders write into alpha;
                            in a shading with several passes, the first draws black and the others add */
    FRAME_PATCHES_COVER, /* each patch hides the earlier ones; for output that is not a colour */
    FRAME_PATCHES_UNSEEN /* patches are not drawn; the surface below them is drawn like an ordinary item */
};

/* One pass of a shading over the ordinary items (those not drawn as patches). Shaders read its index as `pass`. */
struct frame_item_pass {
    const char *name; /* for the report of --time */
    enum frame_blend blend;
    enum frame_depth depth;
    bool masks_color; /* only depth is written */
};

/* A shading: the programs and passes that draw items. Shaders are compiled with `defines` and with the macros that the
 * style, the lights and the item require: PIXEL_LIGHT, SHADOWS, SUN, HIGHLIGHTS, TWO_INKS, NORMAL_MAP, PIECES, and
 * BASE_TEXTURE (together with BASE_TONE, BASE_COLOR, BASE_HOLES or OUTLINE). */
struct frame_shading {
    struct gpu_stages stages;
    const char *defines; /* #define lines put before each stage; NULL: none */
    bool pixel_light;    /* the shaders support PIXEL_LIGHT */
    bool smooth;         /* the shaders do not read normal maps */
    bool colors;         /* the shaders draw the materials' colours and textures, if the style says so */
    enum frame_patches patches;
    struct frame_item_pass passes[FRAME_PASSES_MAX]; /* up to the first one without a name */
};

/* Features of an item for which shaders are compiled separately; bits. FRAME_OUTLINE excludes FRAME_TONE and
 * FRAME_HOLES; all other combinations are possible. */
enum frame_variant {
    FRAME_TONE = 1,    /* the base texture counts as tone, or is drawn in its colours */
    FRAME_HOLES = 2,   /* the base texture has holes */
    FRAME_OUTLINE = 4, /* the base texture is the outline of patches */
    FRAME_PIECES = 8,  /* pieces of near faces are drawn; excludes FRAME_NORMALS */
    FRAME_NORMALS = 16 /* there is a normal map */
};

/* The compiled programs of a shading. Zeroed before the first call. */
struct frame_shader {
    const struct gpu_program *programs[FRAME_VARIANTS]; /* index: bits of enum frame_variant; NULL: not compiled */
    const struct gpu_program *below[2]; /* for the surface below patches: [0] faces, [1] pieces; NULL: not compiled */
};

/* Writes the #define lines that shaders need for the light and the inks of a frame.
 *   pixel_light  the shaders support PIXEL_LIGHT */
void frame_light_defines(const struct frame *frame, bool pixel_light, char text[FRAME_LIGHT_DEFINES_BYTES]);

/* Compiles the programs that the scene's items need, except those for pieces. Programs that are compiled already are
 * kept.
 *   defines  #define lines for the asset and the technique's options, in addition to those of the shading; the same in
 *            all calls with one shader (to change them, zero the shader first) */
enum hatch_status frame_shader_prepare(struct frame *frame, const struct frame_shading *shading, const char *defines,
                                       struct frame_shader *shader, struct hatch_err *err) HATCH_MUST_USE;

/* Draws every item into a target, between frame_begin and frame_end and after frame_shader_prepare. Compiles the
 * variants for pieces itself, because most pictures have none.
 *   target   the canvas's samples, or a target of the same size with depth that the caller has cleared
 *   defines  as in frame_shader_prepare */
enum hatch_status frame_draw_items(struct frame *frame, const struct gpu_target *target,
                                   const struct frame_shading *shading, const char *defines,
                                   struct frame_shader *shader, struct hatch_err *err) HATCH_MUST_USE;

#endif
