#include "render-gl/picture.h"

static uint32_t least(uint32_t a, uint32_t b)
{
    return a < b ? a : b;
}

enum hatch_status picture_target(uint32_t width, uint32_t height, uint32_t side,
                                 const struct renderer *renderer, struct target *target,
                                 struct hatch_err *err)
{
    uint32_t most = least(renderer->size_max_px, PICTURE_TARGET_MAX_PX) / side;
    return target_make(least(width, most), least(height, most), side, &renderer->shaders, target,
                       err);
}

void picture_draw(struct renderer *renderer, uint32_t technique, const struct view *view,
                  const struct target *target, struct hatch_image *image)
{
    for (uint32_t y = 0; y < image->height; y += target->height)
        for (uint32_t x = 0; x < image->width; x += target->width) {
            struct tile tile = {x,
                                y,
                                target->width,
                                target->height,
                                image->width,
                                image->height};
            renderer_draw(renderer, technique, view, &tile, target);
            target_read(target, least(target->width, image->width - x),
                        least(target->height, image->height - y), image, x, y);
        }
}
