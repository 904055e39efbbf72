#include "render-gl/frame/frame.h"

#include <math.h>

#include "render-gl/gpu/bindings.h"
#include "render-gl/gpu/buffer.h"

static void clear(const struct frame *frame)
{
    static const float far = 0.0f;
    const float *rgb = frame->request.background;
    const float color[4] = {rgb[0], rgb[1], rgb[2], 0.0f};
    const struct frame_pass pass = {
        .name = "clear", .target = &frame->request.canvas->samples, .clear = color, .clear_depth = &far};
    frame_pass_begin(&pass);
    frame_pass_end(&pass, frame->timer);
}

enum hatch_status frame_cut_near(struct frame *frame, enum hatch_near_places places, struct hatch_err *err)
{
    const struct hatch_near_options options = {.places = frame->floats_alone ? HATCH_NEAR_NONE : places,
                                               .turn = {(double)frame->block.hatch[0], (double)frame->block.hatch[1]},
                                               .tile = frame->request.tile,
                                               .max_memory = frame->programs.scratch->limit_bytes};
    frame->view = *frame->request.view;
    return near_begin(&frame->near, frame->scene, &options, &frame->view, err);
}

enum hatch_status frame_set_tile(struct frame *frame, const struct hatch_tile *tile, uint32_t side,
                                 enum hatch_near_places places, struct hatch_err *err)
{
    frame->request.tile = tile;
    if (frame->near.found.items)
        HATCH_TRY(frame_cut_near(frame, places, err));
    frame_block_set_view(&frame->block, &frame->view, tile, side);
    gpu_block_update(&frame->block_buffer, BLOCK_FRAME, &frame->block, sizeof frame->block);
    return HATCH_OK;
}

enum hatch_status frame_begin(struct frame *frame, const struct frame_request *request, enum hatch_near_places places,
                              struct hatch_err *err)
{
    const struct frame_style *style = &frame->style;
    struct frame_block *block = &frame->block;
    struct hatch_unit_scene *unit = &frame->scene->unit;
    frame->request = *request;
    gpu_timer_begin(frame->timer);
    frame_targets_begin(&frame->targets);
    frame_block_set_inks(block, &style->inks);
    frame_block_set_curve(block, &style->curve);
    frame_block_set_hatch(block, style->hatch_turn_rad, style->hatch_scale);
    HATCH_TRY(frame_cut_near(frame, places, err));
    frame_block_set_view(block, &frame->view, request->tile, request->canvas->side);
    block->counts[0] = (int32_t)hatch_lights_fill(&unit->pose, &unit->bounds, &frame->view, &style->light,
                                                  style->curve.exposure, block->lights);
    gpu_block_update(&frame->block_buffer, BLOCK_FRAME, block, sizeof *block);
    if (style->shadows) {
        HATCH_TRY(shadow_draw(&frame->shadow, block, frame->scene, style->shadow_edge, &frame->programs, err));
        gpu_timer_end_pass(frame->timer, "shadows");
    }
    clear(frame);
    return HATCH_OK;
}

/* Returns the width of haloes from the edge of the surface. The feature line on that edge covers half its own width of
 * the halo, so this half is added. */
static double halo_reach_px(const struct frame *frame, double line_px)
{
    return frame->style.halo_px + 0.5 * line_px;
}

uint32_t frame_reach_px(const struct frame *frame, double line_px)
{
    /* Detecting edges and slopes reads depth up to three samples beyond the halo. */
    return frame->style.halo_px > 0 ? (uint32_t)ceil(halo_reach_px(frame, line_px)) + 4 : 0;
}

enum hatch_status frame_end(struct frame *frame, bool haloes, struct hatch_err *err)
{
    const struct canvas *canvas = frame->request.canvas;
    if (frame->style.halo_px > 0 && haloes) {
        double reach_px = halo_reach_px(frame, frame->request.line_px);
        HATCH_TRY(halo_draw(&frame->halo, canvas, &frame->view, reach_px, frame->request.background, &frame->programs,
                            &frame->targets, err));
        gpu_timer_end_pass(frame->timer, "haloes");
    }
    canvas_resolve(canvas);
    gpu_timer_end_pass(frame->timer, "resolve");
    return HATCH_OK;
}

void frame_free(struct frame *frame)
{
    near_free(&frame->near);
    shadow_free(&frame->shadow);
    halo_free(&frame->halo);
    frame_targets_free(&frame->targets);
    glDeleteBuffers(1, &frame->block_buffer);
    frame->block_buffer = 0;
    gpu_programs_free(&frame->programs);
}
