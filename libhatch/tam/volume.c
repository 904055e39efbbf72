#include "tam/volume.h"

#include <assert.h>
#include <math.h>

#define PIECE 256u

/* A blend of two columns, where column -1 is paper. */
struct blend {
    int below, above;
    float share; /* weight of above, 0 .. 1 */
};

struct slice {
    uint32_t level, index;
    struct blend blend;
};

struct job {
    const struct hatch_tam *tam;
    const struct hatch_texels *texels;
    const struct slice *slices;
};

static float tone_of(const struct hatch_tam *tam, int column)
{
    return column < 0 ? 0 : tam->target[column];
}

/* Returns the two columns around a tone and their blend at that tone.
 *   distance  out: difference to the tone of the nearer column; 0 beyond the last column */
static struct blend find_columns(const struct hatch_tam *tam, double tone, double *distance)
{
    int above = 0, last = (int)tam->tones - 1;
    while (above <= last && (double)tam->target[above] < tone)
        above++;
    *distance = 0;
    if (above > last)
        return (struct blend){last, last, 0};
    double down = tone - (double)tone_of(tam, above - 1), up = (double)tam->target[above] - tone;
    *distance = fmin(down, up);
    return (struct blend){above - 1, above, (float)(down / (down + up))};
}

/* Chooses the columns of a slice.
 *   step  tones from one slice of the level to the next */
static struct slice choose_slice(const struct hatch_tam *tam, uint32_t level, uint32_t index, double step,
                                 struct hatch_volume_figures *figures)
{
    double distance;
    struct slice slice = {level, index, find_columns(tam, (index + 0.5) * step, &distance)};
    bool drawn = level < tam->levels;
    if (distance <= step / 4) {
        int nearest = slice.blend.share > 0.5f ? slice.blend.above : slice.blend.below;
        slice.blend = (struct blend){nearest, nearest, 0};
    } else if (drawn) {
        figures->blended++;
    }
    figures->slices += drawn;
    if (drawn && distance > figures->distance)
        figures->distance = distance;
    return slice;
}

/* Blends and encodes up to PIECE texels of one channel, in separate loops so that compilers vectorise them.
 *   below, above  every stride-th float; NULL: paper */
static void fill_piece(const float *below, const float *above, float share, size_t stride, size_t count, uint8_t *out,
                       size_t out_stride)
{
    float values[PIECE], others[PIECE];
    uint8_t codes[PIECE];
    for (size_t i = 0; i < count; i++)
        values[i] = below ? below[i * stride] : 1;
    for (size_t i = 0; share > 0 && i < count; i++)
        others[i] = above ? above[i * stride] : 1;
    for (size_t i = 0; share > 0 && i < count; i++)
        values[i] += share * (others[i] - values[i]);
    for (size_t i = 0; i < count; i++)
        codes[i] = hatch_unorm8(values[i]);
    for (size_t i = 0; i < count; i++)
        out[i * out_stride] = codes[i];
}

static void fill_slice(void *context, uint32_t number)
{
    const struct job *job = context;
    const struct slice *slice = &job->slices[number];
    const struct hatch_texels *texels = job->texels;
    size_t count = (size_t)hatch_mip_size(texels->width, slice->level) * hatch_mip_size(texels->height, slice->level);
    size_t stride = job->tam->columns[0].levels[0].channel_count, out_stride = texels->channels;
    uint8_t *out = texels->texels[slice->level] + slice->index * count * out_stride;
    const float *pixels[2];
    const int columns[2] = {slice->blend.below, slice->blend.above};
    for (int i = 0; i < 2; i++)
        pixels[i] = columns[i] < 0 ? NULL : job->tam->columns[columns[i]].levels[slice->level].pixels;
    for (uint32_t c = 0; c < out_stride; c++)
        for (size_t at = 0; at < count; at += PIECE) {
            const float *from[2];
            for (int i = 0; i < 2; i++)
                from[i] = pixels[i] && c < 3 ? pixels[i] + at * stride + c : NULL;
            fill_piece(from[0], from[1], slice->blend.share, stride, count - at < PIECE ? count - at : PIECE,
                       out + at * out_stride + c, out_stride);
        }
}

/* The texels along an axis that a texel of the next level covers, and their parts of it. */
struct cover {
    uint32_t first, count, parts[3];
};

/* Returns those of texel `at`: two texels; of an odd number, three, the outer ones in part; or the only one. */
static struct cover find_cover(uint32_t size, uint32_t at)
{
    uint32_t next = hatch_mip_size(size, 1);
    if (size == 1)
        return (struct cover){0, 1, {1}};
    if (size % 2 == 0)
        return (struct cover){2 * at, 2, {1, 1}};
    return (struct cover){2 * at, 3, {next - at, next, at + 1}};
}

/* Returns the weighted mean of a channel over the texels that a texel of the next level covers.
 *   from  sizes of the level in */
static uint8_t filter_texel(const uint8_t *in, const uint32_t from[3], const struct cover cover[3], uint32_t channels,
                            uint32_t channel)
{
    uint64_t sum = 0, weights = 0;
    for (uint32_t k = 0; k < cover[2].count; k++)
        for (uint32_t j = 0; j < cover[1].count; j++)
            for (uint32_t i = 0; i < cover[0].count; i++) {
                uint64_t weight = (uint64_t)cover[0].parts[i] * cover[1].parts[j] * cover[2].parts[k];
                size_t row = (size_t)(cover[2].first + k) * from[1] + cover[1].first + j;
                sum += weight * in[(row * from[0] + cover[0].first + i) * channels + channel];
                weights += weight;
            }
    return (uint8_t)((sum + weights / 2) / weights);
}

/* Box-filters a level from the one before it. */
static void filter_level(const struct hatch_texels *texels, uint32_t level)
{
    const uint32_t sizes[3] = {texels->width, texels->height, texels->depth};
    uint32_t from[3], to[3], at[3];
    for (int axis = 0; axis < 3; axis++) {
        from[axis] = hatch_mip_size(sizes[axis], level - 1);
        to[axis] = hatch_mip_size(sizes[axis], level);
    }
    const uint8_t *in = texels->texels[level - 1];
    uint8_t *out = texels->texels[level];
    for (at[2] = 0; at[2] < to[2]; at[2]++)
        for (at[1] = 0; at[1] < to[1]; at[1]++)
            for (at[0] = 0; at[0] < to[0]; at[0]++) {
                const struct cover cover[3] = {find_cover(from[0], at[0]), find_cover(from[1], at[1]),
                                               find_cover(from[2], at[2])};
                for (uint32_t c = 0; c < texels->channels; c++)
                    *out++ = filter_texel(in, from, cover, texels->channels, c);
            }
}

/* Fills the slices of the first `levels` levels from columns: these are all levels of an array, but only the drawn ones
 * of a 3D texture.
 *   tones  slices of the finest level of a whole volume */
static enum hatch_status fill_slices(const struct hatch_tam *tam, const struct hatch_texels *texels, uint32_t tones,
                                     uint32_t levels, struct hatch_pool *pool, struct hatch_arena *arena,
                                     struct hatch_volume_figures *figures, struct hatch_err *err)
{
    uint32_t count = 0, layers = texels->layers;
    struct slice *slices;
    HATCH_TRY(HATCH_ALLOC(arena, &slices, (size_t)levels * HATCH_VOLUME_TONES_MAX, err));
    for (uint32_t level = 0; level < levels; level++) {
        uint32_t depth = layers ? layers : hatch_mip_size(texels->depth, level);
        for (uint32_t index = 0; index < depth; index++)
            slices[count++] =
                choose_slice(tam, level, index, 1.0 / (layers ? tones : hatch_mip_size(tones, level)), figures);
    }
    if (figures->distance > HATCH_VOLUME_DISTANCE_MAX)
        return hatch_fail(err, HATCH_BAD_INPUT,
                          "too few columns for a volume: a slice is %.3f in tone from the nearest of %u columns",
                          figures->distance, tam->tones);
    struct job job = {tam, texels, slices};
    hatch_parallel_for(pool, count, fill_slice, &job);
    return HATCH_OK;
}

/* Returns the number of slices of the finest level: all, or those up to the last column of a map that is not whole. */
static uint32_t count_slices(const struct hatch_tam *tam, const struct hatch_volume_options *options)
{
    uint32_t least = options->layout == HATCH_VOLUME_ARRAY ? 1 : 1u << (tam->levels - 1), count = least;
    if (tam->tones == tam->whole.tones)
        return options->tones;
    while (count < options->tones && count < (double)tam->target[tam->tones - 1] * options->tones + 0.5)
        count += least;
    return count < options->tones ? count : options->tones;
}

enum hatch_status hatch_volume_make(const struct hatch_tam *tam, const struct hatch_volume_options *options,
                                    struct hatch_pool *pool, struct hatch_arena *arena, struct hatch_volume *volume,
                                    struct hatch_volume_figures *figures, struct hatch_err *err)
{
    uint32_t tones = options->tones;
    bool array = options->layout == HATCH_VOLUME_ARRAY;
    assert(tones >= HATCH_VOLUME_TONES_MIN && tones <= HATCH_VOLUME_TONES_MAX && !(tones & (tones - 1)));
    struct hatch_volume_figures found = {0};
    uint32_t slices = count_slices(tam, options);
    struct hatch_volume made = {
        .levels = tam->levels, .darkest = tam->target[tam->tones - 1], .top = (float)((double)slices / tones)};
    struct hatch_texels *texels = &made.texels;
    texels->width = texels->height = tam->size_px;
    texels->channels = tam->color ? (options->alpha ? 4 : 3) : 1;
    texels->depth = array ? 0 : slices;
    texels->layers = array ? slices : 0;
    texels->level_count = hatch_texels_chain_length(texels);
    HATCH_TRY(hatch_texels_make(arena, texels, err));
    uint32_t drawn = array ? texels->level_count : tam->levels;
    HATCH_TRY(fill_slices(tam, texels, tones, drawn, pool, arena, &found, err));
    for (uint32_t level = drawn; level < texels->level_count; level++)
        filter_level(texels, level);
    *volume = made;
    *figures = found;
    return HATCH_OK;
}

uint32_t hatch_volume_dense_levels(const struct hatch_texels *texels, uint32_t levels, double top)
{
    uint32_t count = 0;
    while (count < levels && round((texels->depth ? hatch_mip_size(texels->depth, count) : texels->layers) / top) >=
                                 HATCH_VOLUME_SLICES_FEW)
        count++;
    return count;
}
