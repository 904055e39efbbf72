/* Which tiles of the ground are traced, and which are missing. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "trace/finer/store.h"

#define TILE_GAPS 16.0    /* side of a tile */
#define TILE_BYTES 512.0  /* of strokes in a tile, before it is known */
#define MARGIN_GAPS 100.0 /* around missing tiles, in which strokes are traced with them, since they may matter */

double hatch_store_gap(const struct hatch_store *store, uint32_t level, const struct hatch_component *component)
{
    return ldexp(store->options.gap, -(int)level) / component->scale;
}

double hatch_store_tile_side(double gap)
{
    return TILE_GAPS * gap;
}

/* Returns the number of tiles along an axis of a face. */
static int64_t tiles_along(double size, double side)
{
    return (int64_t)fmax(ceil(size / side), 1);
}

static int64_t tile_number(double from_low, double size, double side)
{
    return (int64_t)fmin(fmax(floor(from_low / side), 0), (double)(tiles_along(size, side) - 1));
}

struct hatch_store_tile hatch_store_tile_at(const struct hatch_trace_ground *ground, uint32_t face, const double at[2],
                                            double side)
{
    const struct hatch_trace_window whole = hatch_trace_window_of(ground, face);
    return (struct hatch_store_tile){face, tile_number(at[0] - whole.low[0], whole.high[0] - whole.low[0], side),
                                     tile_number(at[1] - whole.low[1], whole.high[1] - whole.low[1], side)};
}

static struct hatch_trace_window window_of(const struct hatch_trace_ground *ground, const struct hatch_store_tile *tile,
                                           double side)
{
    const struct hatch_trace_window whole = hatch_trace_window_of(ground, tile->face);
    double low[2] = {whole.low[0] + (double)tile->x * side, whole.low[1] + (double)tile->y * side};
    return (struct hatch_trace_window){
        tile->face, {low[0], low[1]}, {fmin(low[0] + side, whole.high[0]), fmin(low[1] + side, whole.high[1])}};
}

static int compare(const void *a, const void *b)
{
    const struct hatch_store_tile *x = a, *y = b;
    if (x->face != y->face)
        return x->face < y->face ? -1 : 1;
    if (x->y != y->y)
        return x->y < y->y ? -1 : 1;
    return (x->x > y->x) - (x->x < y->x);
}

bool hatch_store_has_tile(const struct hatch_store_batch *batch, const struct hatch_store_tile *tile)
{
    return batch->tile_count > 0 && bsearch(tile, batch->tiles, batch->tile_count, sizeof *tile, compare);
}

/* Returns whether a tile of a level is traced, and notes that its batch is in use. */
static bool is_traced(struct hatch_store *store, uint32_t level, const struct hatch_component *component,
                      const struct hatch_store_tile *tile)
{
    for (struct hatch_store_batch *batch = store->batches; batch; batch = batch->next)
        if (batch->level == level && batch->component == component && hatch_store_has_tile(batch, tile)) {
            batch->used = store->view;
            return true;
        }
    return false;
}

/* Lists the tiles of a region of a component that are not traced, in order.
 *   tiles  out: in scratch */
static enum hatch_status list_missing(struct hatch_store *store, uint32_t level,
                                      const struct hatch_component *component, double side,
                                      const struct hatch_trace_region *region, struct hatch_store_tile **tiles,
                                      uint32_t *count, struct hatch_err *err)
{
    uint32_t capacity = 0;
    *tiles = NULL;
    *count = 0;
    for (uint32_t i = 0; i < region->count; i++) {
        const struct hatch_trace_window *window = &region->windows[i];
        struct hatch_store_tile first = hatch_store_tile_at(&store->ground, window->face, window->low, side);
        struct hatch_store_tile last = hatch_store_tile_at(&store->ground, window->face, window->high, side);
        for (int64_t y = first.y; y <= last.y; y++)
            for (int64_t x = first.x; x <= last.x; x++) {
                const struct hatch_store_tile tile = {window->face, x, y};
                if (is_traced(store, level, component, &tile))
                    continue;
                HATCH_TRY(hatch_curve_reserve(&store->scratch, tiles, sizeof **tiles, *count, &capacity, err));
                (*tiles)[(*count)++] = tile;
            }
    }
    return HATCH_OK;
}

/* Makes a batch with copies of the tiles, lines and pieces of another one, in an arena of their size. */
static enum hatch_status copy_batch(struct hatch_store *store, const struct hatch_store_batch *from,
                                    struct hatch_store_batch **batch, struct hatch_err *err)
{
    struct hatch_arena arena;
    hatch_arena_init_shared(&arena, &store->budget);
    struct hatch_store_batch *made = hatch_arena_array(&arena, 1, sizeof *made, err);
    struct hatch_store_tile *tiles = made ? hatch_arena_array(&arena, from->tile_count, sizeof *tiles, err) : NULL;
    struct hatch_store_line *lines = tiles ? hatch_arena_array(&arena, from->line_count, sizeof *lines, err) : NULL;
    struct hatch_store_piece *pieces = lines ? hatch_arena_array(&arena, from->piece_count, sizeof *pieces, err) : NULL;
    if (!pieces) {
        hatch_arena_free(&arena);
        return HATCH_LIMIT;
    }
    memcpy(tiles, from->tiles, sizeof *tiles * from->tile_count);
    if (from->line_count > 0)
        memcpy(lines, from->lines, sizeof *lines * from->line_count);
    if (from->piece_count > 0)
        memcpy(pieces, from->pieces, sizeof *pieces * from->piece_count);
    *made = *from;
    made->tiles = tiles;
    made->lines = lines;
    made->pieces = pieces;
    made->line_capacity = from->line_count;
    made->piece_capacity = from->piece_count;
    made->arena = arena;
    *batch = made;
    return HATCH_OK;
}

/* The tiles of a level that are to be traced, and the region in which they are traced with all that may matter. */
struct plan {
    struct hatch_store_tile *tiles;
    uint32_t count;
    struct hatch_trace_region region;
};

/* Lists the windows that a level is needed in: those of the view, and the region of the next level.
 *   windows  out: in scratch */
static enum hatch_status join(struct hatch_store *store, const struct hatch_store_windows *shown,
                              const struct plan *next, struct hatch_trace_window **windows, uint32_t *count,
                              struct hatch_err *err)
{
    *count = shown->count + next->region.count;
    HATCH_TRY(HATCH_ALLOC_UNSET(&store->scratch, windows, *count, err));
    if (shown->count > 0)
        memcpy(*windows, shown->items, sizeof **windows * shown->count);
    if (next->region.count > 0)
        memcpy(*windows + shown->count, next->region.windows, sizeof **windows * next->region.count);
    return HATCH_OK;
}

/* Plans to trace what is missing around some windows.
 *   plans  holds the region; the rest is in scratch */
static enum hatch_status plan_around(struct hatch_store *store, uint32_t level, const struct hatch_component *component,
                                     struct hatch_trace_window *windows, uint32_t count, struct hatch_arena *plans,
                                     struct plan *plan, struct hatch_err *err)
{
    double gap = hatch_store_gap(store, level, component), side = TILE_GAPS * gap;
    struct hatch_trace_region around;
    HATCH_TRY(hatch_trace_region_around(&store->ground, windows, count,
                                        HATCH_TRACE_DETOUR * store->options.length / 2 * gap, plans, &store->scratch,
                                        &around, err));
    HATCH_TRY(list_missing(store, level, component, side, &around, &plan->tiles, &plan->count, err));
    HATCH_TRY(HATCH_ALLOC_UNSET(&store->scratch, &windows, plan->count, err));
    for (uint32_t i = 0; i < plan->count; i++)
        windows[i] = window_of(&store->ground, &plan->tiles[i], side);
    return plan->count > 0 ? hatch_trace_region_around(&store->ground, windows, plan->count, MARGIN_GAPS * gap, plans,
                                                       &store->scratch, &plan->region, err)
                           : HATCH_OK;
}

static double area_of(const struct hatch_trace_window *window)
{
    return (window->high[0] - window->low[0]) * (window->high[1] - window->low[1]);
}

static double area_of_region(const struct hatch_trace_region *region)
{
    double area = 0;
    for (uint32_t i = 0; i < region->count; i++)
        area += area_of(&region->windows[i]);
    return area;
}

/* Returns whether all of a component is to be traced in place of a region: when as much has been traced for earlier
 * views, in regions that overlap, and when all of it can be kept. Views of a film then cost at most about twice as much
 * as the component does. */
static bool is_worth_all(const struct hatch_store *store, uint32_t level, const struct hatch_component *component,
                         const struct hatch_trace_region *region)
{
    double side = TILE_GAPS * hatch_store_gap(store, level, component), area = 0, tiles = 0;
    double traced = 0, traced_tiles = 1, traced_bytes = TILE_BYTES;
    for (const struct hatch_store_batch *batch = store->batches; batch; batch = batch->next)
        if (batch->level == level && batch->component == component) {
            traced += batch->area;
            traced_tiles += batch->tile_count;
            traced_bytes += (double)batch->arena.used_bytes;
        }
    for (uint32_t f = component->first_face; f < component->first_face + component->face_count; f++) {
        const struct hatch_trace_window whole = hatch_trace_window_of(&store->ground, f);
        area += area_of(&whole);
        tiles += (double)tiles_along(whole.high[0] - whole.low[0], side) *
                 (double)tiles_along(whole.high[1] - whole.low[1], side);
    }
    return traced + area_of_region(region) >= (1 - 1e-9) * area &&
           traced_bytes * tiles <= (double)store->keep_bytes * traced_tiles;
}

/* Plans a level.
 *   plans  holds the region; the rest is in scratch */
static enum hatch_status make_plan(struct hatch_store *store, uint32_t level, const struct hatch_component *component,
                                   const struct hatch_store_windows *shown, const struct plan *next,
                                   struct hatch_arena *plans, struct plan *plan, struct hatch_err *err)
{
    struct hatch_trace_window *windows;
    uint32_t count;
    HATCH_TRY(join(store, shown, next, &windows, &count, err));
    if (count == 0)
        return HATCH_OK;
    HATCH_TRY(plan_around(store, level, component, windows, count, plans, plan, err));
    if (plan->count == 0 || !is_worth_all(store, level, component, &plan->region))
        return HATCH_OK;
    HATCH_TRY(HATCH_ALLOC_UNSET(&store->scratch, &windows, component->face_count, err));
    for (uint32_t i = 0; i < component->face_count; i++)
        windows[i] = hatch_trace_window_of(&store->ground, component->first_face + i);
    return plan_around(store, level, component, windows, component->face_count, plans, plan, err);
}

static enum hatch_status carry_out(struct hatch_store *store, uint32_t level, const struct hatch_component *component,
                                   const struct plan *plan, struct hatch_err *err)
{
    struct hatch_store_batch traced = {.level = level,
                                       .component = component,
                                       .used = store->view,
                                       .area = area_of_region(&plan->region),
                                       .tiles = plan->tiles,
                                       .tile_count = plan->count},
                             *batch;
    if (plan->count == 0)
        return HATCH_OK;
    hatch_arena_init_shared(&traced.arena, &store->budget);
    enum hatch_status status = hatch_store_trace_region(store, component, &plan->region, &traced, err);
    if (status == HATCH_OK)
        status = copy_batch(store, &traced, &batch, err);
    hatch_arena_free(&traced.arena);
    HATCH_TRY(status);
    store->traced += batch->line_count;
    batch->next = store->batches;
    store->batches = batch;
    return HATCH_OK;
}

enum hatch_status hatch_store_trace(struct hatch_store *store, const struct hatch_component *component,
                                    const struct hatch_store_windows shown[HATCH_FINER_LEVELS_MAX],
                                    struct hatch_err *err)
{
    struct plan plans[HATCH_FINER_LEVELS_MAX + 1] = {{.count = 0}};
    struct hatch_arena regions;
    struct hatch_arena_mark mark = hatch_arena_mark(&store->scratch);
    enum hatch_status status = HATCH_OK;
    hatch_arena_init_shared(&regions, &store->budget);
    for (uint32_t i = HATCH_FINER_LEVELS_MAX; i-- > 0 && status == HATCH_OK;)
        status =
            make_plan(store, store->level_count + i, component, &shown[i], &plans[i + 1], &regions, &plans[i], err);
    for (uint32_t i = 0; i < HATCH_FINER_LEVELS_MAX && status == HATCH_OK; i++)
        status = carry_out(store, store->level_count + i, component, &plans[i], err);
    hatch_arena_free(&regions);
    hatch_arena_rewind(&store->scratch, mark);
    return status;
}

void hatch_store_free_batch(struct hatch_store_batch *batch)
{
    struct hatch_arena arena = batch->arena; /* which holds the batch */
    hatch_arena_free(&arena);
}
