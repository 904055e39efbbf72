#include "synthesis/heeger.h"

#include <string.h>

#include "base/random.h"
#include "image/texels.h"
#include "synthesis/grid.h"
#include "math/pca.h"

#define BANDS_MAX 6u
#define COARSEST_MIN 4u /* side of the coarsest grids */

/* Colours in which the channels of the exemplar are uncorrelated, so that each can be made alone. */
struct colors {
    uint32_t channels;
    double mean[3];
    double axes[9]; /* [axis * 3 + channel] */
};

struct synthesis {
    const struct hatch_synthesis_options *options;
    const struct hatch_image *exemplar;
    struct hatch_pool *pool;
    struct hatch_arena *scratch;
    const struct hatch_progress *progress;
    struct colors colors;
    uint32_t grid_count;                 /* of a pyramid: the bands, finest first, and what is left of them */
    struct hatch_grid wanted[BANDS_MAX]; /* pyramid of the exemplar, each sorted */
    struct hatch_grid made[BANDS_MAX];   /* pyramid of the solid */
    struct hatch_grid whole;             /* the exemplar itself, sorted */
    struct hatch_grid channels[3];
    double *ranks; /* [HATCH_GRID_RANKS] */
};

static void find_colors(const struct hatch_image *exemplar, struct colors *colors)
{
    const size_t count = (size_t)exemplar->width * exemplar->height;
    const uint32_t n = colors->channels = exemplar->channel_count;
    double covariance[9] = {0}, next[9];
    for (uint32_t c = 0; c < n; c++) {
        double sum = 0;
        for (size_t i = 0; i < count; i++)
            sum += (double)exemplar->pixels[i * n + c];
        colors->mean[c] = sum / (double)count;
    }
    for (size_t i = 0; i < count; i++)
        for (uint32_t a = 0; a < n; a++)
            for (uint32_t b = 0; b < n; b++)
                covariance[a * n + b] += ((double)exemplar->pixels[i * n + a] - colors->mean[a]) *
                                         ((double)exemplar->pixels[i * n + b] - colors->mean[b]);
    hatch_pca_directions(covariance, n, n, colors->axes, next);
}

static void project_exemplar(const struct synthesis *synthesis, uint32_t axis, const struct hatch_grid *grid)
{
    const struct colors *colors = &synthesis->colors;
    const uint32_t n = colors->channels;
    for (size_t i = 0; i < hatch_grid_count(grid); i++) {
        double sum = 0;
        for (uint32_t c = 0; c < n; c++)
            sum += colors->axes[axis * n + c] * ((double)synthesis->exemplar->pixels[i * n + c] - colors->mean[c]);
        grid->values[i] = (float)sum;
    }
}

/* Makes the bands of a pyramid from its finest grid. */
static void decompose(const struct synthesis *synthesis, const struct hatch_grid *grids)
{
    for (uint32_t g = 0; g + 1 < synthesis->grid_count; g++) {
        hatch_grid_reduce(&grids[g], &grids[g + 1], synthesis->pool);
        hatch_grid_add(&grids[g], &grids[g + 1], -1, synthesis->pool);
    }
}

/* Makes one channel of the uncorrelated colours, in made[0]. */
static void make_channel(const struct synthesis *synthesis, uint32_t channel)
{
    const uint32_t iterations = synthesis->options->iterations, last = synthesis->grid_count - 1;
    const struct hatch_grid *whole = &synthesis->whole, *made = synthesis->made;
    const uint64_t key = hatch_random_key(synthesis->options->seed, channel);
    project_exemplar(synthesis, channel, &synthesis->wanted[0]);
    memcpy(whole->values, synthesis->wanted[0].values, hatch_grid_count(whole) * sizeof *whole->values);
    decompose(synthesis, synthesis->wanted);
    hatch_grid_sort(whole);
    for (uint32_t g = 0; g <= last; g++)
        hatch_grid_sort(&synthesis->wanted[g]);
    for (size_t i = 0; i < hatch_grid_count(&made[0]); i++)
        made[0].values[i] = (float)(hatch_random_at(key, i) >> 40) * 0x1p-24f;
    for (uint32_t i = 0; i <= iterations; i++) {
        hatch_grid_match(&made[0], whole->values, hatch_grid_count(whole), synthesis->pool, synthesis->ranks);
        hatch_progress_report(synthesis->progress, ((double)channel * (iterations + 1) + i + 1) /
                                                       ((double)synthesis->colors.channels * (iterations + 1)));
        if (i == iterations)
            break;
        decompose(synthesis, made);
        for (uint32_t g = 0; g <= last; g++)
            hatch_grid_match(&made[g], synthesis->wanted[g].values, hatch_grid_count(&synthesis->wanted[g]),
                             synthesis->pool, synthesis->ranks);
        for (uint32_t g = last; g-- > 0;)
            hatch_grid_add(&made[g], &made[g + 1], 1, synthesis->pool);
    }
}

static enum hatch_status make_grids(struct synthesis *synthesis, uint32_t size, struct hatch_err *err)
{
    const struct hatch_image *exemplar = synthesis->exemplar;
    struct hatch_arena *scratch = synthesis->scratch;
    struct hatch_grid *wanted = synthesis->wanted, *made = synthesis->made;
    synthesis->whole = (struct hatch_grid){{exemplar->width, exemplar->height, 1}, false, NULL};
    wanted[0] = synthesis->whole;
    for (uint32_t c = 0; c < exemplar->channel_count; c++) {
        synthesis->channels[c] = (struct hatch_grid){{size, size, size}, true, NULL};
        HATCH_TRY(
            HATCH_ALLOC_UNSET(scratch, &synthesis->channels[c].values, hatch_grid_count(&synthesis->channels[c]), err));
    }
    made[0] = synthesis->channels[0];
    HATCH_TRY(HATCH_ALLOC_UNSET(scratch, &wanted[0].values, hatch_grid_count(wanted), err));
    HATCH_TRY(HATCH_ALLOC_UNSET(scratch, &synthesis->whole.values, hatch_grid_count(wanted), err));
    HATCH_TRY(HATCH_ALLOC_UNSET(scratch, &synthesis->ranks, HATCH_GRID_RANKS, err));
    uint32_t g = 0;
    for (; g + 1 < BANDS_MAX && made[g].size[0] >= 2 * COARSEST_MIN && wanted[g].size[0] >= 2 * COARSEST_MIN &&
           wanted[g].size[1] >= 2 * COARSEST_MIN;
         g++) {
        HATCH_TRY(hatch_grid_make_half(&made[g], scratch, &made[g + 1], err));
        HATCH_TRY(hatch_grid_make_half(&wanted[g], scratch, &wanted[g + 1], err));
    }
    synthesis->grid_count = g + 1;
    return HATCH_OK;
}

static enum hatch_status fill(struct synthesis *synthesis, struct hatch_solid *solid, struct hatch_err *err)
{
    const struct colors *colors = &synthesis->colors;
    const uint32_t n = colors->channels;
    HATCH_TRY(make_grids(synthesis, solid->size, err));
    find_colors(synthesis->exemplar, &synthesis->colors);
    for (uint32_t c = 0; c < n; c++) {
        synthesis->made[0].values = synthesis->channels[c].values;
        make_channel(synthesis, c);
    }
    for (size_t i = 0; i < hatch_grid_count(&synthesis->channels[0]); i++)
        for (uint32_t c = 0; c < n; c++) {
            double sum = colors->mean[c];
            for (uint32_t axis = 0; axis < n; axis++)
                sum += colors->axes[axis * n + c] * (double)synthesis->channels[axis].values[i];
            solid->texels[i * n + c] = hatch_unorm8((float)sum);
        }
    return HATCH_OK;
}

enum hatch_status hatch_heeger_fill(const struct hatch_image *exemplar, const struct hatch_synthesis_options *options,
                                    struct hatch_pool *pool, const struct hatch_progress *progress,
                                    struct hatch_arena *scratch, struct hatch_solid *solid,
                                    struct hatch_synthesis_figures *figures, struct hatch_err *err)
{
    struct hatch_arena_mark mark = hatch_arena_mark(scratch);
    struct synthesis synthesis = {
        .options = options, .exemplar = exemplar, .pool = pool, .scratch = scratch, .progress = progress};
    synthesis.colors.channels = exemplar->channel_count;
    enum hatch_status status = fill(&synthesis, solid, err);
    hatch_arena_rewind(scratch, mark);
    if (status == HATCH_OK) {
        figures->levels = synthesis.grid_count;
        figures->iterations = options->iterations;
    }
    return status;
}
