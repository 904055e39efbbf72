#include "render-gl/frame/block.h"

#include <math.h>
#include <string.h>

#include "image/color.h"

enum frame_ink_mode frame_ink_mode(const struct frame_inks *inks)
{
    if (inks->two)
        return FRAME_INK_BOTH;
    return hatch_color_luminance(inks->ink) > hatch_color_luminance(inks->paper) ? FRAME_INK_LIGHTENS
                                                                                 : FRAME_INK_DARKENS;
}

void frame_block_set_inks(struct frame_block *block, const struct frame_inks *inks)
{
    memcpy(block->paper, inks->paper, sizeof inks->paper);
    memcpy(block->ink, inks->ink, sizeof inks->ink);
    memcpy(block->light_ink, inks->light_ink, sizeof inks->light_ink);
    block->counts[2] = (int32_t)frame_ink_mode(inks);
}

void frame_block_set_curve(struct frame_block *block, const struct frame_curve *curve)
{
    block->curve[0] = (float)curve->low;
    block->curve[1] = (float)curve->high;
    block->curve[2] = (float)curve->gamma;
    block->shade[1] = (float)curve->ambient;
    block->shade[2] = (float)curve->specular;
    block->shade[3] = (float)curve->shininess;
}

void frame_block_set_tones(struct frame_block *block, const float *targets, uint32_t count, float darkest)
{
    block->counts[1] = (int32_t)count;
    block->shade[0] = darkest;
    for (uint32_t i = 0; i < count; i++) {
        float begin = i ? targets[i - 1] : 0.0f;
        block->targets[i / 4][i % 4] = targets[i];
        if (i >= 6)
            continue;
        block->ramp_low[i / 3][i % 3] = begin;
        block->ramp_scale[i / 3][i % 3] = 1.0f / fmaxf(targets[i] - begin, 1e-6f);
    }
}

void frame_block_set_hatch(struct frame_block *block, double turn_rad, double scale)
{
    block->hatch[0] = (float)(cos(turn_rad) / scale);
    block->hatch[1] = (float)(sin(turn_rad) / scale);
}

void frame_block_set_view(struct frame_block *block, const struct hatch_view *view, const struct hatch_tile *tile,
                          uint32_t side)
{
    block->curve[3] = (float)(side * side);
    hatch_view_matrix(view, tile, block->clip_from_unit);
    block->viewport[0] = (float)(tile->width / 2);
    block->viewport[1] = (float)(tile->height / 2);
    block->viewport[2] = (float)tile->x;
    block->viewport[3] = (float)tile->y;
    for (int k = 0; k < 3; k++)
        block->eye[k] = (float)(view->orthographic ? view->back[k] : view->eye[k]);
    block->eye[3] = view->orthographic ? 0.0f : 1.0f;
}
