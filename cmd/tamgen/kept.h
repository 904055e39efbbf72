/* Columns of a drawing, kept until their tones tell which of them views need. */
#ifndef TAMGEN_KEPT_H
#define TAMGEN_KEPT_H

#include "job.h"

struct kept_columns {
    struct hatch_arena *arena;
    struct hatch_mipmap columns[HATCH_TAM_TONES_MAX];
};

/* Keeps a copy of a column; has the type of take in struct hatch_tam_sink.
 *   context  struct kept_columns */
enum hatch_status kept_take(void *context, uint32_t tone, const struct hatch_mipmap *column,
                            struct hatch_err *err) HATCH_MUST_USE;

/* Passes the columns and levels that are needed to job->columns, which it begins. Dies on failure.
 *   path  of the needs */
void kept_pass_on(struct job *job, const char *path, bool all_levels, struct kept_columns *kept);

#endif
