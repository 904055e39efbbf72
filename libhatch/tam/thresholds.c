#include "tam/thresholds.h"

#include <assert.h>

#include "base/random.h"
#include "tam/steps.h"

#define FULL 255u
#define CROSSING_STROKES_MAX 4u /* more steps of a texel in one bin are a shade of grey, not strokes */

/* Work on one level; a task is a row. */
struct job {
    const struct hatch_tam *tam;
    const struct hatch_threshold_options *options;
    const struct hatch_runs *runs;
    const struct hatch_texels *texels;
    const uint8_t *code;   /* of hatch_step_codes */
    const uint32_t *first; /* of hatch_bin_codes */
    uint32_t level, size;
    uint8_t *filled_x; /* x for bins without a step, eight per texel */
    struct sums {
        uint64_t steps, merged, error, error_max; /* errors in units of 1 / 255² */
    } * rows;
};

/* The x (value 0) or the height (value 1) of a bin in a texel. */
static uint8_t *value_of(const struct job *job, uint32_t level, size_t texel, uint32_t bin, uint32_t value)
{
    uint32_t size = hatch_mip_size(job->texels->width, level), layer = value * 2 + bin / 4;
    return job->texels->texels[level] + (((size_t)layer * size * size + texel) * 4 + bin % 4);
}

/* The area between a step function of count steps and the single step that replaces them. */
static uint64_t area_between(const struct hatch_step *steps, uint32_t count, uint32_t x, uint32_t height)
{
    uint64_t area = 0;
    uint32_t sum = 0;
    for (uint32_t i = 0; i + 1 < count; i++) {
        sum += steps[i].height;
        uint32_t single = steps[i].x >= x ? height : 0;
        area += (uint64_t)(single > sum ? single - sum : sum - single) * (steps[i + 1].x - steps[i].x);
    }
    return area;
}

/* The x of a random step, with a probability in proportion to its height. Where a few strokes cross, all texels of
 * the crossing use the same random number, on every level; a number per texel would let a stroke appear in dots.
 * More steps are a shade of grey, and a number per texel dithers it. */
static uint32_t pick_x(const struct job *job, const struct hatch_step *steps, uint32_t count, uint32_t height,
                       uint32_t bin, size_t texel)
{
    uint64_t stream = bin, key = 0, i = 0;
    if (count > CROSSING_STROKES_MAX) {
        stream = (uint64_t)job->level << 8 | bin;
        key = texel;
    } else {
        for (uint32_t step = 0; step < count; step++)
            key = key << 8 | steps[step].x;
    }
    uint64_t share = hatch_random_u64(job->options->seed, stream, key) >> 32, rest = share * height >> 32;
    for (; rest >= steps[i].height; i++)
        rest -= steps[i].height;
    return steps[i].x;
}

static void merge_texel(const struct job *job, size_t texel, struct sums *sums)
{
    struct hatch_step steps[HATCH_TAM_TONES_MAX];
    uint32_t count = hatch_steps_of_texel(job->runs, job->code, job->level, texel, steps), from = 0;
    uint64_t error = 0;
    for (uint32_t bin = 0; bin < job->options->bins; bin++) {
        uint32_t to = from, height = 0;
        for (; to < count && steps[to].x < job->first[bin + 1]; to++)
            height += steps[to].height;
        if (to == from)
            continue;
        uint32_t x = to == from + 1 ? steps[from].x : pick_x(job, steps + from, to - from, height, bin, texel);
        *value_of(job, job->level, texel, bin, 0) = (uint8_t)x;
        *value_of(job, job->level, texel, bin, 1) = (uint8_t)height;
        sums->merged += to > from + 1 ? to - from : 0;
        error += area_between(steps + from, to - from, x, height);
        from = to;
    }
    sums->steps += count;
    sums->error += error;
    sums->error_max = error > sums->error_max ? error : sums->error_max;
}

static void merge_row(void *context, uint32_t y)
{
    const struct job *job = context;
    for (uint32_t x = 0; x < job->size; x++)
        merge_texel(job, (size_t)y * job->size + x, &job->rows[y]);
}

/* The mean x of the steps of a texel's neighbours, for the four bins of a layer, weighted by their heights; diagonal
 * neighbours count half.
 *   heights  out: sum of the weights; 0 where no neighbour has a step */
static void mean_of_neighbours(const struct job *job, uint32_t x, uint32_t y, uint32_t layer, uint32_t mean[4],
                               uint32_t heights[4])
{
    static const uint32_t weights[] = {1, 2, 1, 2, 0, 2, 1, 2, 1};
    uint32_t size = job->size, sums[4] = {0};
    const uint8_t *step_x = value_of(job, job->level, 0, layer * 4, 0);
    const uint8_t *step_height = value_of(job, job->level, 0, layer * 4, 1);
    memset(heights, 0, 4 * sizeof *heights);
    for (uint32_t i = 0; i < 9; i++) {
        size_t at = (size_t)((y + size - 1 + i / 3) % size) * size + (x + size - 1 + i % 3) % size;
        for (uint32_t bin = 0; bin < 4; bin++) {
            uint32_t height = weights[i] * step_height[at * 4 + bin];
            sums[bin] += height * step_x[at * 4 + bin];
            heights[bin] += height;
        }
    }
    for (uint32_t bin = 0; bin < 4; bin++)
        mean[bin] = heights[bin] ? (sums[bin] + heights[bin] / 2) / heights[bin] : 0;
}

/* The x of the coarser level, which is complete; on the coarsest level the middle of the bin. */
static uint32_t coarser_x(const struct job *job, uint32_t x, uint32_t y, uint32_t bin)
{
    if (job->level + 1 == job->texels->level_count) {
        uint32_t used = bin < job->options->bins ? bin : job->options->bins - 1;
        return (job->first[used] + job->first[used + 1] - 1) / 2;
    }
    uint32_t coarser = hatch_mip_size(job->texels->width, job->level + 1);
    uint32_t across = x / 2 < coarser ? x / 2 : coarser - 1, down = y / 2 < coarser ? y / 2 : coarser - 1;
    return *value_of(job, job->level + 1, (size_t)down * coarser + across, bin, 0);
}

/* Computes an x for bins without a step; stored apart, because neighbouring rows still read the texture. */
static void fill_row(void *context, uint32_t y)
{
    const struct job *job = context;
    for (uint32_t x = 0; x < job->size; x++)
        for (uint32_t layer = 0; layer < 2; layer++) {
            uint32_t mean[4], heights[4];
            size_t texel = (size_t)y * job->size + x;
            const uint8_t *heights_here = value_of(job, job->level, texel, layer * 4, 1);
            if (heights_here[0] && heights_here[1] && heights_here[2] && heights_here[3])
                continue;
            mean_of_neighbours(job, x, y, layer, mean, heights);
            for (uint32_t bin = 0; bin < 4; bin++)
                job->filled_x[texel * 8 + layer * 4 + bin] =
                    (uint8_t)(heights[bin] ? mean[bin] : coarser_x(job, x, y, layer * 4 + bin));
        }
}

static void store_filled_row(void *context, uint32_t y)
{
    const struct job *job = context;
    size_t end = ((size_t)y + 1) * job->size;
    for (size_t texel = (size_t)y * job->size; texel < end; texel++)
        for (uint32_t bin = 0; bin < HATCH_THRESHOLD_BINS; bin++)
            if (!*value_of(job, job->level, texel, bin, 1))
                *value_of(job, job->level, texel, bin, 0) = job->filled_x[texel * 8 + bin];
}

/* One of size² texels of a picture's first channel, box-filtered; NULL is 1 everywhere. */
static uint8_t filtered_texel(const struct hatch_image *image, uint32_t x, uint32_t y, uint32_t size)
{
    if (!image)
        return FULL;
    uint32_t from[2], to[2];
    const uint32_t at[2] = {x, y}, sides[2] = {image->width, image->height};
    for (int axis = 0; axis < 2; axis++) {
        from[axis] = (uint32_t)((uint64_t)at[axis] * sides[axis] / size);
        to[axis] = (uint32_t)(((uint64_t)at[axis] + 1) * sides[axis] / size);
        to[axis] = to[axis] > from[axis] ? to[axis] : from[axis] + 1;
    }
    double sum = 0;
    for (uint32_t row = from[1]; row < to[1]; row++)
        for (uint32_t column = from[0]; column < to[0]; column++)
            sum += (double)image->pixels[((size_t)row * image->width + column) * image->channel_count];
    return hatch_unorm8((float)(sum / (to[0] - from[0]) / (to[1] - from[1])));
}

static void mask_row(void *context, uint32_t y)
{
    const struct job *job = context;
    for (uint32_t x = 0; x < job->size; x++) {
        size_t texel = (size_t)y * job->size + x;
        *value_of(job, job->level, texel, 7, 0) = filtered_texel(job->options->modulation, x, y, job->size);
        *value_of(job, job->level, texel, 7, 1) = filtered_texel(job->options->mask, x, y, job->size);
    }
}

static enum hatch_status make_levels(struct job *job, struct hatch_pool *pool, struct hatch_arena *scratch,
                                     struct sums *sums, struct hatch_err *err)
{
    HATCH_TRY(HATCH_ALLOC(scratch, &job->rows, job->tam->size_px, err));
    HATCH_TRY(HATCH_ALLOC_UNSET(scratch, &job->filled_x, (size_t)job->tam->size_px * job->tam->size_px * 8, err));
    for (uint32_t level = job->texels->level_count; level-- > 0;) {
        job->level = level;
        job->size = hatch_mip_size(job->texels->width, level);
        memset(job->rows, 0, job->size * sizeof *job->rows);
        hatch_parallel_for(pool, job->size, merge_row, job);
        hatch_parallel_for(pool, job->size, fill_row, job);
        hatch_parallel_for(pool, job->size, store_filled_row, job);
        hatch_parallel_for(pool, job->size, mask_row, job);
        for (uint32_t y = 0; level < job->tam->levels && y < job->size; y++) {
            const struct sums *row = &job->rows[y];
            sums->steps += row->steps;
            sums->merged += row->merged;
            sums->error += row->error;
            sums->error_max = row->error_max > sums->error_max ? row->error_max : sums->error_max;
        }
    }
    return HATCH_OK;
}

static void sum_figures(const struct hatch_tam *tam, const struct sums *sums, struct hatch_threshold_figures *figures)
{
    double texels = 0;
    for (uint32_t level = 0; level < tam->levels; level++) {
        double size = hatch_mip_size(tam->size_px, level);
        texels += size * size;
    }
    figures->steps = (double)sums->steps / texels;
    figures->merged = sums->steps ? (double)sums->merged / (double)sums->steps : 0;
    figures->error = (double)sums->error / texels / (FULL * FULL);
    figures->error_max = (double)sums->error_max / (FULL * FULL);
}

static enum hatch_status make(const struct hatch_tam *tam, const struct hatch_threshold_options *options,
                              struct hatch_pool *pool, struct hatch_arena *arena, struct hatch_arena *scratch,
                              struct hatch_thresholds *made, struct hatch_err *err)
{
    struct hatch_runs runs;
    struct sums sums = {0};
    uint8_t code[HATCH_TAM_TONES_MAX];
    uint32_t first[HATCH_THRESHOLD_BINS + 1];
    HATCH_TRY(hatch_runs_make(tam, pool, scratch, arena, &runs, err));
    if (options->border)
        memcpy(made->border, options->border, (options->bins + 1) * sizeof *made->border);
    else
        HATCH_TRY(hatch_steps_fit(tam, &runs, options->bins, scratch, made->border, err));
    hatch_step_codes(tam, code);
    hatch_bin_codes(made->border, options->bins, first);
    struct job job = {
        .tam = tam, .options = options, .runs = &runs, .texels = &made->texels, .code = code, .first = first};
    HATCH_TRY(make_levels(&job, pool, scratch, &sums, err));
    sum_figures(tam, &sums, &made->figures);
    return HATCH_OK;
}

enum hatch_status hatch_thresholds_make(const struct hatch_tam *tam, const struct hatch_threshold_options *options,
                                        struct hatch_pool *pool, struct hatch_arena *arena, struct hatch_arena *scratch,
                                        struct hatch_thresholds *thresholds, struct hatch_err *err)
{
    assert(options->bins >= 1 && options->bins <= HATCH_THRESHOLD_BINS);
    struct hatch_thresholds made = {.levels = tam->levels, .bins = options->bins};
    made.texels = (struct hatch_texels){.width = tam->size_px,
                                        .height = tam->size_px,
                                        .layers = HATCH_THRESHOLD_LAYERS,
                                        .channels = 4,
                                        .level_count = tam->columns[0].level_count};
    HATCH_TRY(hatch_texels_make(arena, &made.texels, err));
    struct hatch_arena_mark mark = hatch_arena_mark(scratch);
    enum hatch_status status = make(tam, options, pool, arena, scratch, &made, err);
    hatch_arena_rewind(scratch, mark);
    if (status == HATCH_OK)
        *thresholds = made;
    return status;
}
