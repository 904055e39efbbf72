/* The order in which a pen draws paths. Part of hatch_vector_sort. */
#ifndef HATCH_VECTOR_TOUR_H
#define HATCH_VECTOR_TOUR_H

#include "vector/paths.h"

/* A path on the pen's way. */
struct hatch_tour_stop {
    uint32_t path;
    uint32_t entry;    /* point of the path where the pen begins: an end, or any point of a closed path */
    double ends[2][2]; /* where the pen begins and leaves */
};

struct hatch_tour {
    uint32_t count;
    struct hatch_tour_stop *stops;
};

/* Shortens the way of the lifted pen: reverses parts of the tour as long as that helps (Croes 1958). Looks at a
 * limited number of stops around each, and passes over all of them a limited number of times.
 *   from   where the pen comes from
 *   paths  that the tour goes along */
void hatch_tour_improve(const struct hatch_tour *tour, const double from[2], const struct hatch_vector_paths *paths);

#endif
