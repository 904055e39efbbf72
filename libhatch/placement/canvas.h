/* The images of one tone column while it is filled, finest first, and what a stroke does to them.
 * For tam and what measures it. */
#ifndef HATCH_TAM_CANVAS_H
#define HATCH_TAM_CANVAS_H

#include "stroke/footprint.h"
#include "placement/style.h"

struct hatch_canvas {
    const struct hatch_style *style;
    const struct hatch_brush *brush;
    uint32_t size_px, levels;
    float *paper[HATCH_MIP_LEVELS_MAX];    /* reflectance of each level, 1 = paper; in colour, the mean of: */
    float *rgb[HATCH_MIP_LEVELS_MAX];      /* three a pixel; NULL without colour */
    double darkness[HATCH_MIP_LEVELS_MAX]; /* 1 - mean reflectance */
    float *id[HATCH_MIP_LEVELS_MAX];       /* NULL without ids; the first stroke keeps its pixels */
    float *along[HATCH_MIP_LEVELS_MAX];
    struct hatch_footprint footprint; /* of the last stroke drawn or tried */
    float *change;                    /* reflectance that each of its pixels lost, the mean of three */
    struct hatch_footprint before;    /* of a growing stroke, as it was */
};

/* White paper on each level. size_px and levels: as in struct hatch_fill_options; style, brush: stay the caller's and
 * must outlive the canvas. */
enum hatch_status hatch_canvas_make(struct hatch_arena *arena, const struct hatch_style *style,
                                    const struct hatch_brush *brush, uint32_t size_px, uint32_t levels, bool color,
                                    bool ids, struct hatch_canvas *canvas, struct hatch_err *err) HATCH_MUST_USE;

/* The size of a level. */
static inline uint32_t hatch_canvas_size(const struct hatch_canvas *canvas, uint32_t level)
{
    return canvas->size_px >> level;
}

/* How much darker the level's mean would become by the stroke at that share of its full length (its
 * width follows at half the pace); fills footprint and change, draws nothing. */
double hatch_canvas_try(struct hatch_canvas *canvas, const struct hatch_stroke *stroke, uint32_t level, float scale);

/* Draws the stroke at that share of its full length, over itself at scale_before (0: it was not there);
 * fills footprint and change. */
void hatch_canvas_draw(struct hatch_canvas *canvas, const struct hatch_stroke *stroke, uint32_t level,
                       float scale_before, float scale);

#endif
