/* A frame: all that drawing the scene needs, apart from how a technique shades it. A technique draws with
 *     frame_begin       the view, lights, near pieces, shadows; clears the canvas
 *     frame_draw_items  its shading on every item (frame/items.h), or passes of its own (frame/pass.h)
 *     frame_end         haloes, the mean of samples
 * of which the shared driver calls the first and the last (technique/technique.h). */
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

/* The user's choices, apart from view and technique. */
struct frame_style {
    struct frame_inks inks;
    struct frame_curve curve;
    struct hatch_key_light light;
    float anisotropy;                   /* 1 .. 16 */
    double hatch_turn_rad, hatch_scale; /* of the strokes on their surface; scale over 0 */
    bool base_tone;                     /* the materials' colours and textures count as tone */
    bool pixel_light;                   /* techniques that can compute light per pixel do so */
    bool shadows;                       /* lights cast shadows; then light is per pixel as well */
    double shadow_edge;                 /* width of shadows' edges in the unit scene; over 0 */
    double halo_px;                     /* width of haloes beside lines; 0: none */
};

/* What one frame shows. */
struct frame_request {
    const struct hatch_view *view;
    const struct hatch_tile *tile;
    const struct canvas *canvas; /* of the tile's size */
    const float *background;     /* 3, linear light */
    double line_px;              /* width of the feature lines that will be drawn; 0: none */
};

struct frame {
    struct gpu_programs programs;
    struct frame_targets targets;
    struct gpu_timer *timer; /* NULL: passes are not timed */
    struct scene *scene;
    struct frame_style style;
    struct frame_block block;
    GLuint block_buffer;
    struct shadow shadow;
    struct halo halo;
    struct near near;
    bool floats_alone;    /* no pieces are made: near faces show how far floats are off */
    uint32_t size_max_px; /* of textures */
    /* From frame_begin to frame_end: */
    struct frame_request request;
    struct hatch_view view; /* the requested one with its near plane moved */
};

/* Sets the block, finds near faces, draws shadows into their maps and clears the canvas. What a technique sets in the
 * block beforehand (tones) stays.
 *   pieces  the technique draws near faces as pieces
 * HATCH_LIMIT when memory, the GPU's too, does not suffice. */
enum hatch_status frame_begin(struct frame *frame, const struct frame_request *request, bool pieces,
                              struct hatch_err *err) HATCH_MUST_USE;

/* Draws haloes, unless the technique's output is no colour, and averages the samples. */
enum hatch_status frame_end(struct frame *frame, bool haloes, struct hatch_err *err) HATCH_MUST_USE;

/* How far outside a tile the frame looks, in pixels. lines: feature lines will be drawn. */
uint32_t frame_reach_px(const struct frame *frame, double line_px);

/* Releases what frames have made, programs too. */
void frame_free(struct frame *frame);

#endif
