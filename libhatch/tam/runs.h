/* The rows of a grey map along tone, run-length encoded: what thresholds and exact runs are made of.
 * Private to tam. */
#ifndef HATCH_TAM_RUNS_H
#define HATCH_TAM_RUNS_H

#include "base/parallel.h"
#include "tam/tam.h"

/* From column on, the texel has that darkness, of 255. */
struct hatch_run {
    uint8_t column, darkness;
};

/* Texel i of a level has the runs first[level][i] .. first[level][i + 1] - 1, rising in column and in
 * darkness; first[] has an entry more than texels. Levels follow one another, the finest first. */
struct hatch_runs {
    uint32_t level_count, count;
    uint32_t *first[HATCH_MIP_LEVELS_MAX];
    struct hatch_run *runs;
};

/* HATCH_BAD_INPUT for a coloured map and where a texel gets lighter, as hatch_tam_check_nesting says;
 * by a single step of 8 bits it may, and stays as dark then. HATCH_LIMIT at 2^32 runs. arena
 * and scratch are two. */
enum hatch_status hatch_runs_make(const struct hatch_tam *tam, struct hatch_pool *pool, struct hatch_arena *arena,
                                  struct hatch_arena *scratch, struct hatch_runs *runs,
                                  struct hatch_err *err) HATCH_MUST_USE;

#endif
