#include <math.h>
#include <string.h>

#include "vector/cells.h"
#include "vector/tidy/tidy.h"

struct range {
    uint32_t first, last;
};

struct work {
    const struct hatch_vector_paths *paths;
    double tolerance;
    uint8_t *kept;       /* per point of the path */
    struct range *stack; /* ranges whose inner points are not decided yet */
};

/* Keeps the points of a range of a path that the tolerance asks for; its ends are kept already. */
static void keep_points(const struct work *w, const struct hatch_vector_path *path, struct range whole)
{
    uint32_t depth = 0;
    w->stack[depth++] = whole;
    while (depth) {
        const struct range range = w->stack[--depth];
        const double *a = hatch_vector_point(w->paths, path, range.first);
        const double *b = hatch_vector_point(w->paths, path, range.last);
        uint32_t farthest = range.first;
        double most = w->tolerance;
        for (uint32_t i = range.first + 1; i < range.last; i++) {
            double distance = hatch_vector_distance_to(hatch_vector_point(w->paths, path, i), a, b);
            if (distance > most) {
                most = distance;
                farthest = i;
            }
        }
        if (farthest == range.first)
            continue;
        w->kept[farthest] = 1;
        w->stack[depth++] = (struct range){range.first, farthest};
        w->stack[depth++] = (struct range){farthest, range.last};
    }
}

/* Chooses the points of a path that are kept. A closed path is divided at its first point and the one farthest from
 * that. */
static void choose(const struct work *w, const struct hatch_vector_path *path)
{
    memset(w->kept, 0, (size_t)path->count + 1);
    w->kept[0] = 1;
    if (!path->closed) {
        w->kept[path->count - 1] = 1;
        keep_points(w, path, (struct range){0, path->count - 1});
        return;
    }
    uint32_t farthest = 0;
    double most = 0;
    for (uint32_t i = 1; i < path->count; i++) {
        double distance =
            hatch_vector_distance(hatch_vector_point(w->paths, path, 0), hatch_vector_point(w->paths, path, i));
        if (distance > most) {
            most = distance;
            farthest = i;
        }
    }
    w->kept[farthest] = 1;
    keep_points(w, path, (struct range){0, farthest});
    keep_points(w, path, (struct range){farthest, path->count});
}

static enum hatch_status simplify(struct work *w, struct hatch_vector_paths *paths, double shortest,
                                  struct hatch_arena *scratch, struct hatch_err *err)
{
    uint32_t most = 0, kept = 0, points = 0;
    for (uint32_t i = 0; i < paths->count; i++)
        most = paths->paths[i].count > most ? paths->paths[i].count : most;
    HATCH_TRY(HATCH_ALLOC(scratch, &w->kept, (size_t)most + 1, err));
    HATCH_TRY(HATCH_ALLOC(scratch, &w->stack, (size_t)most + 1, err));
    for (uint32_t i = 0; i < paths->count; i++) {
        struct hatch_vector_path path = paths->paths[i];
        if (hatch_vector_length(paths, &path) < shortest)
            continue;
        choose(w, &path);
        uint32_t first = points;
        for (uint32_t k = 0; k < path.count; k++)
            if (w->kept[k])
                memmove(&paths->points[2 * (size_t)points++], hatch_vector_point(paths, &path, k), 2 * sizeof(double));
        path.first = first;
        path.count = points - first;
        path.closed = path.closed && path.count > 2;
        paths->paths[kept++] = path;
    }
    paths->count = kept;
    return HATCH_OK;
}

enum hatch_status hatch_vector_simplify(struct hatch_vector_paths *paths, double tolerance, double shortest,
                                        struct hatch_arena *scratch, struct hatch_err *err)
{
    struct hatch_arena_mark mark = hatch_arena_mark(scratch);
    struct work work = {.paths = paths, .tolerance = tolerance};
    enum hatch_status status = simplify(&work, paths, shortest, scratch, err);
    hatch_arena_rewind(scratch, mark);
    return status;
}
