#include "kept.h"

#include <string.h>

#include "shared/needs/map.h"

enum hatch_status kept_take(void *context, uint32_t tone, const struct hatch_mipmap *column, struct hatch_err *err)
{
    struct kept_columns *kept = context;
    struct hatch_mipmap *to = &kept->columns[tone];
    *to = *column;
    HATCH_TRY(HATCH_ALLOC(kept->arena, &to->levels, column->level_count, err));
    for (uint32_t level = 0; level < column->level_count; level++) {
        const struct hatch_image *from = &column->levels[level];
        size_t floats = (size_t)from->width * from->height * from->channel_count;
        to->levels[level] = *from;
        HATCH_TRY(HATCH_ALLOC_UNSET(kept->arena, &to->levels[level].pixels, floats, err));
        memcpy(to->levels[level].pixels, from->pixels, floats * sizeof *from->pixels);
    }
    return HATCH_OK;
}

/* Takes columns and levels out of a stroke. Returns whether the map still has it.
 *   tones  columns that stay
 *   finer  finest levels that go */
static bool cut_stroke(struct hatch_stroke *stroke, uint32_t tones, uint32_t finer)
{
    if (stroke->level < finer || stroke->column + stroke->delay[finer] >= tones)
        return false;
    const uint8_t first = stroke->delay[finer];
    stroke->column += first;
    stroke->level -= finer;
    for (uint32_t level = 0; level < HATCH_STROKE_LEVELS_MAX; level++)
        stroke->delay[level] = level <= stroke->level ? (uint8_t)(stroke->delay[level + finer] - first) : 0;
    while (stroke->column + stroke->delay[stroke->level] >= tones)
        stroke->delay[stroke->level--] = 0;
    return true;
}

static void cut_strokes(struct hatch_stroke_list *strokes, uint32_t tones, uint32_t finer)
{
    uint32_t kept = 0;
    for (uint32_t i = 0; i < strokes->count; i++)
        if (cut_stroke(&strokes->items[i], tones, finer))
            strokes->items[kept++] = strokes->items[i];
    strokes->count = kept;
}

void kept_pass_on(struct job *job, const char *path, bool all_levels, struct kept_columns *kept)
{
    struct hatch_needs needs;
    struct hatch_err err;
    float targets[HATCH_TAM_TONES_MAX];
    const uint32_t whole_px = job->size_px, whole = job->tones;
    for (uint32_t i = 0; i < whole; i++)
        targets[i] = (float)hatch_mipmap_attribute(&kept->columns[i], HATCH_TAM_ATTR_TONE)->number;
    cmd_read_needs(&job->args, path, &needs);
    const struct cmd_map_part part =
        cmd_find_map_part(&needs, targets, whole, targets[whole - 1], whole_px, all_levels ? 1 : job->levels);
    cut_strokes(&job->strokes, part.tones, part.finer);
    job->tones = part.tones;
    job->tolerance = (float)part.tolerance;
    job->size_px >>= part.finer;
    job->levels -= part.finer;
    begin_columns(job);
    for (uint32_t i = 0; i < job->tones; i++) {
        struct hatch_mipmap *column = &kept->columns[i];
        const struct hatch_tam_metadata metadata = {
            .tones = job->tones,
            .levels = job->levels,
            .seed = hatch_mipmap_attribute(column, HATCH_TAM_ATTR_SEED)->text,
            .style = hatch_mipmap_attribute(column, HATCH_TAM_ATTR_STYLE)->text,
            .growth = (float)hatch_mipmap_attribute(column, HATCH_TAM_ATTR_GROWTH)->number,
            .whole = {whole_px, whole, targets[whole - 1], (float)part.tolerance}};
        column->levels += part.finer;
        column->level_count -= part.finer;
        hatch_tam_set_metadata(&metadata, i, targets[i], column);
        cmd_check(columns_take(&job->columns, i, column, &err), NULL, &err);
    }
}
