/* An axis-aligned bounding box of points. */
#ifndef HATCH_MATH_BOX_H
#define HATCH_MATH_BOX_H

#include <math.h>
#include <stdbool.h>

/* Initialize it with {.any = false}. */
struct hatch_box {
    double low[3], high[3]; /* unset while there are no points */
    bool any;               /* at least one point has been added */
};

/* Extends the box so that it contains a point. NaN coordinates are ignored, except in the first point. */
static inline void hatch_box_add(struct hatch_box *box, const double point[3])
{
    for (int k = 0; k < 3; k++) {
        box->low[k] = box->any ? fmin(box->low[k], point[k]) : point[k];
        box->high[k] = box->any ? fmax(box->high[k], point[k]) : point[k];
    }
    box->any = true;
}

#endif
