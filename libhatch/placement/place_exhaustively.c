#include "placement/place.h"

/* A candidate on the tile, independent of the size of an image. */
struct line {
    float x, y, cosine, sine;
    float bend_rad;
    float length; /* fraction of the tile */
    float width_px;
};

/* Moves a point of the straight line to the arc. Ignores that the outer side of an arc is longer than its inner side.
 *   along   in and out: position from the middle of the stroke
 *   across  out: offset across the stroke */
static void bend(float curvature, float *along, float *across)
{
    double angle = (double)(*along * curvature);
    *along = (float)sin(angle) / curvature;
    *across = (float)(1 - cos(angle)) / curvature;
}

/* Returns the darkness that the stroke adds to one square image of a pyramid, from about one sample per pixel of its
 * footprint.
 *   width_px  of the stroke at the scale of the image */
static float added_darkness(const struct line *line, const struct hatch_brush *brush, float width_px,
                            const float *paper, uint32_t size)
{
    float path = line->length * (float)size, length = path > width_px ? path : width_px; /* drawn as long as wide */
    uint32_t along = length < 1 ? 1 : (uint32_t)length;
    uint32_t across = width_px < 1 ? 1 : (uint32_t)(width_px + 0.5f);
    float step_along = length / (float)along, step_across = width_px / (float)across;
    float back = ((float)along - 1) * 0.5f * step_along, aside = ((float)across - 1) * 0.5f * step_across;
    uint32_t mask = size - 1;
    float curvature = line->bend_rad / path, sum = 0; /* 0 of lines, infinite or not a number of dots */
    for (uint32_t i = 0; i < along; i++) {
        uint32_t column = (2 * i + 1) * brush->width / (2 * along);
        float alpha = brush->cumulative[(size_t)(column + 1) * (brush->height + 1) - 1];
        float position = (float)i * step_along - back, lift = 0, reflectance = 0;
        if (isnormal(curvature))
            bend(curvature, &position, &lift);
        for (uint32_t j = 0; j < across; j++) {
            float off = (float)j * step_across - aside + lift;
            float sample_x = (line->x + 8) * (float)size + position * line->cosine - off * line->sine;
            float sample_y = (line->y + 8) * (float)size + position * line->sine + off * line->cosine;
            /* The size is a power of two and samples lie within a few tiles, so the mask wraps them. */
            uint32_t x = (uint32_t)(int32_t)sample_x & mask, y = (uint32_t)(int32_t)sample_y & mask;
            reflectance += paper[y * size + x];
        }
        sum += alpha * reflectance;
    }
    return sum * step_along * step_across / ((float)size * (float)size);
}

struct hatch_stroke hatch_place_exhaustively(const struct hatch_canvas *canvas, float *pyramids[][HATCH_MIP_LEVELS_MAX],
                                             const struct hatch_choice *choice)
{
    struct hatch_stroke best = {0};
    float best_goodness = -1;
    for (uint32_t c = 0; c < choice->candidates; c++) {
        struct hatch_stroke stroke = hatch_choice_candidate(canvas->style, choice, c);
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
