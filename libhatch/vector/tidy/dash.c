#include <math.h>

#include "vector/runs.h"
#include "vector/tidy/tidy.h"

#define SHRINK 0.5 /* least factor of dashes and gaps of an open path */

/* Adds the pieces of a path to the runs; dashes are kept.
 *   period  length of a dash and a gap */
static enum hatch_status add_path(struct hatch_vector_runs *runs, const struct hatch_vector_paths *paths,
                                  const struct hatch_vector_path *path, double dash, double period,
                                  struct hatch_err *err)
{
    double at = 0; /* along the path, from the begin of a dash */
    hatch_vector_runs_clear(runs);
    for (uint32_t i = 0; i < hatch_vector_segments(path); i++) {
        const double *a = hatch_vector_point(paths, path, i), *b = hatch_vector_point(paths, path, i + 1);
        double length = hatch_vector_distance(a, b), done = 0;
        while (length > done) {
            bool drawn = at < dash;
            double step = fmin((drawn ? dash : period) - at, length - done);
            bool last = step >= length - done;
            HATCH_TRY(hatch_vector_runs_add(runs, a, b, done / length, last ? 1 : (done + step) / length, drawn, err));
            at = last ? at + step : drawn ? dash : 0;
            done = last ? length : done + step;
        }
    }
    return hatch_vector_runs_make(runs, err);
}

/* Finds the dashes of a path: returns their length, INFINITY if it is to stay whole.
 *   period  out: length of a dash and the gap after it */
static double fit(double length, bool closed, double dash, double gap, double *period)
{
    const double ends = closed ? 0 : dash, least = ends + dash + gap, periods = floor((length - ends) / (dash + gap));
    *period = (length - ends) / periods;
    if (periods >= 1)
        return dash;
    const double shrink = length / least;
    *period = shrink * (dash + gap);
    return closed || shrink >= SHRINK ? shrink * dash : INFINITY;
}

enum hatch_status hatch_vector_dash(const struct hatch_vector_paths *paths, double dash, double gap,
                                    struct hatch_arena *arena, struct hatch_arena *scratch,
                                    struct hatch_vector_paths *dashes, struct hatch_err *err)
{
    struct hatch_arena_mark mark = hatch_arena_mark(scratch);
    struct hatch_vector_builder built = hatch_vector_builder_of(arena);
    struct hatch_vector_runs runs = hatch_vector_runs_of(scratch);
    enum hatch_status status = HATCH_OK;
    for (uint32_t i = 0; i < paths->count && status == HATCH_OK; i++) {
        const struct hatch_vector_path *path = &paths->paths[i];
        double period, fitted = fit(hatch_vector_length(paths, path), path->closed, dash, gap, &period);
        status = add_path(&runs, paths, path, fitted, period, err);
        if (status == HATCH_OK)
            status = hatch_vector_runs_deliver(&runs, path, path->closed, true, &built, err);
    }
    hatch_arena_rewind(scratch, mark);
    if (status == HATCH_OK)
        *dashes = hatch_vector_built(&built);
    return status;
}
