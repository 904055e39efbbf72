#include "measure/tone_figures.h"

#include <math.h>

#include "base/random.h"

#define SEED 0x746f6e65u
/* Limits: least darkness of inked samples, largest darkness of grey ones, and difference from which on a sample is
 * unlike a column. */
#define INKED 0.1f
#define GREY_MAX 0.9f
#define UNLIKE 0.1f

/* Sums over the samples of a tone. */
struct sums {
    double darkness, map, error, error_max;
    uint64_t inked, grey, grey_all;
};

struct job {
    const struct hatch_tone_test *test;
    uint64_t samples; /* per tone */
    struct sums *tones;
};

/* Returns the last column whose tone is at most the given one; -1 for paper.
 *   share  out: weight of the next column, 0 .. 1 */
static int column_at(const struct hatch_tam *map, float tone, float *share)
{
    uint32_t above = 0;
    while (above < map->tones && map->target[above] <= tone)
        above++;
    float before = above ? map->target[above - 1] : 0;
    *share = above < map->tones ? (tone - before) / (map->target[above] - before) : 0;
    return (int)above - 1;
}

float hatch_tone_sample_map(const void *subject, float u, float v, float tone, float lod)
{
    float share;
    const struct hatch_tam *map = subject;
    int column = column_at(map, tone, &share);
    float below = hatch_tam_sample(map, column, u, v, lod);
    return share > 0 ? below + share * (hatch_tam_sample(map, column + 1, u, v, lod) - below) : below;
}

static bool is_grey(float darkness)
{
    return darkness > INKED && darkness < GREY_MAX;
}

static void measure_tone(void *context, uint32_t index)
{
    const struct job *job = context;
    const struct hatch_tone_test *test = job->test;
    struct sums *sums = &job->tones[index];
    /* The tone is random within its 64th of the range, because even steps would coincide with those of a file. */
    float share, offset = hatch_random_unit(SEED, 2 * HATCH_TONES_MEASURED, index);
    float tone = ((float)index + offset) / HATCH_TONES_MEASURED;
    int column = column_at(test->map, tone, &share), next = share > 0 ? column + 1 : column;
    for (uint64_t i = 0; i < job->samples; i++) {
        float u = hatch_random_unit(SEED, 2 * index, i), v = hatch_random_unit(SEED, 2 * index + 1, i);
        float below = 1 - hatch_tam_sample(test->map, column, u, v, test->lod);
        float above = 1 - hatch_tam_sample(test->map, next, u, v, test->lod);
        float want = below + share * (above - below);
        float got = 1 - test->sample(test->subject, u, v, tone, test->lod);
        double error = fabs((double)got - (double)want);
        sums->darkness += (double)got;
        sums->map += (double)want;
        sums->error += error;
        sums->error_max = fmax(sums->error_max, error);
        sums->inked += got > INKED;
        sums->grey_all += is_grey(got);
        sums->grey += is_grey(got) && fabsf(got - below) > UNLIKE && fabsf(got - above) > UNLIKE;
    }
}

enum hatch_status hatch_measure_tones(const struct hatch_tone_test *test, struct hatch_pool *pool,
                                      struct hatch_arena *scratch, struct hatch_tone_figures *figures,
                                      struct hatch_err *err)
{
    struct hatch_arena_mark mark = hatch_arena_mark(scratch);
    struct job job = {test, (test->samples + HATCH_TONES_MEASURED - 1) / HATCH_TONES_MEASURED,
                      HATCH_NEW(scratch, struct sums, HATCH_TONES_MEASURED, err)};
    if (!job.tones)
        return HATCH_LIMIT;
    hatch_parallel_for(pool, HATCH_TONES_MEASURED, measure_tone, &job);
    struct hatch_tone_figures found = {0};
    double inked = 0, grey = 0, grey_all = 0, count = (double)job.samples;
    for (uint32_t i = 0; i < HATCH_TONES_MEASURED; i++) {
        const struct sums *sums = &job.tones[i];
        double error = fabs(sums->darkness - sums->map) / count;
        found.tone_error += error / HATCH_TONES_MEASURED;
        found.tone_worst = fmax(found.tone_worst, error);
        found.error += sums->error / count / HATCH_TONES_MEASURED;
        found.error_max = fmax(found.error_max, sums->error_max);
        inked += (double)sums->inked;
        grey += (double)sums->grey;
        grey_all += (double)sums->grey_all;
    }
    found.grey = inked > 0 ? grey / inked : NAN;
    found.grey_all = inked > 0 ? grey_all / inked : NAN;
    hatch_arena_rewind(scratch, mark);
    *figures = found;
    return HATCH_OK;
}
