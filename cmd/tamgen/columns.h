/* The finished columns of a tonal art map on their way into a file: compressed on other threads while
 * the next column is filled. */
#ifndef HATCH_TAMGEN_COLUMNS_H
#define HATCH_TAMGEN_COLUMNS_H

#include "base/parallel.h"
#include "io/exr/exr.h"
#include "tam/sheet.h"

struct column_copy;

struct columns {
    struct hatch_arena *arena;
    struct hatch_pool *pool;
    uint32_t tones;
    struct hatch_tam_sheet *sheet;   /* or NULL */
    struct hatch_exr_writer *writer; /* made for the first column */
    struct column_copy *copies;
    uint32_t copy_count;
    uint32_t done; /* columns received */
};

/* Takes one column: a hatch_tam_sink; context is a struct columns. */
enum hatch_status columns_take(void *context, uint32_t tone, const struct hatch_mipmap *column,
                               struct hatch_err *err) HATCH_MUST_USE;

/* Waits for the other threads and tells the file's bytes: those of head, then those of pieces[tones], which live
 * until hatch_exr_abandon(columns->writer). */
enum hatch_status columns_finish(struct columns *columns, struct hatch_buffer *head, struct hatch_bytes *pieces,
                                 struct hatch_err *err) HATCH_MUST_USE;

#endif
