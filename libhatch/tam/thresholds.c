#include "tam/thresholds.h"

#include <assert.h>
#include <math.h>

#include "base/random.h"
#include "tam/runs.h"

#define FULL 255u
#define ROUNDING 1e-3           /* of tones in 255ths */
#define CROSSING_STROKES_MAX 4u /* more steps of a texel in one bin are a shade of grey, not strokes */

struct step {
    uint32_t x;      /* tone code, 0 .. 255 */
    uint32_t height; /* added darkness, 1 .. 255 */
};

/* Computes the tone code at which each column begins: half-way from the column before it, rounded to nearest and
 * ties down, but below the tone of the column, so that sampling there shows it. Sampling at the tone of a column yields
 * its image unless that of the next one is less than a code darker.
 *   code  out: one entry per column */
static void step_codes(const struct hatch_tam *tam, uint8_t *code)
{
    for (uint32_t c = 0; c < tam->tones; c++) {
        double before = c ? (double)tam->target[c - 1] : 0;
        double middle = (before + (double)tam->target[c]) / 2 * 255;
        double last = ceil((double)tam->target[c] * 255 - ROUNDING) - 1;
        code[c] = (uint8_t)fmax(0, fmin(last, ceil(middle - 0.5 - ROUNDING)));
    }
}

/* Lists the steps of a texel and returns their number.
 *   code   from step_codes
 *   texel  index in the level
 *   steps  out: room for one per column of the map */
static uint32_t steps_of_texel(const struct hatch_runs *runs, const uint8_t *code, uint32_t level, size_t texel,
                               struct step *steps)
{
    const struct hatch_run *run = runs->runs + runs->first[level][texel];
    uint32_t count = runs->first[level][texel + 1] - runs->first[level][texel], before = 0;
    for (uint32_t i = 0; i < count; i++) {
        steps[i] = (struct step){code[run[i].column], run[i].darkness - before};
        before = run[i].darkness;
    }
    return count;
}

/* Converts bin borders to tone codes: bin b has the codes first[b] .. first[b + 1] - 1.
 *   border  bins + 1 tones
 *   first   out: bins + 1 entries */
static void bin_codes(const float *border, uint32_t bins, uint32_t *first)
{
    for (uint32_t b = 0; b <= bins; b++)
        first[b] = b < bins ? (uint32_t)ceil((double)border[b] * 255 - ROUNDING) : 256;
}

#define CODES 256u
/* Largest number of pairs of steps to sum over; if there are more, only evenly spaced texels are used. */
#define PAIRS_MAX 4000000u
#define COST_SCALE 64u /* fixed point, so that sums do not depend on their order */

struct costs {
    uint64_t sums[CODES][CODES]; /* [a][b], a <= b: cost of steps at codes a and b in one bin; after sum_up, cost of a
                                    bin of the codes a .. b */
    uint64_t least[HATCH_THRESHOLD_BINS + 1][CODES + 1]; /* [n][end]: least cost of n bins for the codes below end */
    uint32_t from[HATCH_THRESHOLD_BINS + 1][CODES + 1];  /* [n][end]: first code of the last of these bins */
};

static void add(struct costs *costs, uint32_t a, uint32_t b, uint64_t cost)
{
    costs->sums[a < b ? a : b][a < b ? b : a] += cost;
}

/* Adds the cost of merging the steps of one texel. Two steps become one at the x of either, with probabilities in
 * proportion to their heights: the expected area between the two step functions is 2 dy1 dy2 / (dy1 + dy2) times the
 * distance of the steps. */
static void add_within(struct costs *costs, const struct step *steps, uint32_t count)
{
    for (uint32_t i = 0; i < count; i++)
        for (uint32_t j = i + 1; j < count; j++) {
            uint64_t a = steps[i].height, b = steps[j].height;
            add(costs, steps[i].x, steps[j].x, (steps[j].x - steps[i].x) * (2 * COST_SCALE * a * b / (a + b)));
        }
}

/* Adds the cost of interpolating between the steps of neighbouring texels. Half-way between the texels both steps are
 * at the mean x; averaged over the way from one texel to the other, the area is (dy1 + dy2) / 6 times the distance of
 * the steps. */
static void add_across(struct costs *costs, const struct step *steps, uint32_t count, const struct step *others,
                       uint32_t other_count)
{
    for (uint32_t i = 0; i < count; i++)
        for (uint32_t j = 0; j < other_count; j++) {
            uint32_t a = steps[i].x, b = others[j].x;
            uint64_t heights = steps[i].height + others[j].height;
            add(costs, a, b, (a < b ? b - a : a - b) * (COST_SCALE * heights / 6));
        }
}

static void add_texel(struct costs *costs, const struct hatch_runs *runs, const uint8_t *code, uint32_t level,
                      uint32_t size, size_t texel)
{
    struct step steps[CODES], others[CODES];
    size_t x = texel % size, y = texel / size;
    const size_t neighbours[] = {y * size + (x + 1) % size, (y + 1) % size * size + x};
    uint32_t count = steps_of_texel(runs, code, level, texel, steps);
    add_within(costs, steps, count);
    for (int i = 0; i < 2; i++)
        add_across(costs, steps, count, others, steps_of_texel(runs, code, level, neighbours[i], others));
}

static void add_level(struct costs *costs, const struct hatch_tam *tam, const struct hatch_runs *runs,
                      const uint8_t *code, uint32_t level)
{
    uint32_t size = hatch_mip_size(tam->size_px, level);
    size_t texels = (size_t)size * size;
    double pairs = 0;
    for (size_t i = 0; i < texels; i++) {
        double count = runs->first[level][i + 1] - runs->first[level][i];
        pairs += 2.5 * count * count;
    }
    /* An odd stride visits all columns of texels. */
    size_t stride = 1 + 2 * (size_t)(pairs / 2 / PAIRS_MAX);
    for (size_t i = 0; i < texels; i += stride)
        add_texel(costs, runs, code, level, size, i);
}

/* sums[a][b] becomes the cost of a bin that holds the codes a .. b. */
static void sum_up(struct costs *costs)
{
    for (uint32_t length = 2; length <= CODES; length++)
        for (uint32_t a = 0, b = length - 1; b < CODES; a++, b++)
            costs->sums[a][b] +=
                costs->sums[a + 1][b] + costs->sums[a][b - 1] - (length > 2 ? costs->sums[a + 1][b - 1] : 0);
}

/* Computes the cheapest division of the codes below end into bins, for every number of bins and every end. Among
 * equally cheap divisions the one whose last bin begins latest wins, so bins are narrower towards the dark. */
static void divide(struct costs *costs, uint32_t bins)
{
    memset(costs->least, 0xff, sizeof costs->least);
    costs->least[0][0] = 0;
    for (uint32_t bin = 1; bin <= bins; bin++)
        for (uint32_t end = bin; end <= CODES; end++)
            for (uint32_t from = bin - 1; from < end; from++) {
                uint64_t before = costs->least[bin - 1][from];
                if (before == UINT64_MAX || before + costs->sums[from][end - 1] > costs->least[bin][end])
                    continue;
                costs->least[bin][end] = before + costs->sums[from][end - 1];
                costs->from[bin][end] = from;
            }
}

/* Fits bin borders to the steps of a map by dynamic programming over the tone codes. They minimise the expected
 * error of merging the steps of a bin and of interpolating between neighbouring texels.
 *   bins    1 .. HATCH_THRESHOLD_BINS
 *   border  out: bins + 1 tones from 0 to 1, rising
 * HATCH_LIMIT when memory does not suffice. */
static enum hatch_status fit_steps(const struct hatch_tam *tam, const struct hatch_runs *runs, uint32_t bins,
                                   struct hatch_arena *scratch, float *border, struct hatch_err *err)
{
    assert(bins >= 1 && bins <= HATCH_THRESHOLD_BINS);
    struct hatch_arena_mark mark = hatch_arena_mark(scratch);
    struct costs *costs;
    HATCH_TRY(HATCH_ALLOC(scratch, &costs, 1, err));
    uint8_t code[HATCH_TAM_TONES_MAX];
    step_codes(tam, code);
    for (uint32_t level = 0; level < tam->levels; level++)
        add_level(costs, tam, runs, code, level);
    for (uint32_t a = 0; a < CODES; a++)
        costs->sums[a][a] = 0;
    sum_up(costs);
    divide(costs, bins);
    border[bins] = 1;
    /* All steps are below the last code, that of the tone 1: no bin begins there. */
    for (uint32_t bin = bins, end = CODES - 1; bin > 0; bin--) {
        end = costs->from[bin][end];
        border[bin - 1] = (float)end / 255;
    }
    hatch_arena_rewind(scratch, mark);
    return HATCH_OK;
}

/* Work on one level; a task is a row. */
struct job {
    const struct hatch_tam *tam;
    const struct hatch_threshold_options *options;
    const struct hatch_runs *runs;
    const struct hatch_texels *texels;
    const uint8_t *code;   /* from step_codes */
    const uint32_t *first; /* from bin_codes */
    uint32_t level, size;
    uint8_t *filled_x; /* x for bins without a step, eight per texel */
    struct sums {
        uint64_t steps, merged, error, error_max; /* errors in units of 1 / 255² */
    } * rows;
};

/* Returns a pointer to the x (value 0) or the height (value 1) of a bin in a texel. */
static uint8_t *value_of(const struct job *job, uint32_t level, size_t texel, uint32_t bin, uint32_t value)
{
    uint32_t size = hatch_mip_size(job->texels->width, level), layer = value * 2 + bin / 4;
    return job->texels->texels[level] + (((size_t)layer * size * size + texel) * 4 + bin % 4);
}

/* Returns the area between a step function of count steps and the single step that replaces it. */
static uint64_t area_between(const struct step *steps, uint32_t count, uint32_t x, uint32_t height)
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

/* Returns the x of a random step, chosen with a probability in proportion to its height. Where a few strokes cross, all
 * texels of the crossing use the same random number, on every level; a number per texel would make a stroke appear in
 * dots. More steps are a shade of grey, and a number per texel dithers it. */
static uint32_t pick_x(const struct job *job, const struct step *steps, uint32_t count, uint32_t height, uint32_t bin,
                       size_t texel)
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
    struct step steps[HATCH_TAM_TONES_MAX];
    uint32_t count = steps_of_texel(job->runs, job->code, job->level, texel, steps), from = 0;
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

/* Computes the mean x of the steps of a texel's neighbours, for the four bins of a layer, weighted by their heights;
 * diagonal neighbours count half.
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

/* Returns the x of the coarser level, which is complete; on the coarsest level, the middle of the bin. */
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

/* Computes an x for bins without a step. It is stored apart, because neighbouring rows still read the texture. */
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

/* Returns the length of what two intervals have in common, [a, a + length_a) and [b, b + length_b). */
static double common_length(uint64_t a, uint64_t length_a, uint64_t b, uint64_t length_b)
{
    uint64_t from = a > b ? a : b, to = a + length_a < b + length_b ? a + length_a : b + length_b;
    return to > from ? (double)(to - from) : 0;
}

/* Returns a texel of a picture's first channel, box-filtered to size x size texels: pixels that are partly in the texel
 * count by that part. NULL counts as a picture that is 1 everywhere. */
static uint8_t filtered_texel(const struct hatch_image *image, uint64_t x, uint64_t y, uint64_t size)
{
    if (!image)
        return FULL;
    /* In units of 1 / size of a pixel, a pixel is `size` wide, and a texel `width`, since size texels are width pixels.
     */
    const uint64_t width = image->width, height = image->height;
    double sum = 0, area = 0;
    for (uint64_t row = y * height / size; row * size < (y + 1) * height; row++)
        for (uint64_t column = x * width / size; column * size < (x + 1) * width; column++) {
            double part = common_length(x * width, width, column * size, size) *
                          common_length(y * height, height, row * size, size);
            sum += part * (double)image->pixels[(row * width + column) * image->channel_count];
            area += part;
        }
    return hatch_unorm8((float)(sum / area));
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
        HATCH_TRY(fit_steps(tam, &runs, options->bins, scratch, made->border, err));
    step_codes(tam, code);
    bin_codes(made->border, options->bins, first);
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
