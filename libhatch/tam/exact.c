#include "tam/exact.h"

#include "tam/runs.h"
#include "tam/taps.h"

enum { WORD_VERSION, WORD_SIZE, WORD_LEVELS, WORD_DRAWN, WORD_COLUMNS, WORD_RUNS, WORD_RUN_COUNT };

static void put(uint8_t *words, uint64_t word, uint32_t value)
{
    for (int i = 0; i < 4; i++)
        words[word * 4 + (uint64_t)i] = (uint8_t)(value >> 8 * i);
}

static uint32_t get(const uint8_t *words, uint64_t word)
{
    const uint8_t *at = words + word * 4;
    return at[0] | (uint32_t)at[1] << 8 | (uint32_t)at[2] << 16 | (uint32_t)at[3] << 24;
}

static float get_float(const uint8_t *words, uint64_t word)
{
    uint32_t bits = get(words, word);
    float value;
    memcpy(&value, &bits, sizeof value);
    return value;
}

static uint64_t texel_count(uint32_t size_px, uint32_t level)
{
    uint64_t size = hatch_mip_size(size_px, level);
    return size * size;
}

/* Returns the word at which the index of a level begins; for level_count, the word at which the runs begin. */
static uint64_t index_word(uint32_t size_px, uint32_t columns, uint32_t level_count, uint32_t level)
{
    uint64_t word = HATCH_EXACT_HEAD + (uint64_t)level_count + columns;
    for (uint32_t l = 0; l < level; l++)
        word += texel_count(size_px, l) + 1;
    return word;
}

static void fill(const struct hatch_tam *tam, const struct hatch_runs *runs, uint8_t *words)
{
    uint32_t levels = runs->level_count;
    uint64_t first_run = index_word(tam->size_px, tam->tones, levels, levels);
    const uint32_t head[] = {HATCH_EXACT_VERSION, tam->size_px,        levels,     tam->levels,
                             tam->tones,          (uint32_t)first_run, runs->count};
    for (uint32_t i = 0; i < sizeof head / sizeof *head; i++)
        put(words, i, head[i]);
    for (uint32_t c = 0; c < tam->tones; c++) {
        uint32_t bits;
        memcpy(&bits, &tam->target[c], sizeof bits);
        put(words, HATCH_EXACT_HEAD + levels + c, bits);
    }
    for (uint32_t level = 0; level < levels; level++) {
        uint64_t word = index_word(tam->size_px, tam->tones, levels, level);
        put(words, HATCH_EXACT_HEAD + level, (uint32_t)word);
        for (uint64_t i = 0; i <= texel_count(tam->size_px, level); i++)
            put(words, word + i, runs->first[level][i]);
    }
    uint8_t *at = words + first_run * 4;
    for (uint32_t i = 0; i < runs->count; i++) {
        at[2 * (size_t)i] = runs->runs[i].column;
        at[2 * (size_t)i + 1] = runs->runs[i].darkness;
    }
}

static enum hatch_status make(const struct hatch_tam *tam, const struct hatch_runs *runs, struct hatch_arena *arena,
                              struct hatch_exact *made, struct hatch_err *err)
{
    uint64_t words =
        index_word(tam->size_px, tam->tones, runs->level_count, runs->level_count) + ((uint64_t)runs->count + 1) / 2;
    uint64_t rows = (words + HATCH_EXACT_WIDTH - 1) / HATCH_EXACT_WIDTH;
    made->texels = (struct hatch_texels){.width = HATCH_EXACT_WIDTH,
                                         .height = (uint32_t)rows,
                                         .channels = 1,
                                         .level_count = 1,
                                         .code = HATCH_TEXELS_R32UI};
    HATCH_TRY(hatch_texels_make(arena, &made->texels, err));
    fill(tam, runs, made->texels.texels[0]);
    return HATCH_OK;
}

enum hatch_status hatch_exact_make(const struct hatch_tam *tam, struct hatch_pool *pool, struct hatch_arena *arena,
                                   struct hatch_arena *scratch, struct hatch_exact *exact, struct hatch_err *err)
{
    struct hatch_runs runs;
    struct hatch_arena_mark mark = hatch_arena_mark(scratch);
    enum hatch_status status = hatch_runs_make(tam, pool, scratch, arena, &runs, err);
    if (status != HATCH_OK) {
        hatch_arena_rewind(scratch, mark);
        return status;
    }
    struct hatch_exact made = {.size_px = tam->size_px,
                               .level_count = runs.level_count,
                               .levels = tam->levels,
                               .columns = tam->tones,
                               .run_count = runs.count};
    status = make(tam, &runs, arena, &made, err);
    if (status == HATCH_OK)
        *exact = made;
    hatch_arena_rewind(scratch, mark);
    return status;
}

/* Checks that indices do not fall and stay within the runs. */
static enum hatch_status check_indices(const struct hatch_exact *exact, const uint8_t *words, struct hatch_err *err)
{
    uint32_t before = 0;
    for (uint32_t level = 0; level < exact->level_count; level++) {
        uint64_t word = index_word(exact->size_px, exact->columns, exact->level_count, level);
        if (get(words, HATCH_EXACT_HEAD + level) != word)
            return hatch_fail(err, HATCH_BAD_INPUT, "level %u: the header does not place its index at word %llu", level,
                              (unsigned long long)word);
        for (uint64_t i = 0; i <= texel_count(exact->size_px, level); i++) {
            uint32_t first = get(words, word + i);
            if (first < before || first > exact->run_count)
                return hatch_fail(err, HATCH_BAD_INPUT, "level %u: texel %llu begins at run %u, want %u to %u", level,
                                  (unsigned long long)i, first, before, exact->run_count);
            before = first;
        }
    }
    return HATCH_OK;
}

enum hatch_status hatch_exact_from_texels(const struct hatch_texels *texels, struct hatch_exact *exact,
                                          struct hatch_err *err)
{
    const uint8_t *words = texels->texels[0];
    uint64_t count = (uint64_t)texels->width * texels->height;
    if (texels->code != HATCH_TEXELS_R32UI || texels->width != HATCH_EXACT_WIDTH || texels->depth || texels->layers ||
        get(words, WORD_VERSION) != HATCH_EXACT_VERSION)
        return hatch_fail(err, HATCH_BAD_INPUT, "not exact runs as described in tamthresh(5)");
    struct hatch_exact made = {.texels = *texels,
                               .size_px = get(words, WORD_SIZE),
                               .level_count = get(words, WORD_LEVELS),
                               .levels = get(words, WORD_DRAWN),
                               .columns = get(words, WORD_COLUMNS),
                               .run_count = get(words, WORD_RUN_COUNT)};
    if (made.size_px < 1 || made.size_px > HATCH_TAM_SIZE_MAX || made.columns < 1 ||
        made.columns > HATCH_TAM_TONES_MAX || made.level_count != hatch_mip_chain_length(made.size_px, made.size_px) ||
        made.levels < 1 || made.levels > made.level_count)
        return hatch_fail(err, HATCH_BAD_INPUT, "header out of range: %u pixels, %u of %u levels drawn, %u columns",
                          made.size_px, made.levels, made.level_count, made.columns);
    uint64_t first = index_word(made.size_px, made.columns, made.level_count, made.level_count);
    if (get(words, WORD_RUNS) != first || first + ((uint64_t)made.run_count + 1) / 2 > count)
        return hatch_fail(err, HATCH_BAD_INPUT, "damaged: %u runs, said to begin at word %u of %llu", made.run_count,
                          get(words, WORD_RUNS), (unsigned long long)count);
    HATCH_TRY(check_indices(&made, words, err));
    *exact = made;
    return HATCH_OK;
}

float hatch_exact_tone(const struct hatch_exact *exact, uint32_t column)
{
    return get_float(exact->texels.texels[0], HATCH_EXACT_HEAD + (uint64_t)exact->level_count + column);
}

/* Returns the darkness of a texel, 0 .. 1, interpolated between a column and the next.
 *   entry  word of the texel in the index
 *   share  weight of the next column */
static float darkness_at(const struct hatch_exact *exact, uint64_t entry, int column, float share)
{
    const uint8_t *words = exact->texels.texels[0];
    const uint8_t *runs = words + (uint64_t)get(words, WORD_RUNS) * 4;
    uint32_t end = get(words, entry + 1);
    float below = 0, above = 0;
    for (uint32_t i = get(words, entry); i < end && runs[2 * (uint64_t)i] <= column + 1; i++) {
        above = (float)runs[2 * (uint64_t)i + 1] / 255;
        below = runs[2 * (uint64_t)i] <= column ? above : below;
    }
    return below + share * (above - below);
}

/* Returns the last column whose tone is at most `tone`, or -1 if there is none.
 *   share  out: weight of the column after it */
static int find_column(const struct hatch_exact *exact, float tone, float *share)
{
    uint32_t above = 0;
    float before = 0, at = 0;
    for (; above < exact->columns; above++, before = at) {
        at = hatch_exact_tone(exact, above);
        if (at > tone)
            break;
    }
    *share = above < exact->columns && at > before ? (tone - before) / (at - before) : 0;
    return (int)above - 1;
}

float hatch_exact_sample(const struct hatch_exact *exact, float u, float v, float tone, float lod)
{
    float share, part, darkness = 0;
    int column = find_column(exact, tone, &part);
    uint32_t level = hatch_tap_levels(lod, exact->level_count, &share);
    for (uint32_t i = 0; i < (share > 0 ? 2u : 1u); i++) {
        uint32_t size = hatch_mip_size(exact->size_px, level + i);
        struct hatch_taps taps = hatch_taps_at(u, v, size, size);
        uint64_t word = index_word(exact->size_px, exact->columns, exact->level_count, level + i);
        for (int tap = 0; tap < 4; tap++)
            darkness +=
                (i ? share : 1 - share) * taps.weight[tap] * darkness_at(exact, word + taps.texel[tap], column, part);
    }
    return 1 - darkness;
}
