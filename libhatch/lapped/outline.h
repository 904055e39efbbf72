/* The outline that all patches share: one irregular blob with a feathered border (Lapped Textures, SIGGRAPH 2000, §3;
 * kept apart from the strokes as in Real-Time Hatching, §6). Mask coordinates are those of a unit square with the blob
 * in its middle; outside the square opacity is 0. The core is the area with opacity 1. */
#ifndef HATCH_LAPPED_OUTLINE_H
#define HATCH_LAPPED_OUTLINE_H

#include "image/image.h"

/* Lengths are in mask coordinates. */
struct hatch_outline {
    double feather;    /* width of the ramp from opacity 1 to 0 */
    double core_min;   /* radius of the largest circle around the middle that the core contains */
    double reach_max;  /* radius of the smallest circle around the middle outside which opacity is 0 */
    double wave[8][2]; /* Fourier coefficients (cosine, sine) of the core's radius over the angle; [0][0] is its mean */
    double steep;      /* bound of the radial distance to the border over the true distance, 1 .. */
};

/* Makes an outline.
 *   seed       random seed
 *   roughness  0 (a circle) .. 1
 *   feather    0.01 .. 0.3 */
void hatch_outline_make(uint64_t seed, double roughness, double feather, struct hatch_outline *outline);

/* Returns the opacity at mask coordinates uv, 0 .. 1; exactly 1 in the core. */
double hatch_outline_opacity(const struct hatch_outline *outline, const double uv[2]);

/* Returns a signed lower bound of the distance from uv to the core's border, positive in the core. */
double hatch_outline_depth(const struct hatch_outline *outline, const double uv[2]);

/* Returns a lower bound of the distance from uv to the nearest place where opacity is greater than 0. At such a place
 * it is at most 0. */
double hatch_outline_distance(const struct hatch_outline *outline, const double uv[2]);

/* Least width of an image of an outline: in smaller ones, texels on the border touch the core. */
#define HATCH_OUTLINE_PX_MIN 64

/* Returns the number of mip levels of an image of an outline on which the core is opaque, 1 .. 3: those of at least 256
 * pixels. Coarser ones are not for drawing.
 *   side_px  width of the image; less than 256 counts as 256 */
uint32_t hatch_outline_levels(uint32_t side_px);

/* Draws the outline as an image of one channel "Y", rows from the top (v = 0). A texel is 1 where its bilinear
 * footprint, on any of the levels that hatch_outline_levels tells, touches the core; texels on the image's border are
 * 0. The ramp begins where that ends: it is up to 9.3 texels narrower than the feather with three levels, 5 with two,
 * and 2.9 with one.
 *   side_px  width and height, at least HATCH_OUTLINE_PX_MIN
 *   mask     out: pixels in arena */
enum hatch_status hatch_outline_raster(const struct hatch_outline *outline, uint32_t side_px, struct hatch_arena *arena,
                                       struct hatch_image *mask, struct hatch_err *err) HATCH_MUST_USE;

#endif
