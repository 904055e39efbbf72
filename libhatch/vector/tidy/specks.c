#include <math.h>

#include "math/range.h"
#include "vector/tidy/segments.h"
#include "vector/tidy/tidy.h"

struct work {
    const struct hatch_vector_paths *paths;
    double reach;
    struct hatch_segments near; /* segments, numbered by their first points */
    uint32_t *path_of;          /* per point */
    const double *end;          /* of path `own` */
    uint32_t own;
    bool meets; /* another path passes the end */
};

/* Finds out whether the end is within reach of a segment of another path. */
static enum hatch_status look(void *context, uint32_t segment, struct hatch_err *err)
{
    struct work *w = context;
    const struct hatch_vector_path *path = &w->paths->paths[w->path_of[segment]];
    (void)err;
    if (w->path_of[segment] == w->own)
        return HATCH_OK;
    uint32_t i = segment - path->first;
    w->meets = w->meets || hatch_vector_distance_to(w->end, hatch_vector_point(w->paths, path, i),
                                                    hatch_vector_point(w->paths, path, i + 1)) <= w->reach;
    return HATCH_OK;
}

/* Finds out whether another path passes one of the ends of a path: of a closed one, its first or its last point. */
static enum hatch_status find_neighbours(struct work *w, uint32_t number, struct hatch_err *err)
{
    const struct hatch_vector_path *path = &w->paths->paths[number];
    w->own = number;
    w->meets = false;
    for (int last = 0; last < 2 && !w->meets; last++) {
        w->end = hatch_vector_point(w->paths, path, last ? path->count - 1 : 0);
        HATCH_TRY(hatch_segments_find(&w->near, w->end, w->end, w->reach, look, w, err));
    }
    return HATCH_OK;
}

static enum hatch_status drop(struct work *w, struct hatch_vector_paths *paths, double speck,
                              struct hatch_arena *scratch, struct hatch_err *err)
{
    uint8_t *dropped;
    uint32_t kept = 0;
    HATCH_TRY(hatch_segments_make(paths, w->reach, scratch, &w->near, err));
    HATCH_TRY(HATCH_ALLOC(scratch, &w->path_of, hatch_vector_point_count(paths), err));
    HATCH_TRY(HATCH_ALLOC(scratch, &dropped, paths->count, err));
    for (uint32_t i = 0; i < paths->count; i++) {
        const struct hatch_vector_path *path = &paths->paths[i];
        for (uint32_t k = 0; k < hatch_vector_segments(path); k++) {
            w->path_of[path->first + k] = i;
            HATCH_TRY(hatch_segments_insert(&w->near, path->first + k, hatch_vector_point(paths, path, k),
                                            hatch_vector_point(paths, path, k + 1), err));
        }
    }
    for (uint32_t i = 0; i < paths->count; i++) {
        if (!(hatch_vector_length(paths, &paths->paths[i]) < speck))
            continue;
        HATCH_TRY(find_neighbours(w, i, err));
        dropped[i] = !w->meets;
    }
    for (uint32_t i = 0; i < paths->count; i++)
        if (!dropped[i])
            paths->paths[kept++] = paths->paths[i];
    paths->count = kept;
    return HATCH_OK;
}

enum hatch_status hatch_vector_drop_specks(struct hatch_vector_paths *paths, double speck, double reach,
                                           struct hatch_arena *scratch, struct hatch_err *err)
{
    struct hatch_arena_mark mark = hatch_arena_mark(scratch);
    struct work work = {.paths = paths, .reach = reach};
    enum hatch_status status = drop(&work, paths, speck, scratch, err);
    hatch_arena_rewind(scratch, mark);
    return status;
}
