#include <math.h>
#include <stdlib.h>

#include "vector/cells.h"
#include "vector/tidy/tidy.h"

#define NONE UINT32_MAX
#define PARTNERS_MAX 16u /* ends that are compared with an end, at most */
#define BEND_COST 2.0    /* what turning back costs, in reaches */

/* Ends of paths are numbered: 2 * path is its first point, 2 * path + 1 its last one. */

/* Two ends that may be joined. */
struct pair {
    double cost;
    uint32_t ends[2];
};

struct work {
    const struct hatch_vector_paths *paths;
    double reach;
    struct hatch_vector_cells cells;
    uint32_t *head, *next; /* ends of each cell as a list */
    struct hatch_buffer pairs;
    uint32_t pair_count;
    uint32_t *link; /* per end: the end that it is joined to, or NONE */
    uint8_t *taken; /* per path */
    struct hatch_vector_builder built;
};

static const double *end_at(const struct work *w, uint32_t end)
{
    const struct hatch_vector_path *path = &w->paths->paths[end / 2];
    return hatch_vector_point(w->paths, path, end % 2 ? path->count - 1 : 0);
}

/* Computes the direction in which a path leaves at an end. Returns false if it has none. */
static bool leaves(const struct work *w, uint32_t end, double way[2])
{
    const struct hatch_vector_path *path = &w->paths->paths[end / 2];
    const double *at = end_at(w, end), *from = at;
    for (uint32_t i = 1; i < path->count && hatch_vector_distance(from, at) < w->reach; i++)
        from = hatch_vector_point(w->paths, path, end % 2 ? path->count - 1 - i : i);
    double length = hatch_vector_distance(from, at);
    for (int k = 0; k < 2 && length > 0; k++)
        way[k] = (at[k] - from[k]) / length;
    return length > 0;
}

static double cost_of(const struct work *w, uint32_t a, uint32_t b, double distance)
{
    double ways[2][2], straight = 0;
    if (leaves(w, a, ways[0]) && leaves(w, b, ways[1]))
        straight = -(ways[0][0] * ways[1][0] + ways[0][1] * ways[1][1]);
    return distance / w->reach + 0.5 * BEND_COST * (1 - straight);
}

/* Lists the pairs of an end with later ones. */
static enum hatch_status pair_up(struct work *w, uint32_t end, struct hatch_err *err)
{
    const double *at = end_at(w, end);
    uint32_t low[2], high[2], found = 0;
    for (int k = 0; k < 2; k++) {
        low[k] = hatch_vector_cell(&w->cells, k, at[k] - w->reach);
        high[k] = hatch_vector_cell(&w->cells, k, at[k] + w->reach);
    }
    for (uint32_t row = low[1]; row <= high[1]; row++)
        for (uint32_t column = low[0]; column <= high[0]; column++)
            for (uint32_t other = w->head[(size_t)row * w->cells.columns + column];
                 other != NONE && other > end && found < PARTNERS_MAX; other = w->next[other]) {
                double distance = hatch_vector_distance(at, end_at(w, other));
                if (distance > w->reach || w->paths->paths[end / 2].layer != w->paths->paths[other / 2].layer)
                    continue;
                /* A short path is not closed to a dot. */
                if (end / 2 == other / 2 && hatch_vector_length(w->paths, &w->paths->paths[end / 2]) < 4 * w->reach)
                    continue;
                const struct pair pair = {cost_of(w, end, other, distance), {end, other}};
                HATCH_TRY(hatch_buffer_add(&w->pairs, &pair, sizeof pair, err));
                w->pair_count++;
                found++;
            }
    return HATCH_OK;
}

static int compare(const void *a, const void *b)
{
    const struct pair *x = a, *y = b;
    if (x->cost > y->cost || x->cost < y->cost)
        return x->cost > y->cost ? 1 : -1;
    if (x->ends[0] != y->ends[0])
        return x->ends[0] > y->ends[0] ? 1 : -1;
    return (x->ends[1] > y->ends[1]) - (x->ends[1] < y->ends[1]);
}

static enum hatch_status link_ends(struct work *w, struct hatch_arena *scratch, struct hatch_err *err)
{
    uint32_t ends = 2 * w->paths->count;
    w->cells = hatch_vector_cells_over(w->paths->points, hatch_vector_point_count(w->paths), ends + 1.0, w->reach);
    size_t cells = (size_t)w->cells.columns * w->cells.rows;
    HATCH_TRY(HATCH_ALLOC(scratch, &w->head, cells, err));
    HATCH_TRY(HATCH_ALLOC(scratch, &w->next, ends, err));
    HATCH_TRY(HATCH_ALLOC(scratch, &w->link, ends, err));
    HATCH_TRY(HATCH_ALLOC(scratch, &w->taken, w->paths->count, err));
    for (size_t i = 0; i < cells; i++)
        w->head[i] = NONE;
    for (uint32_t end = 0; end < ends; end++) {
        const double *at = end_at(w, end);
        w->link[end] = NONE;
        if (w->paths->paths[end / 2].closed)
            continue;
        uint32_t *head = &w->head[(size_t)hatch_vector_cell(&w->cells, 1, at[1]) * w->cells.columns +
                                  hatch_vector_cell(&w->cells, 0, at[0])];
        w->next[end] = *head;
        *head = end;
    }
    for (uint32_t end = 0; end < ends; end++)
        if (!w->paths->paths[end / 2].closed)
            HATCH_TRY(pair_up(w, end, err));
    if (w->pair_count)
        qsort(w->pairs.data, w->pair_count, sizeof(struct pair), compare);
    for (uint32_t i = 0; i < w->pair_count; i++) {
        const struct pair *pair = (const struct pair *)(const void *)w->pairs.data + i;
        if (w->link[pair->ends[0]] != NONE || w->link[pair->ends[1]] != NONE)
            continue;
        w->link[pair->ends[0]] = pair->ends[1];
        w->link[pair->ends[1]] = pair->ends[0];
    }
    return HATCH_OK;
}

/* Writes the path that begins at an end. */
static enum hatch_status walk(struct work *w, uint32_t begin, struct hatch_err *err)
{
    uint32_t end = begin, id = UINT32_MAX;
    bool closed = w->paths->paths[begin / 2].closed;
    hatch_vector_begin(&w->built, &w->paths->paths[begin / 2]);
    for (;;) {
        const struct hatch_vector_path *path = &w->paths->paths[end / 2];
        w->taken[end / 2] = 1;
        id = path->id < id ? path->id : id;
        for (uint32_t i = 0; i < path->count; i++)
            HATCH_TRY(hatch_vector_add(&w->built, hatch_vector_point(w->paths, path, end % 2 ? path->count - 1 - i : i),
                                       err));
        uint32_t next = w->link[end ^ 1];
        closed = closed || next == begin;
        if (next == NONE || w->taken[next / 2])
            break;
        end = next;
    }
    w->built.path.id = id;
    return hatch_vector_end(&w->built, closed, err);
}

static enum hatch_status join(struct work *w, struct hatch_arena *scratch, struct hatch_err *err)
{
    HATCH_TRY(link_ends(w, scratch, err));
    for (int loops = 0; loops < 2; loops++)
        for (uint32_t end = 0; end < 2 * w->paths->count; end++)
            if (!w->taken[end / 2] && (loops || w->link[end] == NONE))
                HATCH_TRY(walk(w, end, err));
    return HATCH_OK;
}

enum hatch_status hatch_vector_join(const struct hatch_vector_paths *paths, double reach, struct hatch_arena *arena,
                                    struct hatch_arena *scratch, struct hatch_vector_paths *joined,
                                    struct hatch_err *err)
{
    struct hatch_arena_mark mark = hatch_arena_mark(scratch);
    struct work work = {
        .paths = paths, .reach = reach, .pairs = {.arena = scratch}, .built = hatch_vector_builder_of(arena)};
    enum hatch_status status = join(&work, scratch, err);
    hatch_arena_rewind(scratch, mark);
    if (status == HATCH_OK)
        *joined = hatch_vector_built(&work.built);
    return status;
}
