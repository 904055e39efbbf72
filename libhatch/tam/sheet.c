#include "tam/sheet.h"

#include <assert.h>

#define GAP_PX 8u
#define GROUND 0.6f

/* The row of the sheet at which a level begins. */
static uint32_t top_of(const struct hatch_tam_sheet *sheet, uint32_t level)
{
    uint32_t y = GAP_PX;
    for (uint32_t l = sheet->levels - 1; l > level; l--)
        y += hatch_mip_size(sheet->size_px, l) + GAP_PX;
    return y;
}

/* The tone that stands in a place of the sheet. */
static uint32_t tone_at(const struct hatch_tam_sheet *sheet, uint32_t place)
{
    if (sheet->shown == sheet->tones)
        return place;
    return (uint32_t)((uint64_t)(place + 1) * sheet->tones / sheet->shown) - 1;
}

enum hatch_status hatch_tam_sheet_make(uint32_t size_px, uint32_t levels, uint32_t tones, bool color, uint32_t shown,
                                       struct hatch_arena *arena, struct hatch_tam_sheet *sheet, struct hatch_err *err)
{
    assert(shown >= 1 && shown <= tones && levels >= 1);
    struct hatch_tam_sheet made = {.size_px = size_px, .levels = levels, .tones = tones, .shown = shown};
    uint32_t width = shown * (size_px + GAP_PX) + GAP_PX, height = top_of(&made, 0) + size_px + GAP_PX;
    HATCH_TRY(hatch_image_make(arena, width, height, color ? "RGB" : "Y", &made.picture, err));
    size_t floats = (size_t)width * height * made.picture.channel_count;
    for (size_t i = 0; i < floats; i++)
        made.picture.pixels[i] = GROUND;
    *sheet = made;
    return HATCH_OK;
}

static void copy_level(struct hatch_tam_sheet *sheet, uint32_t place, uint32_t level, const struct hatch_image *image)
{
    uint32_t channels = sheet->picture.channel_count;
    uint32_t left = GAP_PX + place * (sheet->size_px + GAP_PX) + (sheet->size_px - image->width) / 2;
    uint32_t top = top_of(sheet, level);
    for (uint32_t y = 0; y < image->height; y++)
        for (uint32_t x = 0; x < image->width; x++)
            for (uint32_t c = 0; c < channels; c++)
                sheet->picture.pixels[((size_t)(top + y) * sheet->picture.width + left + x) * channels + c] =
                    image->pixels[((size_t)y * image->width + x) * image->channel_count + c];
}

void hatch_tam_sheet_add(struct hatch_tam_sheet *sheet, uint32_t tone, const struct hatch_mipmap *column)
{
    for (uint32_t place = 0; place < sheet->shown; place++)
        if (tone_at(sheet, place) == tone)
            for (uint32_t level = 0; level < sheet->levels; level++)
                copy_level(sheet, place, level, &column->levels[level]);
}
