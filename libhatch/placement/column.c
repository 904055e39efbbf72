#include "placement/column.h"

#include <inttypes.h>
#include <stdio.h>

#include "filter/pyramid.h"
#include "stroke/script.h"

enum hatch_status hatch_column_metadata(const struct hatch_style *style, uint32_t tones, uint32_t levels, uint64_t seed,
                                        float growth, struct hatch_arena *arena, struct hatch_tam_metadata *metadata,
                                        struct hatch_err *err)
{
    char text[24];
    int digits = snprintf(text, sizeof text, "%" PRIu64, seed);
    const char *kept = hatch_arena_text(arena, text, (size_t)digits, err);
    if (!kept)
        return HATCH_LIMIT;
    *metadata = (struct hatch_tam_metadata){.tones = tones,
                                            .levels = levels,
                                            .seed = kept,
                                            .style = style->name,
                                            .flat = style->overlap == HATCH_OVERLAP_FLAT,
                                            .growth = growth};
    return HATCH_OK;
}

/* Adds the channels id and t to the image of a level. */
static enum hatch_status join_ids(const struct hatch_canvas *canvas, uint32_t level, struct hatch_arena *scratch,
                                  struct hatch_image *image, struct hatch_err *err)
{
    size_t pixels = (size_t)image->width * image->height;
    uint32_t inks = image->channel_count, channels = inks + 2;
    const float *ink = image->pixels;
    float *joined;
    HATCH_TRY(HATCH_ALLOC(scratch, &joined, channels * pixels, err));
    for (size_t i = 0; i < pixels; i++) {
        for (uint32_t c = 0; c < inks; c++)
            joined[channels * i + c] = ink[inks * i + c];
        joined[channels * i + inks] = canvas->id[level][i];
        joined[channels * i + inks + 1] = canvas->along[level][i];
    }
    image->channel_count = channels;
    image->channels[inks] = (struct hatch_channel){"id", HATCH_UINT};
    image->channels[inks + 1] = (struct hatch_channel){"t", HATCH_FLOAT};
    image->pixels = joined;
    return HATCH_OK;
}

/* Below the drawn levels a pixel mixes several strokes and has no id. */
static void clear_ids(struct hatch_mipmap *column, uint32_t first)
{
    for (uint32_t level = first; level < column->level_count; level++) {
        struct hatch_image *image = &column->levels[level];
        uint32_t channels = image->channel_count;
        for (size_t i = 0; i < (size_t)image->width * image->height; i++)
            image->pixels[channels * i + channels - 2] = image->pixels[channels * i + channels - 1] = 0;
    }
}

static void refer_to_ink(const struct hatch_canvas *canvas, uint32_t level, struct hatch_image *image)
{
    uint32_t size = hatch_canvas_size(canvas, level);
    *image = (struct hatch_image){.width = size, .height = size, .channel_count = 1};
    image->pixels = canvas->paper[level];
    image->channels[0] = (struct hatch_channel){"Y", HATCH_HALF};
    if (!canvas->rgb[level])
        return;
    image->pixels = canvas->rgb[level];
    image->channel_count = 3;
    for (uint32_t c = 0; c < 3; c++)
        image->channels[c] = (struct hatch_channel){{"RGB"[c]}, HATCH_HALF};
}

static enum hatch_status make_column(const struct hatch_canvas *canvas, struct hatch_arena *scratch,
                                     struct hatch_mipmap *column, struct hatch_err *err)
{
    for (uint32_t level = 0; level < canvas->levels; level++) {
        refer_to_ink(canvas, level, &column->levels[level]);
        if (canvas->id[level])
            HATCH_TRY(join_ids(canvas, level, scratch, &column->levels[level], err));
    }
    HATCH_TRY(hatch_mipmap_complete(column, canvas->levels, scratch, err));
    if (canvas->id[0])
        clear_ids(column, canvas->levels);
    return HATCH_OK;
}

enum hatch_status hatch_column_deliver(const struct hatch_canvas *canvas, const struct hatch_tam_metadata *metadata,
                                       uint32_t tone, float target, const struct hatch_stroke_list *strokes,
                                       struct hatch_arena *arena, struct hatch_arena *scratch,
                                       const struct hatch_tam_sink *sink, struct hatch_err *err)
{
    struct hatch_arena_mark mark = hatch_arena_mark(scratch);
    struct hatch_image levels[HATCH_MIP_LEVELS_MAX] = {{0}};
    struct hatch_buffer script = {.arena = arena};
    struct hatch_mipmap column = {.levels = levels};
    hatch_tam_set_metadata(metadata, tone, target, &column);
    if (strokes) {
        HATCH_TRY(hatch_script_print(strokes->items, strokes->count, canvas->size_px, NULL, &script, err));
        HATCH_TRY(hatch_buffer_add(&script, "", 1, err));
        hatch_mipmap_set_text(&column, HATCH_TAM_ATTR_STROKES, (const char *)script.data);
    }
    enum hatch_status status = make_column(canvas, scratch, &column, err);
    if (status == HATCH_OK)
        status = sink->take(sink->context, tone, &column, err);
    hatch_arena_rewind(scratch, mark);
    return status;
}
