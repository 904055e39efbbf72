/* Steps of thresholds: runs as x and height, both of 255. Private to tam. */
#ifndef HATCH_TAM_STEPS_H
#define HATCH_TAM_STEPS_H

#include <math.h>

#include "tam/runs.h"

struct hatch_step {
    uint32_t x, height;
};

/* The x of each column: half-way to the column before it, the lower code where two are as near, so that a
 * column's image is what comes out at its tone. */
static inline void hatch_step_codes(const struct hatch_tam *tam, uint8_t *code)
{
    for (uint32_t c = 0; c < tam->tones; c++) {
        double before = c ? (double)tam->target[c - 1] : 0;
        double middle = (before + (double)tam->target[c]) / 2 * 255;
        code[c] = (uint8_t)fmax(0, ceil(middle - 0.5 - 1e-3));
    }
}

/* The steps of a texel, of which there are the tones of the map at most; returns how many. */
static inline uint32_t hatch_steps_of(const struct hatch_runs *runs, const uint8_t *code, uint32_t level, size_t texel,
                                      struct hatch_step *steps)
{
    const struct hatch_run *run = runs->runs + runs->first[level][texel];
    uint32_t count = runs->first[level][texel + 1] - runs->first[level][texel], before = 0;
    for (uint32_t i = 0; i < count; i++) {
        steps[i] = (struct hatch_step){code[run[i].column], run[i].darkness - before};
        before = run[i].darkness;
    }
    return count;
}

/* The same borders for codes: bin b has the codes from first[b] to first[b + 1] - 1. */
static inline void hatch_bin_codes(const float *border, uint32_t bins, uint32_t *first)
{
    for (uint32_t b = 0; b <= bins; b++)
        first[b] = b < bins ? (uint32_t)ceil((double)border[b] * 255 - 1e-3) : 256;
}

/* Fits bins + 1 borders to a map's steps: those that make the expected error of merging steps, and of
 * interpolating between neighbours, least, by dynamic programming over the codes. */
enum hatch_status hatch_steps_fit(const struct hatch_tam *tam, const struct hatch_runs *runs, uint32_t bins,
                                  struct hatch_arena *scratch, float *border, struct hatch_err *err) HATCH_MUST_USE;

#endif
