#include "synthesis/kopf.h"

#include <math.h>
#include <string.h>

#include "base/random.h"
#include "filter/pyramid.h"
#include "synthesis/blend.h"
#include "synthesis/search.h"

#define SCAN_PAIRS_MAX 0x1p27 /* of texels and neighbourhoods, in these searches: they take seconds */
#define SCANS 2u              /* first searches of the coarsest level that compare all features */
#define SIZE_MIN 8u           /* of the coarsest level */
#define MORE 4u               /* factor of iterations from level to level */
#define BLOCKS 8u             /* allocations of a level, each aligned */
#define STREAMS (1u << 20)

/* Tolerance of the first iteration of a level, in powers of two, and of the last: structures form while means are
 * nearly plain, and become sharp later. */
#define TOLERANCE_FIRST 8
#define TOLERANCE_LAST 4

struct level {
    struct hatch_image image;
    struct hatch_exemplar exemplar;
    struct hatch_volume volume;
    uint32_t iterations;
};

struct synthesis {
    const struct hatch_synthesis_options *options;
    struct hatch_pool *pool;
    struct hatch_arena *scratch;
    uint32_t level_count;
    struct level levels[HATCH_SYNTHESIS_LEVELS_MAX];
    float prices[HATCH_CELLS];
    uint32_t counts[HATCH_CELLS];
    struct hatch_blend_tables tables;
    const struct hatch_progress *progress;
    double work_done, work_total; /* texels times iterations */
    double energy;
};

static enum hatch_status make_level(struct synthesis *synthesis, uint32_t which, uint32_t side,
                                    const struct hatch_solid *solid, struct hatch_err *err)
{
    struct hatch_arena *scratch = synthesis->scratch;
    struct level *level = &synthesis->levels[which];
    struct hatch_volume *volume = &level->volume;
    volume->size = solid->size >> which;
    volume->channels = solid->channels;
    volume->axes = synthesis->options->axes;
    level->iterations = synthesis->options->iterations;
    for (uint32_t finer = 0; finer < which; finer++)
        level->iterations *= MORE;
    if (which > 0) {
        const struct hatch_image *finer = &synthesis->levels[which - 1].image;
        level->image = *finer;
        level->image.width = hatch_mip_size(finer->width, 1);
        level->image.height = hatch_mip_size(finer->height, 1);
        size_t pixels = (size_t)level->image.width * level->image.height;
        HATCH_TRY(HATCH_ALLOC_UNSET(scratch, &level->image.pixels, pixels * level->image.channel_count, err));
        hatch_image_halve(finer, &level->image);
    }
    HATCH_TRY(hatch_exemplar_make(&level->image, side, scratch, &level->exemplar, err));
    const size_t count = hatch_volume_count(volume);
    HATCH_TRY(HATCH_ALLOC_UNSET(scratch, &volume->matches[0], HATCH_AXES * count, err));
    for (uint32_t axis = 1; axis < HATCH_AXES; axis++)
        volume->matches[axis] = volume->matches[0] + axis * count;
    volume->texels = solid->texels;
    if (which > 0)
        HATCH_TRY(HATCH_ALLOC_UNSET(scratch, &volume->texels, count * volume->channels, err));
    HATCH_TRY(HATCH_ALLOC_UNSET(scratch, &volume->next, count * volume->channels, err));
    synthesis->work_total += (double)count * level->iterations;
    return HATCH_OK;
}

static struct hatch_search search_of(const struct synthesis *synthesis, uint32_t which,
                                     const struct hatch_features *features, uint32_t iteration)
{
    const struct level *level = &synthesis->levels[which];
    const bool coarsest = which + 1 == synthesis->level_count;
    const double pairs =
        pow(level->volume.size, 3) * level->exemplar.across * level->exemplar.down; /* of texels and neighbourhoods */
    return (struct hatch_search){
        .exemplar = &level->exemplar,
        .features = features,
        .volume = &level->volume,
        .prices = synthesis->prices,
        .exhaustive = synthesis->options->exhaustive,
        .scan = !features->similar || (coarsest && iteration < SCANS && pairs <= SCAN_PAIRS_MAX),
        .backwards = iteration % 2,
        .key = hatch_random_key(synthesis->options->seed, (uint64_t)which * STREAMS + iteration + 1)};
}

static void reset_prices(struct synthesis *synthesis)
{
    for (uint32_t i = 0; i < HATCH_CELLS; i++)
        synthesis->prices[i] = 1;
}

static enum hatch_status iterate(struct synthesis *synthesis, uint32_t which, const struct hatch_features *features,
                                 struct hatch_err *err)
{
    struct level *level = &synthesis->levels[which];
    reset_prices(synthesis);
    for (uint32_t i = 0; i < level->iterations; i++) {
        const struct hatch_search search = search_of(synthesis, which, features, i);
        const double share = level->iterations > 1 ? (double)i / (level->iterations - 1) : 1;
        const double tolerance = exp2(TOLERANCE_FIRST + (TOLERANCE_LAST - TOLERANCE_FIRST) * share);
        /* The matches of the coarser level are the first ones of this one. */
        if (i > 0 || which + 1 == synthesis->level_count)
            HATCH_TRY(hatch_search_run(&search, synthesis->pool, synthesis->scratch, err));
        hatch_search_price(&level->volume, &level->exemplar, synthesis->counts, synthesis->prices);
        hatch_blend_run(&level->volume, &level->exemplar, (uint32_t)(tolerance + 0.5), synthesis->pool,
                        &synthesis->tables);
        synthesis->work_done += (double)hatch_volume_count(&level->volume);
        hatch_progress_report(synthesis->progress, synthesis->work_done / synthesis->work_total);
    }
    return HATCH_OK;
}

/* Measures the energy of the finest level: of matches to its last texels, at equal prices. */
static enum hatch_status measure(struct synthesis *synthesis, const struct hatch_features *features,
                                 struct hatch_err *err)
{
    const struct level *finest = &synthesis->levels[0];
    const struct hatch_search search = search_of(synthesis, 0, features, finest->iterations);
    reset_prices(synthesis);
    HATCH_TRY(hatch_search_run(&search, synthesis->pool, synthesis->scratch, err));
    return hatch_volume_energy(&finest->volume, &finest->exemplar, synthesis->pool, synthesis->scratch,
                               &synthesis->energy, err);
}

static enum hatch_status fill_level(struct synthesis *synthesis, uint32_t which, struct hatch_err *err)
{
    struct level *level = &synthesis->levels[which];
    struct hatch_features features;
    struct hatch_arena_mark mark = hatch_arena_mark(synthesis->scratch);
    if (which + 1 == synthesis->level_count)
        hatch_volume_randomize(&level->volume, &level->exemplar, hatch_random_key(synthesis->options->seed, 0));
    else
        hatch_volume_refine(&level[1].volume, &level[1].exemplar, &level->volume, &level->exemplar);
    /* Finding what is similar to each neighbourhood of the exemplar takes as long as comparing so many with all. */
    const double searches = (double)hatch_volume_count(&level->volume) * HATCH_AXES * level->iterations;
    const bool similar = searches > (double)level->exemplar.across * level->exemplar.down;
    enum hatch_status status = hatch_features_make(&level->exemplar, similar, synthesis->pool, synthesis->scratch,
                                                   synthesis->scratch, &features, err);
    if (status == HATCH_OK)
        status = iterate(synthesis, which, &features, err);
    if (status == HATCH_OK && which == 0)
        status = measure(synthesis, &features, err);
    hatch_arena_rewind(synthesis->scratch, mark);
    return status;
}

/* Fails if there is not the memory that the finest level takes later, besides what has been allocated. */
static enum hatch_status try_memory(struct synthesis *synthesis, struct hatch_err *err)
{
    const struct level *finest = &synthesis->levels[0];
    const size_t bytes = hatch_features_bytes(&finest->exemplar) +
                         hatch_search_bytes(&finest->volume, &finest->exemplar, synthesis->pool, synthesis->scratch);
    struct hatch_arena_mark mark = hatch_arena_mark(synthesis->scratch);
    uint8_t *block;
    enum hatch_status status = HATCH_ALLOC_UNSET(synthesis->scratch, &block, bytes + BLOCKS * HATCH_ARENA_ALIGN, err);
    hatch_arena_rewind(synthesis->scratch, mark);
    return status;
}

static enum hatch_status fill(struct synthesis *synthesis, const struct hatch_image *exemplar,
                              struct hatch_solid *solid, struct hatch_synthesis_figures *figures, struct hatch_err *err)
{
    const struct hatch_synthesis_options *options = synthesis->options;
    const uint32_t shorter = exemplar->width < exemplar->height ? exemplar->width : exemplar->height;
    /* A picture of one neighbourhood would make a solid of one colour. */
    const uint32_t side = options->side < shorter ? options->side : (shorter + 1) / 2;
    synthesis->level_count = 1;
    while (synthesis->level_count < options->levels && shorter >> synthesis->level_count >= 2 * side &&
           options->size >> synthesis->level_count >= SIZE_MIN)
        synthesis->level_count++;
    synthesis->levels[0].image = *exemplar;
    figures->side = side;
    figures->levels = synthesis->level_count;
    for (uint32_t which = 0; which < synthesis->level_count; which++) {
        HATCH_TRY(make_level(synthesis, which, side, solid, err));
        figures->iterations += synthesis->levels[which].iterations;
    }
    HATCH_TRY(try_memory(synthesis, err));
    for (uint32_t which = synthesis->level_count; which-- > 0;)
        HATCH_TRY(fill_level(synthesis, which, err));
    const struct hatch_volume *finest = &synthesis->levels[0].volume;
    if (finest->texels != solid->texels)
        memcpy(solid->texels, finest->texels, hatch_volume_count(finest) * finest->channels);
    figures->energy = synthesis->energy;
    return HATCH_OK;
}

enum hatch_status hatch_kopf_fill(const struct hatch_image *exemplar, const struct hatch_synthesis_options *options,
                                  struct hatch_pool *pool, const struct hatch_progress *progress,
                                  struct hatch_arena *scratch, struct hatch_solid *solid,
                                  struct hatch_synthesis_figures *figures, struct hatch_err *err)
{
    struct hatch_arena_mark mark = hatch_arena_mark(scratch);
    struct synthesis *synthesis = HATCH_NEW(scratch, struct synthesis, 1, err);
    if (!synthesis)
        return HATCH_LIMIT;
    synthesis->options = options;
    synthesis->pool = pool;
    synthesis->scratch = scratch;
    synthesis->progress = progress;
    enum hatch_status status = fill(synthesis, exemplar, solid, figures, err);
    hatch_arena_rewind(scratch, mark);
    return status;
}
