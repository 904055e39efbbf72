#include "render-gl/mode/picture.h"

#define TILES_SEEN                                                                                                     \
    8u /* at least one part in so many of a canvas is seen; the rest is the margin that strokes reach                  \
        */

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

static struct frame_request request_of(const struct picture *picture, const struct hatch_view *view,
                                       const struct hatch_tile *tile, const struct canvas *canvas)
{
    return (struct frame_request){.view = view,
                                  .tile = tile,
                                  .canvas = canvas,
                                  .background = picture->context->frame->style.inks.paper,
                                  .line_px = line_px(picture),
                                  .film = picture->film};
}

enum hatch_status picture_draw_tile(const struct picture *picture, const struct hatch_view *view,
                                    const struct hatch_tile *tile, const struct canvas *canvas, struct hatch_err *err)
{
    struct frame *frame = picture->context->frame;
    const struct frame_request request = request_of(picture, view, tile, canvas);
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
    uint32_t lines = picture->lines ? hatch_lines_reach_px(&picture->lines->lines.style) : 0;
    return reach > lines ? reach : lines;
}

/* Draws the tiles of a picture, or foresees them.
 *   image  NULL: they are foreseen */
static enum hatch_status go_over(const struct picture *picture, const struct hatch_view *view,
                                 const struct canvas *canvas, uint32_t full_width, uint32_t full_height,
                                 struct hatch_image *image, struct hatch_err *err)
{
    uint32_t reach = reach_px(picture);
    uint32_t left = full_width > canvas->width ? reach : 0, below = full_height > canvas->height ? reach : 0;
    if (canvas->width < 2 * left + canvas->width / TILES_SEEN ||
        canvas->height < 2 * below + canvas->height / TILES_SEEN)
        return hatch_fail(err, HATCH_LIMIT,
                          "the picture is drawn in tiles of %u x %u pixels, and strokes reach %u pixels beyond one: "
                          "use a smaller picture, fewer samples or shorter strokes",
                          canvas->width, canvas->height, reach);
    uint32_t width = canvas->width - 2 * left, height = canvas->height - 2 * below;
    for (uint32_t y = 0; y < full_height; y += height)
        for (uint32_t x = 0; x < full_width; x += width) {
            const struct hatch_tile tile = {(double)x - left, (double)y - below, canvas->width,
                                            canvas->height,   full_width,        full_height};
            const struct gpu_rectangle seen = {left, below, least(width, full_width - x),
                                               least(height, full_height - y)};
            const struct frame_request request = request_of(picture, view, &tile, canvas);
            HATCH_TRY(image ? picture_draw_tile(picture, view, &tile, canvas, err)
                            : technique_foresee(picture->context, picture->instance, &request, 0, err));
            if (image)
                canvas_read(canvas, seen, image, x, y);
        }
    return HATCH_OK;
}

enum hatch_status picture_foresee(const struct picture *picture, const struct hatch_view *view,
                                  const struct canvas *canvas, uint32_t width, uint32_t height, struct hatch_err *err)
{
    return go_over(picture, view, canvas, width, height, NULL, err);
}

enum hatch_status picture_draw(const struct picture *picture, const struct hatch_view *view,
                               const struct canvas *canvas, struct hatch_image *image, struct hatch_err *err)
{
    return go_over(picture, view, canvas, image->width, image->height, image, err);
}
