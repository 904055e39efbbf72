#include "synthesis/search.h"

#include <math.h>
#include <string.h>

#include "base/random.h"

/* Limits of prices, and the share of its fair number that a cell counts as having at least. */
#define PRICE_MIN 0.02f
#define PRICE_MAX 50.0f
#define FEW 0.1f

/* One neighbourhood of the solid, and the best match so far. */
struct query {
    int16_t feature[HATCH_FEATURES];
    float cost;
    uint16_t match;
};

struct job {
    const struct hatch_search *search;
    uint32_t workers;
    size_t padded_bytes;
    uint8_t *padded; /* per worker: a slice with margins, in which it repeats */
};

static void consider(const struct hatch_search *search, struct query *query, uint32_t x, uint32_t y)
{
    const struct hatch_exemplar *exemplar = search->exemplar;
    if (x >= exemplar->across || y >= exemplar->down)
        return;
    uint32_t match = y * HATCH_EXEMPLAR_PITCH + x;
    const int16_t *other = search->features->vectors + ((size_t)y * exemplar->across + x) * HATCH_FEATURES;
    float cost = (float)hatch_features_distance(query->feature, other) * search->prices[hatch_cell_of(match)];
    if (cost < query->cost || (cost == query->cost && match < query->match)) {
        query->cost = cost;
        query->match = (uint16_t)match;
    }
}

/* Considers a match, moved by (dx, dy), and those similar to it, moved alike. */
static void consider_kin(const struct hatch_search *search, struct query *query, uint32_t match, uint32_t dx,
                         uint32_t dy)
{
    uint32_t x = match % HATCH_EXEMPLAR_PITCH, y = match / HATCH_EXEMPLAR_PITCH;
    const uint16_t *similar =
        search->features->similar + ((size_t)y * search->exemplar->across + x) * HATCH_FEATURES_SIMILAR;
    consider(search, query, x + dx, y + dy); /* negative numbers wrap around to large ones */
    for (uint32_t i = 0; i < HATCH_FEATURES_SIMILAR; i++)
        consider(search, query, similar[i] % HATCH_EXEMPLAR_PITCH + dx, similar[i] / HATCH_EXEMPLAR_PITCH + dy);
}

/* Considers random places around the best match, nearer and nearer. */
static void consider_around(const struct hatch_search *search, struct query *query, uint64_t index)
{
    const struct hatch_exemplar *exemplar = search->exemplar;
    uint32_t reach = exemplar->across > exemplar->down ? exemplar->across : exemplar->down;
    for (uint64_t n = index * 16; reach >= 1; reach /= 2) {
        uint64_t bits = hatch_random_at(search->key, n++);
        uint32_t x = query->match % HATCH_EXEMPLAR_PITCH, y = query->match / HATCH_EXEMPLAR_PITCH;
        consider(search, query, x - reach + (uint32_t)(((bits & 0xffffffff) * (2 * reach + 1)) >> 32),
                 y - reach + (uint32_t)(((bits >> 32) * (2 * reach + 1)) >> 32));
    }
}

static void scan_all(const struct hatch_search *search, struct query *query)
{
    for (uint32_t y = 0; y < search->exemplar->down; y++)
        for (uint32_t x = 0; x < search->exemplar->across; x++)
            consider(search, query, x, y);
}

static uint16_t compare_all(const struct hatch_search *search, const int16_t *values)
{
    const struct hatch_exemplar *exemplar = search->exemplar;
    float least = INFINITY;
    uint32_t best = 0;
    for (uint32_t y = 0; y < exemplar->down; y++)
        for (uint32_t x = 0; x < exemplar->across; x++) {
            uint32_t match = y * HATCH_EXEMPLAR_PITCH + x;
            float cost = (float)hatch_exemplar_distance(exemplar, values, match, UINT32_MAX) *
                         search->prices[hatch_cell_of(match)];
            if (cost < least) {
                least = cost;
                best = match;
            }
        }
    return (uint16_t)best;
}

/* Copies a slice into an image with margins, so that the neighbourhood of texel (0, 0) begins at its first pixel. */
static void pad_slice(const struct hatch_search *search, uint32_t axis, uint32_t slice, uint8_t *padded)
{
    const struct hatch_volume *volume = search->volume;
    const struct hatch_slices steps = hatch_slices_of(axis, volume->size);
    const uint32_t size = volume->size, channels = volume->channels, side = search->exemplar->side;
    const uint32_t pitch = size + side - 1, before = size - side / 2 % size;
    for (uint32_t v = 0; v < pitch; v++)
        for (uint32_t u = 0; u < pitch; u++) {
            size_t texel = slice * steps.slice + (v + before) % size * steps.row + (u + before) % size * steps.column;
            for (uint32_t c = 0; c < channels; c++)
                *padded++ = volume->texels[texel * channels + c];
        }
}

/* Searches the match of the texel in column u and row v. */
static void search_texel(const struct hatch_search *search, uint32_t axis, uint32_t slice, const uint8_t *padded,
                         uint32_t u, uint32_t v)
{
    const struct hatch_exemplar *exemplar = search->exemplar;
    const uint32_t size = search->volume->size, row = exemplar->side * exemplar->channels;
    const size_t pitch = (size_t)(size + exemplar->side - 1) * exemplar->channels;
    int16_t values[HATCH_EXEMPLAR_VALUES_MAX + 16] = {0};
    uint16_t *matches = search->volume->matches[axis] + (size_t)slice * size * size;
    for (uint32_t j = 0; j < exemplar->side; j++)
        for (uint32_t i = 0; i < row; i++)
            values[j * row + i] = (int16_t)(padded[(v + j) * pitch + (size_t)u * exemplar->channels + i] - 128);
    uint16_t *match = matches + (size_t)v * size + u;
    if (search->exhaustive) {
        *match = compare_all(search, values);
        return;
    }
    struct query query = {.cost = INFINITY, .match = *match};
    hatch_features_project(search->features, values, query.feature);
    if (search->scan)
        scan_all(search, &query);
    else {
        const uint32_t left = (u + size - 1) % size, right = (u + 1) % size;
        const uint32_t above = (v + size - 1) % size, below = (v + 1) % size;
        consider_kin(search, &query, *match, 0, 0);
        consider_kin(search, &query, matches[(size_t)v * size + left], 1, 0);
        consider_kin(search, &query, matches[(size_t)v * size + right], (uint32_t)-1, 0);
        consider_kin(search, &query, matches[(size_t)above * size + u], 0, 1);
        consider_kin(search, &query, matches[(size_t)below * size + u], 0, (uint32_t)-1);
        consider_around(search, &query, (((uint64_t)axis * size + slice) * size + v) * size + u);
    }
    *match = query.match;
}

/* Searches every so many slices. */
static void search_slices(void *context, uint32_t worker)
{
    const struct job *job = context;
    const struct hatch_search *search = job->search;
    const uint32_t size = search->volume->size;
    uint8_t *padded = job->padded + worker * job->padded_bytes;
    for (uint32_t i = worker; i < HATCH_AXES * size; i += job->workers) {
        if (!hatch_volume_has(search->volume, i / size))
            continue;
        pad_slice(search, i / size, i % size, padded);
        for (uint32_t n = 0; n < size * size; n++) {
            uint32_t at = search->backwards ? size * size - 1 - n : n;
            search_texel(search, i / size, i % size, padded, at % size, at / size);
        }
    }
}

static size_t padded_bytes(const struct hatch_volume *volume, const struct hatch_exemplar *exemplar)
{
    const size_t pitch = volume->size + exemplar->side - 1;
    return pitch * pitch * volume->channels;
}

size_t hatch_search_bytes(const struct hatch_volume *volume, const struct hatch_exemplar *exemplar,
                          struct hatch_pool *pool, const struct hatch_arena *scratch)
{
    const size_t bytes = padded_bytes(volume, exemplar);
    return hatch_pool_workers(pool, bytes, scratch) * bytes;
}

enum hatch_status hatch_search_run(const struct hatch_search *search, struct hatch_pool *pool,
                                   struct hatch_arena *scratch, struct hatch_err *err)
{
    const size_t bytes = padded_bytes(search->volume, search->exemplar);
    struct job job = {search, hatch_pool_workers(pool, bytes, scratch), bytes, NULL};
    struct hatch_arena_mark mark = hatch_arena_mark(scratch);
    HATCH_TRY(HATCH_ALLOC_UNSET(scratch, &job.padded, job.workers * job.padded_bytes, err));
    hatch_parallel_for(pool, job.workers, search_slices, &job);
    hatch_arena_rewind(scratch, mark);
    return HATCH_OK;
}

void hatch_search_price(const struct hatch_volume *volume, const struct hatch_exemplar *exemplar, uint32_t *counts,
                        float *prices)
{
    const size_t count = hatch_volume_count(volume);
    const uint32_t cell = 1u << HATCH_CELL_BITS;
    memset(counts, 0, HATCH_CELLS * sizeof *counts);
    for (uint32_t axis = 0; axis < HATCH_AXES; axis++)
        for (size_t i = 0; i < count && hatch_volume_has(volume, axis); i++)
            counts[hatch_cell_of(volume->matches[axis][i])]++;
    for (uint32_t y = 0; y < exemplar->down; y += cell)
        for (uint32_t x = 0; x < exemplar->across; x += cell) {
            uint32_t across = exemplar->across - x < cell ? exemplar->across - x : cell;
            uint32_t down = exemplar->down - y < cell ? exemplar->down - y : cell;
            float share = (float)(across * down) / (float)(exemplar->across * exemplar->down);
            float fair = (float)hatch_volume_axis_count(volume) * (float)count * share;
            uint32_t at = hatch_cell_of(y * HATCH_EXEMPLAR_PITCH + x);
            float change = sqrtf(((float)counts[at] + FEW * fair) / (fair + FEW * fair));
            prices[at] = fminf(fmaxf(prices[at] * fminf(fmaxf(change, 0.5f), 2), PRICE_MIN), PRICE_MAX);
        }
}
