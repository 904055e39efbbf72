/* The figures of a tonal art map: tone, nesting, seams, evenness. hatchstat(1) writes their formulas. */
#ifndef HATCH_MEASURE_TAM_FIGURES_H
#define HATCH_MEASURE_TAM_FIGURES_H

#include "stroke/stroke.h"
#include "placement/style.h"
#include "tam/tam.h"

#define HATCH_EVENNESS_BOXES 4u

/* The box sides of the evenness: the image's size over 32, 16, 8 and 4. */
extern const uint32_t hatch_evenness_divisors[HATCH_EVENNESS_BOXES];

struct hatch_tam_image_figures {
    uint32_t size_px;
    double mean;                         /* darkness: 1 - mean reflectance (of R, G and B where there are three) */
    double error;                        /* mean - target */
    uint64_t lighter_pixels;             /* pixels lighter than in the column before: broken nesting over tones */
    double seam_z[2];                    /* jump across the wrap, in standard deviations of all rows' (columns')
                                            jumps from their mean: [0] left and right, [1] top and bottom */
    double chroma, hue_error_deg;        /* of the mean; the second from that of the tone's finest image. NaN in grey
                                            maps, the second also where either has HATCH_COLOR_CHROMA_MIN or less */
    double spread[HATCH_EVENNESS_BOXES]; /* standard deviation of the box-blurred image; 0 where the box
                                            would be under a pixel */
};

/* The spread alone, of an image's first channel: HATCH_EVENNESS_BOXES numbers. */
enum hatch_status hatch_measure_spreads(const struct hatch_image *image, struct hatch_arena *scratch, double *spread,
                                        struct hatch_err *err) HATCH_MUST_USE;

/* level: 0 .. chain - 1; it need not hold strokes. */
enum hatch_status hatch_measure_tam_image(const struct hatch_tam *tam, uint32_t tone, uint32_t level,
                                          struct hatch_arena *scratch, struct hatch_tam_image_figures *figures,
                                          struct hatch_err *err) HATCH_MUST_USE;

/* Strokes of a map as its generator wrote them, with what draws them again. */
struct hatch_tam_strokes {
    const struct hatch_stroke_list *list; /* with column and level */
    const struct hatch_style *style;
    const struct hatch_brush *brush;
    float growth;
};

/* Nesting by identity: how many times a stroke is missing from an image that must hold it, in the first
 * column that has it and on all its levels: missing where a pixel of its footprint is lighter than the
 * stroke alone would make it. Darker columns follow from lighter_pixels being 0. */
enum hatch_status hatch_measure_tam_nesting(const struct hatch_tam *tam, const struct hatch_tam_strokes *strokes,
                                            struct hatch_arena *scratch, uint64_t *missing,
                                            struct hatch_err *err) HATCH_MUST_USE;

/* The darkness that one stroke of mean length adds to white paper at a level. */
enum hatch_status hatch_measure_stroke_darkness(const struct hatch_tam *tam, const struct hatch_tam_strokes *strokes,
                                                uint32_t level, struct hatch_arena *scratch, double *darkness,
                                                struct hatch_err *err) HATCH_MUST_USE;

/* Evenness of each tone's finest image: its spread over the spread of the same strokes thrown at random
 * places (root mean square of `draws` throws). ratio[tone * HATCH_EVENNESS_BOXES + box]; 1 is random,
 * lower is more even. */
enum hatch_status hatch_measure_evenness(const struct hatch_tam *tam, const struct hatch_tam_strokes *strokes,
                                         uint32_t draws, struct hatch_arena *scratch, double *ratio,
                                         struct hatch_err *err) HATCH_MUST_USE;

#endif
