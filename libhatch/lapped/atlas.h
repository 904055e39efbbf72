/* The two steps of making an atlas: cutting the patches into charts, and packing the charts. */
#ifndef HATCH_LAPPED_ATLAS_H
#define HATCH_LAPPED_ATLAS_H

#include "lapped/lapped.h"

struct hatch_charts {
    uint32_t count;
    uint32_t *chart_of; /* per face of the surface */
    double *positions;  /* 6 per face: its corners in the hatch coordinates of its chart's patch */
    double (*boxes)[4]; /* per chart: low x, low y, high x, high y of its positions */
};

/* Puts every face of the surface into a chart of the patch that shows most of the face; no chart overlaps itself. */
enum hatch_status hatch_charts_make(const struct hatch_surface *surface, const struct hatch_lapped *lapped,
                                    const struct hatch_outline *outline, struct hatch_arena *arena,
                                    struct hatch_charts *charts, struct hatch_err *err) HATCH_MUST_USE;

/* Packs boxes into a square by shelves of falling height (Coffman, Garey, Johnson, Tarjan 1980).
 *   sizes    2 per box: width, height
 *   margin   distance between boxes, as a share of the square's side; reduced where there are many boxes
 *   corners  out: 2 per box: low corner
 *   side     out: side of the square */
enum hatch_status hatch_charts_pack(const double *sizes, uint32_t count, double margin, struct hatch_arena *scratch,
                                    double *corners, double *side, struct hatch_err *err) HATCH_MUST_USE;

#endif
