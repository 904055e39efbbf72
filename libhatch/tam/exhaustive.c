#include <math.h>

#include "tam/place.h"

/* The darkness that the footprint adds at every level of one image's pyramid. The stroke that is drawn
 * into pyramid level p is the box-filtered stroke, so that its share of one coarse pixel is spread
 * evenly over the fine pixels below. */
static double pyramid_gain(const struct hatch_canvas *canvas, float *const *pyramid, uint32_t size_px)
{
    const struct hatch_footprint *f = &canvas->footprint;
    double sum = 0;
    for (uint32_t i = 0; i < f->count; i++) {
        uint32_t x = f->at[i] % size_px, y = f->at[i] / size_px;
        float paper = 0;
        for (uint32_t p = 0; size_px >> p; p++)
            paper += pyramid[p][(y >> p) * (size_px >> p) + (x >> p)];
        sum += (double)(f->alpha[i] * paper);
    }
    return sum / ((double)size_px * (double)size_px);
}

struct hatch_stroke hatch_place_exhaustively(struct hatch_canvas *canvas,
                                             float *pyramids[][HATCH_MIP_LEVELS_MAX],
                                             const struct hatch_choice *choice)
{
    struct hatch_stroke best = {0};
    double best_goodness = -1;
    for (uint32_t c = 0; c < choice->candidates; c++) {
        struct hatch_stroke stroke = hatch_candidate(canvas->style, choice, c);
        double gain = 0;
        for (uint32_t level = 0; level <= choice->level; level++) {
            uint32_t size_px = hatch_canvas_size(canvas, level);
            (void)hatch_canvas_try(canvas, &stroke, level, choice->scale);
            gain += pyramid_gain(canvas, pyramids[level], size_px);
        }
        float drawn = stroke.length * choice->scale * (float)canvas->size_px;
        double goodness = gain / (double)(drawn > stroke.width_px ? drawn : stroke.width_px);
        if (goodness > best_goodness) {
            best_goodness = goodness;
            best = stroke;
        }
    }
    return best;
}
