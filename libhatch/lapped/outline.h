/* The outline of all patches: one irregular blob with a feathered border (Lapped Textures,
 * SIGGRAPH 2000, §3; Real-Time Hatching §6 keeps it apart from the strokes). It lives in the unit
 * square of mask coordinates, in the middle of which it stands; outside the square it is 0. */
#ifndef HATCH_LAPPED_OUTLINE_H
#define HATCH_LAPPED_OUTLINE_H

#include "image/image.h"

struct hatch_outline {
    double feather;    /* width of the ramp from opacity 1 to 0, in mask coordinates */
    double core_min;   /* radius of the largest circle around the middle at opacity 1 */
    double reach_max;  /* radius of the smallest circle around it outside of which opacity is 0 */
    double wave[8][2]; /* cosine and sine coefficients of the core's radius over the angle; [0]: its mean */
    double steep;      /* how many times a radial distance to a border may be the true one, at most; 1 .. */
};

/* roughness: 0 (a circle) .. 1; feather: 0.01 .. 0.3. */
void hatch_outline_make(uint64_t seed, double roughness, double feather, struct hatch_outline *outline);

/* Opacity at a place, 0 .. 1; exactly 1 in the core. */
double hatch_outline_opacity(const struct hatch_outline *outline, const double place[2]);

/* A signed lower bound of the distance to the core's border, in mask coordinates: over 0 inside.
 */
double hatch_outline_depth(const struct hatch_outline *outline, const double place[2]);

/* A lower bound of the distance to where opacity is over 0, in mask coordinates; 0 or less there. */
double hatch_outline_distance(const struct hatch_outline *outline, const double place[2]);

/* The mask as an image of one channel "Y", side_px square, rows from the top (v = 0): what is
 * drawn with. A texel is 1 where its bilinear footprint, here and on the next two mip levels,
 * touches the core; border texels are 0. */
enum hatch_status hatch_outline_raster(const struct hatch_outline *outline, uint32_t side_px, struct hatch_arena *arena,
                                       struct hatch_image *mask, struct hatch_err *err) HATCH_MUST_USE;

#endif
