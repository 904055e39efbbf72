#include "columns.h"

#include <stdatomic.h>
#include <string.h>

#include "shared/cmd.h"
#include "tam/whole.h"

/* At most 1 / COPIES_DIVISOR of the columns are copied at a time. A copy holds floats, at least twice the size of the
 * column in the file, so that many threads could need more memory for copies than for the map. More copies would not
 * help, since columns are filled slowly. */
#define COPIES_DIVISOR 3u
/* With only one copy per thread, the other threads would idle while the main thread compresses a column itself. */
#define COPIES_PER_THREAD 2u

/* A copy of a column, to be compressed while the canvas already changes. */
struct column_copy {
    struct hatch_exr_writer *writer;
    uint32_t tone;
    struct hatch_mipmap column;
    struct hatch_image levels[HATCH_MIP_LEVELS_MAX];
    atomic_bool busy;
    enum hatch_status status;
    struct hatch_err err;
};

static void compress(void *context, uint32_t index)
{
    struct column_copy *copy = context;
    (void)index;
    copy->status = hatch_exr_add_part(copy->writer, copy->tone, &copy->column, &copy->err);
    atomic_store(&copy->busy, false);
}

/* Makes room for columns of the size of one, which is white. */
static enum hatch_status make_rounded(struct columns *columns, const struct hatch_mipmap *column, struct hatch_err *err)
{
    struct hatch_mipmap *rounded = &columns->rounded;
    HATCH_TRY(HATCH_ALLOC(columns->arena, &rounded->levels, column->level_count, err));
    for (uint32_t level = 0; level < column->level_count; level++) {
        const struct hatch_image *image = &column->levels[level];
        size_t floats = (size_t)image->width * image->height * image->channel_count;
        rounded->levels[level] = *image;
        HATCH_TRY(HATCH_ALLOC_UNSET(columns->arena, &rounded->levels[level].pixels, floats, err));
        for (size_t i = 0; i < floats; i++)
            rounded->levels[level].pixels[i] = 1;
    }
    return HATCH_OK;
}

/* Returns a column after rounding: columns->rounded. */
static const struct hatch_mipmap *round_column(struct columns *columns, const struct hatch_mipmap *column)
{
    struct hatch_image *levels = columns->rounded.levels;
    hatch_tam_round(column, columns->levels, columns->tolerance, &columns->rounded);
    columns->rounded = *column;
    columns->rounded.levels = levels;
    return &columns->rounded;
}

static enum hatch_status begin(struct columns *columns, const struct hatch_mipmap *column, struct hatch_err *err)
{
    HATCH_TRY(hatch_exr_begin(column, columns->tones, columns->arena, &columns->writer, err));
    if (columns->tolerance > 0)
        HATCH_TRY(make_rounded(columns, column, err));
    uint32_t threads = hatch_pool_threads(columns->pool), most = columns->tones / COPIES_DIVISOR;
    uint32_t useful = threads < 2 ? 0 : threads * COPIES_PER_THREAD;
    columns->copy_count = useful < most ? useful : most;
    HATCH_TRY(HATCH_ALLOC(columns->arena, &columns->copies, columns->copy_count, err));
    for (uint32_t i = 0; i < columns->copy_count; i++) {
        struct column_copy *copy = &columns->copies[i];
        copy->writer = columns->writer;
        for (uint32_t level = 0; level < column->level_count; level++) {
            const struct hatch_image *image = &column->levels[level];
            size_t floats = (size_t)image->width * image->height * image->channel_count;
            HATCH_TRY(HATCH_ALLOC(columns->arena, &copy->levels[level].pixels, floats, err));
        }
    }
    return HATCH_OK;
}

static struct column_copy *free_copy(struct columns *columns)
{
    for (uint32_t i = 0; i < columns->copy_count; i++)
        if (!atomic_load(&columns->copies[i].busy))
            return &columns->copies[i];
    return NULL;
}

static void fill_copy(struct column_copy *copy, uint32_t tone, const struct hatch_mipmap *column)
{
    copy->tone = tone;
    copy->column = *column;
    copy->column.levels = copy->levels;
    for (uint32_t level = 0; level < column->level_count; level++) {
        const struct hatch_image *image = &column->levels[level];
        float *pixels = copy->levels[level].pixels;
        memcpy(pixels, image->pixels, (size_t)image->width * image->height * image->channel_count * sizeof *pixels);
        copy->levels[level] = *image;
        copy->levels[level].pixels = pixels;
    }
}

enum hatch_status columns_take(void *context, uint32_t tone, const struct hatch_mipmap *column, struct hatch_err *err)
{
    struct columns *columns = context;
    if (!columns->writer)
        HATCH_TRY(begin(columns, column, err));
    if (columns->tolerance > 0)
        column = round_column(columns, column);
    if (columns->sheet)
        hatch_tam_sheet_add(columns->sheet, tone, column);
    cmd_progress("columns", (double)++columns->done / columns->tones);
    struct column_copy *copy = free_copy(columns);
    if (!copy) /* all copies are still being compressed */
        return hatch_exr_add_part(columns->writer, tone, column, err);
    if (copy->status != HATCH_OK) {
        *err = copy->err;
        return copy->status;
    }
    fill_copy(copy, tone, column);
    atomic_store(&copy->busy, true);
    hatch_pool_submit(columns->pool, compress, copy);
    return HATCH_OK;
}

enum hatch_status columns_finish(struct columns *columns, struct hatch_buffer *head, struct hatch_bytes *pieces,
                                 struct hatch_err *err)
{
    hatch_pool_wait(columns->pool);
    for (uint32_t i = 0; i < columns->copy_count; i++)
        if (columns->copies[i].status != HATCH_OK) {
            *err = columns->copies[i].err;
            return columns->copies[i].status;
        }
    return hatch_exr_pieces(columns->writer, head, pieces, err);
}
