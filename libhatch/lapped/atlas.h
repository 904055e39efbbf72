/* The steps of an atlas: charts, and where they lie. */
#ifndef HATCH_LAPPED_ATLAS_H
#define HATCH_LAPPED_ATLAS_H

#include "lapped/lapped.h"

struct hatch_charts {
    uint32_t count;
    uint32_t *of;       /* per face of the surface: its chart */
    double *places;     /* 6 a face: its corners in the coordinates of its chart's patch */
    double (*boxes)[4]; /* per chart: low x, low y, high x, high y */
};

/* Puts every face into a chart of the patch that shows most of it; charts do not overlap themselves. */
enum hatch_status hatch_charts_make(const struct hatch_surface *surface, const struct hatch_lapped *lapped,
                                    const struct hatch_outline *outline, struct hatch_arena *arena,
                                    struct hatch_charts *charts, struct hatch_err *err) HATCH_MUST_USE;

/* Lays boxes of sizes (2 each) side by side into a square: corners receives their low corners. margin:
 * between them, as a share of the square. Returns in *side the square's side. */
enum hatch_status hatch_shelves_pack(const double *sizes, uint32_t count, double margin, struct hatch_arena *scratch,
                                     double *corners, double *side, struct hatch_err *err) HATCH_MUST_USE;

#endif
