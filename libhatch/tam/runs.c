#include "tam/runs.h"

#include <string.h>

#include "image/texels.h"

#define ROWS_PER_TASK 16u
#define PIECE 256u /* texels per piece, so few that the inner loops work in registers and the first-level cache */

/* Work on one level; a task is ROWS_PER_TASK rows. */
struct job {
    const struct hatch_tam *tam;
    uint32_t level, size, channel;
    uint8_t *darkest; /* size² texels: largest darkness of the columns so far */
    uint8_t *codes;   /* for each of size rows, tones x size darknesses; NULL: not stored */
    uint32_t *count;  /* size²: number of runs of each texel, later the index of its next run */
    uint32_t *fault;  /* per row: first column in which a texel gets lighter; 0: none */
    struct hatch_run *runs;
};

/* Encodes the darkness of count texels in 8 bits. The contiguous case has a loop of its own, which compilers
 * vectorise. */
static void encode_darkness(const float *pixels, size_t stride, size_t count, uint8_t *restrict codes)
{
    if (stride == 1)
        for (size_t x = 0; x < count; x++)
            codes[x] = (uint8_t)(255 - hatch_unorm8(pixels[x]));
    else
        for (size_t x = 0; x < count; x++)
            codes[x] = (uint8_t)(255 - hatch_unorm8(pixels[x * stride]));
}

/* Raises darkest to codes where these are darker. Returns whether any code was lighter than darkest by more than one
 * step. */
static bool raise_darkest(const uint8_t *restrict codes, size_t count, uint8_t *restrict darkest)
{
    uint8_t lighter = 0;
    for (size_t x = 0; x < count; x++) {
        uint8_t most = codes[x] > darkest[x] ? codes[x] : darkest[x];
        uint8_t below = (uint8_t)(most - codes[x]);
        lighter |= below > 1;
        darkest[x] = most;
    }
    return lighter;
}

static bool raise_row(const float *pixels, size_t stride, size_t size, uint8_t *darkest)
{
    uint8_t codes[PIECE];
    bool lighter = false;
    for (size_t x = 0; x < size; x += PIECE) {
        size_t count = size - x < PIECE ? size - x : PIECE;
        encode_darkness(pixels + x * stride, stride, count, codes);
        lighter |= raise_darkest(codes, count, darkest + x);
    }
    return lighter;
}

static void scan_row(const struct job *job, uint32_t y)
{
    size_t size = job->size;
    uint8_t *darkest = job->darkest + y * size;
    for (uint32_t c = 0; c < job->tam->tones; c++) {
        const struct hatch_image *image = &job->tam->columns[c].levels[job->level];
        const float *pixels = image->pixels + y * size * image->channel_count + job->channel;
        bool lighter = raise_row(pixels, image->channel_count, size, darkest);
        if (lighter && !job->fault[y])
            job->fault[y] = c;
        if (job->codes)
            memcpy(job->codes + (y * (size_t)job->tam->tones + c) * size, darkest, size);
    }
}

static void count_row(const struct job *job, uint32_t y)
{
    size_t size = job->size;
    uint32_t *restrict count = job->count + y * size;
    const uint8_t *codes = job->codes + y * (size_t)job->tam->tones * size;
    for (size_t x = 0; x < size; x++)
        count[x] = codes[x] != 0;
    for (uint32_t c = 1; c < job->tam->tones; c++, codes += size)
        for (size_t x = 0; x < size; x++)
            count[x] += codes[x] != codes[size + x];
}

static void fill_row(const struct job *job, uint32_t y)
{
    size_t size = job->size;
    uint32_t *restrict next = job->count + y * size;
    const uint8_t *codes = job->codes + y * (size_t)job->tam->tones * size;
    for (uint32_t c = 0; c < job->tam->tones; c++, codes += size)
        for (size_t x = 0; x < size; x++)
            if (codes[x] != (c ? codes[x - size] : 0))
                job->runs[next[x]++] = (struct hatch_run){(uint8_t)c, codes[x]};
}

static void for_rows(void (*row)(const struct job *, uint32_t), const struct job *job, uint32_t task)
{
    for (uint32_t y = task * ROWS_PER_TASK; y < (task + 1) * ROWS_PER_TASK && y < job->size; y++)
        row(job, y);
}

static void scan(void *context, uint32_t task)
{
    const struct job *job = context;
    for_rows(scan_row, job, task);
    if (job->codes)
        for_rows(count_row, job, task);
}

static void fill(void *context, uint32_t task)
{
    for_rows(fill_row, context, task);
}

static uint32_t task_count(const struct job *job)
{
    return (job->size + ROWS_PER_TASK - 1) / ROWS_PER_TASK;
}

/* Reports the first texel of row y that gets lighter. */
static enum hatch_status report_fault(const struct job *job, uint32_t y, struct hatch_err *err)
{
    uint32_t column = job->fault[y], x = 0;
    uint8_t before = 0, now = 0;
    for (; x < job->size; x++, before = 0) {
        for (uint32_t c = 0; c <= column; c++) {
            const struct hatch_image *image = &job->tam->columns[c].levels[job->level];
            size_t at = ((size_t)y * job->size + x) * image->channel_count + job->channel;
            now = (uint8_t)(255 - hatch_unorm8(image->pixels[at]));
            before = c < column && now > before ? now : before;
        }
        if (now + 1 < before)
            break;
    }
    return hatch_fail(err, HATCH_BAD_INPUT,
                      "tone.%03u: level %u: pixel (%u, %u) gets lighter, from %.3f to %.3f: strokes do not nest",
                      column, job->level, x, y, 1 - before / 255.0, 1 - now / 255.0);
}

static enum hatch_status scan_level(struct job *job, struct hatch_pool *pool, struct hatch_arena *scratch,
                                    struct hatch_err *err)
{
    size_t texels = (size_t)job->size * job->size;
    HATCH_TRY(HATCH_ALLOC(scratch, &job->darkest, texels, err));
    HATCH_TRY(HATCH_ALLOC(scratch, &job->fault, job->size, err));
    hatch_parallel_for(pool, task_count(job), scan, job);
    for (uint32_t y = 0; y < job->size; y++)
        if (job->fault[y])
            return report_fault(job, y, err);
    return HATCH_OK;
}

enum hatch_status hatch_tam_check_nesting(const struct hatch_tam *tam, struct hatch_pool *pool,
                                          struct hatch_arena *scratch, struct hatch_err *err)
{
    enum hatch_status status = HATCH_OK;
    struct hatch_arena_mark mark = hatch_arena_mark(scratch);
    uint32_t channels = tam->color ? 3 : 1, count = channels * tam->columns[0].level_count;
    for (uint32_t i = 0; i < count && status == HATCH_OK; i++) {
        uint32_t level = i / channels;
        struct job job = {
            .tam = tam, .level = level, .size = hatch_mip_size(tam->size_px, level), .channel = i % channels};
        status = scan_level(&job, pool, scratch, err);
        hatch_arena_rewind(scratch, mark);
    }
    hatch_arena_rewind(scratch, mark);
    return status;
}

/* Computes the index of each texel's first run from the counts. */
static enum hatch_status sum_counts(const uint32_t *count, size_t texels, uint64_t *total, uint32_t *first,
                                    struct hatch_err *err)
{
    for (size_t i = 0; i <= texels; i++) {
        if (*total > UINT32_MAX)
            return hatch_fail(err, HATCH_LIMIT,
                              "the texels have 2^32 changes of tone or more: use a smaller map or fewer tones");
        first[i] = (uint32_t)*total;
        *total += i < texels ? count[i] : 0;
    }
    return HATCH_OK;
}

static enum hatch_status encode_levels(const struct hatch_tam *tam, struct hatch_pool *pool, struct hatch_arena *arena,
                                       struct hatch_arena *scratch, struct job *jobs, struct hatch_runs *made,
                                       struct hatch_err *err)
{
    uint64_t total = 0;
    for (uint32_t level = 0; level < made->level_count; level++) {
        struct job *job = &jobs[level];
        *job = (struct job){.tam = tam, .level = level, .size = hatch_mip_size(tam->size_px, level)};
        size_t texels = (size_t)job->size * job->size;
        HATCH_TRY(HATCH_ALLOC_UNSET(scratch, &job->codes, texels * tam->tones, err));
        HATCH_TRY(HATCH_ALLOC(scratch, &job->count, texels, err));
        HATCH_TRY(HATCH_ALLOC(arena, &made->first[level], texels + 1, err));
        HATCH_TRY(scan_level(job, pool, scratch, err));
        HATCH_TRY(sum_counts(job->count, texels, &total, made->first[level], err));
        memcpy(job->count, made->first[level], texels * sizeof *job->count);
    }
    made->count = (uint32_t)total;
    HATCH_TRY(HATCH_ALLOC(arena, &made->runs, made->count, err));
    for (uint32_t level = 0; level < made->level_count; level++) {
        jobs[level].runs = made->runs;
        hatch_parallel_for(pool, task_count(&jobs[level]), fill, &jobs[level]);
    }
    return HATCH_OK;
}

enum hatch_status hatch_runs_make(const struct hatch_tam *tam, struct hatch_pool *pool, struct hatch_arena *arena,
                                  struct hatch_arena *scratch, struct hatch_runs *runs, struct hatch_err *err)
{
    if (tam->color)
        return hatch_fail(err, HATCH_BAD_INPUT, "the map is coloured, want grey");
    struct job jobs[HATCH_MIP_LEVELS_MAX];
    struct hatch_runs made = {.level_count = tam->columns[0].level_count};
    struct hatch_arena_mark mark = hatch_arena_mark(scratch);
    enum hatch_status status = encode_levels(tam, pool, arena, scratch, jobs, &made, err);
    hatch_arena_rewind(scratch, mark);
    if (status == HATCH_OK)
        *runs = made;
    return status;
}
