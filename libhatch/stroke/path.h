/* The line of a drawn stroke that is neither straight nor an arc: a polyline so fine that nobody sees its
 * corners, and the curves that it is made from. */
#ifndef HATCH_STROKE_PATH_H
#define HATCH_STROKE_PATH_H

#include "base/arena.h"
#include "stroke/stroke.h"

/* How far, in tiles, a point may lie from the stroke's middle. */
#define HATCH_PATH_REACH_MAX 64.0
#define HATCH_PATH_LENGTH_MAX 65536.0f /* tiles */
#define HATCH_LINE_LENGTH_MAX 16.0     /* of strokes without a path */
#define HATCH_PATH_POINTS_MAX 1048576u

/* Immutable, owned by an arena. A round brush puts its half discs to the ends, others end with the line.
 * xy: x and y of each point in drawing order, fractions of the tile from the stroke's x and y, not wrapped.
 * count: 2 .. HATCH_PATH_POINTS_MAX. */
struct hatch_path {
    uint32_t count;
    const float *xy;
};

/* Of the polyline, in tiles. */
float hatch_path_length(const struct hatch_path *path);

/* A line in the making: points in the unit of `tolerance`, which is how far the polyline may lie from
 * the curve. Start from {.arena = a, .tolerance = t}. The buffer doubles in arena. */
struct hatch_path_builder {
    struct hatch_arena *arena;
    double tolerance;
    double *xy;
    uint32_t count, capacity;
};

/* Each adds to the line from its last point on; hatch_path_line is also how a line begins. Points equal to
 * the one before are left out. HATCH_LIMIT beyond HATCH_PATH_POINTS_MAX points; HATCH_BAD_INPUT for a
 * point that is not finite. */
enum hatch_status hatch_path_line(struct hatch_path_builder *builder, double x, double y,
                                  struct hatch_err *err) HATCH_MUST_USE;

/* control: x1 y1 x2 y2 x y, of a cubic Bézier curve. */
enum hatch_status hatch_path_cubic(struct hatch_path_builder *builder, const double control[6],
                                   struct hatch_err *err) HATCH_MUST_USE;

/* Turns the line into a stroke's geometry: x, y (the middle of its extent, wrapped into the tile), length
 * (of the line), angle_rad (of its chord) and path, which is NULL for a line of one point: a dot. Other
 * fields stay. Points are fractions of the tile here. Nothing is changed on failure. HATCH_BAD_INPUT for a
 * line that reaches further than HATCH_PATH_REACH_MAX or is longer than HATCH_PATH_LENGTH_MAX. */
enum hatch_status hatch_path_finish(const struct hatch_path_builder *builder, struct hatch_arena *arena,
                                    struct hatch_stroke *stroke, struct hatch_err *err) HATCH_MUST_USE;

#endif
