#include "render-gl/picture.h"

#include <assert.h>

static uint32_t least(uint32_t a, uint32_t b)
{
    return a < b ? a : b;
}

enum hatch_status picture_target(uint32_t width, uint32_t height, uint32_t side, const struct renderer *renderer,
                                 struct target *target, struct hatch_err *err)
{
    uint32_t most = least(renderer->size_max_px, PICTURE_TARGET_MAX_PX) / side;
    return target_make(least(width, most), least(height, most), side, &renderer->shaders, target, err);
}

enum hatch_status picture_draw(struct renderer *renderer, uint32_t technique, const struct hatch_view *view,
                               const struct target *target, struct hatch_image *image, struct hatch_err *err)
{
    uint32_t reach = renderer_reach_px(renderer, technique); /* tiles that overlap see the same around a border */
    uint32_t left = image->width > target->width ? reach : 0;
    uint32_t below = image->height > target->height ? reach : 0;
    uint32_t width = target->width - 2 * left, height = target->height - 2 * below;
    assert(target->width > 2 * left && target->height > 2 * below);
    for (uint32_t y = 0; y < image->height; y += height)
        for (uint32_t x = 0; x < image->width; x += width) {
            struct hatch_tile tile = {(double)x - left, (double)y - below, target->width,
                                      target->height,   image->width,      image->height};
            HATCH_TRY(renderer_draw(renderer, technique, view, &tile, target, err));
            target_read(target, left, below, least(width, image->width - x), least(height, image->height - y), image, x,
                        y);
        }
    return HATCH_OK;
}
