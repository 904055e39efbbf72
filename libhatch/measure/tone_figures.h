/* How well a volume, thresholds, exact runs or a map of few columns show the tones of a map of many, looked
 * at as a shader looks at them: at random places, over tones and levels of detail. hatchstat(1) writes the
 * formulas. */
#ifndef HATCH_MEASURE_TONE_FIGURES_H
#define HATCH_MEASURE_TONE_FIGURES_H

#include "base/parallel.h"
#include "tam/tam.h"

#define HATCH_TONES_MEASURED 64u

/* The reflectance at (u, v), a tone and a level of detail, with what a subject is. */
typedef float (*hatch_tone_sample)(const void *subject, float u, float v, float tone, float lod);

/* A map as such a subject: its two columns around the tone, blended; paper is one of tone 0. subject: a
 * struct hatch_tam. */
float hatch_tone_sample_map(const void *subject, float u, float v, float tone, float lod);

struct hatch_tone_figures {
    double tone_error; /* mean over tones of |mean of darkness - the map's| */
    double tone_worst; /* the largest of a tone */
    double error;      /* mean of |darkness - the map's| */
    double error_max;
    double grey;     /* share of the inked samples that are grey where the map is not */
    double grey_all; /* share of the inked samples that are grey */
};

/* samples: 1 .. ; in all, spread over HATCH_TONES_MEASURED tones. The result does not depend on threads. */
enum hatch_status hatch_measure_tones(const struct hatch_tam *map, hatch_tone_sample sample, const void *subject,
                                      float lod, uint64_t samples, struct hatch_pool *pool, struct hatch_arena *scratch,
                                      struct hatch_tone_figures *figures, struct hatch_err *err) HATCH_MUST_USE;

#endif
