/* Strokes as a picture shows them, for tests and measurements of fit/cubic.h: the pixels around a cubic, each with the
 * parameter of the nearest point of the curve. */
#ifndef HATCH_TEST_FIT_STROKES_H
#define HATCH_TEST_FIT_STROKES_H

#include <math.h>
#include <stdbool.h>
#include <string.h>

#include "base/random.h"
#include "fit/cubic.h"

enum { FIT_MOST = 4096, FIT_SIDE = 512, FIT_HIDDEN = 4 };

/* The way of a stroke, and what hides it. */
struct fit_way {
    double length_px; /* of its Bezier polygon, 1 .. 440 */
    double width_px;
    double turns_rad[2];             /* between the sides of the Bezier polygon */
    double direction_rad, offset[2]; /* of the beginning */
    double noise_px;                 /* parameters are off by up to this length */
    double hidden[FIT_HIDDEN][2];    /* ranges of t without fragments */
    uint64_t seed;                   /* of the noise */
};

/* A cubic Bezier curve, in pixels. */
struct fit_bezier {
    double corner[2][4]; /* x and y of its polygon */
};

struct fit_stroke {
    struct fit_bezier middle;
    size_t count;
    struct hatch_fragment fragments[FIT_MOST];
};

/* Returns a uniform number of a range. */
static inline double fit_between(uint64_t seed, uint64_t stream, uint64_t index, double least, double most)
{
    return least + (most - least) * (double)hatch_random_unit(seed, stream, index);
}

/* Parts of a stroke that are in sight. */
enum fit_kind {
    FIT_WHOLE,
    FIT_PART, /* a quarter to three quarters of it */
    FIT_HOLES,
    FIT_GAP,    /* a fiftieth to a fifth at each end */
    FIT_SLIVER, /* a 64th */
    FIT_KINDS
};

/* Draws a stroke of one kind: lengths 10 to 400 pixels, widths 1 to 6, parameters off by up to half a pixel.
 *   bend  largest turn between the sides of the Bezier polygon, in radians */
static inline struct fit_way fit_draw_way(enum fit_kind kind, uint64_t index, double bend)
{
    const uint64_t seed = index * FIT_KINDS + kind;
    struct fit_way way = {.length_px = exp(fit_between(seed, 2, 0, log(10), log(400))),
                          .width_px = fit_between(seed, 2, 1, 1, 6),
                          .turns_rad = {fit_between(seed, 2, 2, -bend, bend), fit_between(seed, 2, 3, -bend, bend)},
                          .direction_rad = fit_between(seed, 2, 4, 0, 6.2832),
                          .offset = {fit_between(seed, 2, 5, 0, 1), fit_between(seed, 2, 6, 0, 1)},
                          .noise_px = fit_between(seed, 2, 7, 0, 0.5),
                          .seed = seed};
    double first = fit_between(seed, 2, 8, 0, 1), second = fit_between(seed, 2, 9, 0, 1);
    double seen = kind == FIT_PART ? 0.25 + 0.5 * second : 1.0 / 64, begin = first * (1 - seen);
    if (kind == FIT_PART || kind == FIT_SLIVER) {
        way.hidden[0][0] = -1;
        way.hidden[0][1] = begin;
        way.hidden[1][0] = begin + seen;
        way.hidden[1][1] = 2;
    }
    if (kind == FIT_GAP) {
        way.hidden[0][0] = 0.02 + 0.18 * first;
        way.hidden[0][1] = 0.98 - 0.18 * second;
    }
    for (uint64_t i = 0; kind == FIT_HOLES && i < FIT_HIDDEN; i++) {
        way.hidden[i][0] = fit_between(seed, 3, i, 0, 1);
        way.hidden[i][1] = way.hidden[i][0] + fit_between(seed, 4, i, 0, 0.3);
    }
    return way;
}

/* Computes a place of a curve, and the first two derivatives there. */
static inline void fit_bezier_at(const struct fit_bezier *curve, double t, double out[3][2])
{
    double s = 1 - t;
    for (int k = 0; k < 2; k++) {
        const double *p = curve->corner[k], d[3] = {p[1] - p[0], p[2] - p[1], p[3] - p[2]};
        out[0][k] = s * s * s * p[0] + 3 * s * s * t * p[1] + 3 * s * t * t * p[2] + t * t * t * p[3];
        out[1][k] = 3 * (s * s * d[0] + 2 * s * t * d[1] + t * t * d[2]);
        out[2][k] = 6 * (s * (d[1] - d[0]) + t * (d[2] - d[1]));
    }
}

/* Returns the parameter of the point that is nearest to a pixel, near t; it may lie beyond 0 and 1. */
static inline double fit_project(const struct fit_bezier *curve, double x, double y, double t)
{
    for (int i = 0; i < 6; i++) {
        double at[3][2];
        fit_bezier_at(curve, t, at);
        double from[2] = {at[0][0] - x, at[0][1] - y};
        double slope = from[0] * at[1][0] + from[1] * at[1][1];
        double speed = at[1][0] * at[1][0] + at[1][1] * at[1][1];
        double bend = speed + from[0] * at[2][0] + from[1] * at[2][1];
        double step = slope / fmax(bend, 0.25 * speed);
        t -= step;
        if (fabs(step) < 1e-9)
            break;
    }
    return t;
}

/* Draws the polygon of a stroke within a square of FIT_SIDE pixels. */
static inline void fit_polygon(const struct fit_way *way, struct fit_bezier *curve)
{
    double angle = way->direction_rad, least[2] = {0, 0}, *x = curve->corner[0], *y = curve->corner[1];
    x[0] = y[0] = 0;
    for (int i = 1; i < 4; i++) {
        x[i] = x[i - 1] + way->length_px / 3 * cos(angle);
        y[i] = y[i - 1] + way->length_px / 3 * sin(angle);
        angle += i < 3 ? way->turns_rad[i - 1] : 0;
    }
    for (int k = 0; k < 2; k++) {
        for (int i = 0; i < 4; i++)
            least[k] = fmin(least[k], curve->corner[k][i]);
        for (int i = 0; i < 4; i++)
            curve->corner[k][i] += 8 + way->offset[k] - least[k];
    }
}

static inline bool fit_hidden(const struct fit_way *way, double t)
{
    for (int i = 0; i < FIT_HIDDEN; i++)
        if (t > way->hidden[i][0] && t < way->hidden[i][1])
            return true;
    return false;
}

/* Makes the fragments of a stroke: pixels whose middle is within half the width and half a pixel of the curve, with
 * parameters of 16 bits. The weight is the share of a pixel that a straight stroke of that width covers. */
static inline void fit_fragments(const struct fit_way *way, struct fit_stroke *stroke)
{
    static unsigned char seen[FIT_SIDE][FIT_SIDE];
    memset(seen, 0, sizeof seen);
    fit_polygon(way, &stroke->middle);
    stroke->count = 0;
    double reach = 0.5 * way->width_px + 0.5;
    int steps = (int)way->length_px + 2, side = (int)reach + 2;
    for (int i = 0; i <= steps; i++) {
        double near[3][2];
        fit_bezier_at(&stroke->middle, (double)i / steps, near);
        for (int at = 0; at < (2 * side + 1) * (2 * side + 1); at++) {
            int x = (int)near[0][0] + at % (2 * side + 1) - side, y = (int)near[0][1] + at / (2 * side + 1) - side;
            if (x < 0 || y < 0 || x >= FIT_SIDE || y >= FIT_SIDE || seen[y][x])
                continue;
            double t = fit_project(&stroke->middle, x + 0.5, y + 0.5, (double)i / steps), foot[3][2];
            fit_bezier_at(&stroke->middle, t, foot);
            double covered = reach - hypot(foot[0][0] - x - 0.5, foot[0][1] - y - 0.5);
            if (!(t >= 0 && t <= 1 && covered > 0) || stroke->count == FIT_MOST)
                continue;
            seen[y][x] = 1;
            if (fit_hidden(way, t))
                continue;
            t += way->noise_px / way->length_px * fit_between(way->seed, 1, stroke->count, -1, 1);
            stroke->fragments[stroke->count++] =
                (struct hatch_fragment){.t = (float)(rint(fmin(fmax(t, 0), 1) * 65535) / 65535),
                                        .x = (float)x + 0.5f,
                                        .y = (float)y + 0.5f,
                                        .weight = (float)fmin(fmin(covered, way->width_px), 1)};
        }
    }
}

/* Computes the place of a fitted curve at t. */
static inline void fit_curve_at(const struct hatch_cubic *cubic, double t, double place[2])
{
    float at[2];
    hatch_cubic_at(cubic, hatch_cubic_u(cubic, (float)t), at);
    place[0] = (double)at[0];
    place[1] = (double)at[1];
}

#endif
