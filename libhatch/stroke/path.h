/* Paths of drawn strokes that are neither straight nor arcs: polylines fine enough to look smooth, and a builder that
 * makes them from lines and curves. */
#ifndef HATCH_STROKE_PATH_H
#define HATCH_STROKE_PATH_H

#include <stdbool.h>

#include "base/arena.h"
#include "stroke/stroke.h"

#define HATCH_PATH_REACH_MAX 64.0      /* tiles: largest distance of a point from the middle, per axis */
#define HATCH_PATH_LENGTH_MAX 65536.0f /* tiles: largest length of a path */
#define HATCH_LINE_LENGTH_MAX 16.0     /* tiles: largest length of a stroke without a path */
#define HATCH_PATH_POINTS_MAX 1048576u

/* Immutable, in an arena. A round brush has its caps centred on the end points; with other brushes the stroke ends at
 * these points. */
struct hatch_path {
    uint32_t count;  /* 2 .. HATCH_PATH_POINTS_MAX */
    const float *xy; /* points in drawing order, tiles from the stroke's x and y, not wrapped */
};

/* Returns the length of the polyline, in tiles. */
float hatch_path_length(const struct hatch_path *path);

/* Computes the place of a stroke, of any kind, at a share of its length from its start, in tiles; not wrapped. */
void hatch_stroke_place(const struct hatch_stroke *stroke, float t, float place[2]);

/* A polyline under construction. Initialise with {.arena = a, .tolerance = t}; the array of points doubles in arena as
 * it grows. */
struct hatch_path_builder {
    struct hatch_arena *arena;
    double tolerance; /* largest distance of the polyline from a curve, in the unit of the points, greater than 0 */
    double *xy;       /* two numbers per point */
    uint32_t count, capacity; /* number of points */
};

/* Adds a point, joined to the one before by a line; the first call begins the path. A point equal to the one before is
 * left out.
 * HATCH_BAD_INPUT for a point that is not finite; HATCH_LIMIT for more than HATCH_PATH_POINTS_MAX points. */
enum hatch_status hatch_path_add_line(struct hatch_path_builder *builder, double x, double y,
                                      struct hatch_err *err) HATCH_MUST_USE;

/* Adds a cubic Bézier curve that starts at the last point.
 *   control  the two control points and the end point: x1 y1 x2 y2 x y
 * Statuses as for hatch_path_add_line. */
enum hatch_status hatch_path_add_cubic(struct hatch_path_builder *builder, const double control[6],
                                       struct hatch_err *err) HATCH_MUST_USE;

/* Returns whether a line exceeds HATCH_PATH_REACH_MAX, measured from its middle or from the page.
 *   builder  with at least one point; fractions of the tile */
bool hatch_path_is_far(const struct hatch_path_builder *builder);

/* Sets the geometry of a stroke from a builder whose points are fractions of the tile: x and y (centre of the bounding
 * box, wrapped into the tile), length (of the polyline), angle_rad (of the chord from the first to the last point),
 * bend_rad (0) and path (NULL for a dot, which has only one point).
 *   builder  with at least one point
 *   arena    receives the path
 *   stroke   out: other members keep their values; unchanged on failure
 * HATCH_BAD_INPUT for a line that exceeds HATCH_PATH_REACH_MAX or HATCH_PATH_LENGTH_MAX. */
enum hatch_status hatch_path_finish(const struct hatch_path_builder *builder, struct hatch_arena *arena,
                                    struct hatch_stroke *stroke, struct hatch_err *err) HATCH_MUST_USE;

#endif
