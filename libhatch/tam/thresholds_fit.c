#include <assert.h>

#include "tam/steps.h"
#include "tam/thresholds.h"

#define CODES 256u
#define PAIRS_MAX 4000000u /* pairs of steps to sum over; of more, evenly spaced texels are used */
#define COST_SCALE 64u     /* fixed point, so that sums do not depend on their order */

struct costs {
    uint64_t sums[CODES][CODES]; /* [a][b], a <= b: cost of steps at a and b in one bin; later that of a bin a .. b */
    uint64_t least[HATCH_THRESHOLD_BINS + 1][CODES + 1]; /* [n][end]: least cost of n bins for the codes below end */
    uint32_t from[HATCH_THRESHOLD_BINS + 1][CODES + 1];  /* [n][end]: first code of the last of these bins */
};

static void add(struct costs *costs, uint32_t a, uint32_t b, uint64_t cost)
{
    costs->sums[a < b ? a : b][a < b ? b : a] += cost;
}

/* Adds the cost of merging the steps of one texel. Two steps become one at the x of either, with probabilities in
 * proportion to their heights: the expected area between both functions is 2 dy1 dy2 / (dy1 + dy2) times their
 * distance. */
static void add_within(struct costs *costs, const struct hatch_step *steps, uint32_t count)
{
    for (uint32_t i = 0; i < count; i++)
        for (uint32_t j = i + 1; j < count; j++) {
            uint64_t a = steps[i].height, b = steps[j].height;
            add(costs, steps[i].x, steps[j].x, (steps[j].x - steps[i].x) * (2 * COST_SCALE * a * b / (a + b)));
        }
}

/* Adds the cost of interpolating between the steps of neighbouring texels: half-way both are at the mean x; averaged
 * from one texel to the other the area is (dy1 + dy2) / 6 times their distance. */
static void add_across(struct costs *costs, const struct hatch_step *steps, uint32_t count,
                       const struct hatch_step *others, uint32_t other_count)
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
    struct hatch_step steps[CODES], others[CODES];
    size_t x = texel % size, y = texel / size;
    const size_t neighbours[] = {y * size + (x + 1) % size, (y + 1) % size * size + x};
    uint32_t count = hatch_steps_of_texel(runs, code, level, texel, steps);
    add_within(costs, steps, count);
    for (int i = 0; i < 2; i++)
        add_across(costs, steps, count, others, hatch_steps_of_texel(runs, code, level, neighbours[i], others));
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
 * equally cheap ones the last wins, so bins are narrower towards the dark. */
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

enum hatch_status hatch_steps_fit(const struct hatch_tam *tam, const struct hatch_runs *runs, uint32_t bins,
                                  struct hatch_arena *scratch, float *border, struct hatch_err *err)
{
    assert(bins >= 1 && bins <= HATCH_THRESHOLD_BINS);
    struct hatch_arena_mark mark = hatch_arena_mark(scratch);
    struct costs *costs;
    HATCH_TRY(HATCH_ALLOC(scratch, &costs, 1, err));
    uint8_t code[HATCH_TAM_TONES_MAX];
    hatch_step_codes(tam, code);
    for (uint32_t level = 0; level < tam->levels; level++)
        add_level(costs, tam, runs, code, level);
    for (uint32_t a = 0; a < CODES; a++)
        costs->sums[a][a] = 0;
    sum_up(costs);
    divide(costs, bins);
    border[bins] = 1;
    for (uint32_t bin = bins, end = CODES; bin > 0; bin--) {
        end = costs->from[bin][end];
        border[bin - 1] = (float)end / 255;
    }
    hatch_arena_rewind(scratch, mark);
    return HATCH_OK;
}
