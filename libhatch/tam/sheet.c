#include "tam/sheet.h"

#include <assert.h>

#define GAP_PX 8u
#define BACKGROUND 0.6f

/* Returns the first pixel row of a level in the sheet. */
static uint32_t level_top(const struct hatch_tam_sheet_options *options, uint32_t level)
{
    uint32_t y = GAP_PX;
    for (uint32_t l = options->levels - 1; l > level; l--)
        y += hatch_mip_size(options->size_px, l) + GAP_PX;
    return y;
}

/* Returns the index of the tone that a column of the sheet shows. */
static uint32_t shown_tone(const struct hatch_tam_sheet_options *options, uint32_t slot)
{
    if (options->shown == options->tones)
        return slot;
    return (uint32_t)((uint64_t)(slot + 1) * options->tones / options->shown) - 1;
}

enum hatch_status hatch_tam_sheet_make(const struct hatch_tam_sheet_options *options, struct hatch_arena *arena,
                                       struct hatch_tam_sheet *sheet, struct hatch_err *err)
{
    assert(options->shown >= 1 && options->shown <= options->tones && options->levels >= 1);
    struct hatch_tam_sheet made = {.options = *options};
    uint32_t width = options->shown * (options->size_px + GAP_PX) + GAP_PX;
    uint32_t height = level_top(options, 0) + options->size_px + GAP_PX;
    HATCH_TRY(hatch_image_make(arena, width, height, options->color ? "RGB" : "Y", &made.picture, err));
    size_t floats = (size_t)width * height * made.picture.channel_count;
    for (size_t i = 0; i < floats; i++)
        made.picture.pixels[i] = BACKGROUND;
    *sheet = made;
    return HATCH_OK;
}

static void copy_level(struct hatch_tam_sheet *sheet, uint32_t slot, uint32_t level, const struct hatch_image *image)
{
    uint32_t channels = sheet->picture.channel_count, size_px = sheet->options.size_px;
    uint32_t left = GAP_PX + slot * (size_px + GAP_PX) + (size_px - image->width) / 2;
    uint32_t top = level_top(&sheet->options, level);
    for (uint32_t y = 0; y < image->height; y++)
        for (uint32_t x = 0; x < image->width; x++)
            for (uint32_t c = 0; c < channels; c++)
                sheet->picture.pixels[((size_t)(top + y) * sheet->picture.width + left + x) * channels + c] =
                    image->pixels[((size_t)y * image->width + x) * image->channel_count + c];
}

void hatch_tam_sheet_add(struct hatch_tam_sheet *sheet, uint32_t tone, const struct hatch_mipmap *column)
{
    for (uint32_t slot = 0; slot < sheet->options.shown; slot++)
        if (shown_tone(&sheet->options, slot) == tone)
            for (uint32_t level = 0; level < sheet->options.levels; level++)
                copy_level(sheet, slot, level, &column->levels[level]);
}
