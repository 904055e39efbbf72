#include "synthesis/exemplar.h"

#include <assert.h>

#include "filter/pyramid.h"
#include "image/texels.h"

/* Copies the middle of a picture, with one channel or three, clamped to 0 .. 1. */
static void copy_middle(const struct hatch_image *picture, struct hatch_image *middle)
{
    uint32_t left = (picture->width - middle->width) / 2, top = (picture->height - middle->height) / 2;
    for (uint32_t y = 0; y < middle->height; y++)
        for (uint32_t x = 0; x < middle->width; x++)
            for (uint32_t c = 0; c < middle->channel_count; c++) {
                size_t from = (size_t)(top + y) * picture->width + left + x;
                float value = picture->pixels[from * picture->channel_count + c];
                value = value > 0 ? value : 0;
                middle->pixels[((size_t)y * middle->width + x) * middle->channel_count + c] = value < 1 ? value : 1;
            }
}

static uint32_t min_u32(uint32_t a, uint32_t b)
{
    return a < b ? a : b;
}

/* Halves a picture several times. The channels stay those of the picture. */
static enum hatch_status halve(const struct hatch_image *picture, uint32_t halvings, struct hatch_arena *scratch,
                               struct hatch_image *halved, struct hatch_err *err)
{
    *halved = *picture;
    for (uint32_t h = 0; h < halvings; h++) {
        struct hatch_image next = *halved;
        next.width = hatch_mip_size(halved->width, 1);
        next.height = hatch_mip_size(halved->height, 1);
        size_t count = (size_t)next.width * next.height * next.channel_count;
        HATCH_TRY(HATCH_ALLOC_UNSET(scratch, &next.pixels, count, err));
        hatch_image_halve(halved, &next);
        *halved = next;
    }
    return HATCH_OK;
}

enum hatch_status hatch_synthesis_exemplar(const struct hatch_image *picture, uint32_t size, struct hatch_arena *arena,
                                           struct hatch_arena *scratch, struct hatch_image *exemplar,
                                           struct hatch_synthesis_figures *figures, struct hatch_err *err)
{
    const uint32_t side_max = min_u32(2 * size < 128 ? 128 : 2 * size, HATCH_SYNTHESIS_EXEMPLAR_MAX);
    uint32_t halvings = 0;
    while (hatch_mip_size(min_u32(picture->width, picture->height), halvings) > side_max)
        halvings++;
    const uint32_t whole_width = hatch_mip_size(picture->width, halvings), width = min_u32(whole_width, side_max);
    const uint32_t whole_height = hatch_mip_size(picture->height, halvings), height = min_u32(whole_height, side_max);
    struct hatch_image halved, middle;
    HATCH_TRY(hatch_image_make(arena, width, height, picture->channel_count < 3 ? "Y" : "RGB", &middle, err));
    struct hatch_arena_mark mark = hatch_arena_mark(scratch);
    enum hatch_status status = halve(picture, halvings, scratch, &halved, err);
    if (status == HATCH_OK)
        copy_middle(&halved, &middle);
    hatch_arena_rewind(scratch, mark);
    HATCH_TRY(status);
    *exemplar = middle;
    figures->width = width;
    figures->height = height;
    figures->halvings = halvings;
    figures->cropped = width < whole_width || height < whole_height;
    return HATCH_OK;
}

enum hatch_status hatch_exemplar_make(const struct hatch_image *image, uint32_t side, struct hatch_arena *arena,
                                      struct hatch_exemplar *exemplar, struct hatch_err *err)
{
    struct hatch_exemplar made = {image->width, image->height, image->channel_count, side, 0, 0, NULL};
    assert(image->width <= HATCH_EXEMPLAR_PITCH && image->height <= HATCH_EXEMPLAR_PITCH);
    assert(side >= 1 && side <= image->width && side <= image->height);
    made.across = image->width - side + 1;
    made.down = image->height - side + 1;
    size_t row = (size_t)HATCH_EXEMPLAR_PITCH * made.channels, used = (size_t)image->width * made.channels;
    HATCH_TRY(HATCH_ALLOC(arena, &made.pixels, row * made.height, err));
    for (uint32_t y = 0; y < made.height; y++)
        for (size_t i = 0; i < used; i++)
            made.pixels[y * row + i] = hatch_unorm8(image->pixels[y * used + i]);
    *exemplar = made;
    return HATCH_OK;
}

uint32_t hatch_exemplar_distance(const struct hatch_exemplar *exemplar, const int16_t *values, uint32_t match,
                                 uint32_t enough)
{
    const uint8_t *from = exemplar->pixels + (size_t)match * exemplar->channels;
    const uint32_t row = exemplar->side * exemplar->channels;
    uint32_t sum = 0;
    for (uint32_t j = 0; j < exemplar->side && sum < enough; j++) {
        int32_t squares = 0;
        for (uint32_t i = 0; i < row; i++) {
            int32_t d = values[i] - (from[i] - 128);
            squares += d * d;
        }
        sum += (uint32_t)squares;
        values += row;
        from += (size_t)HATCH_EXEMPLAR_PITCH * exemplar->channels;
    }
    return sum;
}
