#include "stroke/path.h"

#include <assert.h>
#include <math.h>
#include <string.h>

#define CURVE_PIECES_MAX 4096.0

static enum hatch_status grow(struct hatch_path_builder *b, struct hatch_err *err)
{
    if (b->count == HATCH_PATH_POINTS_MAX)
        return hatch_fail(err, HATCH_LIMIT, "a stroke has more than %u points", HATCH_PATH_POINTS_MAX);
    uint32_t capacity = b->capacity ? 2 * b->capacity : 64;
    double *larger;
    HATCH_TRY(HATCH_ALLOC(b->arena, &larger, 2 * (size_t)capacity, err));
    if (b->count)
        memcpy(larger, b->xy, 2 * (size_t)b->count * sizeof *larger);
    b->xy = larger;
    b->capacity = capacity;
    return HATCH_OK;
}

enum hatch_status hatch_path_add_line(struct hatch_path_builder *b, double x, double y, struct hatch_err *err)
{
    if (!isfinite(x) || !isfinite(y))
        return hatch_fail(err, HATCH_BAD_INPUT, "a point is not finite");
    if (b->count && b->xy[2 * b->count - 2] == x && b->xy[2 * b->count - 1] == y)
        return HATCH_OK;
    if (b->count == b->capacity)
        HATCH_TRY(grow(b, err));
    b->xy[2 * b->count] = x;
    b->xy[2 * b->count + 1] = y;
    b->count++;
    return HATCH_OK;
}

/* Returns the number of equal parameter steps that keep the polyline within the tolerance. The chord of a step h is off
 * by at most h² / 8 times the second derivative, which is largest at an end of a cubic. */
static double count_pieces(const double *from, const double *control, double tolerance)
{
    double first = hypot(from[0] - 2 * control[0] + control[2], from[1] - 2 * control[1] + control[3]);
    double second = hypot(control[0] - 2 * control[2] + control[4], control[1] - 2 * control[3] + control[5]);
    double bend = 6 * fmax(first, second);
    double pieces = ceil(sqrt(bend / (8 * tolerance)));
    return pieces > 1 ? fmin(pieces, CURVE_PIECES_MAX) : 1; /* NaN gives one piece, whose end point is then rejected */
}

enum hatch_status hatch_path_add_cubic(struct hatch_path_builder *b, const double control[6], struct hatch_err *err)
{
    assert(b->count > 0 && b->tolerance > 0);
    double from[2] = {b->xy[2 * b->count - 2], b->xy[2 * b->count - 1]};
    uint32_t pieces = (uint32_t)count_pieces(from, control, b->tolerance);
    for (uint32_t i = 1; i < pieces; i++) {
        double t = (double)i / pieces, s = 1 - t;
        double w0 = s * s * s, w1 = 3 * s * s * t, w2 = 3 * s * t * t, w3 = t * t * t;
        double x = w0 * from[0] + w1 * control[0] + w2 * control[2] + w3 * control[4];
        double y = w0 * from[1] + w1 * control[1] + w2 * control[3] + w3 * control[5];
        HATCH_TRY(hatch_path_add_line(b, x, y, err));
    }
    return hatch_path_add_line(b, control[4], control[5], err);
}

/* Computes the centre of the bounding box. Returns the larger of half of its larger side, and the distance of the
 * centre from the page's corner, per axis. */
static double find_middle(const struct hatch_path_builder *b, double *middle)
{
    assert(b->count > 0);
    double low[2] = {INFINITY, INFINITY}, high[2] = {-INFINITY, -INFINITY};
    for (uint32_t i = 0; i < b->count; i++)
        for (int axis = 0; axis < 2; axis++) {
            low[axis] = fmin(low[axis], b->xy[2 * i + (uint32_t)axis]);
            high[axis] = fmax(high[axis], b->xy[2 * i + (uint32_t)axis]);
        }
    for (int axis = 0; axis < 2; axis++)
        middle[axis] = (low[axis] + high[axis]) / 2;
    return fmax(fmax(high[0] - middle[0], high[1] - middle[1]), fmax(fabs(middle[0]), fabs(middle[1])));
}

bool hatch_path_is_far(const struct hatch_path_builder *b)
{
    double middle[2];
    return !(find_middle(b, middle) <= HATCH_PATH_REACH_MAX);
}

static enum hatch_status make_path(const struct hatch_path_builder *b, const double *middle, struct hatch_arena *arena,
                                   const struct hatch_path **path, struct hatch_err *err)
{
    struct hatch_path *made;
    float *xy;
    HATCH_TRY(HATCH_ALLOC(arena, &made, 1, err));
    HATCH_TRY(HATCH_ALLOC(arena, &xy, 2 * (size_t)b->count, err));
    *made = (struct hatch_path){0, xy};
    for (uint32_t i = 0; i < b->count; i++) {
        float x = (float)(b->xy[2 * i] - middle[0]), y = (float)(b->xy[2 * i + 1] - middle[1]);
        const float *before = xy + 2 * (size_t)made->count - 2;
        if (made->count && before[0] == x && before[1] == y)
            continue;
        xy[2 * made->count] = x;
        xy[2 * made->count + 1] = y;
        made->count++;
    }
    *path = made->count > 1 ? made : NULL;
    return HATCH_OK;
}

float hatch_path_length(const struct hatch_path *path)
{
    double length = 0;
    for (const float *at = path->xy; at < path->xy + 2 * ((size_t)path->count - 1); at += 2)
        length += sqrt(((double)at[2] - (double)at[0]) * ((double)at[2] - (double)at[0]) +
                       ((double)at[3] - (double)at[1]) * ((double)at[3] - (double)at[1]));
    return (float)length;
}

enum hatch_status hatch_path_finish(const struct hatch_path_builder *b, struct hatch_arena *arena,
                                    struct hatch_stroke *stroke, struct hatch_err *err)
{
    double middle[2];
    const struct hatch_path *path;
    if (!(find_middle(b, middle) <= HATCH_PATH_REACH_MAX))
        return hatch_fail(err, HATCH_BAD_INPUT, "a stroke reaches more than %g tiles from its middle or from the page",
                          HATCH_PATH_REACH_MAX);
    HATCH_TRY(make_path(b, middle, arena, &path, err));
    float length = path ? hatch_path_length(path) : 0;
    if (!(length <= HATCH_PATH_LENGTH_MAX))
        return hatch_fail(err, HATCH_BAD_INPUT, "a stroke is %g tiles long, want %g at most", (double)length,
                          (double)HATCH_PATH_LENGTH_MAX);
    const double *end = b->xy + 2 * (size_t)b->count - 2;
    stroke->x = hatch_stroke_wrap(middle[0]);
    stroke->y = hatch_stroke_wrap(middle[1]);
    stroke->length = length;
    stroke->angle_rad = (float)atan2(end[1] - b->xy[1], end[0] - b->xy[0]);
    stroke->bend_rad = 0;
    stroke->path = path;
    return HATCH_OK;
}

/* Computes the point of a polyline at a distance from its start. */
static void walk(const struct hatch_path *path, double way, double point[2])
{
    const float *xy = path->xy;
    double x = (double)xy[0], y = (double)xy[1];
    for (uint32_t i = 1; i < path->count; i++) {
        double dx = (double)xy[2 * i] - x, dy = (double)xy[2 * i + 1] - y, length = hypot(dx, dy);
        double share = way < length ? way / length : 1;
        point[0] = x + share * dx;
        point[1] = y + share * dy;
        if (way < length)
            return;
        way -= length;
        x += dx;
        y += dy;
    }
}

void hatch_stroke_place(const struct hatch_stroke *stroke, float t, float place[2])
{
    double way = ((double)t - 0.5) * (double)stroke->length, bend = (double)stroke->bend_rad;
    double cosine = cos((double)stroke->angle_rad), sine = sin((double)stroke->angle_rad), from[2] = {0, 0};
    if (stroke->path)
        walk(stroke->path, (double)t * (double)stroke->length, from);
    else {
        bool turns = fabs(bend) > 1e-6 && stroke->length > 0;
        double radius = turns ? (double)stroke->length / bend : 0;
        double along = turns ? radius * sin(way / radius) : way, across = turns ? radius * (1 - cos(way / radius)) : 0;
        from[0] = along * cosine - across * sine;
        from[1] = along * sine + across * cosine;
    }
    place[0] = (float)((double)stroke->x + from[0]);
    place[1] = (float)((double)stroke->y + from[1]);
}
