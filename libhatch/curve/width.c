#include "curve/width.h"

#include <math.h>

#define JOINING 1.3 /* exponent with which the ink of a family grows after it has joined */

/* Returns the tone at which strokes of one family make an amount of ink. */
static double tone_for(const struct hatch_stroke_pen *pen, double ink)
{
    double below = 0;
    for (uint32_t i = 0; i < HATCH_STROKE_RESPONSES; i++) {
        double above = (double)pen->response[i];
        if (ink <= above)
            return (i + (ink - below) / fmax(above - below, 1e-6)) / HATCH_STROKE_RESPONSES;
        below = above;
    }
    return 1;
}

double hatch_stroke_darkest(const struct hatch_stroke_pen *pen, uint32_t families)
{
    return 1 - pow(1 - (double)pen->response[HATCH_STROKE_RESPONSES - 1], families);
}

void hatch_stroke_tones(const struct hatch_stroke_pen *pen, uint32_t families, uint32_t family,
                        float tones[HATCH_STROKE_TONES])
{
    double darkest = hatch_stroke_darkest(pen, families);
    double join = fmin((double)pen->join, 0.9 * (double)pen->response[HATCH_STROKE_RESPONSES - 1]);
    for (uint32_t i = 0; i < HATCH_STROKE_TONES; i++) {
        double ink = fmin((double)i / (HATCH_STROKE_TONES - 1), darkest), sum = 0, own = 0;
        for (uint32_t f = 0; f < families; f++) {
            double from = f > 0 ? join + (darkest - join) * (f - 1) / (families - 1) : 0;
            double weight = f > 0 ? pow(fmax(ink - from, 0) / (darkest - from), JOINING) : 1;
            sum += weight;
            own = f == family ? weight : own;
        }
        tones[i] = (float)tone_for(pen, 1 - pow(1 - ink, own / sum)); /* what crossing strokes leave is multiplied */
    }
}

double hatch_stroke_whole_px(const struct hatch_stroke_pen *pen, double tone)
{
    return (double)pen->width_px * ((double)pen->thin + (1 - (double)pen->thin) * 2 * tone);
}

double hatch_stroke_share(double ratio)
{
    const double half = HATCH_STROKE_HALF;
    return fmin(fmax(fmin(half + (1 - half) * (ratio - 1), half * (2 * ratio - 1)), 0), 1);
}

/* Returns the ink of strokes whose thresholds are more than a factor, at least 1, above what is wanted, as a share of
 * what strokes under the limit would have. */
static double ink_beyond(double factor)
{
    return factor < HATCH_STROKE_FADE
               ? HATCH_STROKE_HALF * (2 * log(HATCH_STROKE_FADE / factor) - (HATCH_STROKE_FADE - factor))
               : 0;
}

double hatch_stroke_grazing(double scale, double facing_scale, double grazing)
{
    return pow(1 + pow(grazing * facing_scale / fmax(scale, 1e-9 * facing_scale), 4), 0.25);
}

double hatch_stroke_width_px(const struct hatch_stroke_pen *pen, double tone, double threshold, double scale,
                             double densest, double raised, double denser)
{
    double whole_px = hatch_stroke_whole_px(pen, tone), covered = tone * scale / HATCH_STROKE_GAIN;
    double wanted = covered / whole_px;
    denser = fmax(fmin(denser, densest / (HATCH_STROKE_FADE * fmax(wanted, 1e-300))), 1);
    double drawn = fmax(fmin(wanted * denser, densest / HATCH_STROKE_SPARE), 1e-300), factor = densest / drawn;
    double lacking = (ink_beyond(factor) - ink_beyond(raised * factor) / raised) / HATCH_STROKE_GAIN;
    whole_px *= fmin(wanted * denser / drawn / (1 - lacking), HATCH_STROKE_WIDEST) / denser;
    return whole_px * hatch_stroke_share(drawn / threshold);
}
