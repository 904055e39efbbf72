/* Draws frames: the programs and the columns of each technique that was asked for. */
#ifndef RENDER_RENDERER_H
#define RENDER_RENDERER_H

#include "render-gl/clock.h"
#include "render-gl/field.h"
#include "render-gl/fine.h"
#include "render-gl/frame.h"
#include "render-gl/halo.h"
#include "render-gl/lines/lines.h"
#include "render-gl/near/near.h"
#include "render-gl/scene.h"
#include "render-gl/seeds.h"
#include "render-gl/shadow.h"
#include "render-gl/target.h"
#include "render-gl/technique/technique.h"

#define VARIANTS 32u /* of a program: sums of enum draw_variant */

/* What a user chose, apart from the view. */
struct style {
    struct inks inks;
    struct tone_curve curve;
    struct own_light light;
    float anisotropy;                   /* 1 .. 16 */
    double hatch_turn_rad, hatch_scale; /* of the strokes on their surface; scale over 0 */
    bool base_tone;                     /* the materials' colours and textures count as tone */
    bool pixel_light;                   /* techniques that can light pixels, not vertices */
    bool shadows;                       /* lights cast some; then the same */
    double shadow_edge;                 /* their edges' width in the unit scene; over 0 */
    double halo_px;                     /* of haloes beside lines; 0: none */
};

struct renderer {
    struct shader_source shaders;
    struct style style;
    const struct hatch_tam *map;     /* NULL: no technique that draws with a map */
    const struct fine *fine;         /* NULL: none that draws with a texture of fine tone */
    const struct hatch_rptam *rptam; /* NULL: no technique that draws at seeds */
    bool all_seeds;                  /* looks at every seed at every place */
    struct gpu_seeds seeds;          /* made when a technique first wants them */
    struct gpu_scene *scene;
    uint32_t size_max_px;
    struct gpu_columns columns[COLUMNS_FORMS]; /* by form, made when a technique first wants them */
    GLuint programs[TECHNIQUE_COUNT][VARIANTS];
    GLuint below_patches[2]; /* draw the surface that patches lie on: without a geometry stage, with one */
    GLuint pieces_below;     /* its pieces */
    struct shadow shadow;    /* made when a style first has shadows */
    struct halo halo;        /* the same for haloes */
    struct near near;        /* what seeds' techniques draw as pieces */
    bool floats_alone;       /* nothing is drawn as pieces: to see what that is good for */
    GLuint block_buffer;
    struct frame_block block;
    struct lines *lines; /* NULL: none */
    struct field *field; /* what the technique field draws; else NULL */
    struct clock *clock; /* NULL: nobody wants to know how long passes take */
};

/* Whether what the technique reads is there, apart from strokes at seeds. */
bool renderer_can(const struct renderer *renderer, uint32_t technique);

/* What lies further outside of a tile changes nothing within it. */
uint32_t renderer_reach_px(const struct renderer *renderer, uint32_t technique);

/* Makes a technique ready to draw: uploads columns and compiles what its items need. Calling it again
 * is cheap. technique: index into techniques. */
enum hatch_status renderer_prepare(struct renderer *renderer, uint32_t technique, struct hatch_arena *scratch,
                                   struct hatch_err *err) HATCH_MUST_USE;

/* After the model of strokes at seeds has changed. */
enum hatch_status renderer_take_strokes(struct renderer *renderer, struct hatch_arena *scratch,
                                        struct hatch_err *err) HATCH_MUST_USE;

/* Draws a tile of a frame into the target and averages its samples; then its lines, where there are
 * some. The scene is posed. HATCH_LIMIT when memory does not suffice for lines. */
enum hatch_status renderer_draw(struct renderer *renderer, uint32_t technique, const struct hatch_view *view,
                                const struct hatch_tile *tile, const struct target *target,
                                struct hatch_err *err) HATCH_MUST_USE;

/* The same over another background than paper and without lines; for measurements that are no
 * picture. */
enum hatch_status renderer_draw_over(struct renderer *renderer, uint32_t technique, const float background[3],
                                     const struct hatch_view *view, const struct hatch_tile *tile,
                                     const struct target *target, struct hatch_err *err) HATCH_MUST_USE;

/* Compiles anew what has been compiled, when shaders are read from a folder that somebody edits. The
 * old programs stay when the new ones have an error. */
enum hatch_status renderer_reload(struct renderer *renderer, struct hatch_err *err) HATCH_MUST_USE;

void renderer_free(struct renderer *renderer);

#endif
