/* A canvas holds one image per mip level (index 0 is the finest) and draws strokes on them. It is kept from column to
 * column, because darker columns contain the strokes of lighter ones. For placement and for measurements. */
#ifndef HATCH_PLACEMENT_CANVAS_H
#define HATCH_PLACEMENT_CANVAS_H

#include "stroke/footprint.h"
#include "placement/style.h"

struct hatch_canvas_options {
    const struct hatch_style *style; /* kept by reference */
    const struct hatch_brush *brush; /* kept by reference */
    uint32_t size_px;                /* width and height of the finest level, a power of two */
    uint32_t levels;                 /* number of drawn levels */
    bool color;                      /* also keep R, G and B */
    bool ids;                        /* also keep the channels id and t */
};

struct hatch_canvas {
    const struct hatch_style *style;
    const struct hatch_brush *brush;
    uint32_t size_px, levels;
    float *paper[HATCH_MIP_LEVELS_MAX]; /* reflectance per pixel of each level, 1 = paper; in colour the mean of rgb */
    float *rgb[HATCH_MIP_LEVELS_MAX];   /* R, G and B of each pixel; NULL without colour */
    double darkness[HATCH_MIP_LEVELS_MAX]; /* 1 - mean reflectance of each level */
    float *id[HATCH_MIP_LEVELS_MAX];       /* id of the first stroke drawn on each pixel; 0: none; NULL without ids */
    float *along[HATCH_MIP_LEVELS_MAX];    /* position along that stroke, 0 .. 1; NULL without ids */
    struct hatch_footprint footprint;      /* footprint of the stroke drawn or tried last */
    float *change;                         /* loss of reflectance per pixel of footprint, in colour the mean of three */
    struct hatch_footprint before;         /* scratch: footprint of a growing stroke at its previous size */
};

/* Makes a canvas of white paper.
 *   canvas  out, in arena */
enum hatch_status hatch_canvas_make(const struct hatch_canvas_options *options, struct hatch_arena *arena,
                                    struct hatch_canvas *canvas, struct hatch_err *err) HATCH_MUST_USE;

/* Returns the width and height of a level. */
static inline uint32_t hatch_canvas_size(const struct hatch_canvas *canvas, uint32_t level)
{
    return canvas->size_px >> level;
}

/* Returns the darkness that the stroke would add to the mean of the level. Fills footprint and change, but draws
 * nothing.
 *   scale  0 .. 1: share of the stroke's full length; its width scales by (1 + scale) / 2 */
double hatch_canvas_try(struct hatch_canvas *canvas, const struct hatch_stroke *stroke, uint32_t level, float scale);

/* Draws the stroke. Fills footprint and change.
 *   scale_before  scale at which it is already drawn; 0: not drawn yet
 *   scale         as for hatch_canvas_try */
void hatch_canvas_draw(struct hatch_canvas *canvas, const struct hatch_stroke *stroke, uint32_t level,
                       float scale_before, float scale);

#endif
