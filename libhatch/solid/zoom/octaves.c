/* The sum of octaves that the infinite zoom reads. */
#include <assert.h>
#include <math.h>
#include <stdbool.h>

#include "image/color.h"
#include "solid/zoom/axes.h"
#include "solid/zoom/ranks.h"

void hatch_zoom_weights(double s, double weights[HATCH_ZOOM_OCTAVES])
{
    weights[0] = s / 2;
    weights[1] = 0.5 - s / 6;
    weights[2] = 1.0 / 3 - s / 6;
    weights[3] = (1 - s) / 6;
}

/* How texels of A along an axis are interpolated between those of an octave of T. */
struct taps {
    uint32_t *first, *second; /* per texel of A */
    float *share;             /* of the second */
};

/* An octave of T, at the mip level whose texels are at least as large as those of A. */
struct octave {
    const uint8_t *texels;
    uint32_t size;
    bool flat;
    float weight;
    struct taps taps; /* the same along each axis */
};

struct summing {
    const struct octave *octaves; /* 3 */
    const struct hatch_solid *out;
    float *rows; /* 2 * out->size * channels floats per slice */
};

static enum hatch_status make_octave(const struct hatch_texels *mips, uint32_t size, uint32_t index, double weight,
                                     struct hatch_arena *arena, struct octave *octave, struct hatch_err *err)
{
    uint32_t level = 0;
    while (level + 1 < mips->level_count && ((mips->width >> level) << index) > size)
        level++;
    *octave =
        (struct octave){mips->texels[level], mips->width >> level, mips->depth == 1, (float)weight, {NULL, NULL, NULL}};
    HATCH_TRY(HATCH_ALLOC(arena, &octave->taps.first, size, err));
    HATCH_TRY(HATCH_ALLOC(arena, &octave->taps.second, size, err));
    HATCH_TRY(HATCH_ALLOC(arena, &octave->taps.share, size, err));
    for (uint32_t i = 0; i < size; i++) {
        double at = (i + 0.5) / size * (1u << index) * octave->size - 0.5;
        double below = floor(at);
        octave->taps.first[i] = (uint32_t)((int64_t)below + octave->size) % octave->size;
        octave->taps.second[i] = (octave->taps.first[i] + 1) % octave->size;
        octave->taps.share[i] = (float)(at - below);
    }
    return HATCH_OK;
}

/* Interpolates a row of an octave along y and z. */
static void mix_row(const struct octave *octave, uint32_t channels, uint32_t y, uint32_t z, float *row)
{
    const struct taps *taps = &octave->taps;
    size_t width = (size_t)octave->size * channels;
    float down = taps->share[y], deep = octave->flat ? 0 : taps->share[z];
    const float weights[4] = {(1 - down) * (1 - deep), down * (1 - deep), (1 - down) * deep, down * deep};
    const uint32_t slices[2] = {octave->flat ? 0 : taps->first[z], octave->flat ? 0 : taps->second[z]};
    const uint32_t rows[4] = {slices[0] * octave->size + taps->first[y], slices[0] * octave->size + taps->second[y],
                              slices[1] * octave->size + taps->first[y], slices[1] * octave->size + taps->second[y]};
    for (size_t i = 0; i < width; i++)
        row[i] = 0;
    for (int k = 0; k < 4; k++) {
        const uint8_t *from = octave->texels + rows[k] * width;
        for (size_t i = 0; i < width && weights[k] > 0; i++)
            row[i] += weights[k] * (float)from[i];
    }
}

static void add_row(const struct octave *octave, uint32_t size, uint32_t channels, const float *row, float *sum)
{
    const struct taps *taps = &octave->taps;
    for (uint32_t x = 0; x < size; x++) {
        const float *first = row + taps->first[x] * channels, *second = row + taps->second[x] * channels;
        for (uint32_t c = 0; c < channels; c++)
            sum[x * channels + c] += octave->weight * (first[c] + taps->share[x] * (second[c] - first[c]));
    }
}

/* Fills a slice of A. */
static void sum_slice(void *context, uint32_t z)
{
    const struct summing *summing = context;
    uint32_t size = summing->out->size, channels = summing->out->channels;
    size_t width = (size_t)size * channels;
    float *row = summing->rows + 2 * width * z, *sum = row + width;
    uint8_t *texels = summing->out->texels + (size_t)z * size * width;
    for (uint32_t y = 0; y < size; y++, texels += width) {
        for (size_t i = 0; i < width; i++)
            sum[i] = 0.5f;
        for (int k = 0; k < 3; k++) {
            mix_row(&summing->octaves[k], channels, y, z, row);
            add_row(&summing->octaves[k], size, channels, row, sum);
        }
        for (size_t i = 0; i < width; i++)
            texels[i] = (uint8_t)sum[i];
    }
}

static enum hatch_status sum_octaves(const struct hatch_solid *solid, uint32_t size, enum hatch_zoom_blend blend,
                                     struct hatch_pool *pool, struct hatch_arena *arena, struct hatch_arena *scratch,
                                     struct hatch_solid *out, struct hatch_err *err)
{
    double weights[HATCH_ZOOM_OCTAVES]; /* at the beginning of a cycle, where the first is 0 */
    struct hatch_texels mips;
    struct octave octaves[3];
    struct summing summing = {octaves, out, NULL};
    HATCH_TRY(hatch_solid_make_like(arena, solid, size, solid->channels, out, err));
    HATCH_TRY(hatch_solid_mips(solid, scratch, &mips, err));
    hatch_zoom_weights(0, weights);
    for (uint32_t i = 0; i < 3; i++) {
        double weight = blend == HATCH_ZOOM_UNION ? i == 0 : weights[i + 1];
        HATCH_TRY(make_octave(&mips, size, i, weight, scratch, &octaves[i], err));
    }
    HATCH_TRY(HATCH_ALLOC_UNSET(scratch, &summing.rows, 2 * (size_t)size * out->depth * solid->channels, err));
    hatch_parallel_for(pool, out->depth, sum_slice, &summing);
    return HATCH_OK;
}

static enum hatch_status make_grey(const struct hatch_solid *solid, struct hatch_arena *arena, struct hatch_solid *out,
                                   struct hatch_err *err)
{
    HATCH_TRY(hatch_solid_make_like(arena, solid, solid->size, 1, out, err));
    for (size_t i = 0; i < hatch_solid_count(solid); i++) {
        float rgb[3];
        for (size_t c = 0; c < 3; c++)
            rgb[c] = (float)solid->texels[3 * i + c] / 255.0f;
        out->texels[i] = hatch_unorm8(hatch_color_luminance(rgb));
    }
    return HATCH_OK;
}

enum hatch_status hatch_zoom_make(const struct hatch_solid *solid, uint32_t size, bool grey,
                                  enum hatch_zoom_blend blend, struct hatch_pool *pool, struct hatch_arena *arena,
                                  struct hatch_arena *scratch, struct hatch_zoom *zoom, struct hatch_err *err)
{
    assert(size >= HATCH_SOLID_SIZE_MIN && size <= 4 * solid->size && (size & (size - 1)) == 0);
    struct hatch_arena_mark mark = hatch_arena_mark(scratch);
    struct hatch_zoom made = {.axes = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
    enum hatch_status status = HATCH_OK;
    if (solid->channels == 3)
        status = grey ? make_grey(solid, arena, &made.base, err) : hatch_zoom_turn(solid, arena, &made, err);
    else
        made.base = *solid;
    if (status == HATCH_OK && blend == HATCH_ZOOM_UNION && made.base.channels == 1)
        status = hatch_zoom_rank(&made.base, pool, arena, scratch, err);
    if (status == HATCH_OK)
        status = sum_octaves(&made.base, size, blend, pool, arena, scratch, &made.octaves, err);
    hatch_arena_rewind(scratch, mark);
    if (status == HATCH_OK)
        *zoom = made;
    return status;
}
