/* Measurements of a tonal art map: tone, nesting, seams, evenness; hatchstat(1) has the formulas. */
#ifndef HATCH_MEASURE_TAM_FIGURES_H
#define HATCH_MEASURE_TAM_FIGURES_H

#include "stroke/stroke.h"
#include "placement/style.h"
#include "tam/tam.h"

#define HATCH_EVENNESS_BOXES 4u

/* Sides of the evenness boxes: the image's size divided by 32, 16, 8 and 4. */
extern const uint32_t hatch_evenness_divisors[HATCH_EVENNESS_BOXES];

struct hatch_tam_image_figures {
    uint32_t size_px;
    double mean;             /* darkness: 1 - mean reflectance of all colour channels */
    double error;            /* mean - target */
    uint64_t lighter_pixels; /* pixels lighter than in the previous column: violations of nesting */
    double seam_z[2]; /* mean jump across the tile's border, less the mean of the jumps between adjacent columns [0] or
                         rows [1], in standard deviations of these jumps; 0 where all are equal */
    double chroma;    /* of the image's mean; NaN in grey maps */
    double hue_error_deg; /* angle to the hue of the tone's finest image; NaN in grey maps and where either
                             chroma is at most HATCH_COLOR_CHROMA_MIN */
    double spread[HATCH_EVENNESS_BOXES]; /* standard deviation of the box-blurred image; 0 when the box is smaller
                                            than a pixel */
};

/* Computes the spreads of an image's first channel.
 *   spread  out: HATCH_EVENNESS_BOXES numbers */
enum hatch_status hatch_measure_spreads(const struct hatch_image *image, struct hatch_arena *scratch, double *spread,
                                        struct hatch_err *err) HATCH_MUST_USE;

/* Measures one image of a map.
 *   level  any level of the column, whether drawn with strokes or filtered */
enum hatch_status hatch_measure_tam_image(const struct hatch_tam *tam, uint32_t tone, uint32_t level,
                                          struct hatch_arena *scratch, struct hatch_tam_image_figures *figures,
                                          struct hatch_err *err) HATCH_MUST_USE;

/* The strokes of a map, with everything that is needed to draw them. */
struct hatch_tam_strokes {
    const struct hatch_stroke_list *list; /* their column and level must be set */
    const struct hatch_style *style;
    const struct hatch_brush *brush;
    float growth; /* as in the map's options */
};

/* Checks nesting stroke by stroke: counts how often a stroke is missing from the images that should first hold it, one
 * on each of its levels. It is missing when a pixel of its footprint is lighter than the stroke alone would make it
 * and rounding by the map's tolerance. That darker columns contain it follows from lighter_pixels being 0.
 * HATCH_BAD_INPUT for a stroke of a column or level that the map does not have. */
enum hatch_status hatch_measure_tam_nesting(const struct hatch_tam *tam, const struct hatch_tam_strokes *strokes,
                                            struct hatch_arena *scratch, uint64_t *missing,
                                            struct hatch_err *err) HATCH_MUST_USE;

/* Computes the darkness that a stroke adds to white paper at a level, the mean over all strokes. */
enum hatch_status hatch_measure_stroke_darkness(const struct hatch_tam *tam, const struct hatch_tam_strokes *strokes,
                                                uint32_t level, struct hatch_arena *scratch, double *darkness,
                                                struct hatch_err *err) HATCH_MUST_USE;

/* Computes the evenness of each tone's finest image: its spread divided by the root mean square spread of drawings of
 * the same strokes at random positions.
 *   draws  number of random drawings, at least 1
 *   ratio  out: [tone * HATCH_EVENNESS_BOXES + box]; 1 is random, lower is more even */
enum hatch_status hatch_measure_evenness(const struct hatch_tam *tam, const struct hatch_tam_strokes *strokes,
                                         uint32_t draws, struct hatch_arena *scratch, double *ratio,
                                         struct hatch_err *err) HATCH_MUST_USE;

#endif
