/* Run-length encoding of a grey map along tone, the source of threshold textures and exact runs.
 * Private to tam. */
#ifndef HATCH_TAM_RUNS_H
#define HATCH_TAM_RUNS_H

#include "base/parallel.h"
#include "tam/tam.h"

/* A run: the texel has this darkness, 0 .. 255, from this column on until the next run. */
struct hatch_run {
    uint8_t column, darkness;
};

/* Texel i of a level has the runs first[level][i] .. first[level][i + 1] - 1; columns and darknesses rise over
 * them. Runs are ordered by level, the finest first. */
struct hatch_runs {
    uint32_t level_count, count;
    uint32_t *first[HATCH_MIP_LEVELS_MAX]; /* one entry per texel, and a last one for the end */
    struct hatch_run *runs;                /* count entries */
};

/* Encodes all levels of a map. A texel that gets lighter by one step of 8 bits keeps the darker value.
 *   pool   NULL: one thread
 *   arena  receives the runs; not the same as scratch
 *   runs   out; unchanged on failure
 * HATCH_BAD_INPUT for a map in colour and where a texel gets lighter by more (hatch_tam_check_nesting); HATCH_LIMIT
 * for 2^32 runs or more, or when memory does not suffice. */
enum hatch_status hatch_runs_make(const struct hatch_tam *tam, struct hatch_pool *pool, struct hatch_arena *arena,
                                  struct hatch_arena *scratch, struct hatch_runs *runs,
                                  struct hatch_err *err) HATCH_MUST_USE;

#endif
