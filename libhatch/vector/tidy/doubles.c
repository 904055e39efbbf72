#include <math.h>
#include <stdlib.h>

#include "math/range.h"
#include "vector/cells.h"
#include "vector/runs.h"
#include "vector/tidy/tidy.h"

#define SINE_MOST 0.35 /* of the angle between lines that count as doubles: 20 degrees */
#define SPECK_REACHES                                                                                                  \
    4.0                 /* what remains between two parts that are cut out, or beside one, is this many reaches long */
#define GAP_REACHES 3.0 /* parts that are cut out between two that remain are this many reaches long */
#define NONE UINT32_MAX

/* A segment of a path that remains, in a cell that it passes. */
struct entry {
    uint32_t point; /* its first end, among the points that remain */
    uint32_t next;  /* entry of the same cell, or NONE */
};

/* A path, and how long it is. */
struct rank {
    double length;
    uint32_t path;
};

struct work {
    const struct hatch_vector_paths *paths;
    double reach;
    struct hatch_vector_cells cells;
    uint32_t *head; /* per cell: its newest entry, or NONE */
    struct hatch_buffer entries;
    uint32_t entry_count;
    struct hatch_vector_runs runs;
    struct hatch_buffer covered; /* parts of a segment: 2 doubles each */
    uint32_t covered_count;
    struct hatch_buffer looked; /* per point that remains: the last search that looked at its segment */
    uint32_t search;
    struct hatch_vector_builder built;
};

static int compare_ranks(const void *a, const void *b)
{
    const struct rank *x = a, *y = b;
    if (x->length > y->length || x->length < y->length)
        return x->length > y->length ? -1 : 1;
    return (x->path > y->path) - (x->path < y->path);
}

/* The cells around a part of a segment. */
struct window {
    uint32_t low[2], high[2];
};

static struct window window_of(const struct work *w, const double a[2], const double b[2], double margin)
{
    struct window window;
    for (int k = 0; k < 2; k++) {
        window.low[k] = hatch_vector_cell(&w->cells, k, fmin(a[k], b[k]) - margin);
        window.high[k] = hatch_vector_cell(&w->cells, k, fmax(a[k], b[k]) + margin);
    }
    return window;
}

/* Returns how many parts a segment is divided into, so that the cells around each part are few. */
static uint32_t parts_of(const struct work *w, const double a[2], const double b[2])
{
    return (uint32_t)fmin(ceil(hatch_vector_distance(a, b) / w->cells.side), 1e6) + 1;
}

static void part_at(const double a[2], const double b[2], uint32_t part, uint32_t parts, double from[2], double to[2])
{
    for (int k = 0; k < 2; k++) {
        from[k] = a[k] + (b[k] - a[k]) * part / parts;
        to[k] = a[k] + (b[k] - a[k]) * (part + 1) / parts;
    }
}

/* Adds a segment that remains to the cells that it passes. */
static enum hatch_status insert(struct work *w, uint32_t point, const double a[2], const double b[2],
                                struct hatch_err *err)
{
    uint32_t parts = parts_of(w, a, b);
    for (uint32_t part = 0; part < parts; part++) {
        double from[2], to[2];
        part_at(a, b, part, parts, from, to);
        const struct window window = window_of(w, from, to, 0);
        for (uint32_t row = window.low[1]; row <= window.high[1]; row++)
            for (uint32_t column = window.low[0]; column <= window.high[0]; column++) {
                uint32_t *head = &w->head[(size_t)row * w->cells.columns + column];
                const struct entry entry = {point, *head};
                HATCH_TRY(hatch_buffer_add(&w->entries, &entry, sizeof entry, err));
                *head = w->entry_count++;
            }
    }
    return HATCH_OK;
}

/* Finds the part of the segment a b that runs along the segment c d. */
static bool runs_along(const struct work *w, const double a[2], const double b[2], const double c[2], const double d[2],
                       double part[2])
{
    double length = hatch_vector_distance(a, b), other = hatch_vector_distance(c, d), across[2], along[2];
    const double *ends[2] = {a, b};
    if (!(length > 0 && other > 0))
        return false;
    const double way[2] = {(d[0] - c[0]) / other, (d[1] - c[1]) / other};
    for (int i = 0; i < 2; i++) {
        double x = ends[i][0] - c[0], y = ends[i][1] - c[1];
        along[i] = x * way[0] + y * way[1];
        across[i] = y * way[0] - x * way[1];
    }
    part[0] = 0;
    part[1] = 1;
    return fabs(across[1] - across[0]) <= SINE_MOST * length &&
           hatch_range_keep(w->reach - across[0], w->reach - across[1], &part[0], &part[1]) &&
           hatch_range_keep(w->reach + across[0], w->reach + across[1], &part[0], &part[1]) &&
           hatch_range_keep(along[0], along[1], &part[0], &part[1]) &&
           hatch_range_keep(other - along[0], other - along[1], &part[0], &part[1]);
}

static int compare_parts(const void *a, const void *b)
{
    const double *x = a, *y = b;
    return x[0] > y[0] ? 1 : x[0] < y[0] ? -1 : (x[1] > y[1]) - (x[1] < y[1]);
}

/* Finds the parts of a segment that run along segments that remain. */
static enum hatch_status find_covered(struct work *w, const double a[2], const double b[2], struct hatch_err *err)
{
    uint32_t parts = parts_of(w, a, b);
    uint32_t *looked = (void *)w->looked.data;
    w->covered.size = 0;
    w->covered_count = 0;
    w->search++;
    for (uint32_t i = 0; i < parts; i++) {
        double from[2], to[2], part[2];
        part_at(a, b, i, parts, from, to);
        const struct window window = window_of(w, from, to, w->reach);
        for (uint32_t row = window.low[1]; row <= window.high[1]; row++)
            for (uint32_t column = window.low[0]; column <= window.high[0]; column++)
                for (uint32_t at = w->head[(size_t)row * w->cells.columns + column]; at != NONE;) {
                    const struct entry *entry = (const struct entry *)(const void *)w->entries.data + at;
                    const double *c = (const double *)(const void *)w->built.points.data + 2 * (size_t)entry->point;
                    at = entry->next;
                    if (looked[entry->point] == w->search)
                        continue;
                    looked[entry->point] = w->search;
                    if (!runs_along(w, a, b, c, c + 2, part))
                        continue;
                    HATCH_TRY(hatch_buffer_add(&w->covered, part, sizeof part, err));
                    w->covered_count++;
                }
    }
    qsort(w->covered.data, w->covered_count, 2 * sizeof(double), compare_parts);
    return HATCH_OK;
}

/* Adds the pieces of a segment to the runs: those that are not covered are kept. */
static enum hatch_status add_segment(struct work *w, const double a[2], const double b[2], struct hatch_err *err)
{
    double at = 0;
    HATCH_TRY(find_covered(w, a, b, err));
    for (uint32_t i = 0; i < w->covered_count; i++) {
        const double *part = (const double *)(const void *)w->covered.data + 2 * (size_t)i;
        HATCH_TRY(hatch_vector_runs_add(&w->runs, a, b, at, part[0], true, err));
        HATCH_TRY(hatch_vector_runs_add(&w->runs, a, b, fmax(at, part[0]), part[1], false, err));
        at = fmax(at, part[1]);
    }
    return hatch_vector_runs_add(&w->runs, a, b, at, 1, true, err);
}

/* Adds what remains of a path. */
static enum hatch_status add_path(struct work *w, const struct hatch_vector_path *path, struct hatch_err *err)
{
    uint32_t before = hatch_vector_built(&w->built).count;
    hatch_vector_runs_clear(&w->runs);
    for (uint32_t i = 0; i < hatch_vector_segments(path); i++)
        HATCH_TRY(
            add_segment(w, hatch_vector_point(w->paths, path, i), hatch_vector_point(w->paths, path, i + 1), err));
    HATCH_TRY(hatch_vector_runs_make(&w->runs, err));
    hatch_vector_runs_drop(&w->runs, SPECK_REACHES * w->reach, path->closed);
    hatch_vector_runs_fill(&w->runs, GAP_REACHES * w->reach);
    HATCH_TRY(hatch_vector_runs_deliver(&w->runs, path, path->closed, true, &w->built, err));
    size_t looked_bytes = w->built.points.size / (2 * sizeof(double)) * sizeof(uint32_t);
    HATCH_TRY(hatch_buffer_add(&w->looked, NULL, looked_bytes - w->looked.size, err));
    const struct hatch_vector_paths made = hatch_vector_built(&w->built);
    for (uint32_t i = before; i < made.count; i++)
        for (uint32_t k = 0; k + 1 < made.paths[i].count; k++)
            HATCH_TRY(insert(w, made.paths[i].first + k, hatch_vector_point(&made, &made.paths[i], k),
                             hatch_vector_point(&made, &made.paths[i], k + 1), err));
    return HATCH_OK;
}

static enum hatch_status drop(struct work *w, struct hatch_arena *scratch, struct hatch_err *err)
{
    const struct hatch_vector_paths *paths = w->paths;
    size_t points = hatch_vector_point_count(paths);
    struct rank *ranks;
    w->cells = hatch_vector_cells_over(paths->points, points, (double)points + 1, 2 * w->reach);
    size_t cells = (size_t)w->cells.columns * w->cells.rows;
    HATCH_TRY(HATCH_ALLOC(scratch, &w->head, cells, err));
    HATCH_TRY(HATCH_ALLOC(scratch, &ranks, paths->count, err));
    for (size_t i = 0; i < cells; i++)
        w->head[i] = NONE;
    for (uint32_t i = 0; i < paths->count; i++)
        ranks[i] = (struct rank){hatch_vector_length(paths, &paths->paths[i]), i};
    qsort(ranks, paths->count, sizeof *ranks, compare_ranks);
    for (uint32_t i = 0; i < paths->count; i++)
        HATCH_TRY(add_path(w, &paths->paths[ranks[i].path], err));
    return HATCH_OK;
}

enum hatch_status hatch_vector_drop_doubles(const struct hatch_vector_paths *paths, double reach,
                                            struct hatch_arena *arena, struct hatch_arena *scratch,
                                            struct hatch_vector_paths *single, struct hatch_err *err)
{
    struct hatch_arena_mark mark = hatch_arena_mark(scratch);
    struct work work = {.paths = paths,
                        .reach = reach,
                        .entries = {.arena = scratch},
                        .covered = {.arena = scratch},
                        .looked = {.arena = scratch},
                        .runs = hatch_vector_runs_of(scratch),
                        .built = hatch_vector_builder_of(arena)};
    enum hatch_status status = drop(&work, scratch, err);
    hatch_arena_rewind(scratch, mark);
    if (status == HATCH_OK)
        *single = hatch_vector_built(&work.built);
    return status;
}
