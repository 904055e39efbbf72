#include "curve/width.h"

#include <math.h>

double hatch_stroke_whole_px(const struct hatch_stroke_pen *pen, double tone)
{
    return pen->width_px * (pen->thin + (1 - pen->thin) * fmin(tone / pen->full, 1));
}

double hatch_stroke_width_px(const struct hatch_stroke_pen *pen, double tone, double threshold, double scale)
{
    /* Mean width of the strokes at a place, if as many as wanted have thresholds below the limit. */
    const double fade = log(HATCH_STROKE_FADE), gain = (HATCH_STROKE_FADE - 1 / HATCH_STROKE_FADE) / (2 * fade);
    double whole_px = hatch_stroke_whole_px(pen, tone);
    double wanted = tone * scale / (gain * whole_px);
    if (!(wanted * HATCH_STROKE_FADE > threshold))
        return 0;
    return whole_px * fmin(0.5 + 0.5 * log(wanted / threshold) / fade, 1);
}
