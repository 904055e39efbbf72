/* Paths for tests of tidying: `builder` grows in the arena `keep`. */
#ifndef HATCH_TEST_VECTOR_PATHS_MADE_H
#define HATCH_TEST_VECTOR_PATHS_MADE_H

#include "arenas.h"
#include "vector/tidy/tidy.h"

static struct hatch_vector_builder builder;

static inline void begin_paths(void)
{
    begin();
    builder = hatch_vector_builder_of(&keep);
}

static inline void add(uint32_t id, const double *points, uint32_t count, bool closed)
{
    hatch_vector_begin(&builder, &(struct hatch_vector_path){.id = id});
    for (uint32_t i = 0; i < count; i++)
        HATCH_TEST_OK(hatch_vector_add(&builder, points + 2 * i, &err), &err);
    HATCH_TEST_OK(hatch_vector_end(&builder, closed, &err), &err);
}

static inline void add_line(uint32_t id, double ax, double ay, double bx, double by)
{
    add(id, (const double[]){ax, ay, bx, by}, 2, false);
}

static inline double total(const struct hatch_vector_paths *paths)
{
    double drawn, lifted;
    hatch_vector_ways(paths, &drawn, &lifted);
    return drawn;
}

#endif
