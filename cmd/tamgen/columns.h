/* Writes the columns of a tonal art map to a file, compressed on other threads while the next column is filled. */
#ifndef TAMGEN_COLUMNS_H
#define TAMGEN_COLUMNS_H

#include "base/parallel.h"
#include "io/exr/exr.h"
#include "tam/sheet.h"

struct column_copy;

struct columns {
    struct hatch_arena *arena;
    struct hatch_pool *pool;
    uint32_t tones;                  /* number of columns */
    uint32_t levels;                 /* number of drawn levels */
    double tolerance;                /* by which reflectance is rounded, hatch_tam_round; 0: it is not */
    struct hatch_tam_sheet *sheet;   /* receives the columns; NULL: none */
    struct hatch_exr_writer *writer; /* made with the first column */
    struct hatch_mipmap rounded;     /* the last column; used if columns are rounded */
    struct column_copy *copies;
    uint32_t copy_count;
    uint32_t done; /* number of columns received */
};

/* Takes one column; has the type of take in struct hatch_tam_sink.
 *   context  struct columns */
enum hatch_status columns_take(void *context, uint32_t tone, const struct hatch_mipmap *column,
                               struct hatch_err *err) HATCH_MUST_USE;

/* Waits for the other threads and returns the file.
 *   head    out: first bytes of the file
 *   pieces  out: the rest of the file, one piece per column, valid until hatch_exr_abandon(columns->writer) */
enum hatch_status columns_finish(struct columns *columns, struct hatch_buffer *head, struct hatch_bytes *pieces,
                                 struct hatch_err *err) HATCH_MUST_USE;

#endif
