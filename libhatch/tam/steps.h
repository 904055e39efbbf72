/* Steps of threshold textures: the tone at which a texel darkens and by how much, both in 8 bits.
 * Private to tam. */
#ifndef HATCH_TAM_STEPS_H
#define HATCH_TAM_STEPS_H

#include <math.h>

#include "tam/runs.h"

struct hatch_step {
    uint32_t x;      /* tone code, 0 .. 255 */
    uint32_t height; /* added darkness, 1 .. 255 */
};

/* Computes the tone code at which each column begins: half-way from the column before it, rounded to nearest and
 * ties down, so that sampling at the tone of a column yields its image.
 *   code  out: one entry per column */
static inline void hatch_step_codes(const struct hatch_tam *tam, uint8_t *code)
{
    for (uint32_t c = 0; c < tam->tones; c++) {
        double before = c ? (double)tam->target[c - 1] : 0;
        double middle = (before + (double)tam->target[c]) / 2 * 255;
        code[c] = (uint8_t)fmax(0, ceil(middle - 0.5 - 1e-3));
    }
}

/* Lists the steps of a texel and returns their number.
 *   code   from hatch_step_codes
 *   texel  index in the level
 *   steps  out: room for one per column of the map */
static inline uint32_t hatch_steps_of_texel(const struct hatch_runs *runs, const uint8_t *code, uint32_t level,
                                            size_t texel, struct hatch_step *steps)
{
    const struct hatch_run *run = runs->runs + runs->first[level][texel];
    uint32_t count = runs->first[level][texel + 1] - runs->first[level][texel], before = 0;
    for (uint32_t i = 0; i < count; i++) {
        steps[i] = (struct hatch_step){code[run[i].column], run[i].darkness - before};
        before = run[i].darkness;
    }
    return count;
}

/* Converts bin borders to tone codes: bin b has the codes first[b] .. first[b + 1] - 1.
 *   border  bins + 1 tones
 *   first   out: bins + 1 entries */
static inline void hatch_bin_codes(const float *border, uint32_t bins, uint32_t *first)
{
    for (uint32_t b = 0; b <= bins; b++)
        first[b] = b < bins ? (uint32_t)ceil((double)border[b] * 255 - 1e-3) : 256;
}

/* Fits bin borders to the steps of a map by dynamic programming over the tone codes. They minimise the expected
 * error of merging the steps of a bin and of interpolating between neighbouring texels.
 *   bins    1 .. HATCH_THRESHOLD_BINS
 *   border  out: bins + 1 tones from 0 to 1, rising
 * HATCH_LIMIT when memory does not suffice. */
enum hatch_status hatch_steps_fit(const struct hatch_tam *tam, const struct hatch_runs *runs, uint32_t bins,
                                  struct hatch_arena *scratch, float *border, struct hatch_err *err) HATCH_MUST_USE;

#endif
