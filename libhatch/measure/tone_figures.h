/* Errors of tone: compares a volume, threshold textures, exact runs or a map of few columns with a map of many columns.
 * Both are sampled as by a shader, at random places over all tones; hatchstat(1) has the formulas. */
#ifndef HATCH_MEASURE_TONE_FIGURES_H
#define HATCH_MEASURE_TONE_FIGURES_H

#include "base/parallel.h"
#include "tam/tam.h"

#define HATCH_TONES_MEASURED 64u

/* Returns the reflectance at (u, v).
 *   tone  0 .. 1
 *   lod   level of detail, 0 = finest */
typedef float (*hatch_tone_sample)(const void *subject, float u, float v, float tone, float lod);

/* Samples a map: blends the two columns around the tone, where paper is a column of tone 0.
 *   subject  a struct hatch_tam */
float hatch_tone_sample_map(const void *subject, float u, float v, float tone, float lod);

/* S is the darkness of the subject, M that of the map; columns are those of the map around the tone. */
struct hatch_tone_figures {
    double tone_error; /* mean over tones of |mean of S - M| */
    double tone_worst; /* largest of these over tones */
    double error;      /* mean of |S - M| */
    double error_max;
    double grey;     /* share of the inked samples that are grey and differ from both columns; NaN if there are none */
    double grey_all; /* share of the inked samples that are grey */
};

struct hatch_tone_test {
    const struct hatch_tam *map;
    hatch_tone_sample sample; /* called on several threads */
    const void *subject;      /* argument of sample */
    float lod;                /* level of detail, 0 = finest */
    uint64_t samples;         /* at least 1; divided among HATCH_TONES_MEASURED tones */
};

/* Compares a subject with a map. The result does not depend on the number of threads.
 *   pool  NULL: on the caller's thread */
enum hatch_status hatch_measure_tones(const struct hatch_tone_test *test, struct hatch_pool *pool,
                                      struct hatch_arena *scratch, struct hatch_tone_figures *figures,
                                      struct hatch_err *err) HATCH_MUST_USE;

#endif
