/* Polylines in the plane, and a builder that appends to them. */
#ifndef HATCH_VECTOR_PATHS_H
#define HATCH_VECTOR_PATHS_H

#include <stdbool.h>

#include "base/bytes.h"

struct hatch_vector_path {
    uint32_t first, count; /* range of points, at least 1; the last point of a closed path is not its first one */
    uint32_t layer;        /* pen or tone that draws it, from 0 */
    uint32_t id;           /* of the curve that it is a part of */
    bool closed;
};

struct hatch_vector_paths {
    uint32_t count;
    struct hatch_vector_path *paths;
    double *points; /* 2 per point: x to the right, y upwards, in pixels from the picture's lower left corner */
};

/* Paths under construction. Initialize it with hatch_vector_builder_of. */
struct hatch_vector_builder {
    struct hatch_buffer paths, points;
    struct hatch_vector_path path; /* the one that grows */
};

/* Makes an empty builder, which grows in arena. */
struct hatch_vector_builder hatch_vector_builder_of(struct hatch_arena *arena);

/* Begins a path like another one: with its layer and id, open and without points. */
void hatch_vector_begin(struct hatch_vector_builder *builder, const struct hatch_vector_path *like);

/* Appends a point, unless it equals the last one. */
enum hatch_status hatch_vector_add(struct hatch_vector_builder *builder, const double at[2],
                                   struct hatch_err *err) HATCH_MUST_USE;

/* Ends the path. A path without points is dropped; a closed path drops a last point that equals its first, and is open
 * if fewer than three points remain. */
enum hatch_status hatch_vector_end(struct hatch_vector_builder *builder, bool closed,
                                   struct hatch_err *err) HATCH_MUST_USE;

/* Appends copies of paths. */
enum hatch_status hatch_vector_append(struct hatch_vector_builder *builder, const struct hatch_vector_paths *paths,
                                      struct hatch_err *err) HATCH_MUST_USE;

/* Returns the paths that have been ended. They share the builder's memory. */
struct hatch_vector_paths hatch_vector_built(const struct hatch_vector_builder *builder);

/* Returns point i of a path. Point `count` of a closed path is its first one. */
static inline const double *hatch_vector_point(const struct hatch_vector_paths *paths,
                                               const struct hatch_vector_path *path, uint32_t i)
{
    return &paths->points[2 * (size_t)(path->first + (i < path->count ? i : i - path->count))];
}

/* Returns the number of segments of a path. */
static inline uint32_t hatch_vector_segments(const struct hatch_vector_path *path)
{
    return path->closed ? path->count : path->count - 1;
}

/* Returns the distance between two points. */
double hatch_vector_distance(const double a[2], const double b[2]);

/* Returns the distance of a point from the segment a b. */
double hatch_vector_distance_to(const double at[2], const double a[2], const double b[2]);

/* Returns the length of a path. */
double hatch_vector_length(const struct hatch_vector_paths *paths, const struct hatch_vector_path *path);

#endif
