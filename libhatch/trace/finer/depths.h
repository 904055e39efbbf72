/* A small picture of how near surfaces are, which tells the faces that are hidden from those that may be seen. */
#ifndef HATCH_TRACE_DEPTHS_H
#define HATCH_TRACE_DEPTHS_H

#include <stdbool.h>

#include "base/arena.h"

struct hatch_depths {
    int width, height;
    float *near; /* per pixel: the greatest nearness of a surface, or -HUGE_VALF */
};

/* A corner of a flat polygon. */
struct hatch_depths_corner {
    double x, y; /* in pixels of the small picture, from its lower left corner */
    double near; /* linear in the picture, greater for what is nearer */
};

/* Makes a picture that shows nothing.
 *   width, height  at least 1 */
enum hatch_status hatch_depths_make(int width, int height, struct hatch_arena *arena, struct hatch_depths *depths,
                                    struct hatch_err *err) HATCH_MUST_USE;

/* Draws a convex polygon.
 *   count  of corners, at least 3 */
void hatch_depths_draw(struct hatch_depths *depths, const struct hatch_depths_corner *corners, int count);

/* Returns whether a part of a polygon may be seen: false only where everything that the picture resolves of it is
 * behind others. */
bool hatch_depths_show(const struct hatch_depths *depths, const struct hatch_depths_corner *corners, int count);

#endif
