/* A frame: drawing the scene once, as far as all techniques do it in the same way. The steps are
 *     frame_begin       sets view and lights, cuts faces near the eye, draws shadow maps, clears the canvas
 *     frame_draw_items  draws every item with a technique's shading (frame/items.h); or the technique's own passes
 *                       (frame/pass.h)
 *     frame_end         draws haloes, averages the samples
 * technique_draw (technique/technique.h) calls the first and the last; the technique does the one between. */
#ifndef RENDER_FRAME_FRAME_H
#define RENDER_FRAME_FRAME_H

#include "render-gl/frame/block.h"
#include "render-gl/frame/canvas.h"
#include "render-gl/frame/halo.h"
#include "render-gl/frame/near.h"
#include "render-gl/frame/pass.h"
#include "render-gl/frame/shadow.h"
#include "render-gl/frame/targets.h"
#include "render-gl/scene/scene.h"

/* The user's settings for drawing, apart from the view and from the technique and its options. */
struct frame_style {
    struct frame_inks inks;
    struct frame_curve curve;
    struct hatch_key_light light;
    float anisotropy;      /* greatest anisotropy of texture filters, 1 (none) .. 16 */
    double hatch_turn_rad; /* turn of the strokes on their surface, counter-clockwise seen from outside */
    double hatch_scale;    /* scale of the strokes' pattern, over 0 */
    bool base_tone;        /* the materials' colours and textures count as tone */
    bool base_color;       /* shadings with colours draw them, and base_tone is not set */
    bool pixel_light;      /* techniques that can compute light per pixel do so */
    bool shadows;          /* lights cast shadows; implies pixel_light */
    double shadow_edge;    /* width of the soft edges of shadows, in the unit scene; over 0 */
    double halo_px;        /* width of haloes in pixels, from the outer edge of the feature line, if any; 0: none */
};

/* One frame to draw. The pointers must stay valid until frame_end. */
struct frame_request {
    const struct hatch_view *view;
    const struct hatch_tile *tile;
    const struct canvas *canvas; /* as large as the tile; the result is drawn on it */
    const float *background;     /* R G B, linear light */
    double line_px;              /* width of feature lines that will be drawn over the frame; 0: none */
    uint32_t film; /* number of the frame in its film, from 1, which technique_foresee has seen; 0: it stands alone */
};

/* State that is kept from frame to frame. The owner zeroes it and sets programs, scene, style and size_max_px. */
struct frame {
    struct gpu_programs programs;
    struct frame_targets targets;
    struct gpu_timer *timer; /* NULL: passes are not timed */
    struct scene *scene;     /* kept by reference; posed before each frame */
    struct frame_style style;
    struct frame_block block;
    GLuint block_buffer; /* the block on the GPU; 0: not made */
    struct shadow shadow;
    struct halo halo;
    struct near near;
    bool floats_alone;    /* for comparison: near faces are not cut into pieces, so floats alone place them */
    uint32_t size_max_px; /* largest side of a texture */
    /* Valid from frame_begin to frame_end: */
    struct frame_request request;
    struct hatch_view view; /* the requested view, its near plane moved to the nearest surface */
};

/* Writes the uniform block, cuts near faces into pieces, draws the shadow maps and clears the canvas. The block's tones
 * must be set before.
 *   places  what the technique needs to know of places in its texture to draw near faces as pieces
 * HATCH_LIMIT when main memory or the GPU's memory does not suffice. */
enum hatch_status frame_begin(struct frame *frame, const struct frame_request *request, enum hatch_near_places places,
                              struct hatch_err *err) HATCH_MUST_USE;

/* Cuts the near faces of a frame into pieces again, for passes that need other places than frame_begin was told. */
enum hatch_status frame_cut_near(struct frame *frame, enum hatch_near_places places,
                                 struct hatch_err *err) HATCH_MUST_USE;

/* Lets the passes that follow draw another tile of the same view: cuts near faces again for it, and writes the uniform
 * block.
 *   tile    kept by reference
 *   side    samples along a side of a pixel
 *   places  as for frame_begin */
enum hatch_status frame_set_tile(struct frame *frame, const struct hatch_tile *tile, uint32_t side,
                                 enum hatch_near_places places, struct hatch_err *err) HATCH_MUST_USE;

/* Draws haloes and averages the samples.
 *   haloes  false: no haloes are drawn, because the technique's output is not a colour */
enum hatch_status frame_end(struct frame *frame, bool haloes, struct hatch_err *err) HATCH_MUST_USE;

/* Returns how far outside a tile, in pixels, surfaces still influence its haloes; 0 without haloes.
 *   line_px  as in struct frame_request */
uint32_t frame_reach_px(const struct frame *frame, double line_px);

/* Releases everything that frames have made, including the programs. */
void frame_free(struct frame *frame);

#endif
