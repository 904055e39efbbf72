#include "vector/tidy/tour.h"

#include <math.h>
#include <string.h>

#define WINDOW 300u     /* stops that are looked at after each */
#define PASSES_MOST 20u /* over all stops */
#define PASS_LEAST 1e-3 /* share of the way that a pass must save for another one to follow */
#define GAIN_LEAST 1e-9 /* less counts as rounding */

/* A tour, with the point that the pen comes from before its first stop. */
struct work {
    const struct hatch_tour *tour;
    const struct hatch_vector_paths *paths;
    const double *from;
};

/* Returns where the pen leaves before stop i. */
static const double *before(const struct work *w, uint32_t i)
{
    return i ? w->tour->stops[i - 1].ends[1] : w->from;
}

/* Returns the way from a point to the begin of stop i; there is none after the last stop. */
static double way_to(const struct work *w, const double at[2], uint32_t i)
{
    return i < w->tour->count ? hatch_vector_distance(at, w->tour->stops[i].ends[0]) : 0;
}

static void reverse_stop(const struct work *w, struct hatch_tour_stop *stop)
{
    const struct hatch_vector_path *path = &w->paths->paths[stop->path];
    double begin[2];
    if (path->closed)
        return;
    memcpy(begin, stop->ends[0], sizeof begin);
    memcpy(stop->ends[0], stop->ends[1], sizeof begin);
    memcpy(stop->ends[1], begin, sizeof begin);
    stop->entry = path->count - 1 - stop->entry;
}

/* Reverses stops i to k. */
static void reverse(const struct work *w, uint32_t i, uint32_t k)
{
    struct hatch_tour_stop *stops = w->tour->stops;
    for (uint32_t a = i, b = k; a < b; a++, b--) {
        const struct hatch_tour_stop stop = stops[a];
        stops[a] = stops[b];
        stops[b] = stop;
    }
    for (uint32_t a = i; a <= k; a++)
        reverse_stop(w, &stops[a]);
}

/* Reverses a part that begins at stop i, if that shortens the way. */
static bool try_reversals(const struct work *w, uint32_t i)
{
    const struct hatch_tour_stop *stops = w->tour->stops;
    uint32_t last = w->tour->count - 1 - i < WINDOW ? w->tour->count - 1 : i + WINDOW;
    const double *at = before(w, i);
    for (uint32_t k = i; k <= last; k++) {
        double old = way_to(w, at, i) + way_to(w, stops[k].ends[1], k + 1);
        double new = hatch_vector_distance(at, stops[k].ends[1]) + way_to(w, stops[i].ends[0], k + 1);
        if (new < old - GAIN_LEAST) {
            reverse(w, i, k);
            return true;
        }
    }
    return false;
}

/* Returns the way of the lifted pen. */
static double whole_way(const struct work *w)
{
    double way = 0;
    for (uint32_t i = 0; i < w->tour->count; i++)
        way += way_to(w, before(w, i), i);
    return way;
}

void hatch_tour_improve(const struct hatch_tour *tour, const double from[2], const struct hatch_vector_paths *paths)
{
    const struct work work = {tour, paths, from};
    double way = whole_way(&work), last = INFINITY;
    for (uint32_t pass = 0; pass < PASSES_MOST && way < (1 - PASS_LEAST) * last; pass++) {
        bool better = false;
        for (uint32_t i = 0; i < tour->count; i++) {
            better = try_reversals(&work, i) || better;
        }
        last = way;
        way = better ? whole_way(&work) : way;
    }
}
