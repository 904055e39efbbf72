#include <math.h>

#include "placement/place.h"

/* A candidate on the tile: what does not depend on the image's size. */
struct line {
    float x, y, cosine, sine;
    float bend_rad;
    float length; /* fraction of the tile */
    float width_px;
};

/* Moves a place of the straight line to where it lies on the arc; across it, the two differ too little to
 * tell. */
static void bend(float curvature, float *at, float *lift)
{
    double angle = (double)(*at * curvature);
    *at = (float)sin(angle) / curvature;
    *lift = (float)(1 - cos(angle)) / curvature;
}

/* The darkness that the stroke adds to one square image of a pyramid: a plain loop over its footprint, one
 * sample a pixel along it and across it. width_px: of the stroke at this image's scale. */
static float added_darkness(const struct line *line, const struct hatch_brush *brush, float width_px,
                            const float *paper, uint32_t size)
{
    float length = line->length * (float)size;
    uint32_t along = length < 1 ? 1 : (uint32_t)length;
    uint32_t across = width_px < 1 ? 1 : (uint32_t)(width_px + 0.5f);
    float step_along = length / (float)along, step_across = width_px / (float)across;
    float back = ((float)along - 1) * 0.5f * step_along, aside = ((float)across - 1) * 0.5f * step_across;
    uint32_t mask = size - 1;
    float sum = 0;
    for (uint32_t i = 0; i < along; i++) {
        uint32_t column = (2 * i + 1) * brush->width / (2 * along);
        float alpha = brush->cumulative[(size_t)(column + 1) * (brush->height + 1) - 1];
        float at = (float)i * step_along - back, lift = 0, left = 0;
        if (line->bend_rad != 0)
            bend(line->bend_rad / length, &at, &lift);
        for (uint32_t j = 0; j < across; j++) {
            float off = (float)j * step_across - aside + lift;
            float place_x = (line->x + 8) * (float)size + at * line->cosine - off * line->sine;
            float place_y = (line->y + 8) * (float)size + at * line->sine + off * line->cosine;
            /* sizes are powers of two and places lie within a few tiles: the mask wraps them */
            uint32_t x = (uint32_t)(int32_t)place_x & mask, y = (uint32_t)(int32_t)place_y & mask;
            left += paper[y * size + x];
        }
        sum += alpha * left;
    }
    return sum * step_along * step_across / ((float)size * (float)size);
}

struct hatch_stroke hatch_place_exhaustively(const struct hatch_canvas *canvas, float *pyramids[][HATCH_MIP_LEVELS_MAX],
                                             const struct hatch_choice *choice)
{
    struct hatch_stroke best = {0};
    float best_goodness = -1;
    for (uint32_t c = 0; c < choice->candidates; c++) {
        struct hatch_stroke stroke = hatch_candidate(canvas->style, choice, c);
        struct line line = {stroke.x,
                            stroke.y,
                            (float)cos((double)stroke.angle_rad),
                            (float)sin((double)stroke.angle_rad),
                            stroke.bend_rad * choice->scale,
                            stroke.length * choice->scale,
                            stroke.width_px};
        float gain = 0;
        for (uint32_t level = 0; level <= choice->level; level++) {
            uint32_t size = hatch_canvas_size(canvas, level);
            float width_px = line.width_px;
            for (uint32_t p = 0; size >> p; p++, width_px *= 0.5f)
                gain += added_darkness(&line, canvas->brush, width_px, pyramids[level][p], size >> p);
        }
        float drawn_px = line.length * (float)canvas->size_px;
        float goodness = gain / (drawn_px > line.width_px ? drawn_px : line.width_px);
        if (goodness > best_goodness) {
            best_goodness = goodness;
            best = stroke;
        }
    }
    return best;
}
