#include "render-gl/mode/picture.h"

#include <assert.h>

static uint32_t least(uint32_t a, uint32_t b)
{
    return a < b ? a : b;
}

enum hatch_status picture_canvas(struct frame *frame, uint32_t width, uint32_t height, uint32_t side,
                                 struct canvas *canvas, struct hatch_err *err)
{
    uint32_t most = least(frame->size_max_px, PICTURE_CANVAS_MAX_PX) / side;
    return canvas_make(least(width, most), least(height, most), side, &frame->programs, canvas, err);
}

static double line_px(const struct picture *picture)
{
    return picture->draws_lines ? picture->lines->lines.style.width_px : 0;
}

enum hatch_status picture_draw_tile(const struct picture *picture, const struct hatch_view *view,
                                    const struct hatch_tile *tile, const struct canvas *canvas, struct hatch_err *err)
{
    struct frame *frame = picture->context->frame;
    const struct frame_request request = {.view = view,
                                          .tile = tile,
                                          .canvas = canvas,
                                          .background = frame->style.inks.paper,
                                          .line_px = line_px(picture)};
    HATCH_TRY(technique_draw(picture->context, picture->instance, &request, err));
    if (picture->draws_lines) {
        picture->lines->lines.style.brush = technique_line_brush(picture->instance);
        HATCH_TRY(line_overlay_draw(picture->lines, frame, err));
    }
    gpu_timer_end(frame->timer);
    return HATCH_OK;
}

/* Returns how far outside a tile drawing influences it; neighbouring tiles overlap by as much. */
static uint32_t reach_px(const struct picture *picture)
{
    uint32_t reach = technique_reach_px(picture->context, picture->instance, line_px(picture));
    return picture->lines && reach < HATCH_LINES_REACH_PX ? HATCH_LINES_REACH_PX : reach;
}

enum hatch_status picture_draw(const struct picture *picture, const struct hatch_view *view,
                               const struct canvas *canvas, struct hatch_image *image, struct hatch_err *err)
{
    uint32_t reach = reach_px(picture);
    uint32_t left = image->width > canvas->width ? reach : 0, below = image->height > canvas->height ? reach : 0;
    uint32_t width = canvas->width - 2 * left, height = canvas->height - 2 * below;
    assert(canvas->width > 2 * left && canvas->height > 2 * below);
    for (uint32_t y = 0; y < image->height; y += height)
        for (uint32_t x = 0; x < image->width; x += width) {
            const struct hatch_tile tile = {(double)x - left, (double)y - below, canvas->width,
                                            canvas->height,   image->width,      image->height};
            const struct gpu_rectangle seen = {left, below, least(width, image->width - x),
                                               least(height, image->height - y)};
            HATCH_TRY(picture_draw_tile(picture, view, &tile, canvas, err));
            canvas_read(canvas, seen, image, x, y);
        }
    return HATCH_OK;
}
