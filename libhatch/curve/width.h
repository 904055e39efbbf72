/* The width of a traced stroke at a point in a picture. shaders/traced/width.glsl of render-gl computes the same.
 *
 * Strokes of a tone a and a width w are drawn where a share a of the surface in the picture would be covered by strokes
 * of that width: where
 *     a * scale / w > threshold,    scale = ppu * cos / s
 * with ppu pixels per mesh unit at the point, cos the foreshortening of areas and s that of lengths along the stroke.
 * Around that limit the width fades over a factor HATCH_STROKE_FADE of the threshold to both sides: it grows linearly
 * with the tone, from 0 at half the limit to a share HATCH_STROKE_HALF at the limit and to 1 at twice the limit. Where
 * each level of strokes halves the gaps of the one before, so that thresholds are powers of two, the levels then make
 * exactly as much ink together as is wanted at any tone, for any gap. Where the surface has fewer strokes than wanted,
 * they are wider, up to a factor HATCH_STROKE_WIDEST.
 *
 * Next to silhouettes of surfaces that turn, the scale changes fast, and strokes would come and go. Where a surface is
 * seen at a grazing angle across its strokes, they are denser and as much thinner (hatch_stroke_grazing): their number
 * changes slowly, and so do their widths. Pens of one width and dots do without this. */
#ifndef HATCH_CURVE_WIDTH_H
#define HATCH_CURVE_WIDTH_H

#include "curve/stroke_look.h"

#define HATCH_STROKE_FADE 2.0      /* ratio of thresholds from the middle of the fading to its ends */
#define HATCH_STROKE_HALF 0.5      /* share of the width in the middle */
#define HATCH_STROKE_GAIN 1.039721 /* (1 + HALF) ln 2: ink of all strokes, if those under the limit would have 1 */
#define HATCH_STROKE_WIDEST 2.4
#define HATCH_STROKE_SPARE                                                                                             \
    1.4 /* least ratio of the densest strokes to those drawn: if more are wanted, strokes get wider */
#define HATCH_STROKE_GRAZING 0.4 /* foreshortening across strokes under which their density hardly falls */
#define HATCH_STROKE_RESPONSES 8u
#define HATCH_STROKE_TONES 33u /* entries of a table of tones */

/* How a pen draws strokes. */
struct hatch_stroke_pen {
    float width_px; /* of a whole stroke at tone 1/2 */
    float thin;     /* width in the lightest tone, as a share of width_px, over 0 .. 1; it grows evenly with the tone */
    float join;     /* ink from which on the second family joins the first, 0 .. 1 */
    float response[HATCH_STROKE_RESPONSES]; /* ink, 0 .. 1, that strokes of one family really make where the tone is
                                               1/8, 2/8 .. 1: less than the tone, because strokes overlap and taper */
    float taper_px;  /* length of the tapered ends of a stroke; of a short one, they are three tenths of its length, and
                        never much longer than the gap of its level */
    float vary;      /* greatest change of width along a stroke, as a share of it, 0 .. 1 */
    float pressure;  /* greatest lightening of the ink along a stroke, 0 .. 1 */
    float grain;     /* share of the ink that the grain of the paper leaves out, 0 .. 1 */
    float wobble_px; /* greatest distance from the stroke's own line */
    float turn_rad;  /* greatest turn of neighbouring strokes together about their middles */
    float mark_px, gap_px; /* length of the marks that a stroke is drawn in, and of the gaps between them; a gap below
                              0: marks overlap; a length of 0: strokes are drawn whole (curve/marks.h) */
    float scatter;         /* greatest distance of marks from the stroke's own line, as a share of mark_px + gap_px */
    struct hatch_stroke_look look;
};

/* Returns the darkest ink that strokes of so many families make together. */
double hatch_stroke_darkest(const struct hatch_stroke_pen *pen, uint32_t families);

/* Divides ink among families that cross: light ink is the first family's alone, and the others join one after the
 * other.
 *   families  of the mesh, at least 1
 *   family    the tones of this one are computed
 *   tones     out: tone of the family at ink 0, 1/32 .. 1 */
void hatch_stroke_tones(const struct hatch_stroke_pen *pen, uint32_t families, uint32_t family,
                        float tones[HATCH_STROKE_TONES]);

/* Returns the width of whole strokes of a tone, in pixels: strokes get thinner before they get fewer. */
double hatch_stroke_whole_px(const struct hatch_stroke_pen *pen, double tone);

/* Returns the width of a stroke at a point, as a share of that of a whole stroke.
 *   ratio  of the strokes that are wanted to the point's threshold */
double hatch_stroke_share(double ratio);

/* Returns the factor, at least 1, by which strokes are denser and thinner because the surface is seen at a grazing
 * angle across them: the scale times it is never under `grazing` times facing_scale.
 *   scale         as below, of the surface
 *   facing_scale  of one that faces the camera, over 0
 *   grazing       HATCH_STROKE_GRAZING; 0: the factor is 1 */
double hatch_stroke_grazing(double scale, double facing_scale, double grazing);

/* Returns the width of a stroke at a point, in pixels; 0: it is not drawn there.
 *   tone       share of the surface that the strokes of this family cover together, 0 .. 1
 *   threshold  of the point, in strokes per mesh unit across
 *   scale      ppu * cos / s, in pixels per mesh unit
 *   densest    greatest threshold of the mesh's strokes: the others are wider, as far as they lack
 *   raised     factor of the thresholds of denser strokes, that is to say, how few of them there are; HUGE_VAL: none
 *   denser     factor of hatch_stroke_grazing; it is used as far as the mesh has so many strokes */
double hatch_stroke_width_px(const struct hatch_stroke_pen *pen, double tone, double threshold, double scale,
                             double densest, double raised, double denser);

#endif
