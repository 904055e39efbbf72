/* Pictures of a large plane that faces the camera, drawn by the technique solid from any distance. */
#ifndef HATCH_TEST_SOLID_FACING_H
#define HATCH_TEST_SOLID_FACING_H

#include "solid/solids.h"
#include "solid/spectrum.h"
#include "zoom_reference.h"

#define FACING_SIZE SPECTRUM_SIZE

/* Opens the plane. It fills pictures from distance 1 and below. */
static inline void facing_open(struct test_frame *frame, struct hatch_mesh *mesh)
{
    frame_arenas(frame);
    *mesh = frame_shape(frame, HATCH_SHAPE_PLANE, 2);
    frame_open(mesh, &frame_unit, NULL, frame);
}

/* Draws a picture of FACING_SIZE pixels a side around a point of the plane. Returns the length of a pixel's side.
 *   octave  binary logarithm of the nearness: the distance is 2^-octave
 *   values  out: one per pixel, linear, rows from the bottom up */
static inline double facing_draw_at(struct test_frame *frame, const double point[3], double octave, double *values)
{
    static float rgba[4 * FACING_SIZE * FACING_SIZE];
    const double back[3] = {0, 0, 1};
    struct hatch_view view = zoomed_view(frame, point, back, exp2(-octave), 1);
    frame_draw_numbers(frame, "solid", &view, FACING_SIZE, FACING_SIZE, rgba);
    for (size_t i = 0; i < FACING_SIZE * FACING_SIZE; i++)
        values[i] = (double)rgba[4 * i];
    return 2 * view.half_height * exp2(-octave) / FACING_SIZE;
}

/* Like facing_draw_at, for one of several parts of the plane. */
static inline void facing_draw(struct test_frame *frame, int place, double octave, double *values)
{
    const double point[3] = {0.31 * cos(place), 0.31 * sin(place), 0};
    facing_draw_at(frame, point, octave, values);
}

/* Returns the mean absolute difference of a picture and an earlier one whose pixels are moved as the surface moved:
 * pixel (x, y) of the picture shows what (x, y) * scale + shift showed. */
static inline double facing_moved_change(const double *before, const double *after, double scale, const double shift[2])
{
    double sum = 0;
    size_t count = 0;
    for (size_t i = 0; i < FACING_SIZE * FACING_SIZE; i++) {
        double x = (double)(i % FACING_SIZE) * scale + shift[0], y = (double)(i / FACING_SIZE) * scale + shift[1];
        if (x < 0 || y < 0 || x >= FACING_SIZE - 1 || y >= FACING_SIZE - 1)
            continue;
        const double *from = before + (size_t)y * FACING_SIZE + (size_t)x;
        double along = x - floor(x), across = y - floor(y);
        double low = from[0] * (1 - along) + from[1] * along;
        double high = from[FACING_SIZE] * (1 - along) + from[FACING_SIZE + 1] * along;
        sum += fabs(after[i] - (low * (1 - across) + high * across));
        count++;
    }
    return sum / (double)count;
}

/* Returns the mean, with weights that fall off towards the edges: waves that do not end with the picture leave it
 * unchanged. */
static inline double facing_mean(const double *values)
{
    double sum = 0, weights = 0;
    for (size_t i = 0; i < FACING_SIZE * FACING_SIZE; i++) {
        double x = sin(SPECTRUM_PI * ((double)(i % FACING_SIZE) + 0.5) / FACING_SIZE);
        double y = sin(SPECTRUM_PI * ((double)(i / FACING_SIZE) + 0.5) / FACING_SIZE);
        sum += values[i] * x * x * y * y;
        weights += x * x * y * y;
    }
    return sum / weights;
}

/* Returns the mean absolute difference of two pictures. */
static inline double facing_change(const double *before, const double *after)
{
    double sum = 0;
    for (size_t i = 0; i < FACING_SIZE * FACING_SIZE; i++)
        sum += fabs(after[i] - before[i]);
    return sum / (FACING_SIZE * FACING_SIZE);
}

#endif
