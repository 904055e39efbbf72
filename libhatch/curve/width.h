/* The width of a traced stroke at a point in a picture. shaders/traced/width.glsl of render-gl computes the same.
 *
 * Strokes of a tone a and a width w are drawn where a share a of the surface in the picture would be covered by strokes
 * of that width: where
 *     a * scale / w > threshold,    scale = ppu * cos / s
 * with ppu pixels per mesh unit at the point, cos the foreshortening of areas and s that of lengths along the stroke.
 * Around that limit the width fades over a factor HATCH_STROKE_FADE of the threshold to both sides. */
#ifndef HATCH_CURVE_WIDTH_H
#define HATCH_CURVE_WIDTH_H

#define HATCH_STROKE_FADE 1.8 /* ratio of thresholds from half the width to none, and from all of it to half */

/* How a pen draws tone. */
struct hatch_stroke_pen {
    double width_px; /* of a whole stroke in the darkest tone */
    double thin;     /* width in the lightest tone, as a share of width_px, over 0 .. 1 */
    double full;     /* tone from which on strokes are as wide as width_px, over 0 .. 1 */
};

/* Returns the width of whole strokes of a tone: strokes get thinner before they get fewer. */
double hatch_stroke_whole_px(const struct hatch_stroke_pen *pen, double tone);

/* Returns the width of a stroke at a point, in pixels; 0: it is not drawn there.
 *   tone       share of the surface that the strokes of this family cover together, 0 .. 1
 *   threshold  of the point, in strokes per mesh unit across
 *   scale      ppu * cos / s, in pixels per mesh unit */
double hatch_stroke_width_px(const struct hatch_stroke_pen *pen, double tone, double threshold, double scale);

#endif
