/* Tables that give blended values back the contrast, or the distribution, of the texture. */
#include <math.h>

#include "solid/zoom.h"

#define POINTS 32768u
#define BINS 1024u

/* A distribution of values, 0 .. 1. */
struct spread {
    double mean, deviation;
    double least, most;
    double below[BINS + 1]; /* share of values below i / BINS */
};

static uint32_t repeated(int64_t texel, uint32_t size)
{
    return (uint32_t)(texel & (int64_t)(size - 1)); /* sizes are powers of two */
}

static void sample_level(const struct hatch_texels *mips, uint32_t level, const float place[3], float value[3])
{
    uint32_t size = hatch_mip_size(mips->width, level), channels = mips->channels;
    size_t at[2][3];
    float share[3];
    for (int k = 0; k < 3; k++) {
        uint32_t side = k < 2 ? size : hatch_mip_size(mips->depth, level);
        float texel = place[k] * (float)side - 0.5f, below = floorf(texel);
        share[k] = texel - below;
        at[0][k] = repeated((int64_t)below, side);
        at[1][k] = repeated((int64_t)below + 1, side);
    }
    for (uint32_t c = 0; c < channels; c++)
        value[c] = 0;
    for (int k = 0; k < 8; k++) {
        int x = k & 1, y = k >> 1 & 1, z = k >> 2;
        float weight =
            (x ? share[0] : 1 - share[0]) * (y ? share[1] : 1 - share[1]) * (z ? share[2] : 1 - share[2]) / 255.0f;
        const uint8_t *texel =
            mips->texels[level] + ((at[z][2] * size + at[y][1]) * (size_t)size + at[x][0]) * channels;
        for (uint32_t c = 0; c < channels; c++)
            value[c] += weight * (float)texel[c];
    }
}

void hatch_zoom_sample(const struct hatch_texels *mips, float level, const float place[3], float value[3])
{
    float within = fminf(fmaxf(level, 0), (float)(mips->level_count - 1)), coarser[3];
    uint32_t finer = (uint32_t)within;
    sample_level(mips, finer, place, value);
    if (within <= (float)finer)
        return;
    sample_level(mips, finer + 1, place, coarser);
    for (uint32_t c = 0; c < mips->channels; c++)
        value[c] += (within - (float)finer) * (coarser[c] - value[c]);
}

#define RANK_LEAST (1.0 / 510.0) /* half of a texel's step: u(0, 1) is undefined */

/* Returns u(rank, s) of solid/zoom.h. */
static double appears(double rank, double s)
{
    double above = 1 - fmax(rank, RANK_LEAST);
    return (1 - above * above) / (1 + above * (1 - 2 * s));
}

/* Returns the blended value of two scales. */
static double blended(enum hatch_zoom_blend blend, double fine, double coarse, double s)
{
    if (blend == HATCH_ZOOM_UNION)
        return fmin(appears(fine, s), appears(coarse, 1 - s));
    return fine + s * (coarse - fine);
}

void hatch_zoom_blend_at(const struct hatch_texels *mips, enum hatch_zoom_blend blend, const float place[3], float s,
                         float level, float value[3])
{
    const float half[3] = {0.5f * place[0], 0.5f * place[1], 0.5f * place[2]};
    float coarse[3];
    hatch_zoom_sample(mips, level, place, value);
    hatch_zoom_sample(mips, level - 1, half, coarse);
    for (uint32_t c = 0; c < mips->channels; c++)
        value[c] = (float)blended(blend, (double)value[c], (double)coarse[c], (double)s);
}

static void add(struct spread *spread, double value)
{
    double clamped = fmin(fmax(value, 0), 1);
    spread->least = fmin(spread->least, clamped);
    spread->most = fmax(spread->most, clamped);
    spread->mean += clamped;
    spread->deviation += clamped * clamped;
    spread->below[1 + (size_t)fmin(clamped * BINS, BINS - 1)]++;
}

/* Turns sums into mean and deviation, and counts into shares. */
static void finish(struct spread *spread, double count)
{
    spread->mean /= count;
    spread->deviation = sqrt(fmax(spread->deviation / count - spread->mean * spread->mean, 0));
    for (size_t i = 0; i < BINS; i++)
        spread->below[i + 1] = i + 1 < BINS ? spread->below[i] + spread->below[i + 1] / count : 1;
}

/* Measures a channel of all texels.
 *   shape  size and channels */
static void spread_of_texels(const uint8_t *texels, const struct hatch_solid *shape, uint32_t channel,
                             struct spread *spread)
{
    size_t count = hatch_solid_count(shape);
    *spread = (struct spread){.least = 1};
    for (size_t i = 0; i < count; i++)
        add(spread, texels[i * shape->channels + channel] / 255.0);
    finish(spread, (double)count);
}

/* The values of A at POINTS places, which fill the period evenly: the additive recurrence of the root of x^4 = x + 1.
 */
static void take_points(const struct hatch_texels *mips, int32_t level, float scale, float (*values)[3])
{
    static const double steps[3] = {0.8191725133961645, 0.6710436067037893, 0.5497004779019703};
    for (uint32_t i = 0; i < POINTS; i++) {
        float place[3];
        for (int k = 0; k < 3; k++)
            place[k] = scale * (float)(steps[k] * i - floor(steps[k] * i));
        hatch_zoom_sample(mips, (float)level, place, values[i]);
    }
}

/* Values of A(p) and A(p / 2) at POINTS places. Within a cycle the mip level rises by one: three levels are read. */
struct samples {
    int32_t level; /* the finest of those of A(p); those of A(p / 2) are one finer */
    float (*fine[3])[3], (*coarse[3])[3];
};

static enum hatch_status take_samples(const struct hatch_texels *mips, double level, struct hatch_arena *scratch,
                                      struct samples *samples, struct hatch_err *err)
{
    samples->level = (int32_t)floor(level);
    for (int32_t i = 0; i < 3; i++) {
        HATCH_TRY(HATCH_ALLOC(scratch, &samples->fine[i], POINTS, err));
        HATCH_TRY(HATCH_ALLOC(scratch, &samples->coarse[i], POINTS, err));
        take_points(mips, samples->level + i, 2, samples->fine[i]);
        take_points(mips, samples->level + i - 1, 1, samples->coarse[i]);
    }
    return HATCH_OK;
}

/* Measures a channel of the blend.
 *   level  of A(p) */
static void spread_of_blend(const struct samples *samples, enum hatch_zoom_blend blend, uint32_t channel, double s,
                            double level, struct spread *spread)
{
    uint32_t from = level - samples->level >= 1;
    double share = level - samples->level - from;
    *spread = (struct spread){.least = 1};
    for (uint32_t i = 0; i < POINTS; i++) {
        double fine = samples->fine[from][i][channel], coarse = samples->coarse[from][i][channel];
        fine += share * (samples->fine[from + 1][i][channel] - fine);
        coarse += share * (samples->coarse[from + 1][i][channel] - coarse);
        add(spread, blended(blend, fine, coarse, s));
    }
    finish(spread, POINTS);
}

/* Returns the share of values below one. */
static double share_below(const struct spread *spread, double value)
{
    double at = fmin(fmax(value, 0), 1) * BINS;
    size_t bin = (size_t)fmin(at, BINS - 1);
    return spread->below[bin] + (at - (double)bin) * (spread->below[bin + 1] - spread->below[bin]);
}

/* Returns the value below which there is a share of the values: for all of them the greatest, although the bins behind
 * it have the same share below them. */
static double value_at(const struct spread *spread, double share)
{
    size_t low = 0, high = BINS;
    while (high - low > 1) {
        size_t middle = (low + high) / 2;
        if (spread->below[middle] <= share)
            low = middle;
        else
            high = middle;
    }
    double step = spread->below[low + 1] - spread->below[low];
    double value = ((double)low + (step > 0 ? fmin((share - spread->below[low]) / step, 1) : 0.5)) / BINS;
    return fmin(fmax(value, spread->least), spread->most);
}

static double changed(enum hatch_zoom_blend blend, const struct spread *base, const struct spread *now, double value)
{
    double gain = now->deviation > 1e-6 ? base->deviation / now->deviation : 1;
    switch (blend) {
    case HATCH_ZOOM_LINEAR:
        return value;
    case HATCH_ZOOM_CONTRAST:
        return base->mean + gain * (value - now->mean);
    case HATCH_ZOOM_HISTOGRAM:
        return now->deviation > 1e-6 ? value_at(base, share_below(now, value)) : value;
    case HATCH_ZOOM_UNION:
    case HATCH_ZOOM_RANK:
        break;
    }
    return share_below(now, value);
}

static void fill_row(enum hatch_zoom_blend blend, const struct spread *base, const struct spread *now,
                     uint16_t entries[HATCH_ZOOM_VALUES])
{
    for (uint32_t i = 0; i < HATCH_ZOOM_VALUES; i++) {
        double value = changed(blend, base, now, (i + 0.5) / HATCH_ZOOM_VALUES);
        entries[i] = (uint16_t)lrint(65535 * fmin(fmax(value, 0), 1));
    }
}

static enum hatch_status fill(const struct hatch_zoom *zoom, const struct hatch_texels *mips,
                              enum hatch_zoom_blend blend, double level, struct hatch_arena *scratch,
                              struct hatch_zoom_table *table, struct hatch_err *err)
{
    struct samples samples;
    struct spread *spreads; /* of T, of the blend */
    HATCH_TRY(take_samples(mips, level, scratch, &samples, err));
    HATCH_TRY(HATCH_ALLOC(scratch, &spreads, 2, err));
    for (uint32_t c = 0; c < mips->channels; c++) {
        spread_of_texels(zoom->base.texels, &zoom->base, c, &spreads[0]);
        for (uint32_t step = 0; step < HATCH_ZOOM_STEPS; step++) {
            double s = (double)step / (HATCH_ZOOM_STEPS - 1);
            spread_of_blend(&samples, blend, c, s, level + s, &spreads[1]);
            fill_row(blend, &spreads[0], &spreads[1], table->entries[c][step]);
        }
    }
    return HATCH_OK;
}

/* Scales the deviations of a level from the mean to those of the finest level. */
static void sharpen(const struct spread *finest, const struct hatch_texels *mips, uint32_t level, uint32_t channel,
                    struct spread *now)
{
    const struct hatch_solid shape = {.size = mips->width >> level,
                                      .channels = mips->channels,
                                      .texels = mips->texels[level],
                                      .depth = hatch_mip_size(mips->depth, level)};
    size_t count = hatch_solid_count(&shape);
    spread_of_texels(shape.texels, &shape, channel, now);
    double gain = fmin(finest->deviation / fmax(now->deviation, 1e-6), HATCH_ZOOM_GAIN_MAX);
    for (size_t i = 0; i < count; i++) {
        uint8_t *texel = &mips->texels[level][i * mips->channels + channel];
        *texel = hatch_unorm8((float)(finest->mean + gain * (*texel / 255.0 - now->mean)));
    }
}

enum hatch_status hatch_zoom_mips(const struct hatch_zoom *zoom, enum hatch_zoom_blend blend, struct hatch_arena *arena,
                                  struct hatch_texels *mips, struct hatch_err *err)
{
    struct spread *spreads;
    HATCH_TRY(hatch_solid_mips(&zoom->octaves, arena, mips, err));
    HATCH_TRY(HATCH_ALLOC(arena, &spreads, 2, err));
    for (uint32_t c = 0; c < mips->channels && blend != HATCH_ZOOM_LINEAR; c++) {
        spread_of_texels(mips->texels[0], &zoom->octaves, c, &spreads[0]);
        for (uint32_t level = 1; level < mips->level_count; level++)
            sharpen(&spreads[0], mips, level, c, &spreads[1]);
    }
    return HATCH_OK;
}

enum hatch_status hatch_zoom_table_make(const struct hatch_zoom *zoom, const struct hatch_texels *mips,
                                        enum hatch_zoom_blend blend, double level, struct hatch_arena *arena,
                                        struct hatch_arena *scratch, struct hatch_zoom_table *table,
                                        struct hatch_err *err)
{
    struct hatch_zoom_table made;
    HATCH_TRY(HATCH_ALLOC(arena, &made.entries, mips->channels, err));
    struct hatch_arena_mark mark = hatch_arena_mark(scratch);
    enum hatch_status status = fill(zoom, mips, blend, level, scratch, &made, err);
    hatch_arena_rewind(scratch, mark);
    if (status == HATCH_OK)
        *table = made;
    return status;
}
