#include <math.h>
#include <string.h>

#include "vector/cells.h"
#include "vector/tidy/tidy.h"
#include "vector/tidy/tour.h"

#define ENTRIES_MOST 16u /* points at which a closed path may be begun */
#define NONE UINT32_MAX

/* A point at which a path may be begun. */
struct entry {
    uint32_t path;
    uint32_t point;        /* of the path */
    uint32_t next, before; /* entries of the same cell */
};

struct work {
    const struct hatch_vector_paths *paths;
    uint32_t entry_count, left; /* left: entries of paths that have not been chosen */
    struct entry *entries;
    uint32_t *first_entry; /* per path, and the end */
    uint8_t *chosen;       /* per path */
    struct hatch_vector_cells cells;
    uint32_t *head;  /* per cell */
    uint32_t listed; /* number of entries when the cells were made */
};

static const double *place_of(const struct work *w, uint32_t entry)
{
    const struct entry *at = &w->entries[entry];
    return hatch_vector_point(w->paths, &w->paths->paths[at->path], at->point);
}

static uint32_t cell_at(const struct work *w, const double at[2])
{
    return hatch_vector_cell(&w->cells, 1, at[1]) * w->cells.columns + hatch_vector_cell(&w->cells, 0, at[0]);
}

static void put_in(struct work *w, uint32_t entry)
{
    uint32_t *head = &w->head[cell_at(w, place_of(w, entry))];
    w->entries[entry].next = *head;
    w->entries[entry].before = NONE;
    if (*head != NONE)
        w->entries[*head].before = entry;
    *head = entry;
}

static void take_out(struct work *w, uint32_t entry)
{
    const struct entry *at = &w->entries[entry];
    if (at->next != NONE)
        w->entries[at->next].before = at->before;
    if (at->before != NONE)
        w->entries[at->before].next = at->next;
    else
        w->head[cell_at(w, place_of(w, entry))] = at->next;
    w->left--;
}

/* Makes cells that suit the number of entries that are left, and puts those in. */
static void make_cells(struct work *w, const struct hatch_vector_cells *whole)
{
    double share = sqrt((double)w->entry_count / (w->left + 1.0));
    w->cells = *whole;
    w->cells.side = whole->side * fmax(share, 1);
    w->cells.columns = (uint32_t)(whole->columns * whole->side / w->cells.side) + 1;
    w->cells.rows = (uint32_t)(whole->rows * whole->side / w->cells.side) + 1;
    for (size_t i = 0; i < (size_t)w->cells.columns * w->cells.rows; i++)
        w->head[i] = NONE;
    for (uint32_t i = w->entry_count; i > 0; i--)
        if (!w->chosen[w->entries[i - 1].path])
            put_in(w, i - 1);
    w->listed = w->left;
}

/* Looks through a cell for an entry nearer than the best one so far. */
static void look(const struct work *w, int64_t column, int64_t row, const double at[2], uint32_t *best, double *least)
{
    if (column < 0 || row < 0 || column >= w->cells.columns || row >= w->cells.rows)
        return;
    for (uint32_t i = w->head[(size_t)row * w->cells.columns + (size_t)column]; i != NONE; i = w->entries[i].next) {
        double distance = hatch_vector_distance(at, place_of(w, i));
        if (distance < *least || (!(distance > *least) && i < *best)) {
            *least = distance;
            *best = i;
        }
    }
}

/* Returns the entry nearest to a point: looks through rings of cells around it until no farther ring can be nearer. */
static uint32_t nearest(const struct work *w, const double at[2])
{
    int64_t column = hatch_vector_cell(&w->cells, 0, at[0]), row = hatch_vector_cell(&w->cells, 1, at[1]);
    int64_t rings = w->cells.columns > w->cells.rows ? w->cells.columns : w->cells.rows;
    uint32_t best = NONE;
    double least = INFINITY;
    for (int64_t ring = 0; ring <= rings && least > ((double)ring - 1) * w->cells.side; ring++)
        for (int64_t x = column - ring; x <= column + ring; x++) {
            bool side = x == column - ring || x == column + ring;
            for (int64_t y = row - ring; y <= row + ring; y += side || ring == 0 ? 1 : 2 * ring)
                look(w, x, y, at, &best, &least);
        }
    return best;
}

/* Returns where the pen leaves a path that it begins at an entry. */
static const double *leave(const struct work *w, uint32_t entry)
{
    const struct hatch_vector_path *path = &w->paths->paths[w->entries[entry].path];
    uint32_t point = w->entries[entry].point;
    return hatch_vector_point(w->paths, path, path->closed ? point : path->count - 1 - point);
}

static enum hatch_status list_entries(struct work *w, struct hatch_arena *scratch, struct hatch_err *err)
{
    const struct hatch_vector_paths *paths = w->paths;
    uint64_t most = 0;
    for (uint32_t i = 0; i < paths->count; i++)
        most += paths->paths[i].closed ? ENTRIES_MOST : 2;
    if (most >= NONE)
        return hatch_fail(err, HATCH_LIMIT, "a drawing has too many paths to be sorted: %u", paths->count);
    HATCH_TRY(HATCH_ALLOC(scratch, &w->entries, most, err));
    for (uint32_t i = 0; i < paths->count; i++) {
        const struct hatch_vector_path *path = &paths->paths[i];
        uint32_t count = !path->closed                ? (path->count > 1 ? 2 : 1)
                         : path->count < ENTRIES_MOST ? path->count
                                                      : ENTRIES_MOST;
        w->first_entry[i] = w->entry_count;
        for (uint32_t k = 0; k < count; k++) {
            uint32_t point = path->closed ? (uint32_t)((uint64_t)k * path->count / count) : k * (path->count - 1);
            w->entries[w->entry_count++] = (struct entry){.path = i, .point = point};
        }
    }
    w->first_entry[paths->count] = w->entry_count;
    return HATCH_OK;
}

/* Orders the paths of a layer, which are a range of the tour: each time the nearest one. The pen moves on. */
static void order_layer(struct work *w, struct hatch_tour *tour, uint32_t layer, double pen[2])
{
    uint32_t most = 0;
    for (uint32_t i = 0; i < w->paths->count; i++) {
        w->chosen[i] = w->paths->paths[i].layer != layer;
        most += w->chosen[i] ? 0 : w->first_entry[i + 1] - w->first_entry[i];
    }
    const struct hatch_vector_cells whole =
        hatch_vector_cells_over(w->paths->points, hatch_vector_point_count(w->paths), fmax(w->entry_count, 1), 1e-6);
    w->left = most;
    make_cells(w, &whole);
    while (w->left) {
        if (w->left < w->listed / 2)
            make_cells(w, &whole);
        uint32_t entry = nearest(w, pen), path = w->entries[entry].path;
        for (uint32_t i = w->first_entry[path]; i < w->first_entry[path + 1]; i++)
            take_out(w, i);
        w->chosen[path] = 1;
        const double *ends[2] = {place_of(w, entry), leave(w, entry)};
        tour->stops[tour->count] = (struct hatch_tour_stop){.path = path, .entry = w->entries[entry].point};
        memcpy(tour->stops[tour->count].ends, (const double[2][2]){{ends[0][0], ends[0][1]}, {ends[1][0], ends[1][1]}},
               sizeof tour->stops->ends);
        tour->count++;
        memcpy(pen, ends[1], 2 * sizeof *pen);
    }
}

/* Rewrites the paths in the order of the tour. */
static void rewrite(struct hatch_vector_paths *paths, const struct hatch_tour *tour, struct hatch_vector_path *list,
                    double *points)
{
    uint32_t used = 0;
    for (uint32_t i = 0; i < tour->count; i++) {
        const struct hatch_tour_stop *stop = &tour->stops[i];
        const struct hatch_vector_path *path = &paths->paths[stop->path];
        list[i] = *path;
        list[i].first = used;
        for (uint32_t k = 0; k < path->count; k++) {
            bool back = !path->closed && stop->entry > 0;
            uint32_t from = back ? path->count - 1 - k : path->closed ? (stop->entry + k) % path->count : k;
            memcpy(&points[2 * (size_t)used++], hatch_vector_point(paths, path, from), 2 * sizeof *points);
        }
    }
    if (used) {
        memcpy(paths->paths, list, tour->count * sizeof *list);
        memcpy(paths->points, points, 2 * sizeof *points * used);
    }
}

static enum hatch_status sort(struct hatch_vector_paths *paths, enum hatch_vector_order order,
                              struct hatch_arena *scratch, struct hatch_err *err)
{
    struct work work = {.paths = paths};
    struct hatch_tour tour = {.count = 0};
    struct hatch_vector_path *list;
    double *points, pen[2] = {0, 0};
    uint32_t layers = 0;
    size_t count = paths->count;
    HATCH_TRY(HATCH_ALLOC(scratch, &work.first_entry, count + 1, err));
    HATCH_TRY(HATCH_ALLOC(scratch, &work.chosen, count, err));
    HATCH_TRY(HATCH_ALLOC(scratch, &tour.stops, count, err));
    HATCH_TRY(HATCH_ALLOC(scratch, &list, count, err));
    HATCH_TRY(HATCH_ALLOC(scratch, &points, 2 * hatch_vector_point_count(paths), err));
    HATCH_TRY(list_entries(&work, scratch, err));
    HATCH_TRY(HATCH_ALLOC(scratch, &work.head, 4 * (size_t)work.entry_count + 16, err));
    for (uint32_t i = 0; i < paths->count; i++)
        layers = paths->paths[i].layer >= layers ? paths->paths[i].layer + 1 : layers;
    for (uint32_t layer = 0; layer < layers; layer++) {
        double from[2] = {pen[0], pen[1]};
        uint32_t first = tour.count;
        order_layer(&work, &tour, layer, pen);
        const struct hatch_tour part = {.count = tour.count - first, .stops = tour.stops + first};
        if (order == HATCH_VECTOR_IMPROVED && part.count) {
            hatch_tour_improve(&part, from, paths);
            memcpy(pen, part.stops[part.count - 1].ends[1], sizeof pen);
        }
    }
    rewrite(paths, &tour, list, points);
    return HATCH_OK;
}

enum hatch_status hatch_vector_sort(struct hatch_vector_paths *paths, enum hatch_vector_order order,
                                    struct hatch_arena *scratch, struct hatch_err *err)
{
    struct hatch_arena_mark mark = hatch_arena_mark(scratch);
    enum hatch_status status = sort(paths, order, scratch, err);
    hatch_arena_rewind(scratch, mark);
    return status;
}

void hatch_vector_ways(const struct hatch_vector_paths *paths, double *drawn, double *lifted)
{
    const struct hatch_vector_path *last = NULL;
    *drawn = *lifted = 0;
    for (uint32_t layer = 0, left = paths->count; left; layer++)
        for (uint32_t i = 0; i < paths->count; i++) {
            const struct hatch_vector_path *path = &paths->paths[i];
            if (path->layer != layer)
                continue;
            *drawn += hatch_vector_length(paths, path);
            if (last)
                *lifted += hatch_vector_distance(hatch_vector_point(paths, last, last->closed ? 0 : last->count - 1),
                                                 hatch_vector_point(paths, path, 0));
            last = path;
            left--;
        }
}
