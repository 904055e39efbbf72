#include <math.h>
#include <stdlib.h>

#include "math/range.h"
#include "vector/runs.h"
#include "vector/tidy/segments.h"
#include "vector/tidy/tidy.h"

#define SINE_MOST 0.35 /* of the angle between lines that count as doubles: 20 degrees */
#define SPECK_REACHES                                                                                                  \
    4.0                 /* what remains between two parts that are cut out, or beside one, is this many reaches long */
#define GAP_REACHES 3.0 /* parts that are cut out between two that remain are this many reaches long */

/* A path, its layer, and how long it is. */
struct rank {
    double length;
    uint32_t path, layer;
};

struct work {
    const struct hatch_vector_paths *paths;
    double reach;
    struct hatch_segments near; /* segments of the paths that remain, and of those drawn before */
    struct hatch_buffer ends;   /* of these segments, in the order of their numbers: 4 doubles each */
    uint32_t near_count;
    struct hatch_vector_runs runs;
    struct hatch_buffer covered; /* parts of a segment: 2 doubles each */
    uint32_t covered_count;
    const double *sought[2]; /* ends of the segment that is searched for */
    struct hatch_vector_builder built;
};

static int compare_ranks(const void *a, const void *b)
{
    const struct rank *x = a, *y = b;
    if (x->layer != y->layer)
        return x->layer > y->layer ? 1 : -1;
    if (x->length > y->length || x->length < y->length)
        return x->length > y->length ? -1 : 1;
    return (x->path > y->path) - (x->path < y->path);
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

/* Notes the part of the segment searched for that runs along one that remains. */
static enum hatch_status note(void *context, uint32_t segment, struct hatch_err *err)
{
    struct work *w = context;
    const double *ends = (const double *)(const void *)w->ends.data + 4 * (size_t)segment;
    double part[2];
    if (!runs_along(w, w->sought[0], w->sought[1], ends, ends + 2, part))
        return HATCH_OK;
    w->covered_count++;
    return hatch_buffer_add(&w->covered, part, sizeof part, err);
}

/* Finds the parts of a segment that run along segments that remain. */
static enum hatch_status find_covered(struct work *w, const double a[2], const double b[2], struct hatch_err *err)
{
    w->sought[0] = a;
    w->sought[1] = b;
    w->covered.size = 0;
    w->covered_count = 0;
    HATCH_TRY(hatch_segments_find(&w->near, a, b, w->reach, note, w, err));
    if (w->covered_count)
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

/* Adds the segments of a path to those that others must not run along. */
static enum hatch_status insert(struct work *w, const struct hatch_vector_paths *paths,
                                const struct hatch_vector_path *path, struct hatch_err *err)
{
    for (uint32_t i = 0; i < hatch_vector_segments(path); i++) {
        const double *a = hatch_vector_point(paths, path, i), *b = hatch_vector_point(paths, path, i + 1);
        const double ends[4] = {a[0], a[1], b[0], b[1]};
        HATCH_TRY(hatch_buffer_add(&w->ends, ends, sizeof ends, err));
        HATCH_TRY(hatch_segments_insert(&w->near, w->near_count++, a, b, err));
    }
    return HATCH_OK;
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
    const struct hatch_vector_paths made = hatch_vector_built(&w->built);
    for (uint32_t i = before; i < made.count; i++)
        HATCH_TRY(insert(w, &made, &made.paths[i], err));
    return HATCH_OK;
}

/* Begins a layer, of which only what was drawn before remains so far. */
static enum hatch_status begin_layer(struct work *w, const struct hatch_vector_paths *drawn,
                                     struct hatch_arena *scratch, struct hatch_err *err)
{
    w->ends.size = 0;
    w->near_count = 0;
    HATCH_TRY(hatch_segments_make(w->paths, w->reach, scratch, &w->near, err));
    for (uint32_t i = 0; drawn && i < drawn->count; i++)
        HATCH_TRY(insert(w, drawn, &drawn->paths[i], err));
    return HATCH_OK;
}

static enum hatch_status drop(struct work *w, const struct hatch_vector_paths *drawn, struct hatch_arena *scratch,
                              struct hatch_err *err)
{
    const struct hatch_vector_paths *paths = w->paths;
    struct rank *ranks;
    HATCH_TRY(HATCH_ALLOC(scratch, &ranks, paths->count, err));
    for (uint32_t i = 0; i < paths->count; i++) {
        const struct hatch_vector_path *path = &paths->paths[i];
        ranks[i] = (struct rank){hatch_vector_length(paths, path), i, path->layer};
    }
    qsort(ranks, paths->count, sizeof *ranks, compare_ranks);
    for (uint32_t i = 0; i < paths->count; i++) {
        if (i == 0 || ranks[i].layer != ranks[i - 1].layer)
            HATCH_TRY(begin_layer(w, drawn, scratch, err));
        HATCH_TRY(add_path(w, &paths->paths[ranks[i].path], err));
    }
    return HATCH_OK;
}

enum hatch_status hatch_vector_drop_doubles(const struct hatch_vector_paths *paths,
                                            const struct hatch_vector_paths *drawn, double reach,
                                            struct hatch_arena *arena, struct hatch_arena *scratch,
                                            struct hatch_vector_paths *single, struct hatch_err *err)
{
    struct hatch_arena_mark mark = hatch_arena_mark(scratch);
    struct work work = {.paths = paths,
                        .reach = reach,
                        .ends = {.arena = scratch},
                        .covered = {.arena = scratch},
                        .runs = hatch_vector_runs_of(scratch),
                        .built = hatch_vector_builder_of(arena)};
    enum hatch_status status = drop(&work, drawn, scratch, err);
    hatch_arena_rewind(scratch, mark);
    if (status == HATCH_OK)
        *single = hatch_vector_built(&work.built);
    return status;
}
